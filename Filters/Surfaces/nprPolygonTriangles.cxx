// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPolygonTriangles.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Vector3d;

//------------------------------------------------------------------------------
/// Adds triangles to the result, each after a check of its points.
class Collector
{
public:
  explicit Collector(const std::vector<Vector3d>& points) : Points(points) {}

  void Add(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell)
  {
    if (this->IsGood(a) && this->IsGood(b) && this->IsGood(c))
    {
      this->Result.Triangles.push_back(
        { static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c) });
      this->Result.Cells.push_back(cell);
    }
    else
    {
      ++this->Result.NumberOfBadTriangles;
    }
  }

  void AddQuad(const vtkIdType* corners, vtkIdType cell)
  {
    // The diagonal that leaves both triangles on the same side; of two such, the shorter one.
    const auto bend = [&](int first)
    {
      const Vector3d& a = this->Points[corners[first]];
      const Vector3d& b = this->Points[corners[(first + 1) % 4]];
      const Vector3d& c = this->Points[corners[(first + 2) % 4]];
      const Vector3d& d = this->Points[corners[(first + 3) % 4]];
      return (b - a).cross(c - a).dot((c - a).cross(d - a));
    };
    int first = 0;
    if (this->AreGood(4, corners))
    {
      const bool convex0 = bend(0) > 0.0;
      const bool convex1 = bend(1) > 0.0;
      const double length0 = (this->Points[corners[2]] - this->Points[corners[0]]).squaredNorm();
      const double length1 = (this->Points[corners[3]] - this->Points[corners[1]]).squaredNorm();
      first = convex0 != convex1 ? convex1 : length1 < length0;
    }
    for (int i : { first, first + 2 })
    {
      this->Add(corners[i % 4], corners[(i + 1) % 4], corners[(i + 2) % 4], cell);
    }
  }

  void AddPolygon(vtkIdType size, const vtkIdType* corners, vtkIdType cell)
  {
    if (!this->AreGood(size, corners))
    {
      this->Result.NumberOfBadTriangles += size - 2;
      return;
    }
    this->Polygon->PointIds->SetNumberOfIds(size);
    this->Polygon->Points->SetNumberOfPoints(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Polygon->PointIds->SetId(i, corners[i]);
      this->Polygon->Points->SetPoint(i, this->Points[corners[i]].data());
    }
    this->Polygon->Triangulate(0, this->Ids, this->Scratch);
    for (vtkIdType i = 0; i + 2 < this->Ids->GetNumberOfIds(); i += 3)
    {
      this->Add(this->Ids->GetId(i), this->Ids->GetId(i + 1), this->Ids->GetId(i + 2), cell);
    }
  }

  PolygonTriangles Result;

private:
  bool IsGood(vtkIdType point) const
  {
    return point >= 0 && point < static_cast<vtkIdType>(this->Points.size()) &&
      this->Points[point].allFinite();
  }
  bool AreGood(vtkIdType size, const vtkIdType* points) const
  {
    return std::all_of(
      points, points + size, [this](vtkIdType point) { return this->IsGood(point); });
  }

  const std::vector<Vector3d>& Points;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Ids;
  vtkNew<vtkPoints> Scratch;
};
}

//------------------------------------------------------------------------------
PolygonTriangles GetPolygonTriangles(vtkPolyData* input, const std::vector<Vector3d>& points)
{
  Collector collector(points);
  collector.Result.Triangles.reserve(input->GetNumberOfPolys());
  collector.Result.Cells.reserve(input->GetNumberOfPolys());
  vtkIdType cell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  vtkIdType size;
  const vtkIdType* corners;

  auto polygon = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (polygon->GoToFirstCell(); !polygon->IsDoneWithTraversal(); polygon->GoToNextCell(), ++cell)
  {
    polygon->GetCurrentCell(size, corners);
    if (size == 3)
    {
      collector.Add(corners[0], corners[1], corners[2], cell);
      continue;
    }
    if (size == 4)
    {
      collector.AddQuad(corners, cell);
    }
    else if (size > 4)
    {
      collector.AddPolygon(size, corners, cell);
    }
    ++collector.Result.NumberOfTriangulatedCells;
  }

  auto strip = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (strip->GoToFirstCell(); !strip->IsDoneWithTraversal(); strip->GoToNextCell(), ++cell)
  {
    strip->GetCurrentCell(size, corners);
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      // Every other triangle of a strip runs the other way.
      collector.Add(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2], cell);
    }
    ++collector.Result.NumberOfTriangulatedCells;
  }
  return std::move(collector.Result);
}
}
