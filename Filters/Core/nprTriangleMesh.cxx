// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprTriangleMesh.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace npr
{
//------------------------------------------------------------------------------
TriangleMesh::TriangleMesh(vtkPolyData* surface)
{
  const vtkIdType numberOfPoints = surface->GetNumberOfPoints();
  if (numberOfPoints > 0)
  {
    double bounds[6];
    surface->GetBounds(bounds);
    const Eigen::Vector3d centre(
      0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5]));
    if (centre.allFinite())
    {
      this->Origin = centre;
    }
  }
  this->Points.resize(numberOfPoints);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      Eigen::Vector3d point;
      for (vtkIdType i = begin; i < end; ++i)
      {
        surface->GetPoints()->GetPoint(i, point.data());
        this->Points[i] = (point - this->Origin).cast<float>();
      }
    });

  vtkCellArray* polygons = surface->GetPolys();
  this->Triangles.reserve(polygons->GetNumberOfCells());
  this->CellIds.reserve(polygons->GetNumberOfCells());
  vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  auto iterator = vtk::TakeSmartPointer(polygons->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal();
       iterator->GoToNextCell(), ++cell)
  {
    vtkIdType size;
    const vtkIdType* corners;
    iterator->GetCurrentCell(size, corners);
    if (size == 3 && this->IsUsable(corners))
    {
      this->Triangles.push_back({ static_cast<Index>(corners[0]), static_cast<Index>(corners[1]),
        static_cast<Index>(corners[2]) });
      this->CellIds.push_back(cell);
    }
  }
}

//------------------------------------------------------------------------------
TriangleMesh::TriangleMesh(
  std::vector<Vector> points, std::vector<Triangle> triangles, const Eigen::Vector3d& origin)
  : Points(std::move(points)), Triangles(std::move(triangles)), Origin(origin)
{
}

//------------------------------------------------------------------------------
bool TriangleMesh::IsUsable(const vtkIdType* corners) const
{
  Vector sum = Vector::Zero();
  for (int i = 0; i < 3; ++i)
  {
    if (corners[i] < 0 || corners[i] >= this->GetNumberOfPoints() ||
      corners[i] == corners[(i + 1) % 3])
    {
      return false;
    }
    sum += this->Points[corners[i]];
  }
  // A sum is finite only if all that went into it was.
  return sum.allFinite();
}

//------------------------------------------------------------------------------
void TriangleMesh::Flip(Index triangle)
{
  std::swap(this->Triangles[triangle][1], this->Triangles[triangle][2]);
  if (!this->Neighbours.empty())
  {
    std::swap(this->Neighbours[triangle][0], this->Neighbours[triangle][2]);
  }
}

//------------------------------------------------------------------------------
TriangleMesh::Vector TriangleMesh::GetAreaNormal(Index triangle) const
{
  const Triangle& corners = this->Triangles[triangle];
  const Vector& origin = this->Points[corners[0]];
  return (this->Points[corners[1]] - origin).cross(this->Points[corners[2]] - origin);
}

//------------------------------------------------------------------------------
double TriangleMesh::ComputeLengthScale() const
{
  // Over a triangle, the integral of p is its area times the mean of its corners, and that of
  // |p|^2 is area / 12 times (the sum of |p_i|^2 plus |sum of p_i|^2).
  double area = 0.0;
  double second = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  for (Index t = 0; t < this->GetNumberOfTriangles(); ++t)
  {
    const double weight = 0.5 * this->GetAreaNormal(t).cast<double>().norm();
    if (!std::isfinite(weight))
    {
      continue;
    }
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double squares = 0.0;
    for (Index corner : this->Triangles[t])
    {
      const Eigen::Vector3d point = this->Points[corner].cast<double>();
      sum += point;
      squares += point.squaredNorm();
    }
    area += weight;
    first += weight / 3.0 * sum;
    second += weight / 12.0 * (squares + sum.squaredNorm());
  }
  if (area <= 0.0)
  {
    return 0.0;
  }
  return std::sqrt(std::max(0.0, second / area - (first / area).squaredNorm()));
}

//------------------------------------------------------------------------------
void TriangleMesh::BuildIncidence()
{
  this->IncidentOffsets.assign(this->Points.size() + 1, 0);
  for (const Triangle& corners : this->Triangles)
  {
    for (Index corner : corners)
    {
      ++this->IncidentOffsets[corner + 1];
    }
  }
  for (std::size_t i = 1; i < this->IncidentOffsets.size(); ++i)
  {
    this->IncidentOffsets[i] += this->IncidentOffsets[i - 1];
  }
  this->Incident.resize(this->IncidentOffsets.back());
  std::vector<Index> next(this->IncidentOffsets.begin(), this->IncidentOffsets.end() - 1);
  for (Index t = 0; t < this->GetNumberOfTriangles(); ++t)
  {
    for (Index corner : this->Triangles[t])
    {
      this->Incident[next[corner]++] = t;
    }
  }
}

//------------------------------------------------------------------------------
void TriangleMesh::BuildNeighbours()
{
  if (this->IncidentOffsets.empty())
  {
    this->BuildIncidence();
  }
  this->Neighbours.resize(this->Triangles.size());
  vtkSMPTools::For(0, this->GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        const Triangle& corners = this->Triangles[t];
        for (int e = 0; e < 3; ++e)
        {
          // The point with fewer triangles is searched: hubs of fans may have thousands.
          Index from = corners[e];
          Index to = corners[(e + 1) % 3];
          if (this->GetNumberOfIncident(to) < this->GetNumberOfIncident(from))
          {
            std::swap(from, to);
          }
          Index neighbour = Boundary;
          for (const Index* other = this->IncidentBegin(from); other != this->IncidentEnd(from);
               ++other)
          {
            const Triangle& o = this->Triangles[*other];
            if (*other != t && (o[0] == to || o[1] == to || o[2] == to))
            {
              neighbour = neighbour == Boundary ? *other : NonManifold;
            }
          }
          this->Neighbours[t][e] = neighbour;
        }
      }
    });
}

//------------------------------------------------------------------------------
int TriangleMesh::CountTrianglesAtEdge(Index from, Index to) const
{
  if (this->GetNumberOfIncident(to) < this->GetNumberOfIncident(from))
  {
    std::swap(from, to);
  }
  int count = 0;
  for (const Index* t = this->IncidentBegin(from); t != this->IncidentEnd(from); ++t)
  {
    const Triangle& corners = this->Triangles[*t];
    count += corners[0] == to || corners[1] == to || corners[2] == to;
  }
  return count;
}

//------------------------------------------------------------------------------
bool TriangleMesh::IsBorderPoint(Index point) const
{
  // Each edge at the point shows as another corner of its triangles: twice, off the border.
  constexpr int capacity = 32;
  std::array<Index, capacity + 1>
    others; // one to spare: the point itself is written, and left again
  const Index numberOfIncident = this->GetNumberOfIncident(point);
  if (2 * numberOfIncident <= capacity)
  {
    int size = 0;
    for (const Index* t = this->IncidentBegin(point); t != this->IncidentEnd(point); ++t)
    {
      for (Index corner : this->Triangles[*t])
      {
        others[size] = corner;
        size += corner != point;
      }
    }
    return std::any_of(others.begin(), others.begin() + size,
      [&](Index other)
      {
        int count = 0;
        for (int i = 0; i < size; ++i)
        {
          count += others[i] == other;
        }
        return count != 2;
      });
  }
  // Hubs of fans: with thousands of triangles the quadratic search would take too long.
  for (const Index* t = this->IncidentBegin(point); t != this->IncidentEnd(point); ++t)
  {
    for (Index corner : this->Triangles[*t])
    {
      if (corner != point && this->CountTrianglesAtEdge(point, corner) != 2)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void TriangleMesh::BuildEdges()
{
  if (this->IncidentOffsets.empty())
  {
    this->BuildIncidence();
  }
  const Index numberOfPoints = this->GetNumberOfPoints();
  const auto collect = [this](Index point, std::vector<Index>& ends)
  {
    ends.clear();
    for (const Index* t = this->IncidentBegin(point); t != this->IncidentEnd(point); ++t)
    {
      for (Index corner : this->Triangles[*t])
      {
        if (corner > point)
        {
          ends.push_back(corner);
        }
      }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  };
  this->EdgeOffsets.assign(numberOfPoints + 1, 0);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> ends;
      for (vtkIdType i = begin; i < end; ++i)
      {
        collect(static_cast<Index>(i), ends);
        this->EdgeOffsets[i + 1] = static_cast<Index>(ends.size());
      }
    });
  for (Index i = 0; i < numberOfPoints; ++i)
  {
    this->EdgeOffsets[i + 1] += this->EdgeOffsets[i];
  }
  this->EdgeStarts.resize(this->EdgeOffsets.back());
  this->EdgeEnds.resize(this->EdgeOffsets.back());
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> ends;
      for (vtkIdType i = begin; i < end; ++i)
      {
        collect(static_cast<Index>(i), ends);
        const Index offset = this->EdgeOffsets[i];
        std::copy(ends.begin(), ends.end(), this->EdgeEnds.begin() + offset);
        std::fill_n(this->EdgeStarts.begin() + offset, ends.size(), static_cast<Index>(i));
      }
    });
}

//------------------------------------------------------------------------------
TriangleMesh::Index TriangleMesh::FindEdge(Index a, Index b) const
{
  const auto first = this->EdgeEnds.begin() + this->EdgeOffsets[std::min(a, b)];
  const auto last = this->EdgeEnds.begin() + this->EdgeOffsets[std::min(a, b) + 1];
  return static_cast<Index>(std::lower_bound(first, last, std::max(a, b)) - this->EdgeEnds.begin());
}
}
