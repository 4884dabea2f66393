// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprTriangleMesh.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace npr
{
namespace
{
/// The middle of the points; where these span much more than polygons do, that of a sample of
/// polygons: a point that none uses, far away or infinite, must not take the digits of all others.
Eigen::Vector3d FindCentre(vtkPolyData* surface)
{
  constexpr double muchMore = 100.0;
  constexpr vtkIdType sampleSize = 1000;
  vtkCellArray* const polygons = surface->GetPolys();
  const vtkIdType size = polygons->GetNumberOfCells();
  const vtkIdType step = std::max<vtkIdType>(1, size / sampleSize);
  Eigen::AlignedBox3d box;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < size; i += step)
  {
    polygons->GetCellAtId(i, corners);
    for (const vtkIdType corner : *corners)
    {
      if (corner >= 0 && corner < surface->GetNumberOfPoints())
      {
        Eigen::Vector3d point;
        surface->GetPoint(corner, point.data());
        if (point.allFinite())
        {
          box.extend(point);
        }
      }
    }
  }
  double bounds[6];
  surface->GetBounds(bounds);
  const Eigen::AlignedBox3d all(Eigen::Vector3d(bounds[0], bounds[2], bounds[4]),
    Eigen::Vector3d(bounds[1], bounds[3], bounds[5]));
  if (box.isEmpty() || all.diagonal().norm() < muchMore * box.diagonal().norm())
  {
    box = all;
  }
  const Eigen::Vector3d centre = box.center();
  return centre.allFinite() ? centre : Eigen::Vector3d(Eigen::Vector3d::Zero());
}
}

//------------------------------------------------------------------------------
TriangleMesh::TriangleMesh(vtkPolyData* surface)
{
  this->ReadPoints(surface);
  this->MeasurePoints();
  this->ReadTriangles(surface);
}

//------------------------------------------------------------------------------
TriangleMesh::TriangleMesh(
  std::vector<Vector> points, std::vector<Triangle> triangles, const Eigen::Vector3d& origin)
  : Points(std::move(points)), Triangles(std::move(triangles)), Origin(origin)
{
  this->MeasurePoints();
}

//------------------------------------------------------------------------------
void TriangleMesh::MovePoints(std::vector<Vector> points, const Eigen::Vector3d& origin)
{
  this->Points = std::move(points);
  this->Origin = origin;
  this->MeasurePoints();
}

//------------------------------------------------------------------------------
void TriangleMesh::ReadPoints(vtkPolyData* surface)
{
  const vtkIdType numberOfPoints = surface->GetNumberOfPoints();
  if (numberOfPoints == 0)
  {
    return;
  }
  this->Origin = FindCentre(surface);
  this->Points.resize(numberOfPoints);
  vtkDataArray* const data = surface->GetPoints()->GetData();
  auto* const floats = vtkFloatArray::FastDownCast(data);
  vtkSMPTools::For(0, numberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      Eigen::Vector3d point;
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (floats)
        {
          point = Eigen::Map<const Vector>(floats->GetPointer(3 * i)).cast<double>();
        }
        else
        {
          data->GetTuple(i, point.data());
        }
        this->Points[i] = (point - this->Origin).cast<float>();
      }
    });
}

//------------------------------------------------------------------------------
void TriangleMesh::MeasurePoints()
{
  vtkSMPThreadLocal<float> largest(0.0f);
  std::atomic<bool> isFinite{ true };
  vtkSMPTools::For(0, this->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      float mine = 0.0f;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const float here = this->Points[i].cwiseAbs().sum();
        if (std::isfinite(here))
        {
          mine = std::max(mine, here);
        }
        else
        {
          isFinite = false;
        }
      }
      largest.Local() = std::max(largest.Local(), mine);
    });
  float size = 0.0f;
  for (const float mine : largest)
  {
    size = std::max(size, mine);
  }
  // Far enough from the ends for the inverse, and for its square beside other factors.
  this->Unit = size > 0.0f ? std::ldexp(1.0f, std::clamp(std::ilogb(size), -60, 60)) : 1.0f;
  this->IsFinite = isFinite;
}

//------------------------------------------------------------------------------
template<typename Id>
bool TriangleMesh::IsUsable(const Id* corners) const
{
  for (int i = 0; i < 3; ++i)
  {
    if (corners[i] < 0 || corners[i] >= this->GetNumberOfPoints() ||
      corners[i] == corners[(i + 1) % 3])
    {
      return false;
    }
  }
  return this->IsFinite ||
    (this->Points[corners[0]].allFinite() && this->Points[corners[1]].allFinite() &&
      this->Points[corners[2]].allFinite());
}

//------------------------------------------------------------------------------
template<typename Ids>
bool TriangleMesh::ReadAllTriangles(vtkPolyData* surface)
{
  vtkCellArray* const polygons = surface->GetPolys();
  auto* const ids = Ids::FastDownCast(polygons->GetConnectivityArray());
  const vtkIdType size = polygons->GetNumberOfCells();
  if (!ids || surface->GetNumberOfVerts() + surface->GetNumberOfLines() > 0 ||
    polygons->IsHomogeneous() != 3 || ids->GetNumberOfValues() < 3 * size)
  {
    return false;
  }
  this->Triangles.resize(size);
  std::atomic<bool> areUsable{ true };
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      bool mine = true;
      for (vtkIdType t = begin; t < end; ++t)
      {
        const auto* const corners = ids->GetPointer(3 * t);
        mine = mine && this->IsUsable(corners);
        this->Triangles[t] = { static_cast<Index>(corners[0]), static_cast<Index>(corners[1]),
          static_cast<Index>(corners[2]) };
      }
      if (!mine)
      {
        areUsable = false;
      }
    });
  return areUsable;
}

//------------------------------------------------------------------------------
void TriangleMesh::ReadTriangles(vtkPolyData* surface)
{
  if (this->ReadAllTriangles<vtkAOSDataArrayTemplate<vtkTypeInt64>>(surface) ||
    this->ReadAllTriangles<vtkAOSDataArrayTemplate<vtkTypeInt32>>(surface))
  {
    return;
  }
  vtkCellArray* const polygons = surface->GetPolys();
  this->Triangles.clear();
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
}
