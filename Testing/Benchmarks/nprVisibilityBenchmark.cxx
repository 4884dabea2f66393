// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How much of the lines of a model is labelled visible or hidden wrongly, and what that costs:
 *
 *   nprVisibilityBenchmark [MODEL...] [--views N] [--runs N] [--jets] [--splines] [--no-oracle]
 *                          [--minimum PIXELS] [--depth]
 *
 * Several models are one scene: each is scaled to the same size and put on a circle by a matrix of
 * its own, so that they hide one another. Without any the built-in sample is taken. Drawn are
 * contours, suggestive contours and creases, as chains, or with --splines as Catmull-Rom splines,
 * in an image 700 pixels high. The views (--views; 10) are all around, in turn with a perspective
 * and a parallel projection.
 *
 * A row is a view: the length of the strokes; what share of it is labelled visible but hidden, or
 * hidden but visible, or only has another number of layers; the longest piece that is wrong; how
 * many visible parts are shorter than 5 pixels (and how many strokes were); seconds for a view with
 * the surfaces prepared anew, for a new view, and for one that only tells visible from hidden, the
 * least of several runs (--runs; 3) with two threads. What is right is said by
 * nprtest::VisibilityOracle, every quarter of a pixel along the strokes. --minimum is the
 * length of the shortest parts that are kept; 0 keeps all. --depth tries vtkNPRDepthVisibility
 * instead, with the depth buffer of the same surfaces in a window twice as wide as it is high; the
 * seconds are those of the picture, and of the filter.
 */
#include "nprArrayNames.h"
#include "nprBenchmarkCost.h"
#include "nprBenchmarkViews.h"
#include "nprDepthPicture.h"
#include "nprVisibilityOracle.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRModelImporter.h"
#include "vtkNPRSampleSource.h"
#include "vtkNPRSplineStrokes.h"
#include "vtkNPRStrokeVisibility.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

namespace
{
using namespace nprbench;
using Surface = vtkSmartPointer<vtkPolyData>;
constexpr double Height = 700.0; // of the image, in pixels

struct Arguments
{
  std::vector<std::string> Models;
  int Views = 10;
  int Runs = 3;
  bool Jets = false;
  bool Splines = false;
  double Minimum = -1.0; // the filter's own
  bool NoOracle = false;
  bool Depth = false;

  bool Read(int argc, char* argv[])
  {
    for (int i = 1; i < argc; ++i)
    {
      const std::string argument = argv[i];
      const bool hasValue = i + 1 < argc;
      const auto is = [&argument](const char* name, bool& flag)
      { return argument == name && (flag = true); };
      if (argument == "--views" && hasValue)
      {
        this->Views = std::max(1, std::atoi(argv[++i]));
      }
      else if (argument == "--minimum" && hasValue)
      {
        this->Minimum = std::atof(argv[++i]);
      }
      else if (argument == "--runs" && hasValue)
      {
        this->Runs = std::max(1, std::atoi(argv[++i]));
      }
      else if (is("--jets", this->Jets) || is("--splines", this->Splines) ||
        is("--no-oracle", this->NoOracle) || is("--depth", this->Depth))
      {
        continue;
      }
      else if (argument[0] != '-')
      {
        this->Models.push_back(argument);
      }
      else
      {
        return false;
      }
    }
    return true;
  }
};

//------------------------------------------------------------------------------
/// A surface with its matrix and the filter that makes its lines.
struct Actor
{
  Surface Data;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkNew<vtkNPRFeatureLines> Lines;
};
using Actors = std::vector<std::unique_ptr<Actor>>;

/// A file's surface, or the sample without one, split along its creases. Null, with the importer's
/// error, where there is none.
Surface ReadSurface(const std::string& name)
{
  vtkNew<vtkNPRSampleSource> sample;
  vtkNew<vtkNPRModelImporter> importer;
  vtkNew<vtkPolyData> model;
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputConnection(sample->GetOutputPort());
  if (!name.empty())
  {
    importer->SetFileName(name.c_str());
    if (!importer->GetSurface(model))
    {
      return nullptr;
    }
    preparation->SetInputData(model);
  }
  preparation->Update();
  return preparation->GetOutput();
}

bool AddActor(const std::string& model, const Arguments& arguments, Actors& actors)
{
  const Surface bare = ReadSurface(model);
  if (!bare)
  {
    return false;
  }
  auto actor = std::make_unique<Actor>();
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetEstimator(
    arguments.Jets ? vtkNPRCurvatureTensor::JETS : vtkNPRCurvatureTensor::PER_FACE);
  tensor->SetInputData(bare);
  tensor->Update();
  actor->Data = tensor->GetOutput();
  if (arguments.Models.size() > 1)
  {
    const double angle = 360.0 * static_cast<double>(actors.size()) / arguments.Models.size();
    const double* const centre = actor->Data->GetCenter();
    vtkNew<vtkTransform> place;
    place->RotateY(angle);
    place->Translate(0.0, 0.0, 0.8);
    place->RotateX(angle);
    const double scale = 1.0 / actor->Data->GetLength();
    place->Scale(scale, scale, scale);
    place->Translate(-centre[0], -centre[1], -centre[2]);
    actor->Matrix->DeepCopy(place->GetMatrix());
  }
  actor->Lines->SetInputData(actor->Data);
  actor->Lines->SetMatrix(actor->Matrix);
  for (const char* name : { "contours", "suggestive", "creases" })
  {
    actor->Lines->AddDefinition(name);
  }
  actors.push_back(std::move(actor));
  return true;
}

/// The lines of all actors, in the world.
Surface MakeStrokes(const Actors& actors, vtkCamera* camera, bool splines)
{
  vtkNew<vtkAppendPolyData> append;
  for (const auto& actor : actors)
  {
    actor->Lines->SetCamera(camera);
    actor->Lines->Update();
    vtkNew<vtkTransform> toWorld;
    toWorld->SetMatrix(actor->Matrix);
    vtkNew<vtkTransformPolyDataFilter> place;
    place->SetTransform(toWorld);
    place->SetInputData(actor->Lines->GetOutput());
    place->Update();
    append->AddInputData(place->GetOutput());
  }
  append->Update();
  if (!splines)
  {
    return append->GetOutput();
  }
  vtkNew<vtkNPRSplineStrokes> spline;
  spline->SetInputConnection(append->GetOutputPort());
  spline->Update();
  return spline->GetOutput();
}

Surface MakeWorld(const Actors& actors)
{
  vtkNew<vtkAppendPolyData> append;
  for (const auto& actor : actors)
  {
    vtkNew<vtkTransform> toWorld;
    toWorld->SetMatrix(actor->Matrix);
    vtkNew<vtkTransformPolyDataFilter> place;
    place->SetTransform(toWorld);
    place->SetInputData(actor->Data);
    place->Update();
    append->AddInputData(place->GetOutput());
  }
  append->Update();
  return append->GetOutput();
}

//------------------------------------------------------------------------------
/// Lengths in pixels.
struct Errors
{
  double All = 0.0;
  double WrongVisible = 0.0; // labelled visible, but hidden
  double WrongHidden = 0.0;  // labelled hidden, but visible
  double WrongLayers = 0.0;  // hidden, but by another number of layers
  double LongestVisible = 0.0;
  double LongestHidden = 0.0;
};

Eigen::Vector3d GetTuple(vtkDataArray* array, vtkIdType id)
{
  Eigen::Vector3d tuple;
  array->GetTuple(id, tuple.data());
  return tuple;
}

Errors CompareWithOracle(vtkPolyData* strokes, nprtest::VisibilityOracle& oracle)
{
  constexpr double step = 0.25;
  Errors errors;
  auto* const layers =
    vtkIntArray::SafeDownCast(strokes->GetCellData()->GetArray(npr::names::HidingLayers));
  vtkDataArray* const points = strokes->GetPoints()->GetData();
  vtkDataArray* const normals = strokes->GetPointData()->GetArray(npr::names::Normals);
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < strokes->GetNumberOfLines(); ++line)
  {
    strokes->GetLines()->GetCellAtId(line, ids);
    const int label = layers->GetValue(line);
    double next = 0.5 * step; // where along the image the next sample is
    double visibleRun = 0.0;
    double hiddenRun = 0.0;
    double passed = 0.0;
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      const Eigen::Vector3d from = GetTuple(points, ids->GetId(i));
      const Eigen::Vector3d to = GetTuple(points, ids->GetId(i + 1));
      const Eigen::Vector3d normalFrom = GetTuple(normals, ids->GetId(i));
      const Eigen::Vector3d normalTo = GetTuple(normals, ids->GetId(i + 1));
      const double length = (oracle.See(to) - oracle.See(from)).head<2>().norm();
      for (; next < passed + length; next += step)
      {
        const double t = (next - passed) / length;
        const int truth = oracle.CountLayers(
          from + t * (to - from), normalFrom + t * (normalTo - normalFrom), to - from);
        const bool isWrongVisible = label == 0 && truth > 0;
        const bool isWrongHidden = label > 0 && truth == 0;
        errors.All += step;
        errors.WrongVisible += isWrongVisible ? step : 0.0;
        errors.WrongHidden += isWrongHidden ? step : 0.0;
        errors.WrongLayers += label > 0 && truth > 0 && label != truth ? step : 0.0;
        visibleRun = isWrongVisible ? visibleRun + step : 0.0;
        hiddenRun = isWrongHidden ? hiddenRun + step : 0.0;
        errors.LongestVisible = std::max(errors.LongestVisible, visibleRun);
        errors.LongestHidden = std::max(errors.LongestHidden, hiddenRun);
      }
      passed += length;
    }
  }
  return errors;
}

/// How many polylines look shorter than 5 pixels; of parts, only the visible ones.
int CountFragments(vtkPolyData* strokes, const nprtest::VisibilityOracle& oracle)
{
  vtkDataArray* const layers = strokes->GetCellData()->GetArray(npr::names::HidingLayers);
  vtkDataArray* const points = strokes->GetPoints()->GetData();
  int count = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < strokes->GetNumberOfLines(); ++line)
  {
    strokes->GetLines()->GetCellAtId(line, ids);
    double length = 0.0;
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      length += (oracle.See(GetTuple(points, ids->GetId(i + 1))) -
        oracle.See(GetTuple(points, ids->GetId(i))))
                  .head<2>()
                  .norm();
    }
    count += length < 5.0 && (!layers || layers->GetComponent(line, 0) == 0.0) ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
struct Row
{
  Errors Wrong;
  int Fragments = 0;
  int Strokes = 0;
  double First = 0.0;
  double NewView = 0.0;
  double VisibleOnly = 0.0;
};

void PrintRow(const char* name, const Row& row)
{
  const double percent = 100.0 / std::max(1e-9, row.Wrong.All);
  std::printf("%-12s %8.0f %8.3f %8.3f %8.3f %7.2f %7.2f %6d %6d %8.3f %8.3f %8.3f\n", name,
    row.Wrong.All, percent * row.Wrong.WrongVisible, percent * row.Wrong.WrongHidden,
    percent * row.Wrong.WrongLayers, row.Wrong.LongestVisible, row.Wrong.LongestHidden,
    row.Fragments, row.Strokes, row.First, row.NewView, row.VisibleOnly);
  std::fflush(stdout);
}

vtkSmartPointer<vtkNPRStrokeVisibility> MakeFilter(
  const Actors& actors, vtkPolyData* strokes, vtkCamera* camera, double minimum)
{
  auto filter = vtkSmartPointer<vtkNPRStrokeVisibility>::New();
  filter->SetInputData(strokes);
  for (const auto& actor : actors)
  {
    filter->AddSurfaceData(actor->Data, actor->Matrix);
  }
  filter->SetCamera(camera);
  filter->SetViewportHeight(Height);
  filter->SetMinimumLength(minimum < 0.0 ? filter->GetMinimumLength() : minimum);
  return filter;
}

/// What vtkNPRDepthVisibility says, and the seconds that the picture and the filter take.
vtkPolyData* LabelByDepth(DepthPicture& picture, const Arguments& arguments, vtkPolyData* strokes,
  vtkCamera* camera, Row& row)
{
  row.NewView = Measure(arguments.Runs, [&]() { picture.Render(camera); }).Wall;
  vtkNPRDepthVisibility* const filter = picture.GetFilter();
  filter->SetInputData(strokes);
  filter->SetMinimumLength(
    arguments.Minimum < 0.0 ? filter->GetMinimumLength() : arguments.Minimum);
  row.VisibleOnly = Measure(arguments.Runs,
    [&]()
    {
      filter->Modified();
      filter->Update();
    }).Wall;
  return filter->GetOutput();
}

void PrintStages(vtkNPRStrokeVisibility* filter)
{
  for (int stage = 0; stage < vtkNPRStrokeVisibility::NumberOfStages; ++stage)
  {
    std::printf(
      " %s %.3f", vtkNPRStrokeVisibility::GetStageName(stage), filter->GetStageSeconds(stage));
  }
  std::printf("\n");
}

/// What vtkNPRStrokeVisibility says. `kept` has prepared the surfaces after the first call.
vtkPolyData* LabelBySurfaces(const Actors& actors, const Arguments& arguments, vtkPolyData* strokes,
  vtkCamera* camera, vtkSmartPointer<vtkNPRStrokeVisibility>& kept, double& megabytes, Row& row)
{
  vtkSmartPointer<vtkNPRStrokeVisibility> filter;
  if (!kept)
  {
    ForgetPeak();
    const double before = ReadMegabytes("VmRSS");
    MakeFilter(actors, strokes, camera, arguments.Minimum)->Update();
    megabytes = ReadMegabytes("VmHWM") - before;
    kept = MakeFilter(actors, strokes, camera, arguments.Minimum);
    kept->Update();
    PrintStages(kept);
  }
  row.First = Measure(arguments.Runs,
    [&]()
    {
      filter = MakeFilter(actors, strokes, camera, arguments.Minimum);
      filter->Update();
    }).Wall;
  kept->SetInputData(strokes);
  kept->SetCamera(camera);
  for (const bool visibleOnly : { true, false })
  {
    kept->SetMaximumLayers(visibleOnly ? vtkNPRStrokeVisibility::VISIBLE_ONLY : VTK_INT_MAX);
    (visibleOnly ? row.VisibleOnly : row.NewView) = Measure(arguments.Runs,
      [&]()
      {
        kept->Modified();
        kept->Update();
      }).Wall;
  }
  return kept->GetOutput();
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  Arguments arguments;
  if (!arguments.Read(argc, argv))
  {
    std::fprintf(stderr,
      "usage: nprVisibilityBenchmark [MODEL...] [--views N] [--runs N] [--jets] [--splines]\n"
      "                              [--no-oracle] [--minimum PIXELS] [--depth]\n");
    return EXIT_FAILURE;
  }
  if (arguments.Models.empty())
  {
    arguments.Models.emplace_back();
  }
  UseThreads(2);
  Actors actors;
  for (const std::string& model : arguments.Models)
  {
    if (!AddActor(model, arguments, actors))
    {
      return EXIT_FAILURE;
    }
  }
  const Surface world = MakeWorld(actors);
  std::printf("%s%s: %lld triangles\n",
    arguments.Models[0].empty() ? "sample" : arguments.Models[0].c_str(),
    actors.size() > 1 ? " ..." : "", static_cast<long long>(world->GetNumberOfPolys()));
  nprtest::VisibilityOracle oracle;
  if (!arguments.NoOracle)
  {
    for (const auto& actor : actors)
    {
      oracle.AddSurface(actor->Data,
        Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(actor->Matrix->GetData()));
    }
    oracle.Prepare();
  }

  std::printf("%-12s %8s %8s %8s %8s %15s %13s %26s\n", "view", "pixels", "% wrong:", "", "",
    "longest wrong", "under 5 px", "seconds");
  std::printf("%-12s %8s %8s %8s %8s %7s %7s %6s %6s %8s %8s %8s\n", "", "", "visible", "hidden",
    "layers", "visible", "hidden", "parts", "before", "first", "view", "visible");
  std::unique_ptr<DepthPicture> picture;
  if (arguments.Depth)
  {
    picture = std::make_unique<DepthPicture>(static_cast<int>(Height));
    for (const auto& actor : actors)
    {
      picture->AddSurface(actor->Data, actor->Matrix);
    }
  }
  Row all;
  double megabytes = 0.0;
  vtkSmartPointer<vtkNPRStrokeVisibility> kept;
  for (int view = 0; view < arguments.Views; ++view)
  {
    const auto camera = MakeView(world, 360.0 * view / arguments.Views, 4.0);
    if (view % 2 == 1)
    {
      camera->SetParallelProjection(true);
      camera->SetParallelScale(0.5 * world->GetLength());
    }
    const Surface strokes = MakeStrokes(actors, camera, arguments.Splines);
    Row row;
    vtkPolyData* const labelled = picture
      ? LabelByDepth(*picture, arguments, strokes, camera, row)
      : LabelBySurfaces(actors, arguments, strokes, camera, kept, megabytes, row);
    if (!arguments.NoOracle)
    {
      oracle.SetView(camera, Height);
      row.Wrong = CompareWithOracle(labelled, oracle);
      row.Fragments = CountFragments(labelled, oracle);
      row.Strokes = CountFragments(strokes, oracle);
    }
    PrintRow(
      (std::string(view % 2 == 1 ? "parallel " : "view ") + std::to_string(view)).c_str(), row);
    all.Wrong.All += row.Wrong.All;
    all.Wrong.WrongVisible += row.Wrong.WrongVisible;
    all.Wrong.WrongHidden += row.Wrong.WrongHidden;
    all.Wrong.WrongLayers += row.Wrong.WrongLayers;
    all.Wrong.LongestVisible = std::max(all.Wrong.LongestVisible, row.Wrong.LongestVisible);
    all.Wrong.LongestHidden = std::max(all.Wrong.LongestHidden, row.Wrong.LongestHidden);
    all.Fragments += row.Fragments;
    all.Strokes += row.Strokes;
    all.First += row.First / arguments.Views;
    all.NewView += row.NewView / arguments.Views;
    all.VisibleOnly += row.VisibleOnly / arguments.Views;
  }
  PrintRow("all", all);
  std::printf("%.0f megabytes more at the peak of the first view\n", megabytes);
  return EXIT_SUCCESS;
}
