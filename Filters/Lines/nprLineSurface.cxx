// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineSurface.h"

#include "nprArrayNames.h"
#include "nprLengthScale.h"
#include "nprWeldedPoints.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <tuple>

namespace npr
{
//------------------------------------------------------------------------------
LineSurface::LineSurface(vtkPolyData* surface, double lengthScale) : Mesh(surface)
{
  this->LengthScale = lengthScale > 0.0 ? lengthScale : npr::GetLengthScale(surface, this->Mesh);
  const Index numberOfPoints = this->Mesh.GetNumberOfPoints();

  if (surface->GetPointData()->HasArray(names::WeldedPointIds))
  {
    this->WeldedIds = GetWeldedPoints(surface);
  }

  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<float>& coordinates = this->Coordinates[axis];
    coordinates.resize(numberOfPoints);
    for (Index i = 0; i < numberOfPoints; ++i)
    {
      coordinates[i] = this->Mesh.GetPoint(i)[axis];
    }
  }
  this->BuildTwins();
  this->BuildSeams();
}

//------------------------------------------------------------------------------
bool LineSurface::LoadArray(vtkPolyData* surface, const char* name, int components)
{
  if (this->HasArray(name))
  {
    return true;
  }
  vtkDataArray* array = surface->GetPointData()->GetArray(name);
  if (!array && std::string(name) == names::Normals)
  {
    array = surface->GetPointData()->GetNormals();
  }
  const Index numberOfPoints = this->Mesh.GetNumberOfPoints();
  if (!array || array->GetNumberOfComponents() != components ||
    array->GetNumberOfTuples() != numberOfPoints)
  {
    return false;
  }
  std::vector<std::vector<float>> spans(components, std::vector<float>(numberOfPoints));
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> tuple(components);
      for (vtkIdType i = begin; i < end; ++i)
      {
        array->GetTuple(i, tuple.data());
        for (int c = 0; c < components; ++c)
        {
          spans[c][i] = static_cast<float>(tuple[c]);
        }
      }
    });
  this->Arrays.emplace(name, std::move(spans));
  return true;
}

//------------------------------------------------------------------------------
void LineSurface::BuildTwins()
{
  this->Mesh.BuildNeighbours();
  this->Twins.assign(this->GetNumberOfHalfEdges(), NoTwin);
  vtkSMPTools::For(0, this->GetNumberOfHalfEdges(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (Index h = static_cast<Index>(begin); h < end; ++h)
      {
        const Index neighbour = this->Mesh.GetNeighbour(h / 3, h % 3);
        if (neighbour < 0)
        {
          continue;
        }
        const Index from = this->GetStart(h);
        const Index to = this->GetEnd(h);
        for (Index other = 3 * neighbour; other < 3 * neighbour + 3; ++other)
        {
          const Index start = this->GetStart(other);
          const Index end2 = this->GetEnd(other);
          // Either direction: triangles with opposite windings are still neighbours. Both sides
          // must agree, which they do not where a triangle uses a point twice.
          if (((start == to && end2 == from) || (start == from && end2 == to)) &&
            this->Mesh.GetNeighbour(neighbour, other % 3) == h / 3)
          {
            this->Twins[h] = other;
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
void LineSurface::BuildSeams()
{
  struct Side
  {
    Index Low, High, HalfEdge;
    bool operator<(const Side& other) const
    {
      return std::tie(this->Low, this->High, this->HalfEdge) <
        std::tie(other.Low, other.High, other.HalfEdge);
    }
  };
  std::vector<Side> sides;
  for (Index h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    if (this->Twins[h] == NoTwin)
    {
      const Index start = this->GetWelded(this->GetStart(h));
      const Index end = this->GetWelded(this->GetEnd(h));
      if (start != end)
      {
        sides.push_back({ std::min(start, end), std::max(start, end), h });
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    this->Seams.HalfEdges.push_back(sides[i].HalfEdge);
    if (i + 1 == sides.size() || sides[i].Low != sides[i + 1].Low ||
      sides[i].High != sides[i + 1].High)
    {
      this->Seams.Offsets.push_back(static_cast<Index>(i + 1));
    }
  }
}

//------------------------------------------------------------------------------
void LineSurface::BuildInnerEdges()
{
  if (!this->InnerEdges.HalfEdges.empty())
  {
    return;
  }
  for (Index h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    if (this->Twins[h] > h)
    {
      this->InnerEdges.HalfEdges.push_back(h);
      this->InnerEdges.HalfEdges.push_back(this->Twins[h]);
      this->InnerEdges.Offsets.push_back(static_cast<Index>(this->InnerEdges.HalfEdges.size()));
    }
  }
}
}
