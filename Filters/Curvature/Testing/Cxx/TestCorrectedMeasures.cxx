// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Corrected curvature measures converge on irregular, noisy and bordered meshes, with the automatic
// radius and with a given one; and give the same for any number of threads.
#include "nprCurvaturePipeline.h"

#include "nprErrorStatistics.h"
#include "nprIrregularSurfaces.h"

#include <vtkFieldData.h>
#include <vtkObject.h>
#include <vtkSMPTools.h>

#include <cstring>

using namespace nprtest;

namespace
{
vtkSmartPointer<vtkPolyData> Estimate(vtkPolyData* mesh, double radius = 0.0, bool inScale = false)
{
  vtkNew<vtkNPRCurvatureTensor> filter;
  filter->SetInputData(mesh);
  filter->SetEstimatorToCorrectedMeasures();
  filter->SetNeighbourhoodRadius(radius);
  filter->SetRadiusUnit(
    inScale ? vtkNPRCurvatureTensor::LENGTH_SCALE : vtkNPRCurvatureTensor::MEAN_EDGE);
  filter->Update();
  return filter->GetOutput();
}

double GetRadius(vtkPolyData* output)
{
  vtkDataArray* array = output->GetFieldData()->GetArray(npr::names::NeighbourhoodRadius);
  return array ? array->GetComponent(0, 0) : 0.0;
}

SurfaceStatistics Measure(const std::string& name, const AnalyticSurface& surface)
{
  const vtkSmartPointer<vtkPolyData> output = Estimate(surface.Mesh);
  const SurfaceStatistics statistics = MeasureSurface(output, surface.Truths);
  for (const auto& part :
    { std::make_pair("inside", statistics.Interior), std::make_pair("border", statistics.Border) })
  {
    if (part.second.Points > 0)
    {
      std::cout << name << ", " << surface.Mesh->GetNumberOfPolys() << " triangles, radius "
                << GetRadius(output) << ", " << part.first << ": normal " << part.second.Normal.Rms
                << " curvature " << part.second.Principal.Rms << " derivatives "
                << part.second.Cubic.Rms << "\n";
    }
  }
  return statistics;
}

/// Curvature and derivatives inside must fall to what is asked, and at least by the factors, with
/// every step.
struct Limits
{
  double Curvature;
  double CurvatureFactor;
  double Derivatives;
  double DerivativesFactor;
};

void TestConvergence(const std::string& name, const std::function<AnalyticSurface(int)>& make,
  const std::vector<int>& sizes, const Limits& limits, Checks& check)
{
  SurfaceStatistics last;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const SurfaceStatistics errors = Measure(name, make(sizes[i]));
    if (i > 0)
    {
      const double curvature = last.Interior.Principal.Rms / errors.Interior.Principal.Rms;
      const double derivatives = last.Interior.Cubic.Rms / errors.Interior.Cubic.Rms;
      check(curvature > limits.CurvatureFactor, name + ": curvature converges", curvature);
      check(derivatives > limits.DerivativesFactor, name + ": derivatives converge", derivatives);
    }
    check(errors.All.Unknown == 0, name + ": known everywhere");
    last = errors;
  }
  check(last.Interior.Principal.Rms < limits.Curvature, name + ": curvature",
    last.Interior.Principal.Rms);
  check(
    last.Interior.Cubic.Rms < limits.Derivatives, name + ": derivatives", last.Interior.Cubic.Rms);
}

void TestConstants(Checks& check)
{
  const SurfaceStatistics sphere = Measure("sphere", MakeRemeshedEllipsoid(Vector3d::Ones(), 32));
  check(sphere.All.Principal.Max < 1e-3, "a sphere", sphere.All.Principal.Max);
  check(sphere.All.Cubic.Max < 5e-3, "nothing changes on a sphere", sphere.All.Cubic.Max);
  const SurfaceStatistics cylinder =
    Measure("cylinder", MakeSurface(Cylinder(0.5, 1.0), 80, 24, { 0.3, 1 }));
  check(cylinder.All.Principal.Rms < 5e-3, "a cylinder", cylinder.All.Principal.Rms);
  check(cylinder.Interior.Direction.Rms < 5e-3, "directions of a cylinder",
    cylinder.Interior.Direction.Rms);
}

void TestBorder(Checks& check)
{
  const SurfaceStatistics coarse =
    Measure("torus with a border", CutByPlane(MakeJitteredTorus(36)));
  const SurfaceStatistics fine = Measure("torus with a border", CutByPlane(MakeJitteredTorus(72)));
  check(fine.Border.Principal.Rms < 0.02 &&
      fine.Border.Principal.Rms < 0.7 * coarse.Border.Principal.Rms,
    "curvature converges at borders", fine.Border.Principal.Rms);
  check(fine.Border.Cubic.Rms < 0.25, "derivatives at borders", fine.Border.Cubic.Rms);
}

void TestRadius(Checks& check)
{
  AnalyticSurface torus = MakeJitteredTorus(48);
  const double clean = GetRadius(Estimate(torus.Mesh));
  check(clean >= 3.0 && clean <= 5.0, "the radius on a clean mesh", clean);
  AddNoise(torus, 0.02);
  const double noisy = GetRadius(Estimate(torus.Mesh));
  check(noisy > clean + 1.0, "noise makes the radius grow", noisy);
  const vtkSmartPointer<vtkPolyData> given = Estimate(torus.Mesh, 4.0);
  check(GetRadius(given) == 4.0, "a given radius is taken");

  // What the input says holds, and gives the same as when it is set.
  const vtkSmartPointer<vtkPolyData> again = vtkSmartPointer<vtkPolyData>::New();
  again->ShallowCopy(torus.Mesh);
  again->GetFieldData()->AddArray(given->GetFieldData()->GetArray(npr::names::NeighbourhoodRadius));
  const vtkSmartPointer<vtkPolyData> stored = Estimate(again);
  for (vtkIdType i = 0; i < stored->GetNumberOfPoints(); ++i)
  {
    check(GetValue(stored, npr::names::MeanCurvature, i) ==
        GetValue(given, npr::names::MeanCurvature, i),
      "the input's radius holds");
  }
  // A fraction of the model is the same on a finer mesh; there it is more edges.
  for (int n : { 36, 72 })
  {
    const AnalyticSurface other = MakeJitteredTorus(n);
    const vtkSmartPointer<vtkPolyData> output = Estimate(other.Mesh, 0.2, true);
    const double error = MeasureSurface(output, other.Truths).All.Principal.Rms;
    check(error > 0.005 && error < 0.03, "a radius in units of the model", error);
  }
}

void TestThreads(Checks& check)
{
  AnalyticSurface torus = MakeJitteredTorus(36);
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential");
  const vtkSmartPointer<vtkPolyData> one = Estimate(torus.Mesh);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(3);
  const vtkSmartPointer<vtkPolyData> many = Estimate(torus.Mesh);
  vtkSMPTools::SetBackend(backend.c_str());
  vtkSMPTools::Initialize();
  for (const char* name : GetArrayNames())
  {
    vtkDataArray* a = one->GetPointData()->GetArray(name);
    vtkDataArray* b = many->GetPointData()->GetArray(name);
    check(a && b && a->GetDataSize() == b->GetDataSize() &&
        std::memcmp(
          a->GetVoidPointer(0), b->GetVoidPointer(0), a->GetDataSize() * a->GetDataTypeSize()) == 0,
      std::string("the same bits for any number of threads: ") + name);
  }
}

void TestScaleAndPlace(Checks& check)
{
  const AnalyticSurface torus = MakeJitteredTorus(24);
  const vtkSmartPointer<vtkPolyData> plain = Estimate(torus.Mesh);
  for (double scale : { 1e-9, 1e9 })
  {
    const AnalyticSurface other = MakeJitteredTorus(24);
    for (vtkIdType i = 0; i < other.Mesh->GetNumberOfPoints(); ++i)
    {
      const Vector3d p = scale * (other.Truths[i].Point + Vector3d(1e6, -1e6, 1e6));
      other.Mesh->GetPoints()->SetPoint(i, p.data());
    }
    const vtkSmartPointer<vtkPolyData> output = Estimate(other.Mesh);
    double worst = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      worst = std::max(worst,
        std::abs(scale * GetValue(output, npr::names::MeanCurvature, i) -
          GetValue(plain, npr::names::MeanCurvature, i)));
      worst = std::max(worst,
        1e-1 *
          (scale * scale * GetTuple<4>(output, npr::names::CurvatureDerivatives, i) -
            GetTuple<4>(plain, npr::names::CurvatureDerivatives, i))
            .cwiseAbs()
            .minCoeff());
    }
    check(worst < 1e-4, "tiny, huge and far away", worst);
  }
}

void TestBadInput(Checks& check)
{
  // Points alone, one triangle, an unused point and one that is no number, three sheets at an edge,
  // no area, and a plane.
  const double nan = std::nan("");
  const std::vector<Vector3d> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 },
    { 0, 0, 1 }, { 2, 0, 0 }, { nan, 0, 0 } };
  const std::vector<std::vector<Corners>> meshes = { {}, { { 0, 1, 2 } },
    { { 0, 1, 2 }, { 0, 3, 1 }, { 1, 2, 6 } }, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } },
    { { 0, 1, 5 }, { 0, 1, 1 } } };
  std::vector<vtkSmartPointer<vtkPolyData>> inputs;
  for (const auto& triangles : meshes)
  {
    std::vector<Truth> truths(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      truths[i].Point = points[i];
    }
    inputs.push_back(MakeMesh(truths, triangles));
  }
  inputs.push_back(
    MakeSurface({ [](double x, double y) {
                   return MakeHeightTruth(x, y, { 0.0, { 0, 0 }, { 0, 0, 0 }, { 0, 0, 0, 0 } });
                 },
                  { 0.0, 1.0, 0.0, 1.0 } },
      8, 8)
      .Mesh);
  vtkObject::GlobalWarningDisplayOff();
  for (vtkPolyData* input : inputs)
  {
    const vtkSmartPointer<vtkPolyData> output = Estimate(input);
    for (const char* name : GetArrayNames())
    {
      vtkDataArray* array = output->GetPointData()->GetArray(name);
      check(array != nullptr, std::string("there is ") + name);
      for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
      {
        const int components = array->GetNumberOfComponents();
        const double value = array->GetComponent(i / components, i % components);
        check(std::isfinite(value), std::string("finite ") + name);
      }
    }
  }
  vtkObject::GlobalWarningDisplayOn();
  const vtkSmartPointer<vtkPolyData> plane = Estimate(inputs.back());
  check(std::abs(GetValue(plane, npr::names::PrincipalCurvature1, 7)) < 1e-5, "a plane is flat");
}
}

int TestCorrectedMeasures(int, char*[])
{
  Checks check;
  TestConstants(check);
  TestConvergence(
    "torus", [](int n) { return MakeJitteredTorus(n); }, { 36, 72, 144 }, { 0.003, 2.5, 0.01, 1.4 },
    check);
  TestConvergence(
    "ellipsoid",
    [](int n) {
      return MakeRemeshedEllipsoid({ 1.0, 0.7, 0.5 }, n);
    },
    { 28, 56 }, { 0.01, 2.5, 0.05, 2.0 }, check);
  TestConvergence(
    "noisy torus",
    [](int n)
    {
      AnalyticSurface torus = MakeJitteredTorus(n);
      AddNoise(torus, 0.01);
      return torus;
    },
    { 36, 72 }, { 0.012, 1.3, 0.12, 1.05 }, check);
  TestBorder(check);
  TestRadius(check);
  TestThreads(check);
  TestScaleAndPlace(check);
  TestBadInput(check);
  return check.GetResult();
}
