// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts and results on messes made by hand; creases of a cube; noise that must not be split.
#include "nprAnalyticSurfaces.h"
#include "nprArrayNames.h"
#include "nprPointValues.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkSMPTools.h>

#include <limits>

using namespace nprtest;

namespace
{
vtkIdType Insert(vtkCellArray* cells, const std::vector<vtkIdType>& points)
{
  return cells->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
}

/// One polygon mesh with everything wrong with it once.
void TestMess(Checks& check)
{
  const double NaN = std::numeric_limits<double>::quiet_NaN();
  const double coordinates[][3] = {
    { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, // 0-3: a quad
    { 1, 0, -0.0 }, { 2, 0, 0 }, { 2, 1, 0 },
    { 1, 1, 0 },                               // 4-7: the next, 4 and 7 doubling 1 and 2
    { 2, 2, 0 }, { 1, 2, 0 }, { 0.5, 2.5, 0 }, // 8-10: a pentagon's
    { NaN, 0, 0 }, { 5, 5, 5 },                // 11: no number; 12: of a vertex
    { 3, 0, 0 }, { 3, 1, 0 },                  // 13, 14: a strip's
    { 3, 0.5, 0 }, { 4, 0, 0 },                // 15, 16: with a T-junction at 15
    { 4, 1, 0 }, { 7, 7, 7 }                   // 17; 18: unused
  };
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> pointNumbers;
  pointNumbers->SetName("PointNumbers");
  for (const auto& c : coordinates)
  {
    pointNumbers->InsertNextValue(static_cast<int>(points->InsertNextPoint(c)));
  }
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> strips;
  Insert(vertices, { 12 });
  Insert(lines, { 0, 12 });
  Insert(polygons, { 0, 1, 2, 3 });    // cell 2: two triangles
  Insert(polygons, { 4, 7, 6, 5 });    // cell 3: turned over, two triangles
  Insert(polygons, { 3, 2, 6, 8, 9 }); // cell 4: three triangles
  Insert(polygons, { 0, 1, 11 });      // cell 5: no number
  Insert(polygons, { 1, 4, 3 });       // cell 6: degenerate once welded
  Insert(polygons, { 6, 14, 8 });      // cell 7
  Insert(polygons, { 14, 6, 8 });      // cell 8: cell 7 again
  Insert(polygons, { 13, 15, 14 });    // cell 9: a needle that closes a T-junction
  Insert(polygons, { 13, 16, 15 });    // cell 10
  Insert(polygons, { 15, 16, 17 });    // cell 11
  Insert(polygons, { 15, 17, 14 });    // cell 12
  Insert(strips, { 5, 13, 6, 14 });    // cell 13: two triangles
  mesh->SetPoints(points);
  mesh->SetVerts(vertices);
  mesh->SetLines(lines);
  mesh->SetPolys(polygons);
  mesh->SetStrips(strips);
  mesh->GetPointData()->AddArray(pointNumbers);
  vtkNew<vtkIntArray> cellNumbers;
  cellNumbers->SetName("CellNumbers");
  for (int i = 0; i < 14; ++i)
  {
    cellNumbers->InsertNextValue(i);
  }
  mesh->GetCellData()->AddArray(cellNumbers);

  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(mesh);
  preparation->Update();
  vtkPolyData* output = preparation->GetOutput();
  std::cout << preparation->GetReport() << "\n";
  check(preparation->GetNumberOfDroppedCells() == 2, "dropped cells",
    preparation->GetNumberOfDroppedCells());
  check(preparation->GetNumberOfTriangulatedCells() == 4, "triangulated",
    preparation->GetNumberOfTriangulatedCells());
  check(preparation->GetNumberOfNonFiniteTriangles() == 1, "not finite",
    preparation->GetNumberOfNonFiniteTriangles());
  check(
    preparation->GetNumberOfWeldedPoints() == 2, "welded", preparation->GetNumberOfWeldedPoints());
  check(preparation->GetNumberOfUnusedPoints() == 4, "unused: 10, 11, 12, 18",
    preparation->GetNumberOfUnusedPoints());
  check(preparation->GetNumberOfDegenerateTriangles() == 1, "degenerate",
    preparation->GetNumberOfDegenerateTriangles());
  check(preparation->GetNumberOfDuplicateTriangles() == 1, "duplicate",
    preparation->GetNumberOfDuplicateTriangles());
  check(preparation->GetNumberOfFlippedNeedles() == 1, "needles",
    preparation->GetNumberOfFlippedNeedles());
  check(preparation->GetNumberOfReorientedTriangles() == 2, "reoriented",
    preparation->GetNumberOfReorientedTriangles());
  check(preparation->GetNumberOfNonManifoldEdges() == 0, "non-manifold edges",
    preparation->GetNumberOfNonManifoldEdges());
  check(preparation->GetNumberOfSplitPoints() == 0, "split points",
    preparation->GetNumberOfSplitPoints());
  check(output->GetNumberOfCells() == 2 + 2 + 3 + 1 + 1 + 3 + 2, "triangles",
    output->GetNumberOfCells());
  check(output->GetNumberOfPoints() == 13, "points", output->GetNumberOfPoints());

  // All lie flat and look up, cover what they covered, and have kept their numbers.
  npr::TriangleMesh triangles(output);
  double area = 0.0;
  for (npr::TriangleMesh::Index t = 0; t < triangles.GetNumberOfTriangles(); ++t)
  {
    const Vector3d normal = triangles.GetAreaNormal(t).cast<double>();
    check(normal.z() > 0.0, "all look the same way");
    area += 0.5 * normal.norm();
  }
  check(std::abs(area - (1.0 + 1.0 + 1.5 + 0.5 + 1.0 + 1.0)) < 1e-5, "the area stays", area);
  vtkDataArray* numbers = output->GetPointData()->GetArray("PointNumbers");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    const double* expected = coordinates[static_cast<int>(numbers->GetComponent(i, 0))];
    check(p[0] == expected[0] && p[1] == expected[1], "point arrays go with their points");
    check(GetValue(output, npr::names::WeldedPointIds, i) == i, "no copies");
  }
  vtkDataArray* cellArray = output->GetCellData()->GetArray("CellNumbers");
  std::vector<int> perCell(14, 0);
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    ++perCell[static_cast<int>(cellArray->GetComponent(c, 0))];
  }
  check(perCell == std::vector<int>({ 0, 0, 2, 2, 3, 0, 0, 1, 0, 0, 1, 1, 1, 2 }) ||
      perCell == std::vector<int>({ 0, 0, 2, 2, 3, 0, 0, 1, 0, 0, 1, 1, 1, 3 }),
    "cell arrays go with their cells");
}

void TestCube(Checks& check)
{
  vtkSmartPointer<vtkPolyData> cube = MakeCube();
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(cube);
  preparation->Update();
  vtkPolyData* output = preparation->GetOutput();
  check(output->GetNumberOfPoints() == 24, "a cube has six patches", output->GetNumberOfPoints());
  check(preparation->GetNumberOfCreaseEdges() == 12, "and twelve creases");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const vtkIdType first = static_cast<vtkIdType>(GetValue(output, npr::names::WeldedPointIds, i));
    double a[3];
    double b[3];
    output->GetPoint(i, a);
    output->GetPoint(first, b);
    check(first <= i && first < 8 && a[0] == b[0] && a[1] == b[1] && a[2] == b[2],
      "copies know their first");
  }
  check(output->GetFieldData()->HasArray(npr::names::LengthScale), "the length scale is written");

  preparation->SetCreaseAngle(95.0);
  preparation->Update();
  check(output->GetNumberOfPoints() == 8, "at more than its angle it is one patch");
  preparation->SetCreaseAngle(40.0);
  preparation->SplitCreasesOff();
  preparation->Update();
  check(output->GetNumberOfPoints() == 8 &&
      output->GetPointData()->HasArray(npr::names::WeldedPointIds),
    "without splitting it is one patch");
}

void TestSmallCreases(Checks& check)
{
  // The fewest edges that still are creases: a tetrahedron, and one fold from border to border.
  const double corners[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  for (bool closed : { true, false })
  {
    vtkNew<vtkPolyData> mesh;
    vtkNew<vtkPoints> points;
    for (const auto& corner : corners)
    {
      points->InsertNextPoint(corner);
    }
    vtkNew<vtkCellArray> cells;
    Insert(cells, { 0, 2, 1 });
    Insert(cells, { 0, 1, 3 });
    if (closed)
    {
      Insert(cells, { 0, 3, 2 });
      Insert(cells, { 1, 2, 3 });
    }
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    vtkNew<vtkNPRSurfacePreparation> preparation;
    preparation->SetInputData(mesh);
    preparation->Update();
    check(preparation->GetOutput()->GetNumberOfPoints() == (closed ? 12 : 6), "small creases split",
      preparation->GetOutput()->GetNumberOfPoints());
  }
}

void TestOrientation(Checks& check)
{
  // Every other triangle of a closed surface turned over, welded from a soup.
  vtkSmartPointer<vtkPolyData> sphere = MakeOctasphere(1.0, 3);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  const vtkIdType size = sphere->GetNumberOfCells();
  for (vtkIdType c = 0; c < size; ++c)
  {
    sphere->GetPolys()->GetCellAtId(c, ids);
    const bool turned = c % 3 != 0;
    Insert(cells, { ids->GetId(0), ids->GetId(turned ? 2 : 1), ids->GetId(turned ? 1 : 2) });
  }
  sphere->SetPolys(cells);
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(sphere);
  preparation->Update();
  vtkPolyData* output = preparation->GetOutput();
  check(output->GetNumberOfPoints() == size / 2 + 2, "a soup becomes one surface",
    output->GetNumberOfPoints());
  check(preparation->GetNumberOfSplitPoints() == 0, "a sphere is not split");
  check(preparation->GetNumberOfReorientedTriangles() == size - (size + 2) / 3, "turned triangles");
  npr::TriangleMesh mesh(output);
  for (npr::TriangleMesh::Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    check(
      mesh.GetAreaNormal(t).dot(mesh.GetPoint(mesh.GetTriangle(t)[0])) > 0.0f, "all look outward");
  }
}

void TestTolerance(Checks& check)
{
  // The corners of a soup of a sphere's triangles, each off by less than the tolerance.
  vtkSmartPointer<vtkPolyData> sphere = MakeOctasphere(1.0, 3);
  const vtkIdType size = sphere->GetNumberOfCells();
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    double p[3];
    sphere->GetPoint(i, p);
    for (double& c : p)
    {
      random->Next();
      c += 1e-4 * random->GetValue();
    }
    sphere->GetPoints()->SetPoint(i, p);
  }
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(sphere);
  preparation->SplitCreasesOff();
  preparation->Update();
  check(
    preparation->GetOutput()->GetNumberOfPoints() > size, "without a tolerance it stays a soup");
  preparation->SetWeldTolerance(3e-4);
  preparation->Update();
  check(preparation->GetOutput()->GetNumberOfPoints() == size / 2 + 2, "with one it is welded",
    preparation->GetOutput()->GetNumberOfPoints());
}

void TestNoise(Checks& check)
{
  // Noise of a fifth of the edge length along the normal: dihedral angles of 40 degrees and more
  // here and there, but no crease.
  AnalyticSurface torus = MakeTorus(1.0, 0.4, 160, 80);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (vtkIdType i = 0; i < torus.Mesh->GetNumberOfPoints(); ++i)
  {
    random->Next();
    const Vector3d p =
      torus.Truths[i].Point + 0.006 * (2.0 * random->GetValue() - 1.0) * torus.Truths[i].Normal;
    torus.Mesh->GetPoints()->SetPoint(i, p.data());
  }
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(torus.Mesh);
  preparation->Update();
  std::cout << "noise: " << preparation->GetReport() << "\n";
  check(preparation->GetNumberOfSplitPoints() * 500 < torus.Mesh->GetNumberOfPoints(),
    "a noisy scan is not shattered", preparation->GetNumberOfSplitPoints());
}
}

int TestSurfacePreparation(int, char*[])
{
  Checks check;
  TestMess(check);
  TestCube(check);
  TestSmallCreases(check);
  TestOrientation(check);
  TestTolerance(check);
  TestNoise(check);
  return check.GetResult();
}
