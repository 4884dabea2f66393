// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a vector drawing costs from the prepared mesh on, and what is wrong with its lines:
 *
 *   nprDrawingBenchmark [MODEL...] [--views N] [--runs N] [--style NAME] [--pdf] [--keep FILE]
 *
 * Several models are one scene. Without any the built-in sample is taken. Drawn are contours,
 * suggestive contours and creases in a style (--style; ink), in an image 933 pixels wide and 700
 * high, on A4, as SVG or, with --pdf, as PDF. The views (--views; 10) are all around, in turn with
 * a perspective and a parallel projection.
 *
 * A row is a view: seconds in finding what is hidden, in making strokes, and in fitting and writing
 * them, the least of several runs (--runs; 3) with two threads; their sum; the size of the file;
 * how many visible strokes there are, how many of them look shorter than 5 pixels, and how often
 * one turns back by more than 90 degrees; and how much of the outline (of the pixels that the model
 * covers) is farther than 2 pixels from any visible line. The first row includes what no view
 * changes: the surface's adjacency and the hierarchy for rays. Files have to be the same on all
 * runs. --keep keeps that of the last view.
 */
#include "nprArrayNames.h"
#include "nprBenchmarkCost.h"
#include "vtkNPRDrawingStyle.h"
#include "vtkNPRIllustration.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPRModelImporter.h"
#if NPR_HAS_CAIRO
#include "vtkNPRPDFWriter.h"
#endif
#include "vtkNPRSVGWriter.h"
#include "vtkNPRSampleSource.h"
#include "vtkNPRViewpoint.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace
{
using namespace nprbench;
constexpr int Width = 933;
constexpr int Height = 700;

struct Arguments
{
  std::vector<std::string> Models;
  int Views = 10;
  int Runs = 3;
  std::string Style = "ink";
  bool IsPDF = false;
  std::string File;

  bool Read(int argc, char* argv[])
  {
    for (int i = 1; i < argc; ++i)
    {
      const std::string argument = argv[i];
      const bool hasValue = i + 1 < argc;
      if (argument == "--views" && hasValue)
      {
        this->Views = std::max(1, std::atoi(argv[++i]));
      }
      else if (argument == "--runs" && hasValue)
      {
        this->Runs = std::max(1, std::atoi(argv[++i]));
      }
      else if (argument == "--style" && hasValue)
      {
        this->Style = argv[++i];
      }
      else if (argument == "--pdf" && NPR_HAS_CAIRO)
      {
        this->IsPDF = true;
      }
      else if (argument == "--keep" && hasValue)
      {
        this->File = argv[++i];
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
/// Pixels of the image, with a mark on some.
class Pixels
{
public:
  bool Get(int x, int y) const
  {
    return x >= 0 && y >= 0 && x < Width && y < Height && this->Marks[y * Width + x] != 0;
  }
  void Set(int x, int y)
  {
    if (x >= 0 && y >= 0 && x < Width && y < Height)
    {
      this->Marks[y * Width + x] = 1;
    }
  }

  /// All whose middle is in the triangle.
  void Fill(const Eigen::Vector2d corners[3])
  {
    const Eigen::Vector2d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const Eigen::Vector2d high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    const auto side =
      [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p)
    { return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x(); };
    const double area = side(corners[0], corners[1], corners[2]);
    const int lastX = std::min(Width - 1, static_cast<int>(high.x()));
    const int lastY = std::min(Height - 1, static_cast<int>(high.y()));
    for (int y = std::max(0, static_cast<int>(low.y())); y <= lastY; ++y)
    {
      for (int x = std::max(0, static_cast<int>(low.x())); x <= lastX; ++x)
      {
        const Eigen::Vector2d p(x + 0.5, y + 0.5);
        bool isInside = area != 0.0;
        for (int i = 0; i < 3 && isInside; ++i)
        {
          isInside = side(corners[i], corners[(i + 1) % 3], p) * area >= 0.0;
        }
        if (isInside)
        {
          this->Set(x, y);
        }
      }
    }
  }

private:
  std::vector<char> Marks = std::vector<char>(Width * Height, 0);
};

/// From the world to pixels.
class View
{
public:
  explicit View(vtkCamera* camera)
  {
    const vtkMatrix4x4* const matrix =
      camera->GetCompositeProjectionTransformMatrix(double(Width) / Height, -1.0, 1.0);
    this->Projection =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(matrix->GetData());
  }

  Eigen::Vector2d See(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector4d clip = this->Projection * place.homogeneous();
    return { (0.5 * clip.x() / clip.w() + 0.5) * Width,
      (0.5 * clip.y() / clip.w() + 0.5) * Height };
  }

private:
  Eigen::Matrix4d Projection;
};

Pixels DrawSurfaces(vtkRenderer* renderer, const std::vector<vtkActor*>& actors)
{
  const View view(renderer->GetActiveCamera());
  Pixels pixels;
  vtkNew<vtkIdList> ids;
  for (vtkActor* const actor : actors)
  {
    auto* const surface = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    const Eigen::Matrix4d matrix =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(actor->GetMatrix()->GetData());
    for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
    {
      surface->GetPolys()->GetCellAtId(cell, ids);
      Eigen::Vector2d corners[3];
      for (int i = 0; i < 3; ++i)
      {
        Eigen::Vector3d point;
        surface->GetPoint(ids->GetId(i), point.data());
        corners[i] = view.See((matrix * point.homogeneous()).eval().head<3>());
      }
      pixels.Fill(corners);
    }
  }
  return pixels;
}

//------------------------------------------------------------------------------
struct Measures
{
  int Strokes = 0;
  int Fragments = 0;
  int Reversals = 0;
  double Uncovered = 0.0; // percent of the outline
};

/// The visible strokes in pixels, with steps of a half at least.
std::vector<std::vector<Eigen::Vector2d>> SeeStrokes(vtkPolyData* strokes, vtkCamera* camera)
{
  constexpr double Step = 0.5;
  const View view(camera);
  vtkDataArray* const layers = strokes->GetCellData()->GetArray(npr::names::HidingLayers);
  std::vector<std::vector<Eigen::Vector2d>> seen;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < strokes->GetNumberOfLines(); ++line)
  {
    if (layers->GetComponent(line, 0) == 0.0)
    {
      seen.emplace_back();
      strokes->GetLines()->GetCellAtId(line, ids);
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        Eigen::Vector3d point;
        strokes->GetPoint(ids->GetId(i), point.data());
        const Eigen::Vector2d pixel = view.See(point);
        if (seen.back().empty() || (pixel - seen.back().back()).norm() >= Step)
        {
          seen.back().push_back(pixel);
        }
      }
    }
  }
  return seen;
}

Measures MeasureDrawing(vtkPolyData* strokes, vtkCamera* camera, const Pixels& model)
{
  Measures measures;
  Pixels ink;
  for (const std::vector<Eigen::Vector2d>& stroke : SeeStrokes(strokes, camera))
  {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
    {
      const Eigen::Vector2d step = stroke[i + 1] - stroke[i];
      length += step.norm();
      measures.Reversals += i > 0 && step.dot(stroke[i] - stroke[i - 1]) < 0.0 ? 1 : 0;
      const int parts = static_cast<int>(2.0 * step.norm()) + 1;
      for (int k = 0; k <= parts; ++k)
      {
        const Eigen::Vector2d p = stroke[i] + double(k) / parts * step;
        ink.Set(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
      }
    }
    ++measures.Strokes;
    measures.Fragments += length < 5.0 ? 1 : 0;
  }

  int outline = 0;
  int uncovered = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      if (!model.Get(x, y) ||
        (model.Get(x - 1, y) && model.Get(x + 1, y) && model.Get(x, y - 1) && model.Get(x, y + 1)))
      {
        continue;
      }
      bool isNear = false;
      for (int dy = -2; dy <= 2; ++dy)
      {
        for (int dx = -2; dx <= 2; ++dx)
        {
          isNear = isNear || (dx * dx + dy * dy <= 4 && ink.Get(x + dx, y + dy));
        }
      }
      ++outline;
      uncovered += isNear ? 0 : 1;
    }
  }
  measures.Uncovered = 100.0 * uncovered / std::max(1, outline);
  return measures;
}

//------------------------------------------------------------------------------
std::string ReadBytes(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), {} };
}

bool AddModels(const Arguments& arguments, vtkRenderer* renderer, int& upAxis)
{
  if (arguments.Models.empty())
  {
    vtkNew<vtkNPRSampleSource> sample;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sample->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
  }
  for (const std::string& model : arguments.Models)
  {
    vtkNew<vtkNPRModelImporter> importer;
    importer->SetFileName(model.c_str());
    if (!importer->Read())
    {
      return false; // it has said why
    }
    importer->ImportInto(renderer);
    upAxis = importer->GetUpAxis();
  }
  return true;
}

vtkSmartPointer<vtkNPRDrawingWriter> MakeWriter(bool isPDF)
{
#if NPR_HAS_CAIRO
  if (isPDF)
  {
    return vtkSmartPointer<vtkNPRPDFWriter>::New();
  }
#endif
  return vtkSmartPointer<vtkNPRSVGWriter>::New();
}

std::vector<vtkActor*> ListActors(vtkRenderer* renderer)
{
  std::vector<vtkActor*> actors;
  vtkCollectionSimpleIterator cookie;
  vtkActorCollection* const all = renderer->GetActors(); // each call makes the list anew
  all->InitTraversal(cookie);
  while (vtkActor* const actor = all->GetNextActor(cookie))
  {
    actors.push_back(actor);
  }
  return actors;
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  Arguments arguments;
  if (!arguments.Read(argc, argv))
  {
    std::fprintf(stderr,
      "usage: nprDrawingBenchmark [MODEL...] [--views N] [--runs N] [--style NAME]\n"
      "                           [--pdf] [--keep FILE]\n"
      "(--pdf only where vtkNPR was built with cairo)\n");
    return EXIT_FAILURE;
  }
  UseThreads(2);
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetSize(Width, Height);
  window->AddRenderer(renderer);
  int upAxis = 1;
  if (!AddModels(arguments, renderer, upAxis))
  {
    return EXIT_FAILURE;
  }
  const std::vector<vtkActor*> actors = ListActors(renderer);

  vtkNew<vtkNPRViewpoint> viewpoint;
  viewpoint->SetUpAxis(upAxis);
  viewpoint->SetElevation(15.0);
  viewpoint->Apply(renderer);
  vtkNew<vtkNPRIllustrationStyle> style;
  vtkNew<vtkNPRIllustration> illustration;
  illustration->SetRenderer(renderer);
  illustration->SetStyle(style);
  if (!style->Load(arguments.Style) || !style->SelectLines({ "contours", "suggestive", "creases" }))
  {
    return EXIT_FAILURE;
  }
  vtkIdType triangles = 0;
  for (vtkActor* const actor : actors)
  {
    actor->GetMapper()->Update();
    triangles +=
      vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0))->GetNumberOfPolys();
  }
  illustration->Apply();
  std::printf("%s%s: %lld triangles\n",
    arguments.Models.empty() ? "sample" : arguments.Models[0].c_str(),
    arguments.Models.size() > 1 ? " ..." : "", static_cast<long long>(triangles));
  std::printf("%-12s %10s %8s %8s %8s %7s %8s %9s %9s %10s\n", "view", "visibility", "strokes",
    "write", "seconds", "kB", "strokes", "under 5px", "reversals", "% no line");

  const std::string file = arguments.File.empty() ? "nprDrawingBenchmark.tmp" : arguments.File;
  double megabytes = 0.0;
  for (int i = 0; i < arguments.Views; ++i)
  {
    viewpoint->SetAzimuth(360.0 * i / arguments.Views);
    viewpoint->SetParallelProjection(i % 2 == 1);
    viewpoint->Apply(renderer);
    vtkNew<vtkPolyData> lines;
    illustration->GetLines(lines); // their extraction is not counted
    vtkNew<vtkPolyData> strokes;
    Cost visibility, shaping, writing;
    std::string bytes;
    if (i == 0)
    {
      ForgetPeak();
    }
    const double before = ReadMegabytes("VmRSS");
    for (int run = 0; run < (i == 0 ? 1 : arguments.Runs); ++run)
    {
      const double hiddenBefore = illustration->GetStageSeconds("visibility");
      const double shapedBefore = illustration->GetStageSeconds("strokes");
      renderer->GetActiveCamera()->Modified();
      illustration->GetLines(lines);
      illustration->GetStrokes(strokes);
      visibility.Wall =
        std::min(visibility.Wall, illustration->GetStageSeconds("visibility") - hiddenBefore);
      shaping.Wall =
        std::min(shaping.Wall, illustration->GetStageSeconds("strokes") - shapedBefore);
      const vtkSmartPointer<vtkNPRDrawingWriter> writer = MakeWriter(arguments.IsPDF);
      writer->SetInputData(strokes);
      writer->SetCamera(renderer->GetActiveCamera());
      writer->SetViewportSize(Width, Height);
      vtkNew<vtkNPRDrawingStyle> inks;
      style->GetDrawingStyle(inks, writer->GetShorterSide());
      writer->SetStyle(inks);
      writer->SetFileName(file.c_str());
      writing.Wall = std::min(writing.Wall, Measure(1, [&]() { writer->Write(); }).Wall);
      const std::string now = ReadBytes(file);
      if (now.empty() || (!bytes.empty() && now != bytes))
      {
        std::fprintf(stderr, "view %d: no file, or not the same one as before\n", i);
        return EXIT_FAILURE;
      }
      bytes = now;
    }
    if (i == 0)
    {
      megabytes = ReadMegabytes("VmHWM") - before;
    }
    const Measures measures =
      MeasureDrawing(strokes, renderer->GetActiveCamera(), DrawSurfaces(renderer, actors));
    std::printf("%-12s %10.3f %8.3f %8.3f %8.3f %7.0f %8d %9d %9d %10.3f\n",
      (std::string(i % 2 == 1 ? "parallel " : "view ") + std::to_string(i)).c_str(),
      visibility.Wall, shaping.Wall, writing.Wall, visibility.Wall + shaping.Wall + writing.Wall,
      bytes.size() / 1000.0, measures.Strokes, measures.Fragments, measures.Reversals,
      measures.Uncovered);
    std::fflush(stdout);
  }
  if (arguments.File.empty())
  {
    std::remove(file.c_str());
  }
  std::printf("%.0f megabytes more at the peak of the first view\n", megabytes);
  return EXIT_SUCCESS;
}
