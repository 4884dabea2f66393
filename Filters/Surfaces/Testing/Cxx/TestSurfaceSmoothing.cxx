// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Noise goes, triangles become more alike, what is fixed stays.
#include "nprPointValues.h"
#include "nprRemeshing.h"
#include "vtkNPRSurfaceSmoothing.h"

using namespace nprtest;

namespace
{
/// Root mean square of |p| - r, about its mean if r is 0.
double GetRadialError(vtkPolyData* mesh, double& mean)
{
  const vtkIdType size = mesh->GetNumberOfPoints();
  mean = 0.0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    mean += GetPoint(mesh, i).norm() / size;
  }
  double sum = 0.0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double d = GetPoint(mesh, i).norm() - mean;
    sum += d * d / size;
  }
  return std::sqrt(sum);
}

void TestNoise(Checks& check)
{
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere(1.0, 4);
  Shake(sphere, 0.01);
  double mean;
  const double before = GetRadialError(sphere, mean);
  vtkNew<vtkNPRSurfaceSmoothing> smoothing;
  smoothing->SetInputData(sphere);
  smoothing->SetNumberOfIterations(20);
  double means[2];
  for (int component :
    { vtkNPRSurfaceSmoothing::NORMAL, vtkNPRSurfaceSmoothing::TANGENTIAL_AND_NORMAL })
  {
    for (int continuity : { 0, 1 })
    {
      smoothing->SetComponent(component);
      smoothing->SetContinuity(continuity);
      smoothing->Update();
      const double after = GetRadialError(smoothing->GetOutput(), means[continuity]);
      std::cout << "component " << component << ", C" << continuity << ": noise " << before
                << " -> " << after << ", radius " << means[continuity] << "\n";
      if (continuity == 1)
      {
        check(after < 0.4 * before, "noise goes", after / before);
        check(std::abs(means[1] - 1.0) < 0.01, "the size stays", means[1]);
      }
    }
    check(std::abs(means[1] - 1.0) < std::abs(means[0] - 1.0), "C1 keeps the size better");
  }

  // The same far away and for other units.
  smoothing->Update();
  const vtkSmartPointer<vtkPolyData> reference = Copy(smoothing->GetOutput());
  const double scales[] = { 1e-9, 1e9, 1.0 };
  const Vector3d offsets[] = { Vector3d::Zero(), Vector3d::Zero(), Vector3d(1e8, -1e8, 1e8) };
  for (int i = 0; i < 3; ++i)
  {
    smoothing->SetInputData(Transform(sphere, scales[i], offsets[i]));
    smoothing->Update();
    double largest = 0.0;
    for (vtkIdType p = 0; p < reference->GetNumberOfPoints(); ++p)
    {
      const Vector3d back = (GetPoint(smoothing->GetOutput(), p) - offsets[i]) / scales[i];
      largest = std::max(largest, (back - GetPoint(reference, p)).norm());
    }
    check(largest < (i == 2 ? 1e-6 : 1e-12), "units and place do not matter", largest);
  }
}

void TestTangential(Checks& check)
{
  vtkSmartPointer<vtkPolyData> torus = MakeTorus(1.0, 0.4, 48, 24).Mesh;
  Shake(torus, 0.03);
  const auto distance = [](const Vector3d& p)
  { return std::hypot(std::hypot(p.x(), p.y()) - 1.0, p.z()) - 0.4; };
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    Vector3d p = GetPoint(torus, i);
    const Vector3d ring = Vector3d(p.x(), p.y(), 0.0).normalized();
    p = ring + 0.4 * (p - ring).normalized();
    torus->GetPoints()->SetPoint(i, p.data());
  }
  vtkNew<vtkNPRSurfaceSmoothing> smoothing;
  smoothing->SetInputData(torus);
  smoothing->SetComponentToTangential();
  smoothing->Update();
  const double before = GetSmallestAngle(torus);
  const double after = GetSmallestAngle(smoothing->GetOutput());
  const double error = GetLargestDistance(smoothing->GetOutput(), distance);
  std::cout << "tangential: smallest angle " << before << " -> " << after << ", distance "
            << GetLargestDistance(torus, distance) << " -> " << error << "\n";
  check(after > 1.5 * before, "triangles become more alike", after);
  check(error < 0.02, "the shape stays", error);
}

void TestFixed(Checks& check)
{
  vtkSmartPointer<vtkPolyData> patch = MakeWaves(20).Mesh;
  Shake(patch, 0.01);
  AddArrays(patch);
  AddShapeArrays(patch);
  const vtkSmartPointer<vtkPolyData> before = Copy(patch);
  npr::TriangleMesh mesh(patch);
  mesh.BuildIncidence();
  vtkNew<vtkNPRSurfaceSmoothing> smoothing;
  smoothing->SetInputData(patch);
  for (int component = 0; component < 3; ++component)
  {
    smoothing->SetComponent(component);
    smoothing->Update();
    vtkPolyData* output = smoothing->GetOutput();
    int moved = 0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const bool isMoved = GetPoint(output, i) != GetPoint(before, i);
      moved += isMoved;
      check(!isMoved || !mesh.IsBorderPoint(static_cast<Index>(i)), "borders stay");
      check(GetPoint(patch, i) == GetPoint(before, i), "the input stays");
      check(GetValue(output, "PointNumbers", i) == i, "arrays pass");
    }
    check(moved > output->GetNumberOfPoints() / 2, "the rest moves", moved);
    check(output->GetCellData()->HasArray("CellNumbers") &&
        output->GetNumberOfCells() == patch->GetNumberOfCells(),
      "cells pass");
    check(!output->GetPointData()->GetNormals() && !output->GetPointData()->HasArray("Normals2") &&
        !output->GetPointData()->HasArray(npr::names::PrincipalCurvature1) &&
        !output->GetFieldData()->HasArray(npr::names::NeighbourhoodRadius) &&
        patch->GetFieldData()->HasArray(npr::names::NeighbourhoodRadius),
      "what belongs to the old shape is dropped, from the output alone");
  }

  smoothing->SetComponentToTangentialAndNormal();
  smoothing->SetContinuity(0);
  smoothing->SetNumberOfIterations(100);
  smoothing->SetMaximumMove(0.005);
  smoothing->Update();
  vtkPolyData* output = smoothing->GetOutput();
  // Across the surface, so not along its steepest tilt, which here is 45 degrees and less.
  double largest = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vector3d move = GetPoint(output, i) - GetPoint(before, i);
    const double x = GetPoint(before, i).x();
    const double y = GetPoint(before, i).y();
    const Vector3d normal(
      -0.6 * std::cos(2.0 * x) * std::cos(y), 0.3 * std::sin(2.0 * x) * std::sin(y), 1.0);
    largest = std::max(largest, std::abs(move.dot(normal.normalized())));
  }
  check(largest < 0.03, "the move is bounded", largest);
  smoothing->SetMaximumMove(0.0);

  // A box, finely divided: its edges are features, or are rounded.
  vtkSmartPointer<vtkPolyData> box = MakeSphere(1.0, 4);
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    Vector3d p = GetPoint(box, i);
    p /= p.cwiseAbs().maxCoeff();
    box->GetPoints()->SetPoint(i, p.data());
  }
  smoothing->SetInputData(box);
  smoothing->SetNumberOfIterations(10);
  smoothing->SetFeatureAngle(40.0);
  for (bool isFixed : { true, false })
  {
    smoothing->SetFeatureAngle(isFixed ? 40.0 : 180.0);
    smoothing->Update();
    const double area = GetArea(smoothing->GetOutput()) / GetArea(box);
    std::cout << "box: area " << area << "\n";
    check(isFixed ? std::abs(area - 1.0) < 0.002 : area < 0.99, "features stay", area);
  }
}

void TestDegenerate(Checks& check)
{
  // A needle within a sheet: the middle of an edge drawn onto another corner's line.
  vtkSmartPointer<vtkPolyData> sheet = MakeWaves(10).Mesh;
  vtkSmartPointer<vtkPolyData> flat = Copy(sheet);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    Vector3d p = GetPoint(sheet, i);
    p.z() = 0.0;
    if (i >= 50 && i < 60)
    {
      p = GetPoint(sheet, i + 11); // whole rows in the same place
    }
    flat->GetPoints()->SetPoint(i, p.data());
  }
  vtkNew<vtkNPRSurfaceSmoothing> smoothing;
  smoothing->SetInputData(flat);
  for (int component = 0; component < 3; ++component)
  {
    for (int continuity : { 0, 1 })
    {
      smoothing->SetComponent(component);
      smoothing->SetContinuity(continuity);
      smoothing->Update();
      for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
      {
        check(GetPoint(smoothing->GetOutput(), i).allFinite(), "always finite");
      }
    }
  }
}
}

int TestSurfaceSmoothing(int, char*[])
{
  Checks check;
  TestNoise(check);
  TestTangential(check);
  TestFixed(check);
  TestDegenerate(check);
  vtkNew<vtkNPRSurfaceSmoothing> smoothing;
  TestObstacles(check, smoothing);
  return check.GetResult();
}
