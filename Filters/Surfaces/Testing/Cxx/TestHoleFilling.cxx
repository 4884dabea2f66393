// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// A punctured sphere becomes whole; holes of any outline in a plane are covered exactly; what is no
// hole, or no small one, stays.
#include "nprAnalyticSurfaces.h"
#include "nprManifoldChecks.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkCellData.h>
#include <vtkIntArray.h>

#include <functional>

using namespace nprtest;

namespace
{
/// The mesh without the triangles whose centre is in some place. Its cells have numbers.
vtkSmartPointer<vtkPolyData> Puncture(
  vtkPolyData* mesh, const std::function<bool(const Vector3d&)>& isHole)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(mesh->GetPoints());
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (const Corners& corners : GetTriangles(mesh))
  {
    Vector3d centre = Vector3d::Zero();
    for (vtkIdType corner : corners)
    {
      Vector3d p;
      mesh->GetPoint(corner, p.data());
      centre += p / 3.0;
    }
    if (!isHole(centre))
    {
      numbers->InsertNextValue(static_cast<int>(cells->InsertNextCell(3, corners.data())));
    }
  }
  result->SetPolys(cells);
  result->GetCellData()->AddArray(numbers);
  return result;
}

Vector3d GetAreaVector(vtkPolyData* surface, const Corners& corners)
{
  Vector3d p[3];
  for (int i = 0; i < 3; ++i)
  {
    surface->GetPoint(corners[i], p[i].data());
  }
  return 0.5 * (p[1] - p[0]).cross(p[2] - p[0]);
}

double GetSmallestAngle(vtkPolyData* surface, const Corners& corners)
{
  double smallest = Pi;
  for (int i = 0; i < 3; ++i)
  {
    Vector3d p[3];
    for (int j = 0; j < 3; ++j)
    {
      surface->GetPoint(corners[(i + j) % 3], p[j].data());
    }
    smallest =
      std::min(smallest, std::acos((p[1] - p[0]).normalized().dot((p[2] - p[0]).normalized())));
  }
  return smallest;
}

//------------------------------------------------------------------------------
void TestSphere(Checks& check)
{
  // One triangle, a disk, and a long slot.
  const auto sphere = MakeOctasphere(2.0, 4);
  const Vector3d disk = Vector3d(1.0, 1.0, 1.0).normalized();
  int missing = 0;
  const auto mesh = Puncture(sphere,
    [&](const Vector3d& c)
    {
      const Vector3d n = c.normalized();
      const bool one = n.z() < -0.97 && missing == 0;
      const bool slot = n.y() < -0.8 && std::abs(n.x()) < 0.07;
      const bool hole = one || slot || n.dot(disk) > 0.96;
      missing += hole;
      return hole;
    });
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(mesh);
  preparation->SplitCreasesOff();
  preparation->Update();
  check(GetShape(preparation->GetOutput()).BoundaryEdges > 20 &&
      preparation->GetNumberOfFilledHoles() + preparation->GetNumberOfOpenHoles() == 0,
    "by default holes stay");

  preparation->SetFillHoles(4.0);
  preparation->Update();
  vtkPolyData* const output = preparation->GetOutput();
  std::cout << "sphere: " << preparation->GetReport() << "\n";
  const Shape shape = GetShape(output);
  check(shape.IsManifold() && shape.BoundaryEdges == 0 && shape.Disagreements == 0 &&
      shape.EulerCharacteristic == 2,
    "a sphere is closed again");
  check(preparation->GetNumberOfFilledHoles() >= 3 && preparation->GetNumberOfOpenHoles() == 0,
    "three holes, and more where they are pinched");
  const std::vector<Corners> triangles = GetTriangles(output);
  const auto first = static_cast<std::size_t>(mesh->GetNumberOfCells());
  check(
    static_cast<vtkIdType>(triangles.size() - first) == preparation->GetNumberOfFillingTriangles(),
    "what was added is counted");
  vtkDataArray* const numbers = output->GetCellData()->GetArray("Number");
  double smallest = Pi;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    Vector3d centre = Vector3d::Zero();
    for (vtkIdType corner : triangles[t])
    {
      Vector3d p;
      output->GetPoint(corner, p.data());
      centre += p / 3.0;
    }
    const Vector3d area = GetAreaVector(output, triangles[t]);
    check(area.dot(centre) > 0.7 * area.norm() * centre.norm(), "no triangle is turned or upright",
      static_cast<double>(t));
    const auto number =
      static_cast<std::size_t>(numbers->GetComponent(static_cast<vtkIdType>(t), 0));
    if (t < first)
    {
      check(number == t, "cell data stay");
      continue;
    }
    smallest = std::min(smallest, GetSmallestAngle(output, triangles[t]));
    double nearest = 1e9;
    for (vtkIdType corner : triangles[number])
    {
      Vector3d p;
      output->GetPoint(corner, p.data());
      nearest = std::min(nearest, (p - centre).norm());
    }
    check(number < first && nearest < 1.0, "cell data come from beside the hole", nearest);
  }
  std::cout << "smallest angle " << smallest * 180.0 / Pi << "\n";
  check(smallest > 0.1, "fillings have no slivers", smallest);

  const vtkIdType all = preparation->GetNumberOfFilledHoles();
  preparation->SetFillHoles(0.5);
  preparation->Update();
  check(preparation->GetNumberOfFilledHoles() > 0 && preparation->GetNumberOfFilledHoles() < all &&
      GetShape(preparation->GetOutput()).BoundaryEdges > 20,
    "the short ones alone", static_cast<double>(preparation->GetNumberOfFilledHoles()));
}

//------------------------------------------------------------------------------
void TestInsideOut(Checks& check)
{
  // An open surface keeps its side, but this one is closed in the end, and then has an outside.
  auto mesh = Puncture(MakeOctasphere(1.0, 3), [](const Vector3d& c) { return c.z() > 0.95; });
  vtkNew<vtkCellArray> cells;
  for (const Corners& corners : GetTriangles(mesh))
  {
    const vtkIdType turned[3] = { corners[0], corners[2], corners[1] };
    cells->InsertNextCell(3, turned);
  }
  mesh->SetPolys(cells);
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(mesh);
  preparation->SetFillHoles(3.0);
  preparation->Update();
  vtkPolyData* const output = preparation->GetOutput();
  check(preparation->GetNumberOfReorientedTriangles() == mesh->GetNumberOfCells(),
    "what fills it is not counted as turned",
    static_cast<double>(preparation->GetNumberOfReorientedTriangles()));
  for (const Corners& corners : GetTriangles(output))
  {
    Vector3d p;
    output->GetPoint(corners[0], p.data());
    check(GetAreaVector(output, corners).dot(p) > 0.0, "a closed surface looks out");
  }
}

//------------------------------------------------------------------------------
void TestPlane(Checks& check)
{
  // A star with deep bays: whatever its outline, exactly the hole is covered, and nothing twice.
  const AnalyticSurface plane =
    MakeSurface({ [](double x, double y) { return MakeHeightTruth(x, y, HeightJet{}); },
                  { -1.0, 1.0, -1.0, 1.0 } },
      40, 40);
  const auto mesh = Puncture(plane.Mesh,
    [](const Vector3d& p)
    { return p.norm() < 0.45 + 0.3 * std::cos(3.0 * std::atan2(p.y(), p.x())); });
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(mesh);
  preparation->SetFillHoles(20.0);
  preparation->Update();
  vtkPolyData* const output = preparation->GetOutput();
  std::cout << "plane: " << preparation->GetReport() << "\n";
  const Shape shape = GetShape(output);
  check(shape.IsManifold() && shape.BoundaryEdges == 160 && shape.EulerCharacteristic == 1,
    "only the outline is left", static_cast<double>(shape.BoundaryEdges));
  check(preparation->GetNumberOfFilledHoles() == 1 && preparation->GetNumberOfOpenHoles() == 1,
    "the outline of a sheet is no hole");
  double area = 0.0;
  for (const Corners& corners : GetTriangles(output))
  {
    const Vector3d vector = GetAreaVector(output, corners);
    check(vector.z() > 0.0, "all triangles look up");
    area += vector.norm();
  }
  check(std::abs(area - 4.0) < 1e-6, "the plane is covered once", area);
}

//------------------------------------------------------------------------------
void TestNoHoles(Checks& check)
{
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetFillHoles(100.0);
  preparation->SplitCreasesOff();
  const auto expect = [&](const char* what, vtkPolyData* mesh, vtkIdType filled, vtkIdType open)
  {
    const vtkIdType before = mesh->GetNumberOfCells();
    preparation->SetInputData(mesh);
    preparation->Update();
    const bool same = preparation->GetNumberOfFilledHoles() == filled &&
      preparation->GetNumberOfOpenHoles() == open &&
      (filled > 0 || preparation->GetOutput()->GetNumberOfCells() == before);
    check(same, std::string(what) + ": " + preparation->GetReport());
  };
  expect(
    "a triangle alone", MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }), 0, 1);
  // An open box is a hole of a fifth of its area, and bent sharply all round.
  const std::vector<std::array<double, 3>> box = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const std::vector<Corners> open = { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 }, { 3, 0, 4 }, { 3, 4, 7 } };
  expect("an open box", MakeMesh(box, open), 1, 0);
  check(GetShape(preparation->GetOutput()).Disagreements == 0, "the lid looks out");
  // Splitting cuts it off, which is no hole either.
  auto fin = open;
  fin.insert(fin.end(), { { 4, 5, 6 }, { 4, 6, 7 }, { 4, 8, 6 } });
  auto points = box;
  points.push_back({ 0.5, 0.5, 2.0 });
  expect("a fin on a box", MakeMesh(points, fin), 0, 0);
  // The lid of a bowl is more than half of what it closes.
  expect("a bowl", Puncture(MakeOctasphere(1.0, 4), [](const Vector3d& c) { return c.z() < 0.26; }),
    0, 1);
  // The shorter diagonal of the hole is an edge already, of a closed thing that stands on it.
  preparation->SetFillHoles(4.0);
  preparation->SplitNonManifoldOff();
  const std::vector<std::array<double, 3>> frame = { { 1, 0, 0 }, { 0, 1.2, 0 }, { -1, 0, 0 },
    { 0, -1.2, 0 }, { 9, 0, 0 }, { 0, 9, 0 }, { -9, 0, 0 }, { 0, -9, 0 }, { 0, 0.1, 1 },
    { 0, -0.1, 1 } };
  expect("a thing on a diagonal",
    MakeMesh(frame,
      { { 0, 4, 5 }, { 0, 5, 1 }, { 1, 5, 6 }, { 1, 6, 2 }, { 2, 6, 7 }, { 2, 7, 3 }, { 3, 7, 4 },
        { 3, 4, 0 }, { 0, 8, 2 }, { 0, 2, 9 }, { 0, 9, 8 }, { 2, 8, 9 } }),
    1, 0);
  check(GetShape(preparation->GetOutput()).NonManifoldEdges == 0, "the other one is taken");
  preparation->SetFillHoles(100.0);
  preparation->SplitNonManifoldOn();
  // Borders of more edges than the time allows.
  AnalyticSurface tube = MakeCylinder(1.0, 4.0, 500, 3);
  expect("a fine tube", tube.Mesh, 0, 2);
  expect("a coarse tube", MakeCylinder(1.0, 4.0, 50, 3).Mesh, 2, 0);
  check(GetShape(preparation->GetOutput()).EulerCharacteristic >= 2, "a can");
}
}

int TestHoleFilling(int, char*[])
{
  Checks check;
  TestSphere(check);
  TestInsideOut(check);
  TestPlane(check);
  TestNoHoles(check);
  return check.GetResult();
}
