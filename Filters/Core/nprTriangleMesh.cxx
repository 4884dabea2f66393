// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprTriangleMesh.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

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
  vtkSMPTools::For(0, numberOfPoints, [&](vtkIdType begin, vtkIdType end) {
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
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell(), ++cell)
  {
    vtkIdType size;
    const vtkIdType* corners;
    iterator->GetCurrentCell(size, corners);
    if (size == 3)
    {
      this->Triangles.push_back({ static_cast<Index>(corners[0]), static_cast<Index>(corners[1]),
        static_cast<Index>(corners[2]) });
      this->CellIds.push_back(cell);
    }
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
  vtkSMPTools::For(0, this->GetNumberOfTriangles(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType t = begin; t < end; ++t)
    {
      const Triangle& corners = this->Triangles[t];
      for (int e = 0; e < 3; ++e)
      {
        const Index from = corners[e];
        const Index to = corners[(e + 1) % 3];
        Index neighbour = Boundary;
        for (const Index* other = this->IncidentBegin(from); other != this->IncidentEnd(from); ++other)
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
}
