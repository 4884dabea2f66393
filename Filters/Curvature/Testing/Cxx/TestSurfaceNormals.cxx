// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Vertex normals: each weighting as it is defined, exactness on spheres and strips, and what is
// active afterwards.
#include "nprCurvaturePipeline.h"

#include <vtkMath.h>

#include <algorithm>

using namespace nprtest;

namespace
{
/// A point with four triangles around it in two planes of known normals, and unequal sizes.
void TestWeights(Checks& check)
{
  // A roof: left of the ridge (the y axis) one triangle of a slope, right of it three flat ones,
  // and all closed around the origin by a boundary far off.
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  const double corners[5][3] = { { 0, 0, 0 }, { 0, -1, 0 }, { 3, 0, 0 }, { 0, 1, 0 },
    { -2, 0, -2 } };
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 1; i < 5; ++i)
  {
    const vtkIdType triangle[3] = { 0, i, i % 4 + 1 };
    cells->InsertNextCell(3, triangle);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);

  // Right: two triangles of area 1.5, a right angle, edges 1 and 3. Left: two of area sqrt 2, a
  // right angle, edges 1 and sqrt 8.
  const Vector3d right(0.0, 0.0, 1.0);
  const Vector3d left = Vector3d(-1.0, 0.0, 1.0).normalized();
  const double weights[3][2] = { { 1.5 / 9.0, std::sqrt(2.0) / 8.0 }, { 1.5, std::sqrt(2.0) },
    { 1.0, 1.0 } };
  for (int w = 0; w < 3; ++w)
  {
    vtkNew<vtkNPRSurfaceNormals> normals;
    normals->SetInputData(mesh);
    normals->SetWeighting(w);
    normals->Update();
    const Vector3d expected = (weights[w][0] * right + weights[w][1] * left).normalized();
    const Vector3d actual = GetTuple<3>(normals->GetOutput(), npr::names::Normals, 0);
    check((actual - expected).norm() < 1e-6, "weights as defined", w);
    check(normals->GetOutput()->GetPointData()->GetNormals() ==
        normals->GetOutput()->GetPointData()->GetArray(npr::names::Normals),
      "the normals are active");
  }
}

void TestSphere(Checks& check)
{
  Pipeline pipeline(MakeOctasphere(3.0, 3));
  vtkPolyData* output = pipeline.Update();
  double error = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    error = std::max(error,
      (GetTuple<3>(output, npr::names::Normals, i) - Eigen::Map<Vector3d>(p).normalized()).norm());
    check(std::abs(GetValue(output, npr::names::PrincipalCurvature1, i) - 1.0 / 3.0) < 1e-4,
      "a sphere's curvature is exact, and positive");
  }
  check(error < 2e-6, "a sphere's normals are exact", error);
}

/// The side of a quarter of a cylinder of radius 1, in one row, and after it so much of a plane
/// that touches it: there is no inner point.
vtkSmartPointer<vtkPolyData> MakeStrip(int panels, double plane)
{
  auto strip = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const int columns = panels + (plane > 0.0 ? 1 : 0);
  for (vtkIdType i = 0; i <= columns; ++i)
  {
    const double angle = 0.5 * vtkMath::Pi() * std::min<double>(i, panels) / panels;
    const double x = std::cos(angle) - (i > panels ? plane : 0.0);
    points->InsertNextPoint(x, std::sin(angle), 0.0);
    points->InsertNextPoint(x, std::sin(angle), 3.0);
    if (i > 0)
    {
      const vtkIdType a = 2 * i - 2;
      cells->InsertNextCell({ a, a + 2, a + 3 });
      cells->InsertNextCell({ a, a + 3, a + 1 });
    }
  }
  strip->SetPoints(points);
  strip->SetPolys(cells);
  return strip;
}

void TestStrips(Checks& check)
{
  constexpr int Panels = 9;
  for (const double plane : { 0.0, 2.0 })
  {
    const auto strip = MakeStrip(Panels, plane);
    vtkNew<vtkNPRSurfaceNormals> normals;
    normals->SetInputData(strip);
    normals->Update();
    for (vtkIdType i = 0; i < strip->GetNumberOfPoints(); ++i)
    {
      double p[3];
      strip->GetPoint(i, p);
      const Vector3d normal = GetTuple<3>(normals->GetOutput(), npr::names::Normals, i);
      const bool ofPlane = i / 2 > Panels;
      const bool isTouching = plane > 0.0 && i / 2 == Panels;
      const Vector3d expected = ofPlane ? Vector3d(0.0, 1.0, 0.0) : Vector3d(p[0], p[1], 0.0);
      check(isTouching || (normal - expected).norm() < 1e-3,
        "normals of strips are those of the cylinder, to its corners, and of the plane",
        (normal - expected).norm());
    }
  }
}
}

int TestSurfaceNormals(int, char*[])
{
  Checks check;
  TestWeights(check);
  TestSphere(check);
  TestStrips(check);
  return check.GetResult();
}
