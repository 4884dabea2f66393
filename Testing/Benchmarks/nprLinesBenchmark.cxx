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
#include "nprLengthScale.h"
#include "nprLineFlicker.h"
#include "nprPlainLines.h"
#include "nprPlainMesh.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRLineDefinition.h"
#include "vtkNPRSurfaceNormals.h"

#include <vtkPolyDataSilhouette.h>

#include <cstdlib>
#include <cstring>
#include <optional>

namespace
{
using namespace nprbench;
using Names = std::vector<std::string>;
using Views = std::vector<vtkSmartPointer<vtkCamera>>;

//------------------------------------------------------------------------------
bool IsBuilt(const std::string& name)
{
  return vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(name.c_str())) != nullptr;
}

Names GetAllNames()
{
  Names names;
  for (int i = 0; i < vtkNPRLineDefinition::GetNumberOfLineNames(); ++i)
  {
    names.emplace_back(vtkNPRLineDefinition::GetLineName(i));
  }
  return names;
}

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
vtkSmartPointer<vtkNPRFeatureLines> MakeFilter(vtkPolyData* surface, const Names& names)
{
  auto filter = vtkSmartPointer<vtkNPRFeatureLines>::New();
  for (const std::string& name : names)
  {
    filter->AddDefinition(name.c_str());
  }
  filter->SetInputData(surface);
  return filter;
}

//------------------------------------------------------------------------------
/// How many segments and chains there are in a view, in the mean.
struct Counts
{
  double Segments = 0.0;
  double Chains = 0.0;
};

//------------------------------------------------------------------------------
/// Ours beside the plain one, which is 1. The ratio with one thread is that of processor seconds,
/// with two that of time on the clock.
class TimeTable
{
public:
  TimeTable(vtkPolyData* surface, const Views& views, int runs)
    : Input(surface), AllViews(views), Runs(runs)
  {
    std::printf("%-34s %9s %7s %17s %17s %14s\n", "milliseconds a view", "segments", "chains",
      "one thread", "two threads", "ratio");
    std::printf(
      "%-52s %8s%9s %8s%9s %7s%7s\n", "", "clock", "processor", "clock", "processor", "one", "two");
  }

  /// A plain implementation, and the yardstick of what follows.
  void AddPlain(
    const char* name, const PlainLines& plain, const std::function<void(vtkCamera*)>& work)
  {
    Counts counts;
    UseThreads(1);
    this->Yardstick = MeasureMean(this->GetSize(), this->Runs,
      [&](int view)
      {
        work(this->AllViews[view]);
        counts.Segments += static_cast<double>(plain.GetSegments().size());
      });
    counts.Segments /= this->Runs * this->GetSize();
    this->PrintStart(name, counts);
    this->PrintCost(*this->Yardstick);
    std::printf("\n");
  }

  /// Also a yardstick: VTK's filter, in some of the views, for it takes long.
  void AddSilhouette()
  {
    vtkNew<vtkPolyDataSilhouette> filter;
    filter->SetInputData(this->Input);
    filter->SetEnableFeatureAngle(0);
    constexpr int stride = 8;
    const int count = (this->GetSize() + stride - 1) / stride;
    Counts counts;
    UseThreads(1);
    this->Yardstick = MeasureMean(count, 1,
      [&](int i)
      {
        filter->SetCamera(this->AllViews[i * stride]);
        filter->Modified();
        filter->Update();
        counts.Segments += static_cast<double>(filter->GetOutput()->GetNumberOfLines()) / count;
      });
    this->PrintStart("vtkPolyDataSilhouette", counts);
    this->PrintCost(*this->Yardstick);
    std::printf("\n");
  }

  /// Without a yardstick there is no ratio. `anew` sets up the definitions for every view.
  void Add(const char* title, const Names& names, bool anew = false,
    const std::function<void(vtkNPRLineDefinition*)>& setUp = nullptr)
  {
    std::string missing;
    for (const std::string& name : names)
    {
      missing += IsBuilt(name) ? "" : " " + name;
    }
    if (!missing.empty())
    {
      std::printf("%-34s not built:%s\n", title, missing.c_str());
      return;
    }
    const auto filter = MakeFilter(this->Input, names);
    for (int i = 0; setUp && i < filter->GetNumberOfDefinitions(); ++i)
    {
      setUp(filter->GetDefinition(i));
    }
    Cost costs[2];
    Counts counts;
    for (int threads = 1; threads <= 2; ++threads)
    {
      UseThreads(threads);
      filter->SetCamera(this->AllViews[0]);
      filter->Update(); // the set-up
      costs[threads - 1] = MeasureMean(this->GetSize(), this->Runs,
        [&](int view)
        {
          filter->SetCamera(this->AllViews[view]);
          for (int i = 0; anew && i < filter->GetNumberOfDefinitions(); ++i)
          {
            filter->GetDefinition(i)->Modified();
          }
          filter->Update();
          vtkCellArray* const lines = filter->GetOutput()->GetLines();
          counts.Segments +=
            static_cast<double>(lines->GetNumberOfConnectivityIds() - lines->GetNumberOfCells());
          counts.Chains += static_cast<double>(lines->GetNumberOfCells());
        });
    }
    counts.Segments /= 2 * this->Runs * this->GetSize();
    counts.Chains /= 2 * this->Runs * this->GetSize();
    this->PrintStart(title, counts);
    this->PrintCost(costs[0]);
    this->PrintCost(costs[1]);
    if (this->Yardstick)
    {
      std::printf(" %7.2f%7.2f", costs[0].Processor / this->Yardstick->Processor,
        costs[1].Wall / this->Yardstick->Wall);
    }
    std::printf("\n");
    std::fflush(stdout);
  }

  void ForgetYardstick() { this->Yardstick.reset(); }

private:
  int GetSize() const { return static_cast<int>(this->AllViews.size()); }
  static void PrintStart(const char* title, const Counts& counts)
  {
    std::printf("%-34s %9.0f", title, counts.Segments);
    if (counts.Chains > 0.0)
    {
      std::printf(" %7.0f", counts.Chains);
    }
    else
    {
      std::printf(" %7s", "");
    }
  }
  static void PrintCost(const Cost& cost)
  {
    std::printf(" %8.2f%9.2f", 1e3 * cost.Wall, 1e3 * cost.Processor);
  }

  vtkPolyData* Input;
  const Views& AllViews;
  int Runs;
  std::optional<Cost> Yardstick;
};

//------------------------------------------------------------------------------
std::vector<float> MakeLevels(int count, double low, double high)
{
  std::vector<float> levels;
  for (int i = 1; i <= count; ++i)
  {
    levels.push_back(static_cast<float>(low + (high - low) * i / (count + 1)));
  }
  return levels;
}

void PrintTimes(vtkPolyData* surface, const Views& views, int runs)
{
  Eigen::Vector3d origin;
  PlainMesh mesh = MakePlainMesh(surface, &origin);
  CopyCurvature(surface, mesh);
  PlainLines plain(std::move(mesh), static_cast<float>(npr::GetLengthScale(surface)));
  const auto getEye = [&](vtkCamera* camera)
  {
    return PlainMesh::Vector(
      (Eigen::Map<const Vector3d>(camera->GetPosition()) - origin).cast<float>());
  };
  double bounds[6];
  surface->GetBounds(bounds);
  const std::vector<float> heights = MakeLevels(20, bounds[2] - origin.y(), bounds[3] - origin.y());
  const std::vector<float> tones = MakeLevels(9, 0.0, 1.0);
  const auto setLevels = [](double count)
  {
    return [count](vtkNPRLineDefinition* definition) { definition->SetParameter("levels", count); };
  };

  TimeTable table(surface, views, runs);
  table.AddPlain(
    "plain: contours", plain, [&](vtkCamera* camera) { plain.FindContours(getEye(camera)); });
  table.Add("contours", { "contours" });
  table.AddPlain("plain: contours, suggestive", plain,
    [&](vtkCamera* camera) { plain.FindSuggestiveContours(getEye(camera)); });
  table.Add("contours, suggestive", { "contours", "suggestive" });
  table.AddPlain("plain: apparent ridges", plain,
    [&](vtkCamera* camera) { plain.FindApparentRidges(getEye(camera)); });
  table.Add("apparent-ridges", { "apparent-ridges" });
  table.AddPlain(
    "plain: ridges, valleys", plain, [&](vtkCamera*) { plain.FindRidgesAndValleys(); });
  table.Add("ridges, valleys, parabolic: new view", { "ridges", "valleys", "parabolic" });
  table.Add("ridges, valleys: new view", { "ridges", "valleys" });
  table.Add("ridges, valleys: found anew", { "ridges", "valleys" }, true);
  table.AddPlain("plain: 9 isophotes", plain,
    [&](vtkCamera* camera) { plain.FindIsophotes(getEye(camera), tones); });
  table.Add("isophotes", { "isophotes" }, false, setLevels(9.0));
  table.AddPlain("plain: 20 topographic levels", plain,
    [&](vtkCamera*) { plain.FindTopographicLines(PlainMesh::Vector::UnitY(), heights); });
  table.Add("topographic: found anew", { "topographic" }, true, setLevels(20.0));
  table.AddSilhouette();
  table.Add("contour-edges", { "contour-edges" });
  table.ForgetYardstick();
  std::printf("every kind alone\n");
  for (const std::string& name : GetAllNames())
  {
    table.Add(name.c_str(), { name });
  }
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
  std::printf("\ncontours, milliseconds a view, two threads\n%-34s", "triangles of the torus");
  const std::vector<int> sizes = { 10000, 50000, 200000, 1000000, 5000000 };
  for (const int size : sizes)
  {
    std::printf(" %9d", size);
  }
  std::printf(" %9s\n", "exponent");
  UseThreads(2);
  for (const double bumps : { 0.0, 0.15 })
  {
    std::printf("%-34s", bumps > 0.0 ? "bumpy" : "smooth");
    std::vector<double> triangles;
    std::vector<double> seconds;
    for (const int size : sizes)
    {
      const Surface surface = AddNormals(MakeTorus(size, bumps));
      const Views views = MakeViews(surface, 12);
      const auto filter = MakeFilter(surface, { "contours" });
      filter->SetCamera(views[0]);
      filter->Update();
      const Cost cost = MeasureMean(static_cast<int>(views.size()), runs,
        [&](int view)
        {
          filter->SetCamera(views[view]);
          filter->Update();
        });
      triangles.push_back(static_cast<double>(surface->GetNumberOfPolys()));
      seconds.push_back(cost.Wall);
      std::printf(" %9.2f", 1e3 * cost.Wall);
      std::fflush(stdout);
    }
    std::printf(" %9.2f\n", FitExponent(triangles, seconds));
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
    const auto filter = MakeFilter(small, names);
    filter->SetCamera(views[0]);
    filter->Update();
  }
  malloc_trim(0);
  const double before = ReadMegabytes("VmRSS");
  ForgetPeak();
  const auto filter = MakeFilter(surface, names);
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
  for (const std::string& name : GetAllNames())
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
    "\n%-34s %9s %9s %9s\n", "per cent a step of half a degree", "appeared", "vanished", "pixels");
  UseThreads(2);
  for (const std::string& name : GetAllNames())
  {
    const LineFlicker flicker = MeasureFlicker(surface, name.c_str(), steps, 0.5);
    std::printf("%-34s %9.2f %9.2f %9.0f\n", name.c_str(), 100.0 * flicker.Appeared,
      100.0 * flicker.Vanished, flicker.Pixels);
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
  PrintTimes(surface, views, arguments.Runs);
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
