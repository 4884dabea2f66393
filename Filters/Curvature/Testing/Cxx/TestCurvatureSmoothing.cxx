// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Smoothing keeps what is constant along the surface, removes noise, does what a Gaussian does,
// depends on the radius and not on the mesh, and stops at creases.
#include "nprCurvaturePipeline.h"

#include "nprCurvature.h"
#include "nprLengthScale.h"
#include "nprSurfaceDiffusion.h"

#include <vtkMinimalStandardRandomSequence.h>

using namespace nprtest;

namespace
{
void TestConstants(Checks& check)
{
  // On a sphere the curvature is the same everywhere, however the tangent planes turn.
  vtkSmartPointer<vtkPolyData> sphere = MakeOctasphere(2.0, 4);
  Pipeline pipeline(sphere);
  pipeline.Tensor->SetSmoothingRadius(0.3);
  pipeline.Derivatives->SetSmoothingRadius(0.1);
  vtkPolyData* output = pipeline.Update();
  double error = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    error = std::max({ error, std::abs(GetValue(output, npr::names::PrincipalCurvature1, i) - 0.5),
      std::abs(GetValue(output, npr::names::PrincipalCurvature2, i) - 0.5) });
  }
  check(error < 1e-3, "smoothing keeps the curvature of a sphere", error);

  // A cylinder's tensor has a direction: it must be carried along, not lost.
  AnalyticSurface cylinder = MakeCylinder(0.5, 1.0, 48, 24);
  Pipeline second(cylinder.Mesh);
  second.Tensor->SetSmoothingRadius(0.3);
  output = second.Update();
  error = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    error = std::max(error, GetErrors(output, i, cylinder.Truths[i]).Form);
  }
  check(error < 0.02, "smoothing keeps the curvature of a cylinder", error);
}

void TestGaussian(Checks& check)
{
  // On a flat, periodic-enough sheet the wave cos(kx) shrinks by exp(-k^2 radius^2 / 2).
  const double k = 2.0 * Pi;
  const double radius = 0.1;
  for (int n : { 40, 80 })
  {
    AnalyticSurface sheet = MakeSurface({ [](double x, double y)
                                          {
                                            // Sheared, and finer on one side: the triangles are not
                                            // regular.
                                            return MakeHeightTruth(x + 0.2 * y, y + 0.2 * y * y,
                                              { 0.0, { 0, 0 }, { 0, 0, 0 }, { 0, 0, 0, 0 } });
                                          },
                                          { -1.0, 1.0, -1.0, 1.0 } },
      n, n);
    npr::TriangleMesh mesh(sheet.Mesh);
    mesh.BuildIncidence();
    const npr::Tuples<3> normals(mesh.GetNumberOfPoints(), Eigen::Vector3f::UnitZ());
    npr::SurfaceDiffusion::Field field(mesh.GetNumberOfPoints());
    for (npr::TriangleMesh::Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
    {
      field[i] = { static_cast<float>(std::cos(k * sheet.Truths[i].Point.x())), 1.0f };
    }
    npr::SurfaceDiffusion(mesh, normals).Smooth(field, 0, radius);
    double worst = 0.0;
    for (npr::TriangleMesh::Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
    {
      const Vector3d& p = sheet.Truths[i].Point;
      check(std::abs(field[i].imag() - 1.0f) < 1e-4f, "a constant stays");
      if (std::abs(p.x()) < 0.5 && std::abs(p.y()) < 0.5)
      {
        const double exact = std::exp(-0.5 * k * k * radius * radius) * std::cos(k * p.x());
        worst = std::max(worst, std::abs(field[i].real() - exact));
      }
    }
    check(worst < 0.02, "smoothing is a Gaussian of the given radius", worst);
  }
}

void TestTessellation(Checks& check)
{
  // The curvature across a torus' tube, smoothed, where it is largest: the same from two meshes.
  double values[2];
  for (int i = 0; i < 2; ++i)
  {
    const int n = i == 0 ? 32 : 80;
    Pipeline pipeline(MakeTorus(1.0, 0.4, 2 * n, n).Mesh);
    pipeline.Tensor->SetSmoothingRadius(0.2);
    values[i] = GetValue(pipeline.Update(), npr::names::PrincipalCurvature2, 0);
  }
  const double unsmoothed = 1.0 / 1.4;
  check(values[1] < 0.97 * unsmoothed, "smoothing does something", values[1]);
  check(std::abs(values[0] - values[1]) < 0.01 * unsmoothed,
    "smoothing does not depend on the mesh", values[0] - values[1]);
}

void TestNoise(Checks& check)
{
  AnalyticSurface torus = MakeTorus(1.0, 0.4, 120, 60);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (vtkIdType i = 0; i < torus.Mesh->GetNumberOfPoints(); ++i)
  {
    random->Next();
    const Vector3d p =
      torus.Truths[i].Point + 0.002 * (2.0 * random->GetValue() - 1.0) * torus.Truths[i].Normal;
    torus.Mesh->GetPoints()->SetPoint(i, p.data());
  }
  const auto measure = [&](double normals, double tensor, double derivatives)
  {
    Pipeline pipeline(torus.Mesh);
    pipeline.Normals->SetSmoothingRadius(normals);
    pipeline.Tensor->SetSmoothingRadius(tensor);
    pipeline.Derivatives->SetSmoothingRadius(derivatives);
    vtkPolyData* output = pipeline.Update();
    Errors sum;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Errors here = GetErrors(output, i, torus.Truths[i]);
      sum.Normal += here.Normal;
      sum.Form += here.Form;
      sum.Cubic += here.Cubic;
    }
    return sum;
  };
  const Errors rough = measure(0.0, 0.0, 0.0);
  check(measure(0.05, 0.0, 0.0).Normal < 0.5 * rough.Normal, "smoothed normals have less noise");
  check(measure(0.0, 0.06, 0.0).Form < 0.4 * rough.Form, "smoothed tensors have less noise");
  check(measure(0.0, 0.06, 0.06).Cubic < 0.2 * rough.Cubic, "smoothed derivatives have less noise");
}

void TestCreases(Checks& check)
{
  // The caps of a can are flat: nothing of the side's curvature may reach them.
  Pipeline pipeline(MakeCan(1.0, 1.0, 48));
  pipeline.Tensor->SetSmoothingRadius(0.3);
  pipeline.Normals->SetSmoothingRadius(0.1);
  vtkPolyData* output = pipeline.Update();
  int caps = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vector3d normal = GetTuple<3>(output, npr::names::Normals, i);
    if (std::abs(normal.z()) > 0.5)
    {
      ++caps;
      check(std::abs(std::abs(normal.z()) - 1.0) < 1e-5, "normals do not leak over a crease");
      check(std::abs(GetValue(output, npr::names::PrincipalCurvature1, i)) < 1e-4,
        "curvature does not leak over a crease");
    }
    else
    {
      check(std::abs(GetValue(output, npr::names::PrincipalCurvature1, i) - 1.0) < 0.02,
        "the side keeps its curvature", GetValue(output, npr::names::PrincipalCurvature1, i));
    }
  }
  check(caps == 2 * 49, "a rim's points are there for cap and side", caps);
}
}

int TestCurvatureSmoothing(int, char*[])
{
  Checks check;
  TestConstants(check);
  TestGaussian(check);
  TestTessellation(check);
  TestNoise(check);
  TestCreases(check);
  return check.GetResult();
}
