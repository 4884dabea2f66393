// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Adjacency, edges and the length scale of small meshes whose answers are known by hand.
#include "nprLengthScale.h"
#include "nprTriangleArea.h"
#include "nprTriangleMesh.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <iostream>
#include <limits>

namespace
{
int failures = 0;

void Check(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++failures;
  }
}

/// A unit square in four triangles around its centre (point 4), and a fin on one spoke.
void MakeSquare(vtkPolyData* surface, bool withFin)
{
  const double far = 1e6;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double corners[6][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 0.5, 0.5, 0 }, { 0.5, 0.5, 1 } };
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner[0] + far, corner[1], corner[2]);
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const vtkIdType triangle[3] = { i, (i + 1) % 4, 4 };
    cells->InsertNextCell(3, triangle);
  }
  if (withFin)
  {
    const vtkIdType fin[3] = { 0, 4, 5 };
    cells->InsertNextCell(3, fin);
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
}

void TestAdjacency()
{
  using npr::TriangleMesh;
  vtkNew<vtkPolyData> surface;
  MakeSquare(surface, false);
  TriangleMesh mesh(surface);
  mesh.BuildNeighbours();
  mesh.BuildEdges();
  Check(mesh.GetNumberOfTriangles() == 4, "four triangles");
  Check(mesh.GetNeighbour(0, 0) == TriangleMesh::Boundary, "the outer edge is a boundary");
  Check(mesh.GetNeighbour(0, 1) == 1 && mesh.GetNeighbour(0, 2) == 3, "the neighbours around");
  Check(mesh.GetNumberOfIncident(4) == 4 && mesh.GetNumberOfIncident(5) == 0, "incidence");
  Check(!mesh.IsBorderPoint(4) && mesh.IsBorderPoint(0), "border points");
  Check(mesh.GetNumberOfEdges() == 8, "eight edges");
  for (TriangleMesh::Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const auto ends = mesh.GetEdge(e);
    Check(ends[0] < ends[1] && mesh.FindEdge(ends[1], ends[0]) == e, "edges are found either way");
    Check(mesh.CountTrianglesAtEdge(ends[0], ends[1]) == (ends[1] == 4 ? 2 : 1), "edge counts");
  }
  mesh.Flip(0);
  Check(mesh.GetTriangle(0) == TriangleMesh::Triangle{ 0, 4, 1 }, "a flip swaps two corners");
  Check(mesh.GetNeighbour(0, 0) == 3 && mesh.GetNeighbour(0, 1) == 1 &&
      mesh.GetNeighbour(0, 2) == TriangleMesh::Boundary,
    "a flip moves the neighbours along");

  MakeSquare(surface, true);
  TriangleMesh fin(surface);
  fin.BuildNeighbours();
  Check(fin.GetNeighbour(0, 2) == TriangleMesh::NonManifold, "three triangles at an edge");
  Check(fin.IsBorderPoint(4), "a point at a non-manifold edge is on a border");
}

void TestBadTriangles()
{
  vtkNew<vtkPolyData> surface;
  MakeSquare(surface, true);
  vtkNew<vtkCellArray> cells;
  const vtkIdType bad[4][3] = { { 0, 0, 1 }, { 0, 1, 99 }, { -1, 1, 2 }, { 0, 4, 5 } };
  for (const auto& triangle : bad)
  {
    cells->InsertNextCell(3, triangle);
  }
  const vtkIdType good[3] = { 0, 1, 2 };
  cells->InsertNextCell(3, good);
  surface->SetPolys(cells);
  surface->GetPoints()->SetPoint(5, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const npr::TriangleMesh mesh(surface);
  Check(mesh.GetNumberOfTriangles() == 1 && mesh.GetCellId(0) == 4, "bad triangles are left out");
}

/// A point that no triangle uses, however far, takes no digits from the others.
void TestStrayPoints()
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double stray : { -1e9, infinity, std::numeric_limits<double>::quiet_NaN() })
  {
    vtkNew<vtkPolyData> surface;
    MakeSquare(surface, false);
    surface->GetPoints()->InsertNextPoint(stray, stray, stray);
    const npr::TriangleMesh mesh(surface);
    const Eigen::Vector3f edge = mesh.GetPoint(1) - mesh.GetPoint(0);
    Check((edge - Eigen::Vector3f(1.0f, 0.0f, 0.0f)).norm() < 1e-6f, "no digits are lost");
  }
}

/// Corners on a line, to single precision, have no area; one triangle, or one of a fan or strip, is
/// enough.
void TestArea()
{
  const auto hasArea = [](bool isStrip, std::initializer_list<std::array<double, 3>> corners)
  {
    vtkNew<vtkPolyData> surface;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const auto& corner : corners)
    {
      cells->InsertCellPoint(points->InsertNextPoint(corner.data()));
    }
    surface->SetPoints(points);
    isStrip ? surface->SetStrips(cells) : surface->SetPolys(cells);
    return npr::HasArea(surface);
  };
  const double third = 1.0 / 3.0;
  for (const bool isStrip : { false, true })
  {
    Check(!hasArea(isStrip, { { 0, 0, 0 }, { third, third, third }, { 1, 1, 1 } }), "a line");
    Check(
      !hasArea(isStrip, { { 0, 0, 0 }, { 1, 1e-8, 0 }, { 2, 0, 0 } }), "a line but for rounding");
    Check(hasArea(isStrip, { { 0, 0, 0 }, { 1, 1e-6, 0 }, { 2, 0, 0 } }), "a needle");
    Check(hasArea(isStrip, { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 } }), "four corners");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Check(!hasArea(isStrip, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, nan, 0 } }), "what is no number");
  }
  vtkNew<vtkPolyData> empty;
  Check(!npr::HasArea(empty), "nothing has no area");
}

void TestLengthScale()
{
  vtkNew<vtkPolyData> surface;
  MakeSquare(surface, false);
  // Of a unit square the mean of (x - 1/2)^2 + (y - 1/2)^2 is 1/6.
  Check(std::abs(npr::GetLengthScale(surface) - std::sqrt(1.0 / 6.0)) < 1e-6, "a square's scale");
  npr::SetLengthScale(surface, 3.0);
  Check(npr::GetLengthScale(surface) == 3.0, "a given scale wins");
  npr::SetLengthScale(surface, std::numeric_limits<double>::quiet_NaN());
  Check(npr::GetLengthScale(surface) < 1.0, "a scale that is no number does not");
  vtkNew<vtkPolyData> empty;
  Check(npr::GetLengthScale(empty) == 0.0, "nothing has no scale");
}
}

int TestTriangleMesh(int, char*[])
{
  TestAdjacency();
  TestBadTriangles();
  TestStrayPoints();
  TestArea();
  TestLengthScale();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
