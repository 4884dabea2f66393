// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What curvature costs, beside a plain implementation of the published algorithm and beside VTK's
 * own filter, in one run:
 *
 *   nprCurvatureBenchmark [MODEL | --torus N] [--runs N] [--scaling] [--memory]
 *
 * MODEL is prepared once, its creases left whole; without it a torus of N triangles is made (200000
 * if not said). Times are the least of several runs (--runs; 5). Machines are busy with other
 * things: seconds of processor time are little disturbed by that, and ratios least.
 *
 * --scaling shows time for each triangle on tori from 10k to 5M triangles. --memory shows the
 * peak: it starts this program once for each row, so that nothing is left over from another, and
 * says by how much the largest resident size exceeds that before there was a mesh (Linux only).
 */
#include "nprArrayNames.h"
#include "nprBenchmarkCost.h"
#include "nprBenchmarkModel.h"
#include "nprBenchmarkTorus.h"
#include "nprPlainCurvature.h"
#include "nprPlainMesh.h"
#include "nprTriangleMesh.h"
#include "vtkNPRCurvatureDerivatives.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRSurfaceNormals.h"

#include <vtkCurvatures.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace nprbench;

//------------------------------------------------------------------------------
/// Runs a filter on the surface as if for the first time. The output is dropped.
void Run(vtkPolyDataAlgorithm* filter, vtkPolyData* surface)
{
  filter->SetInputData(surface);
  filter->Modified();
  filter->Update();
  filter->GetOutput()->Initialize();
}

/// All arrays, those that are off by default too.
vtkSmartPointer<vtkNPRCurvatureTensor> MakeTensorFilter(int estimator)
{
  auto filter = vtkSmartPointer<vtkNPRCurvatureTensor>::New();
  filter->SetEstimator(estimator);
  filter->OutputShapeIndexOn();
  filter->OutputCurvednessOn();
  filter->OutputPointAreaOn();
  return filter;
}

void RunVTK(vtkPolyData* surface, bool gauss)
{
  vtkNew<vtkCurvatures> curvatures;
  curvatures->SetCurvatureType(gauss ? VTK_CURVATURE_GAUSS : VTK_CURVATURE_MEAN);
  Run(curvatures, surface);
}

//------------------------------------------------------------------------------
void PrintAccuracy()
{
  constexpr int triangles = 50000;
  const Surface torus = MakeTorus(triangles);
  std::printf("\nRMS errors on a torus of %d triangles, relative\n", triangles);
  PlainMesh plain = MakePlainMesh(torus);
  plain.ComputeNormals();
  plain.ComputeAreas();
  plain.ComputeCurvature();
  plain.ComputeDerivatives();
  TorusErrors errors;
  for (std::size_t i = 0; i < plain.Points.size(); ++i)
  {
    errors.Add(Vector3d(torus->GetPoint(static_cast<vtkIdType>(i))), plain.K1[i], plain.K2[i],
      plain.E1[i].cast<double>(), plain.E2[i].cast<double>(),
      Eigen::Map<const Eigen::Vector4f>(plain.Derivatives[i].data()).cast<double>());
  }
  errors.Print("plain");
  for (int e = 0; e < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++e)
  {
    const auto filter = MakeTensorFilter(e);
    filter->SetInputData(torus);
    filter->Update();
    vtkPointData* const data = filter->GetOutput()->GetPointData();
    errors = TorusErrors();
    for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
    {
      const auto array = [&](const char* name) { return data->GetArray(name); };
      Vector4d derivatives;
      array(npr::names::CurvatureDerivatives)->GetTuple(i, derivatives.data());
      Vector3d e1;
      Vector3d e2;
      array(npr::names::PrincipalDirection1)->GetTuple(i, e1.data());
      array(npr::names::PrincipalDirection2)->GetTuple(i, e2.data());
      errors.Add(Vector3d(torus->GetPoint(i)), array(npr::names::PrincipalCurvature1)->GetTuple1(i),
        array(npr::names::PrincipalCurvature2)->GetTuple1(i), e1, e2, derivatives);
    }
    errors.Print(vtkNPRCurvatureTensor::GetEstimatorName(e));
  }
}

//------------------------------------------------------------------------------
/// Ours beside the plain one, which is 1. The ratio with one thread is that of processor seconds,
/// with two that of time on the clock.
class TimeTable
{
public:
  explicit TimeTable(int runs) : Runs(runs)
  {
    std::printf("%-32s %18s %18s %15s\n", "seconds", "one thread", "two threads", "ratio");
    std::printf(
      "%-32s %9s%9s %9s%9s %7s%8s\n", "", "clock", "processor", "clock", "processor", "one", "two");
  }
  /// A row of the plain implementation, one part of the yardstick.
  void AddPlain(const char* name, const std::function<void()>& work)
  {
    UseThreads(1);
    const Cost cost = Measure(this->Runs, work);
    this->Plain.Wall += cost.Wall;
    this->Plain.Processor += cost.Processor;
    this->PrintPlain(name, cost);
  }
  void PrintPlain() const { this->PrintPlain("plain, all", this->Plain); }
  void Add(const std::string& name, const std::function<void()>& work, int runs = 0) const
  {
    UseThreads(1);
    const Cost one = Measure(runs ? runs : this->Runs, work);
    UseThreads(2);
    const Cost two = Measure(runs ? runs : this->Runs, work);
    std::printf("%-32s %9.4f%9.4f %9.4f%9.4f %7.2f%8.2f\n", name.c_str(), one.Wall, one.Processor,
      two.Wall, two.Processor, one.Processor / this->Plain.Processor, two.Wall / this->Plain.Wall);
    std::fflush(stdout);
  }

private:
  void PrintPlain(const char* name, const Cost& cost) const
  {
    std::printf("%-32s %9.4f%9.4f\n", name, cost.Wall, cost.Processor);
  }

  int Runs;
  Cost Plain{ 0.0, 0.0 };
};

void PrintTimes(vtkPolyData* surface, int runs)
{
  TimeTable table(runs);
  PlainMesh plain = MakePlainMesh(surface);
  table.AddPlain("plain: normals", [&]() { plain.ComputeNormals(); });
  table.AddPlain("plain: adjacency",
    [&]()
    {
      plain.AdjacentTriangles = {};
      plain.ComputeAdjacency();
    });
  table.AddPlain("plain: point areas", [&]() { plain.ComputeAreas(); });
  table.AddPlain("plain: curvature", [&]() { plain.ComputeCurvature(); });
  table.AddPlain("plain: derivatives", [&]() { plain.ComputeDerivatives(); });
  table.PrintPlain();
  plain = {};

  vtkNew<vtkNPRSurfaceNormals> normals;
  vtkNew<vtkNPRCurvatureDerivatives> derivatives;
  const auto tensor = MakeTensorFilter(vtkNPRCurvatureTensor::PER_FACE);
  tensor->OutputDerivativesOff();
  table.Add("mesh and its adjacency",
    [&]()
    {
      npr::TriangleMesh mesh(surface);
      mesh.BuildIncidence();
    });
  table.Add("vtkNPRSurfaceNormals", [&]() { Run(normals, surface); });
  normals->SetInputData(surface);
  normals->Modified();
  normals->Update();
  vtkNew<vtkPolyData> withNormals;
  withNormals->ShallowCopy(normals->GetOutput());
  table.Add("vtkNPRCurvatureTensor", [&]() { Run(tensor, withNormals); });
  tensor->SetInputData(withNormals);
  tensor->Modified();
  tensor->Update();
  vtkNew<vtkPolyData> withTensors;
  withTensors->ShallowCopy(tensor->GetOutput());
  table.Add("vtkNPRCurvatureDerivatives", [&]() { Run(derivatives, withTensors); });
  for (int e = 0; e < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++e)
  {
    const auto all = MakeTensorFilter(e);
    table.Add(
      std::string("all in one, ") + vtkNPRCurvatureTensor::GetEstimatorName(e),
      [&]() { Run(all, surface); }, e == vtkNPRCurvatureTensor::PER_FACE ? 0 : 2);
  }
  table.Add("vtkCurvatures, mean and Gauss",
    [&]()
    {
      RunVTK(surface, false);
      RunVTK(surface, true);
    });
}

//------------------------------------------------------------------------------
void PrintScaling(int runs)
{
  std::printf("\nnanoseconds for a triangle, two threads\n%-32s", "triangles of the torus");
  const std::vector<int> sizes = { 10000, 100000, 1000000, 5000000 };
  std::vector<Surface> tori;
  for (int size : sizes)
  {
    tori.push_back(MakeTorus(size));
    std::printf(" %10lld", static_cast<long long>(tori.back()->GetNumberOfPolys()));
  }
  std::printf("\n");
  UseThreads(2);
  for (int e = 0; e < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++e)
  {
    std::printf("%-32s", vtkNPRCurvatureTensor::GetEstimatorName(e));
    for (const Surface& torus : tori)
    {
      const auto filter = MakeTensorFilter(e);
      const Cost cost =
        Measure(torus == tori.back() ? std::min(runs, 2) : runs, [&]() { Run(filter, torus); });
      std::printf(" %10.0f", 1e9 * cost.Wall / torus->GetNumberOfPolys());
      std::fflush(stdout);
    }
    std::printf("\n");
  }
}

//------------------------------------------------------------------------------
/// Measures one thing: "mesh", "plain", "vtkCurvatures" or the name of an estimator.
void PrintPeak(const std::string& what, const std::function<Surface()>& makeSurface)
{
  const auto work = [&](vtkPolyData* surface, PlainMesh& plain)
  {
    const int estimator = vtkNPRCurvatureTensor::FindEstimator(what.c_str());
    if (estimator >= 0)
    {
      const auto filter = MakeTensorFilter(estimator);
      filter->SetInputData(surface);
      filter->Update();
    }
    else if (what == "vtkCurvatures")
    {
      RunVTK(surface, false);
    }
    else if (what == "plain")
    {
      plain.ComputeNormals();
      plain.ComputeAdjacency();
      plain.ComputeAreas();
      plain.ComputeCurvature();
      plain.ComputeDerivatives();
    }
  };
  UseThreads(2);
  {
    // Libraries and threads come into memory with their first use.
    const Surface small = MakeTorus(200000);
    PlainMesh plain = MakePlainMesh(small);
    work(small, plain);
  }
  malloc_trim(0);
  const double before = ReadMegabytes("VmRSS");
  Surface surface = makeSurface();
  PlainMesh plain;
  if (what == "plain")
  {
    plain = MakePlainMesh(surface);
    surface = nullptr;
  }
  ForgetPeak();
  work(surface, plain);
  std::printf("%-32s %8.1f\n", what.c_str(), ReadMegabytes("VmHWM") - before);
}

void PrintMemory(const std::string& program)
{
  std::printf("\npeak megabytes: mesh, results and working memory\n");
  std::vector<std::string> rows = { "mesh", "plain" };
  for (int e = 0; e < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++e)
  {
    rows.emplace_back(vtkNPRCurvatureTensor::GetEstimatorName(e));
  }
  rows.emplace_back("vtkCurvatures");
  std::fflush(stdout);
  for (const std::string& row : rows)
  {
    if (std::system((program + " --peak-of " + row).c_str()) != 0)
    {
      std::printf("%-32s failed\n", row.c_str());
    }
  }
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  std::string model;
  std::string peakOf;
  int triangles = 200000;
  int runs = 5;
  bool scaling = false;
  bool memory = false;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const bool hasValue = i + 1 < argc;
    if (argument == "--torus" && hasValue)
    {
      triangles = std::atoi(argv[++i]);
    }
    else if (argument == "--runs" && hasValue)
    {
      runs = std::max(1, std::atoi(argv[++i]));
    }
    else if (argument == "--peak-of" && hasValue) // what --memory starts
    {
      peakOf = argv[++i];
    }
    else if (argument == "--scaling")
    {
      scaling = true;
    }
    else if (argument == "--memory")
    {
      memory = true;
    }
    else if (argument[0] != '-')
    {
      model = argument;
    }
    else
    {
      std::fprintf(stderr,
        "usage: nprCurvatureBenchmark [MODEL | --torus N] [--runs N] [--scaling] [--memory]\n");
      return EXIT_FAILURE;
    }
  }
  const auto makeSurface = [&]()
  { return model.empty() ? MakeTorus(triangles) : ReadModel(model.c_str()); };
  if (!peakOf.empty())
  {
    PrintPeak(peakOf, makeSurface);
    return EXIT_SUCCESS;
  }
  const Surface surface = makeSurface();
  if (!surface)
  {
    return EXIT_FAILURE;
  }
  std::printf("%s: %lld points, %lld triangles\n", model.empty() ? "torus" : model.c_str(),
    static_cast<long long>(surface->GetNumberOfPoints()),
    static_cast<long long>(surface->GetNumberOfPolys()));
  PrintTimes(surface, runs);
  PrintAccuracy();
  if (scaling)
  {
    PrintScaling(runs);
  }
  if (memory)
  {
    const std::string quotedModel = "'" + model + "'";
    PrintMemory(std::string("'") + argv[0] + "' " +
      (model.empty() ? "--torus " + std::to_string(triangles) : quotedModel));
  }
  return EXIT_SUCCESS;
}
