// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Smoothing keeps what is constant along the surface, removes noise, does what a Gaussian does,
// depends on the radius and not on the mesh, and stops at creases; it keeps ridges where that is
// wanted, and makes scales each smoother than the last.
#include "nprCurvaturePipeline.h"

#include "nprCurvature.h"
#include "nprIrregularSurfaces.h"
#include "nprLengthScale.h"
#include "nprSurfaceDiffusion.h"

#include <vtkDataArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkPointData.h>

#include <cmath>
#include <string>

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

// On a flat, periodic-enough sheet a wave cos(kx) shrinks by exp(-k^2 radius^2 / 2), whichever way
// it runs.
void CheckGaussian(
  vtkPolyData* sheet, const Vector3d& normal, double most, const char* what, Checks& check)
{
  const double k = 2.0 * Pi;
  const double radius = 0.1;
  npr::TriangleMesh mesh(sheet);
  mesh.BuildIncidence();
  const npr::Tuples<3> normals(mesh.GetNumberOfPoints(), normal.cast<float>());
  const npr::SurfaceDiffusion diffusion(mesh, normals);
  const npr::TangentFrame frame = npr::MakeTangentFrame(normal);
  for (const double angle : { 0.0, 0.5, 0.9, 1.6 })
  {
    const Vector3d along = std::cos(angle) * frame.U + std::sin(angle) * frame.V;
    npr::SurfaceDiffusion::Field field(mesh.GetNumberOfPoints());
    const auto wave = [&](npr::TriangleMesh::Index i)
    { return std::cos(k * along.dot(Vector3d(sheet->GetPoint(i)))); };
    for (npr::TriangleMesh::Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
    {
      field[i] = { static_cast<float>(wave(i)), 1.0f };
    }
    diffusion.Smooth(field, 0, radius);
    double worst = 0.0;
    for (npr::TriangleMesh::Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
    {
      check(std::abs(field[i].imag() - 1.0f) < 1e-4f, "a constant stays");
      if (Vector3d(sheet->GetPoint(i)).cwiseAbs().maxCoeff() < 0.5)
      {
        const double exact = std::exp(-0.5 * k * k * radius * radius) * wave(i);
        worst = std::max(worst, std::abs(field[i].real() - exact));
      }
    }
    check(worst < most, what, worst);
  }
}

void TestGaussian(Checks& check)
{
  for (const int n : { 40, 80 })
  {
    const AnalyticSurface sheared =
      MakeSurface({ [](double x, double y)
                    {
                      return MakeHeightTruth(x + 0.2 * y, y + 0.2 * y * y,
                        { 0.0, { 0, 0 }, { 0, 0, 0 }, { 0, 0, 0, 0 } });
                    },
                    { -1.0, 1.0, -1.0, 1.0 } },
        n, n);
    CheckGaussian(sheared.Mesh, Vector3d::UnitZ(), 0.01,
      "smoothing is a Gaussian on sheared triangles, finer on one side", check);

    // As scans are: where the surface comes close to the corners of cells there are slivers, and
    // points close to each other.
    vtkNew<vtkImageData> cells;
    cells->SetDimensions(n + 1, n + 1, n + 1);
    cells->SetOrigin(-1.0, -1.0, -1.0);
    cells->SetSpacing(2.0 / n, 2.0 / n, 2.0 / n);
    cells->AllocateScalars(VTK_DOUBLE, 1);
    const Vector3d normal = Vector3d(0.23, 0.34, 0.9).normalized();
    for (vtkIdType i = 0; i < cells->GetNumberOfPoints(); ++i)
    {
      const Vector3d p(cells->GetPoint(i));
      cells->GetPointData()->GetScalars()->SetTuple1(i, -normal.dot(p));
    }
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(cells);
    contour->SetValue(0, 0.0013);
    contour->Update();
    CheckGaussian(contour->GetOutput(), normal, 1.2 / n, "and on those of marching cubes", check);
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

/// Two planes that meet at a right angle in a ridge along y, rounded with the given radius.
AnalyticSurface MakeRidge(double rounding, int n)
{
  const double range[4] = { -1.0, 1.0, -0.6, 0.6 };
  return MakeSurface(
    { [=](double s, double y)
      {
        const double half = 0.25 * Pi * rounding; // of the arc
        const double angle = std::clamp(s / rounding, -0.25 * Pi, 0.25 * Pi);
        const double beyond = s - std::clamp(s, -half, half);
        Truth truth;
        truth.Normal = { std::sin(angle), 0.0, std::cos(angle) };
        truth.Point = rounding * truth.Normal +
          beyond * Vector3d(std::cos(angle), 0.0, -std::sin(angle)) + Vector3d(0.0, y, 0.0);
        truth.Frame = { Vector3d(std::cos(angle), 0.0, -std::sin(angle)), Vector3d::UnitY() };
        truth.Form = { std::abs(s) < half ? 1.0 / rounding : 0.0, 0.0, 0.0 };
        truth.Cubic = Vector4d::Zero();
        return truth;
      },
      { range[0], range[1], range[2], range[3] } },
    n, n * 3 / 5, { 0.2, 1 });
}

double GetAngle(vtkPolyData* surface, vtkIdType point, const Vector3d& truth,
  const char* name = npr::names::Normals)
{
  const Vector3d normal = GetTuple<3>(surface, name, point);
  return std::atan2(normal.cross(truth).norm(), normal.dot(truth));
}

void TestFeatures(Checks& check)
{
  AnalyticSurface ridge = MakeRidge(0.04, 80);
  AddNoise(ridge, 0.05);
  struct Angles
  {
    double Flat = 0.0;  // root mean square, away from the ridge
    double Ridge = 0.0; // beside the ridge, where plain smoothing rounds it
  };
  const auto measure = [&](double radius, double preservation)
  {
    vtkNew<vtkNPRSurfaceNormals> normals;
    normals->SetInputData(ridge.Mesh);
    normals->SetSmoothingRadius(radius);
    normals->SetFeaturePreservation(preservation);
    normals->Update();
    Angles angles;
    int flat = 0;
    int beside = 0;
    for (vtkIdType i = 0; i < normals->GetOutput()->GetNumberOfPoints(); ++i)
    {
      const Truth& truth = ridge.Truths[i];
      const double angle = GetAngle(normals->GetOutput(), i, truth.Normal);
      // The distance from the plane through the ridge tells how far away it is.
      const double away = std::abs(truth.Point.x()) * std::sqrt(2.0);
      if (std::abs(truth.Point.y()) < 0.5 && away > 0.06 && away < 0.9)
      {
        const bool isFlat = away > 0.3;
        (isFlat ? angles.Flat : angles.Ridge) += angle * angle;
        ++(isFlat ? flat : beside);
      }
    }
    angles.Flat = std::sqrt(angles.Flat / flat);
    angles.Ridge = std::sqrt(angles.Ridge / beside);
    return angles;
  };
  const Angles rough = measure(0.0, 0.0);
  const Angles plain = measure(0.2, 0.0);
  const Angles kept = measure(0.2, 4.0);
  std::cout << "ridge: rough " << rough.Flat << " " << rough.Ridge << ", plain " << plain.Flat
            << " " << plain.Ridge << ", preserving " << kept.Flat << " " << kept.Ridge << "\n";
  check(plain.Ridge > 2.0 * rough.Ridge, "plain smoothing rounds the ridge", plain.Ridge);
  check(kept.Ridge < 0.6 * rough.Ridge, "a ridge is kept, and smoothed along itself", kept.Ridge);
  check(kept.Flat < 0.3 * rough.Flat, "flat parts are smoothed", kept.Flat);

  // A sphere bends everywhere alike, and stays what it is.
  vtkNew<vtkNPRSurfaceNormals> normals;
  normals->SetInputData(MakeRemeshedEllipsoid(Vector3d::Ones(), 24, 1, false).Mesh);
  normals->SetSmoothingRadius(0.1);
  normals->SetFeaturePreservation(2.0);
  normals->Update();
  double worst = 0.0;
  for (vtkIdType i = 0; i < normals->GetOutput()->GetNumberOfPoints(); ++i)
  {
    Vector3d p;
    normals->GetOutput()->GetPoint(i, p.data());
    worst = std::max(worst, GetAngle(normals->GetOutput(), i, p.normalized()));
  }
  check(worst < 0.01, "a sphere stays a sphere", worst);
}

void TestScales(Checks& check)
{
  AnalyticSurface torus = MakeJitteredTorus(60);
  AddNoise(torus, 0.05);
  vtkNew<vtkNPRSurfaceNormals> normals;
  normals->SetInputData(torus.Mesh);
  normals->SetNumberOfScales(7);
  normals->Update();
  vtkPolyData* output = normals->GetOutput();
  const auto getName = [](int scale)
  {
    return scale == 0 ? std::string(npr::names::Normals)
                      : npr::names::ScaleNormalsPrefix + std::to_string(scale);
  };
  // How much the normals turn from point to point.
  npr::TriangleMesh mesh(output);
  double last = 1e9;
  for (int scale = 0; scale <= 7; ++scale)
  {
    const std::string name = getName(scale);
    double sum = 0.0;
    for (const auto& corners : mesh.GetTriangles())
    {
      sum += (GetTuple<3>(output, name.c_str(), corners[0]) -
        GetTuple<3>(output, name.c_str(), corners[1]))
               .squaredNorm();
    }
    check(sum > 0.0 && sum < last, name + " is smoother than the last", sum / last);
    last = sum;
  }
  check(!output->GetPointData()->HasArray(getName(8).c_str()), "as many scales as asked for");

  // Scale after scale is the same as at once.
  vtkNew<vtkNPRSurfaceNormals> once;
  once->SetInputData(torus.Mesh);
  once->SetSmoothingRadius(0.01 * std::pow(2.0, 3.0));
  once->Update();
  double worst = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    worst = std::max(worst,
      GetAngle(output, i, GetTuple<3>(once->GetOutput(), npr::names::Normals, i), "Normals7"));
  }
  check(worst < 0.03, "scales add up", worst);
}

void TestLongTimes(Checks& check)
{
  // A wave over a long, fine strip, smoothed by many edges: long steps must do what short ones do.
  const double k = 2.0 * Pi;
  AnalyticSurface sheet =
    MakeSurface({ [](double x, double y) {
                   return MakeHeightTruth(x, y, { 0.0, { 0, 0 }, { 0, 0, 0 }, { 0, 0, 0, 0 } });
                 },
                  { -1.0, 1.0, 0.0, 0.02 } },
      800, 8, { 0.2, 1 });
  npr::TriangleMesh mesh(sheet.Mesh);
  mesh.BuildIncidence();
  const npr::SurfaceDiffusion diffusion(
    mesh, npr::Tuples<3>(mesh.GetNumberOfPoints(), Eigen::Vector3f::UnitZ()));
  for (double radius : { 0.03, 0.1, 0.2 })
  {
    npr::SurfaceDiffusion::Field field(mesh.GetNumberOfPoints());
    for (npr::TriangleMesh::Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
    {
      field[i] = { static_cast<float>(std::cos(k * sheet.Truths[i].Point.x())), 1.0f };
    }
    diffusion.Smooth(field, 0, radius);
    double worst = 0.0;
    for (npr::TriangleMesh::Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
    {
      const double x = sheet.Truths[i].Point.x();
      const double exact = std::exp(-0.5 * k * k * radius * radius) * std::cos(k * x);
      worst = std::max(worst, std::abs(field[i].real() - exact));
      check(std::abs(field[i].imag() - 1.0f) < 1e-4f, "a constant stays for long", field[i].imag());
    }
    check(worst < 0.04, "a Gaussian of many edges", worst);
  }
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
  TestFeatures(check);
  TestScales(check);
  TestLongTimes(check);
  return check.GetResult();
}
