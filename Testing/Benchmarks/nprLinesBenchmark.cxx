// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What lines cost in a new view, beside a plain implementation of the published algorithms and
 * beside VTK's own filter, in one run:
 *
 *   nprLinesBenchmark [MODEL | --torus N] [--views N] [--runs N] [--jets]
 *                     [--scaling] [--memory] [--flicker]
 *
 * MODEL is prepared once, its creases left whole; without it a torus of N triangles is made (200000
 * if not said). Its curvature is estimated per face (--jets: by jets). The views (--views; 32) are
 * on a circle around it at three distances; a time is the mean over the views, for each of which
 * the least of several runs (--runs; 3) counts. Machines are busy with other things: seconds of
 * processor time are little disturbed by that, and ratios least. Kinds of lines that this build
 * does not know are said to be not built.
 *
 * --scaling shows the time of contours on tori, smooth and bumpy, from 10k to 5M triangles, and the
 * exponent that it grows with. --memory shows what the filter holds between two views, and its
 * set-up: it starts this program once for each row (Linux only). --flicker shows which share of the
 * lines comes and goes with each half degree that the camera turns.
 */
#include "nprBenchmarkCost.h"
#include "nprBenchmarkModel.h"
#include "nprBenchmarkTorus.h"
#include "nprBenchmarkViews.h"
#include "nprLineFlicker.h"
#include "nprLineTimes.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRSurfaceNormals.h"

#include <cstdlib>

namespace
{
using namespace nprbench;

//------------------------------------------------------------------------------
/// Normals, curvature and its derivatives.
Surface AddCurvature(vtkPolyData* surface, int estimator)
{
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetEstimator(estimator);
  tensor->SetInputData(surface);
  tensor->Update();
  return tensor->GetOutput();
}

Surface AddNormals(vtkPolyData* surface)
{
  vtkNew<vtkNPRSurfaceNormals> normals;
  normals->SetInputData(surface);
  normals->Update();
  return normals->GetOutput();
}

//------------------------------------------------------------------------------
/// The exponent of y = a x^b, by least squares of the logarithms.
double FitExponent(const std::vector<double>& x, const std::vector<double>& y)
{
  const Eigen::Map<const Eigen::ArrayXd> xs(x.data(), static_cast<Eigen::Index>(x.size()));
  const Eigen::Map<const Eigen::ArrayXd> ys(y.data(), static_cast<Eigen::Index>(y.size()));
  const Eigen::ArrayXd u = xs.log() - xs.log().mean();
  return (u * ys.log()).sum() / u.square().sum();
}

void PrintScaling(int runs)
{
  std::printf("\ncontours, milliseconds a view\n%-34s", "triangles of the torus");
  const std::vector<int> sizes = { 10000, 50000, 200000, 1000000, 5000000 };
  for (const int size : sizes)
  {
    std::printf(" %9d", size);
  }
  std::printf(" %9s\n", "exponent");
  for (const double bumps : { 0.0, 0.15 })
  {
    std::vector<double> triangles;
    std::array<std::vector<double>, 2> seconds; // with one thread, with two
    std::vector<double> points;
    for (const int size : sizes)
    {
      const Surface surface = AddNormals(MakeTorus(size, bumps));
      const Views views = MakeViews(surface, 12);
      const auto filter = MakeLineFilter(surface, { "contours" });
      filter->SetCamera(views[0]);
      filter->Update();
      triangles.push_back(static_cast<double>(surface->GetNumberOfPolys()));
      for (const int threads : { 1, 2 })
      {
        UseThreads(threads);
        const Cost cost = MeasureMean(static_cast<int>(views.size()), runs,
          [&](int view)
          {
            filter->SetCamera(views[view]);
            filter->Update();
          });
        seconds[threads - 1].push_back(threads == 1 ? cost.Processor : cost.Wall);
      }
      points.push_back(static_cast<double>(filter->GetOutput()->GetNumberOfPoints()));
    }
    for (const int threads : { 1, 2 })
    {
      const std::string title = std::string(bumps > 0.0 ? "bumpy" : "smooth") +
        (threads == 1 ? ", one thread, processor" : ", two threads, wall");
      std::printf("%-34s", title.c_str());
      for (const double time : seconds[threads - 1])
      {
        std::printf(" %9.2f", 1e3 * time);
      }
      std::printf(" %9.2f\n", FitExponent(triangles, seconds[threads - 1]));
    }
    std::printf("%-34s", "  points of the lines, last view");
    for (const double count : points)
    {
      std::printf(" %9.0f", count);
    }
    std::printf(" %9.2f\n", FitExponent(triangles, points));
    std::fflush(stdout);
  }
}

//------------------------------------------------------------------------------
Names Split(const std::string& list)
{
  Names names;
  for (std::size_t begin = 0; begin < list.size();)
  {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    names.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

/// Measures one filter: the names of its lines with commas between them.
void PrintHeld(const std::string& list, vtkPolyData* surface, const Views& views)
{
  UseThreads(2);
  const Names names = Split(list);
  {
    // Libraries and threads come into memory with their first use.
    const Surface small = AddCurvature(MakeTorus(20000), vtkNPRCurvatureTensor::PER_FACE);
    const auto filter = MakeLineFilter(small, names);
    filter->SetCamera(views[0]);
    filter->Update();
  }
  malloc_trim(0);
  const double before = ReadMegabytes("VmRSS");
  ForgetPeak();
  const auto filter = MakeLineFilter(surface, names);
  filter->SetCamera(views[0]);
  const Cost first = Measure(1, [&]() { filter->Update(); });
  const double peak = ReadMegabytes("VmHWM");
  const Cost later = MeasureMean(static_cast<int>(views.size()), 1,
    [&](int view)
    {
      filter->SetCamera(views[view]);
      filter->Update();
    });
  filter->GetOutput()->Initialize();
  malloc_trim(0);
  const double scale = 1024.0 * 1024.0 / static_cast<double>(surface->GetNumberOfPolys());
  std::printf("%-34s %9.1f %9.1f %11.3f %9.3f\n", list.c_str(),
    scale * (ReadMegabytes("VmRSS") - before), scale * (peak - before), first.Wall - later.Wall,
    first.Processor - later.Processor);
}

void PrintMemory(vtkPolyData* surface, int estimator, const std::string& program)
{
  UseThreads(2);
  const Cost cost = Measure(2, [&]() { AddCurvature(surface, estimator); });
  std::printf("\n%-34s %19s %21s\n", "two threads", "bytes a triangle", "seconds of set-up");
  std::printf("%-34s %9s %9s %11s %9s\n", "", "held", "peak", "clock", "processor");
  std::printf(
    "%-34s %9s %9s %11.3f %9.3f\n", "vtkNPRCurvatureTensor", "", "", cost.Wall, cost.Processor);
  Names rows = { "contours", "contours,suggestive" };
  std::string all;
  for (const std::string& name : GetAllLineNames())
  {
    all += (all.empty() ? "" : ",") + name;
  }
  rows.push_back(all);
  std::fflush(stdout);
  for (const std::string& row : rows)
  {
    if (std::system((program + " --held-by " + row).c_str()) != 0)
    {
      std::printf("%-34s failed\n", row.c_str());
    }
  }
}

//------------------------------------------------------------------------------
void PrintFlicker(vtkPolyData* surface)
{
  constexpr int steps = 24;
  std::printf(
    "\n%-34s %9s %9s %9s\n", "per cent a step of half a degree", "faded", "drawn", "pixels");
  UseThreads(2);
  for (const std::string& name : GetAllLineNames())
  {
    const LineFlicker flicker = MeasureFlicker(surface, name.c_str(), steps, 0.5);
    std::printf("%-34s %9.3f %9.3f %9.0f\n", name.c_str(), 100.0 * flicker.Faded,
      100.0 * flicker.Drawn, flicker.Pixels);
    std::fflush(stdout);
  }
}

//------------------------------------------------------------------------------
struct Arguments
{
  std::string Model;
  std::string HeldBy; // what --memory starts
  int Triangles = 200000;
  int Views = 32;
  int Runs = 3;
  bool Jets = false;
  bool Scaling = false;
  bool Memory = false;
  bool Flicker = false;

  bool Read(int argc, char* argv[])
  {
    for (int i = 1; i < argc; ++i)
    {
      const std::string argument = argv[i];
      const bool hasValue = i + 1 < argc;
      const auto is = [&argument](const char* name, bool& flag)
      { return argument == name && (flag = true); };
      if (argument == "--torus" && hasValue)
      {
        this->Triangles = std::atoi(argv[++i]);
      }
      else if (argument == "--views" && hasValue)
      {
        this->Views = std::max(1, std::atoi(argv[++i]));
      }
      else if (argument == "--runs" && hasValue)
      {
        this->Runs = std::max(1, std::atoi(argv[++i]));
      }
      else if (argument == "--held-by" && hasValue)
      {
        this->HeldBy = argv[++i];
      }
      else if (is("--jets", this->Jets) || is("--scaling", this->Scaling) ||
        is("--memory", this->Memory) || is("--flicker", this->Flicker))
      {
        continue;
      }
      else if (argument[0] != '-')
      {
        this->Model = argument;
      }
      else
      {
        return false;
      }
    }
    return true;
  }
};
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  Arguments arguments;
  if (!arguments.Read(argc, argv))
  {
    std::fprintf(stderr,
      "usage: nprLinesBenchmark [MODEL | --torus N] [--views N] [--runs N] [--jets]\n"
      "                         [--scaling] [--memory] [--flicker]\n");
    return EXIT_FAILURE;
  }
  const std::string& model = arguments.Model;
  const Surface bare = model.empty() ? MakeTorus(arguments.Triangles) : ReadModel(model.c_str());
  if (!bare)
  {
    return EXIT_FAILURE;
  }
  const int estimator =
    arguments.Jets ? vtkNPRCurvatureTensor::JETS : vtkNPRCurvatureTensor::PER_FACE;
  const Surface surface = AddCurvature(bare, estimator);
  const Views views = MakeViews(surface, arguments.Views);
  if (!arguments.HeldBy.empty())
  {
    PrintHeld(arguments.HeldBy, surface, views);
    return EXIT_SUCCESS;
  }
  std::printf("%s: %lld points, %lld triangles, %d views\n",
    model.empty() ? "torus" : model.c_str(), static_cast<long long>(surface->GetNumberOfPoints()),
    static_cast<long long>(surface->GetNumberOfPolys()), arguments.Views);
  PrintLineTimes(surface, views, arguments.Runs);
  if (arguments.Scaling)
  {
    PrintScaling(arguments.Runs);
  }
  if (arguments.Memory)
  {
    PrintMemory(bare, estimator,
      std::string("'") + argv[0] + "' --views 4 " + (arguments.Jets ? "--jets " : "") +
        (model.empty() ? "--torus " + std::to_string(arguments.Triangles) : "'" + model + "'"));
  }
  if (arguments.Flicker)
  {
    PrintFlicker(surface);
  }
  return EXIT_SUCCESS;
}
