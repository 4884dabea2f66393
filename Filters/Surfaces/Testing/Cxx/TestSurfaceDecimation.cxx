// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Targets are met, bounds hold, the topology and borders stay, triangles are small where it bends.
#include "nprPointValues.h"
#include "nprRemeshing.h"
#include "vtkNPRSurfaceDecimation.h"

#include <vtkCellLocator.h>
#include <vtkGenericCell.h>
#include <vtkQuadricDecimation.h>

#include <utility>

using namespace nprtest;

namespace
{
/// Root mean square and maximum, of points from a surface.
std::pair<double, double> GetDistances(vtkPolyData* points, vtkPolyData* surface)
{
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  double largest = 0.0;
  double sum = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double closest[3];
    vtkIdType id;
    int part;
    double squared;
    locator->FindClosestPoint(points->GetPoint(i), closest, cell, id, part, squared);
    largest = std::max(largest, squared);
    sum += squared;
  }
  return { std::sqrt(sum / points->GetNumberOfPoints()), std::sqrt(largest) };
}

void TestTarget(Checks& check)
{
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere(1.0, 5);
  AddArrays(sphere);
  AddShapeArrays(sphere);
  vtkNew<vtkNPRSurfaceDecimation> decimation;
  decimation->SetInputData(sphere);
  for (double reduction : { 0.5, 0.9, 0.97 })
  {
    decimation->SetTargetReduction(reduction);
    decimation->Update();
    vtkPolyData* output = decimation->GetOutput();
    const double wanted = (1.0 - reduction) * sphere->GetNumberOfCells();
    check(std::abs(output->GetNumberOfCells() - wanted) <= 2, "the target is met",
      output->GetNumberOfCells());
    const Topology topology = GetTopology(output);
    check(topology.Euler == 2 && topology.Borders == 0 && topology.Bad == 0, "still a sphere");
    const double angle = GetSmallestAngle(output);
    const double error =
      GetLargestDistance(output, [](const Vector3d& p) { return p.norm() - 1.0; });
    // A regular triangle with its corners on the sphere has the area A and the sag s with
    // A = 3 sqrt(3) / 4 * 2 s.
    const double ideal = 4.0 * Pi / wanted / (1.5 * std::sqrt(3.0));
    std::cout << "sphere to " << output->GetNumberOfCells() << ": smallest angle " << angle
              << ", distance " << error << ", of regular triangles " << ideal << "\n";
    check(angle >= 9.999, "angles are bounded", angle);
    check(error < 5.0 * ideal, "the shape stays", error);
    std::vector<bool> isTaken(sphere->GetNumberOfPoints(), false);
    double farthest = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const auto number = static_cast<vtkIdType>(GetValue(output, "PointNumbers", i));
      check(number >= 0 && number < sphere->GetNumberOfPoints() && !isTaken[number],
        "numbers are not mixed, and come from different points", number);
      isTaken[number] = true;
      farthest =
        std::max(farthest, (GetTuple<3>(output, "Coordinates", i) - GetPoint(output, i)).norm());
    }
    // Both are within the triangles that met at what is now one point.
    check(farthest < std::sqrt(16.0 * Pi / wanted), "points bring their arrays", farthest);
    vtkDataArray* cells = output->GetCellData()->GetArray("CellNumbers");
    check(cells && cells->GetNumberOfTuples() == output->GetNumberOfCells() &&
        cells->GetRange()[1] < sphere->GetNumberOfCells(),
      "so do triangles");
    check(!output->GetPointData()->GetNormals() &&
        !output->GetPointData()->HasArray(npr::names::PrincipalCurvature1) &&
        sphere->GetPointData()->HasArray(npr::names::PrincipalCurvature1) &&
        !output->GetFieldData()->HasArray(npr::names::NeighbourhoodRadius) &&
        sphere->GetFieldData()->HasArray(npr::names::NeighbourhoodRadius),
      "what describes the shape is dropped, as points have moved");
  }
  decimation->SetTargetReduction(0.0);
  decimation->Update();
  check(decimation->GetOutput()->GetPointData()->GetNormals() &&
      decimation->GetOutput()->GetNumberOfCells() == sphere->GetNumberOfCells(),
    "nothing to do, nothing lost");
  decimation->SetTargetNumberOfTriangles(1000);
  decimation->Update();
  check(std::abs(decimation->GetOutput()->GetNumberOfCells() - 1000) <= 2, "a number as target");
  const vtkIdType reference = decimation->GetOutput()->GetNumberOfPoints();

  decimation->SetInputData(Transform(sphere, 1e-9, Vector3d::Zero()));
  decimation->Update();
  check(decimation->GetOutput()->GetNumberOfPoints() == reference, "small units");
  decimation->SetInputData(Transform(sphere, 1.0, Vector3d(1e8, 1e8, -1e8)));
  decimation->Update();
  check(decimation->GetOutput()->GetNumberOfPoints() == reference, "far away");
  check(GetSmallestAngle(decimation->GetOutput()) > 9.999, "as good there");

  decimation->SetInputData(sphere);
  decimation->SetTargetNumberOfTriangles(0);
  decimation->SetMinimumAngle(30.0);
  decimation->Update();
  check(GetSmallestAngle(decimation->GetOutput()) > 29.999, "the bound of angles goes before");
}

/// VTK's filter moves points, too, and knows no bounds.
void TestOracle(Checks& check)
{
  vtkSmartPointer<vtkPolyData> torus = MakeTorus(1.0, 0.4, 120, 60).Mesh;
  vtkSmartPointer<vtkPolyData> scan = Copy(torus);
  Shake(scan, 0.003);
  for (vtkPolyData* surface : { torus.Get(), scan.Get() })
  {
    vtkNew<vtkNPRSurfaceDecimation> decimation;
    decimation->SetInputData(surface);
    decimation->Update();
    vtkPolyData* output = decimation->GetOutput();
    vtkNew<vtkQuadricDecimation> quadric;
    quadric->SetInputData(surface);
    quadric->SetTargetReduction(0.9);
    quadric->Update();
    check(std::abs(output->GetNumberOfCells() - quadric->GetOutput()->GetNumberOfCells()) <= 4,
      "as many triangles");
    const auto ours = GetDistances(surface, output);
    const auto theirs = GetDistances(surface, quadric->GetOutput());
    const auto back = GetDistances(output, surface);
    std::cout << "torus to " << output->GetNumberOfCells() << ": RMS distance " << ours.first
              << ", of vtkQuadricDecimation " << theirs.first << "; largest " << ours.second << ", "
              << theirs.second << "; back " << back.first << "; smallest angle "
              << GetSmallestAngle(output) << ", " << GetSmallestAngle(quadric->GetOutput()) << "\n";
    check(ours.first < 1.25 * theirs.first, "about as near as VTK's", ours.first / theirs.first);
    check(ours.second < 1.6 * theirs.second, "everywhere", ours.second / theirs.second);
    check(back.first < 1.5 * ours.first, "no new point is far away", back.first / ours.first);
    check(GetSmallestAngle(output) > 9.999, "angles are bounded", GetSmallestAngle(output));
  }
}

void TestMaximumError(Checks& check)
{
  vtkSmartPointer<vtkPolyData> torus = MakeTorus(1.0, 0.4, 80, 40).Mesh;
  vtkNew<vtkNPRSurfaceDecimation> decimation;
  decimation->SetInputData(torus);
  decimation->SetTargetReduction(1.0);
  const double lengthScale = npr::TriangleMesh(torus).ComputeLengthScale();
  vtkIdType last = torus->GetNumberOfCells();
  for (double bound : { 0.002, 0.01, 0.05 })
  {
    decimation->SetMaximumError(bound);
    decimation->Update();
    vtkPolyData* output = decimation->GetOutput();
    const double largest = GetDistances(torus, output).second / lengthScale;
    std::cout << "torus, error " << bound << ": " << output->GetNumberOfCells()
              << " triangles, farthest point " << largest << "\n";
    check(largest <= bound, "no point is farther", largest);
    check(largest > 0.5 * bound, "the bound is used", largest);
    check(output->GetNumberOfCells() < 0.7 * last, "the looser the bound, the fewer");
    last = output->GetNumberOfCells();
    const Topology topology = GetTopology(output);
    check(topology.Euler == 0 && topology.Borders == 0, "still a torus");
  }
}

void TestFlat(Checks& check)
{
  // A square with a hill in its middle. Flat, it is the four corners of its border that count.
  for (double height : { 0.0, 0.3 })
  {
    const auto at = [=](double x, double y)
    {
      Truth truth;
      truth.Point = { x, y, height * std::exp(-20.0 * (x * x + y * y)) };
      return truth;
    };
    const vtkSmartPointer<vtkPolyData> square =
      MakeSurface({ at, { -1.0, 1.0, -1.0, 1.0 } }, 80, 80).Mesh;
    vtkNew<vtkNPRSurfaceDecimation> decimation;
    decimation->SetInputData(square);
    decimation->SetTargetReduction(0.95);
    decimation->Update();
    vtkPolyData* output = decimation->GetOutput();
    double bounds[6];
    output->GetPoints()->GetBounds(bounds);
    check(bounds[0] == -1.0 && bounds[1] == 1.0 && bounds[2] == -1.0 && bounds[3] == 1.0,
      "corners of a border stay");
    check(GetTopology(output).Euler == 1, "still a disk");
    check(GetSmallestAngle(output) > 9.999, "angles are bounded", GetSmallestAngle(output));
    if (height == 0.0)
    {
      check(std::abs(GetArea(output) - 4.0) < 1e-12, "and the border's edges", GetArea(output));
      check(output->GetNumberOfCells() <= 642, "what is flat can go", output->GetNumberOfCells());
      continue;
    }
    double areas[2] = { 0.0, 0.0 }; // in the projection: on the hill, and beside it
    int counts[2] = { 0, 0 };
    ForTriangles(output,
      [&](vtkIdType a, vtkIdType b, vtkIdType c)
      {
        const Vector3d p = GetPoint(output, a);
        const Vector3d u = GetPoint(output, b) - p;
        const Vector3d v = GetPoint(output, c) - p;
        const Vector3d middle = p + (u + v) / 3.0;
        const int where = std::hypot(middle.x(), middle.y()) < 0.4 ? 0 : 1;
        areas[where] += 0.5 * (u.x() * v.y() - u.y() * v.x());
        ++counts[where];
      });
    const double ratio = areas[1] / counts[1] / (areas[0] / counts[0]);
    std::cout << "hill: triangles are larger beside it by " << ratio << "\n";
    check(ratio > 10.0, "large where it is flat", ratio);
    check(std::abs(areas[0] + areas[1] - 4.0) < 1e-12, "nothing is lost", areas[0] + areas[1]);
  }
}

void TestCreases(Checks& check)
{
  vtkSmartPointer<vtkPolyData> can = MakeCylinder(1.0, 2.0, 60, 40).Mesh;
  vtkSmartPointer<vtkPolyData> caps = MakeCan(1.0, 2.0, 60);
  // The wall of the one, the caps of the other.
  vtkNew<vtkPolyData> solid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  const auto append = [&](vtkPolyData* mesh, bool isCap)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(mesh->GetPoint(i));
    }
    ForTriangles(mesh,
      [&](vtkIdType a, vtkIdType b, vtkIdType c)
      {
        if (!isCap || c >= 120)
        {
          const vtkIdType ids[3] = { first + a, first + b, first + c };
          cells->InsertNextCell(3, ids);
        }
      });
  };
  append(can, false);
  append(caps, true);
  solid->SetPoints(points);
  solid->SetPolys(cells);
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(solid);
  preparation->SetWeldTolerance(1e-9); // the two were computed by other formulas
  preparation->Update();
  vtkPolyData* const patches = preparation->GetOutput();
  check(preparation->GetNumberOfCreaseEdges() == 120, "there are two creases");
  vtkNew<vtkNPRSurfaceDecimation> decimation;
  decimation->SetInputData(patches);
  decimation->SetTargetReduction(0.8);
  decimation->Update();
  vtkPolyData* output = decimation->GetOutput();
  check(output->GetNumberOfCells() < patches->GetNumberOfCells() / 3, "between creases points go",
    output->GetNumberOfCells());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto first = static_cast<vtkIdType>(GetValue(output, npr::names::WeldedPointIds, i));
    check(first >= 0 && first <= i && GetPoint(output, i) == GetPoint(output, first),
      "copies know their first");
  }
  const Topology welded = GetTopology(Prepare(output, false));
  check(welded.Euler == 2 && welded.Borders == 0 && welded.Bad == 0, "the solid stays watertight",
    welded.Borders);
}
}

int TestSurfaceDecimation(int, char*[])
{
  Checks check;
  TestTarget(check);
  TestOracle(check);
  TestMaximumError(check);
  TestFlat(check);
  TestCreases(check);
  vtkNew<vtkNPRSurfaceDecimation> decimation;
  TestObstacles(check, decimation);
  return check.GetResult();
}
