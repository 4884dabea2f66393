// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The default estimator: it converges on irregular, noisy and bordered meshes, is exact where it
// should be, and depends on nothing that does not matter.
#include "nprErrorStatistics.h"
#include "nprIrregularSurfaces.h"
#include "nprJets.h"
#include "vtkNPRCurvatureTensor.h"

#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkSMPTools.h>

#include <cstring>
#include <string>

using namespace nprtest;

namespace
{
struct Estimate
{
  vtkNew<vtkNPRCurvatureTensor> Tensor;
  vtkPolyData* Update(vtkPolyData* mesh)
  {
    this->Tensor->SetInputData(mesh);
    this->Tensor->Update();
    return this->Tensor->GetOutput();
  }
};

double GetRadius(vtkPolyData* output)
{
  vtkDataArray* radius = output->GetFieldData()->GetArray(npr::names::NeighbourhoodRadius);
  return radius ? radius->GetComponent(0, 0) : 0.0;
}

void Print(const std::string& name, const AnalyticSurface& surface, vtkPolyData* output,
  const SurfaceStatistics& errors)
{
  std::cout << name << ", " << surface.Mesh->GetNumberOfCells() << " triangles, radius "
            << GetRadius(output) << ": curvature " << errors.Interior.Principal.Rms << " (border "
            << errors.Border.Principal.Rms << "), derivatives " << errors.Interior.Cubic.Rms
            << " (border " << errors.Border.Cubic.Rms << "), normals " << errors.Interior.Normal.Rms
            << "\n";
}

/// Each refinement, which halves the edges, must divide the errors by 2^order at least.
struct Orders
{
  double Curvature;
  double Derivatives;
};

void TestConvergence(const std::string& name, const std::function<AnalyticSurface(int)>& make,
  int n, int degree, const Orders& inside, const Orders& border, double lastCurvature,
  double lastDerivatives, Checks& check)
{
  SurfaceStatistics coarse;
  for (int level = 0; level < 3; ++level)
  {
    const AnalyticSurface surface = make(n << level);
    Estimate estimate;
    estimate.Tensor->SetJetDegree(degree);
    vtkPolyData* output = estimate.Update(surface.Mesh);
    const SurfaceStatistics fine = MeasureSurface(output, surface.Truths);
    Print(name, surface, output, fine);
    check(fine.All.Unknown == 0, name + ": there is an estimate everywhere");
    if (level > 0)
    {
      const auto checkOrder = [&](double before, double after, double order, const char* what)
      {
        check(std::isnan(before) || std::log2(before / after) > order, name + ": " + what,
          std::log2(before / after));
      };
      checkOrder(coarse.Interior.Principal.Rms, fine.Interior.Principal.Rms, inside.Curvature,
        "curvature converges");
      checkOrder(coarse.Interior.Cubic.Rms, fine.Interior.Cubic.Rms, inside.Derivatives,
        "derivatives converge");
      checkOrder(coarse.Border.Principal.Rms, fine.Border.Principal.Rms, border.Curvature,
        "curvature converges at borders");
      checkOrder(coarse.Border.Cubic.Rms, fine.Border.Cubic.Rms, border.Derivatives,
        "derivatives converge at borders");
    }
    coarse = fine;
  }
  check(coarse.Interior.Principal.Rms < lastCurvature, name + ": curvature is right",
    coarse.Interior.Principal.Rms);
  check(coarse.Interior.Cubic.Rms < lastDerivatives, name + ": derivatives are right",
    coarse.Interior.Cubic.Rms);
}

/// z is a polynomial of degree 4: a jet of degree 4 is that, whatever the mesh.
void TestExactness(Checks& check)
{
  ParametricSurface graph = Saddle();
  graph.At = [](double x, double y)
  {
    return MakeHeightTruth(x, y,
      { 0.3 * x * x - 0.2 * x * y + 0.1 * y * y * y + 0.2 * x * x * x * x - 0.1 * x * y * y * y,
        { 0.6 * x - 0.2 * y + 0.8 * x * x * x - 0.1 * y * y * y,
          -0.2 * x + 0.3 * y * y - 0.3 * x * y * y },
        { 0.6 + 2.4 * x * x, -0.2 - 0.3 * y * y, 0.6 * y - 0.6 * x * y },
        { 4.8 * x, 0.0, -0.6 * y, 0.6 - 0.6 * x } });
  };
  AnalyticSurface surface = MakeSurface(graph, 24, 24, { 0.3, 5 });
  // In the frame of the polynomial, and not in that of the surface's normal.
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < surface.Truths.size(); ++i)
  {
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
  }
  npr::TriangleMesh mesh(surface.Mesh);
  mesh.BuildIncidence();
  npr::Jets::Options options;
  options.Radius = 3.0;
  const npr::CurvatureEstimate estimate =
    npr::Jets(options).Estimate(mesh, npr::ReadTuples<3>(normals), true, npr::IgnoreProgress);
  double normal = 0.0;
  double form = 0.0;
  double cubic = 0.0;
  for (std::size_t i = 0; i < surface.Truths.size(); ++i)
  {
    const Truth& truth = surface.Truths[i];
    const Vector3d n = estimate.Normals[i].cast<double>();
    normal = std::max(normal, (n - truth.Normal).norm());
    form = std::max(
      form, (estimate.Tensors[i].cast<double>() - npr::FromFrame(truth.Form, truth.Frame)).norm());
    const npr::TangentFrame frame = npr::MakeTangentFrame(n);
    cubic = std::max(cubic,
      (npr::ChangeFrame(estimate.Derivatives[i].cast<double>(), frame, truth.Frame) - truth.Cubic)
        .norm());
  }
  std::cout << "polynomial: normal " << normal << ", form " << form << ", derivatives " << cubic
            << "\n";
  check(normal < 1e-5, "the normal of a polynomial is exact", normal);
  check(form < 1e-3, "the curvature of a polynomial is exact", form);
  check(cubic < 2e-2, "the derivatives of a polynomial are exact", cubic);
}

void TestInvariance(Checks& check)
{
  const AnalyticSurface surface = MakeJitteredTorus(32);
  Estimate plain;
  const ErrorStatistics expected = MeasureSurface(plain.Update(surface.Mesh), surface.Truths).All;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  for (double scale : { 1e-9, 1e-3, 1.0, 1e3, 1e9 })
  {
    // Points in the reverse order, too.
    AnalyticSurface other;
    const vtkIdType size = surface.Mesh->GetNumberOfPoints();
    for (vtkIdType i = size - 1; i >= 0; --i)
    {
      Truth truth = surface.Truths[i];
      truth.Point = scale * (turn * truth.Point);
      truth.Normal = turn * truth.Normal;
      truth.Frame = { turn * truth.Frame.U, turn * truth.Frame.V };
      truth.Form /= scale;
      truth.Cubic /= scale * scale;
      other.Truths.push_back(truth);
    }
    std::vector<Corners> triangles = GetTriangles(surface.Mesh);
    for (Corners& corners : triangles)
    {
      for (vtkIdType& corner : corners)
      {
        corner = size - 1 - corner;
      }
    }
    std::reverse(triangles.begin(), triangles.end());
    other.Mesh = MakeMesh(other.Truths, triangles);
    Estimate moved;
    vtkPolyData* output = moved.Update(other.Mesh);
    const ErrorStatistics actual = MeasureSurface(output, other.Truths).All;
    const std::string what = "turned, in another order and scaled by " + std::to_string(scale);
    check(std::abs(GetRadius(output) - GetRadius(plain.Tensor->GetOutput())) < 0.05,
      what + ": radius", GetRadius(output));
    check(std::abs(actual.Principal.Rms - expected.Principal.Rms) < 0.02 * expected.Principal.Rms,
      what + ": curvature", actual.Principal.Rms);
    check(std::abs(actual.Cubic.Rms - expected.Cubic.Rms) < 0.02 * expected.Cubic.Rms,
      what + ": derivatives", actual.Cubic.Rms);
  }
}

void TestThreads(Checks& check)
{
  AnalyticSurface surface = CutByPlane(MakeRemeshedEllipsoid({ 1.0, 0.8, 0.6 }, 24));
  AddNoise(surface, 0.01);
  const std::string backend = vtkSMPTools::GetBackend();
  std::vector<vtkSmartPointer<vtkPolyData>> outputs;
  for (int threads : { 1, 2 })
  {
    // TBB would not take more threads again after it has been held to one.
    vtkSMPTools::SetBackend(threads == 1 ? "Sequential" : "STDThread");
    vtkSMPTools::Initialize(threads);
    Estimate estimate;
    outputs.emplace_back(estimate.Update(surface.Mesh));
  }
  vtkSMPTools::SetBackend(backend.c_str());
  for (const char* name :
    { npr::names::Normals, npr::names::CurvatureTensor, npr::names::CurvatureDerivatives })
  {
    vtkDataArray* a = outputs[0]->GetPointData()->GetArray(name);
    vtkDataArray* b = outputs[1]->GetPointData()->GetArray(name);
    check(a && b &&
        std::memcmp(
          a->GetVoidPointer(0), b->GetVoidPointer(0), a->GetDataSize() * a->GetDataTypeSize()) == 0,
      std::string("the same bits for any number of threads: ") + name);
  }
}

/// A radius that is given holds, in either unit; and so does one that comes with the data.
void TestRadius(Checks& check)
{
  AnalyticSurface surface = MakeJitteredTorus(24);
  AddNoise(surface, 0.01);
  Estimate automatic;
  const double chosen = GetRadius(automatic.Update(surface.Mesh));
  check(chosen > 3.0 && chosen < 6.0, "noise widens the neighbourhood", chosen);
  Estimate given;
  given.Tensor->SetNeighbourhoodRadius(4.5);
  check(GetRadius(given.Update(surface.Mesh)) == 4.5, "a radius that is given holds");
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface.Mesh);
  copy->GetFieldData()->ShallowCopy(given.Tensor->GetOutput()->GetFieldData());
  Estimate stored;
  check(GetRadius(stored.Update(copy)) == 4.5, "a radius that comes with the data holds");
  const auto getError = [&](vtkPolyData* output)
  { return MeasureSurface(output, surface.Truths).All.Principal.Rms; };
  check(getError(stored.Tensor->GetOutput()) == getError(given.Tensor->GetOutput()),
    "and is the same as one that is given");
  given.Tensor->SetNeighbourhoodRadius(40.0);
  const double greatest = getError(given.Update(surface.Mesh));
  given.Tensor->SetNeighbourhoodRadius(1e20);
  const double beyond = getError(given.Update(surface.Mesh));
  check(GetRadius(given.Tensor->GetOutput()) == 40.0 && beyond == greatest,
    "one that is too large becomes the greatest", beyond - greatest);
  Estimate length;
  length.Tensor->SetRadiusUnitToLengthScale();
  length.Tensor->SetNeighbourhoodRadius(0.4);
  const double error = getError(length.Update(surface.Mesh));
  check(error < 0.1, "a radius in length scales is taken", error);
  length.Tensor->SetNeighbourhoodRadius(1.0);
  check(getError(length.Update(surface.Mesh)) > 2.0 * error, "and makes a difference");

  // A plane that stands askew, so that its points are rounded.
  const AnalyticSurface plane = MakeWaves(48);
  for (vtkIdType i = 0; i < plane.Mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    plane.Mesh->GetPoint(i, p);
    plane.Mesh->GetPoints()->SetPoint(
      i, 0.8 * p[0] + 0.1 * p[1], 0.3 * p[0] - 0.7 * p[1], 0.5 * p[0] + 0.6 * p[1]);
  }
  Estimate flat;
  const double radius = GetRadius(flat.Update(plane.Mesh));
  check(radius < 3.0, "rounding is not taken for noise", radius);
}
}

int TestCurvatureJets(int, char*[])
{
  Checks check;
  const auto noisy = [](int n)
  {
    AnalyticSurface surface = MakeJitteredTorus(n);
    AddNoise(surface, 0.01);
    return surface;
  };
  const auto torus = [](int n) { return MakeJitteredTorus(n); };
  TestConvergence("torus, degree 4", torus, 24, 4, { 3.0, 1.7 }, {}, 2e-4, 0.02, check);
  TestConvergence("torus, degree 3", torus, 24, 3, { 1.7, 0.8 }, {}, 0.01, 0.05, check);
  TestConvergence("torus, degree 2", torus, 24, 2, { 1.7, -0.1 }, {}, 0.01, 1.1, check);
  TestConvergence("noisy torus", noisy, 24, 4, { 0.9, 0.6 }, {}, 0.02, 0.15, check);
  TestConvergence(
    "ellipsoid",
    [](int n) {
      return MakeRemeshedEllipsoid({ 1.0, 0.8, 0.6 }, n);
    },
    16, 4, { 2.5, 1.5 }, {}, 1e-3, 0.02, check);
  TestConvergence(
    "cut ellipsoid",
    [](int n) {
      return CutByPlane(MakeRemeshedEllipsoid({ 1.0, 0.8, 0.6 }, n));
    },
    16, 4, { 2.5, 1.5 }, { 2.0, 1.0 }, 1e-3, 0.02, check);
  TestExactness(check);
  TestInvariance(check);
  TestThreads(check);
  TestRadius(check);
  return check.GetResult();
}
