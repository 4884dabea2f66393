// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineTimes.h"

#include "nprBenchmarkCost.h"
#include "nprLengthScale.h"
#include "nprPlainLines.h"
#include "nprPlainMesh.h"
#include "vtkNPRLineDefinition.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyDataSilhouette.h>

#include <array>
#include <cstdio>
#include <numeric>
#include <optional>
#include <utility>

namespace nprbench
{
namespace
{
using Settings = std::vector<std::pair<const char*, std::vector<double>>>;

bool IsBuilt(const std::string& name)
{
  return vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(name.c_str())) != nullptr;
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

  /// Without a yardstick there is no ratio. `anew` has the lines found again even if no view
  /// changes them. The second line says where the time with two threads goes.
  void Add(const char* title, const Names& names, bool anew = false, const Settings& settings = {},
    int strategy = vtkNPRFeatureLines::HIERARCHICAL)
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
    const auto filter = MakeLineFilter(this->Input, names);
    filter->SetStrategy(strategy);
    for (const auto& [parameter, values] : settings)
    {
      if (!filter->GetDefinition(0)->SetParameter(parameter, values))
      {
        std::printf("%s: there is no such parameter as \"%s\"\n", title, parameter);
      }
    }
    Cost costs[2];
    Counts counts;
    std::array<double, vtkNPRFeatureLines::NumberOfStages> stages;
    for (int threads = 1; threads <= 2; ++threads)
    {
      UseThreads(threads);
      filter->SetCamera(this->AllViews[0]);
      filter->Update(); // the set-up
      stages.fill(0.0);
      costs[threads - 1] = MeasureMean(this->GetSize(), this->Runs,
        [&](int view)
        {
          filter->SetCamera(this->AllViews[view]);
          for (int i = 0; anew && i < filter->GetNumberOfDefinitions(); ++i)
          {
            filter->GetDefinition(i)->Modified();
          }
          filter->Update();
          for (int stage = 0; stage < vtkNPRFeatureLines::NumberOfStages; ++stage)
          {
            stages[stage] += filter->GetStageSeconds(stage);
          }
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
    PrintShares(stages);
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
  static void PrintShares(const std::array<double, vtkNPRFeatureLines::NumberOfStages>& stages)
  {
    const double all = std::accumulate(stages.begin(), stages.end(), 0.0);
    std::printf("   ");
    for (int stage = 0; stage < vtkNPRFeatureLines::NumberOfStages; ++stage)
    {
      std::printf(
        " %s %.0f %%", vtkNPRFeatureLines::GetStageName(stage), 100.0 * stages[stage] / all);
    }
    std::printf("\n");
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
}

//------------------------------------------------------------------------------
Names GetAllLineNames()
{
  Names names;
  for (int i = 0; i < vtkNPRLineDefinition::GetNumberOfLineNames(); ++i)
  {
    const char* const name = vtkNPRLineDefinition::GetLineName(i);
    if (vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(name))->IsForAnySurface())
    {
      names.emplace_back(name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkNPRFeatureLines> MakeLineFilter(vtkPolyData* surface, const Names& names)
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
void PrintLineTimes(vtkPolyData* surface, const Views& views, int runs)
{
  Eigen::Vector3d origin;
  PlainMesh mesh = MakePlainMesh(surface, &origin);
  CopyCurvature(surface, mesh);
  PlainLines plain(std::move(mesh), static_cast<float>(npr::GetLengthScale(surface)));
  const auto getEye = [&](vtkCamera* camera)
  {
    return PlainMesh::Vector(
      (Eigen::Map<const Eigen::Vector3d>(camera->GetPosition()) - origin).cast<float>());
  };
  double bounds[6];
  surface->GetBounds(bounds);
  const std::vector<float> heights = MakeLevels(20, bounds[2] - origin.y(), bounds[3] - origin.y());
  const std::vector<float> tones = MakeLevels(9, 0.0, 1.0);
  TimeTable table(surface, views, runs);
  table.AddPlain(
    "plain: contours", plain, [&](vtkCamera* camera) { plain.FindContours(getEye(camera)); });
  table.Add("contours", { "contours" });
  table.Add(
    "contours, all triangles", { "contours" }, false, {}, vtkNPRFeatureLines::FULL_TRAVERSAL);
  table.Add("contours, random seeds", { "contours" }, false, {}, vtkNPRFeatureLines::RANDOM_SEEDS);
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
  table.Add("isophotes", { "isophotes" }, false,
    { { "levels", { 9.0 } }, { "threshold", { 0.0 } }, { "distance", { 0.0 } },
      { "smoothing", { 0.0 } } });
  table.AddPlain("plain: 20 topographic levels", plain,
    [&](vtkCamera*) { plain.FindTopographicLines(PlainMesh::Vector::UnitY(), heights); });
  table.Add("topographic: found anew", { "topographic" }, true,
    { { "levels", { 20.0 } }, { "direction", { 0.0, 1.0, 0.0 } } });
  table.AddSilhouette();
  table.Add("contour-edges", { "contour-edges" });
  table.ForgetYardstick();
  std::printf("every kind alone\n");
  for (const std::string& name : GetAllLineNames())
  {
    table.Add(name.c_str(), { name });
  }
}
}
