// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What an illustration costs beside VTK's plain picture of the same model, in one run:
//   nprRenderBenchmark MODEL [STYLE] [WIDTH HEIGHT [SAMPLES]]
// Without SAMPLES all windows have as many a pixel as VTK's own, which is what its users see; 0
// turns multisampling off, as `npr render` does, whose strokes are smooth without. A frame is the
// mean over viewpoints, each with lines extracted anew, of the least of several; all kinds of
// frames are drawn in turn. Processor: the time of all threads, which tells less of what else the
// machine does.
#include "nprBenchmarkCost.h"
#include "vtkNPRIllustration.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPRModelImporter.h"
#include "vtkNPROffscreen.h"
#include "vtkNPRViewpoint.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
constexpr int NumberOfViews = 6;
constexpr int Rounds = 3;

/// A model in a window of its own.
class Scene
{
public:
  vtkNew<vtkActor> Actor;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkNPRViewpoint> Viewpoint;
  std::vector<nprbench::Cost> Views; // the least so far of each

  Scene(int width, int height, int samples)
  {
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(samples);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
  }

  void Render()
  {
    this->Window->Render();
    this->Window->WaitForCompletion();
  }

  void Draw(int view)
  {
    this->Viewpoint->Apply(this->Renderer);
    this->Renderer->GetActiveCamera()->Azimuth(360.0 / NumberOfViews * view);
    this->Renderer->ResetCameraClippingRange();
    const nprbench::Cost cost = nprbench::Measure(1, [this]() { this->Render(); });
    this->Views.resize(NumberOfViews);
    this->Views[view].Wall = std::min(this->Views[view].Wall, cost.Wall);
    this->Views[view].Processor = std::min(this->Views[view].Processor, cost.Processor);
  }

  nprbench::Cost GetFrame() const
  {
    nprbench::Cost mean{ 0.0, 0.0 };
    for (const nprbench::Cost& view : this->Views)
    {
      mean.Wall += view.Wall / NumberOfViews;
      mean.Processor += view.Processor / NumberOfViews;
    }
    return mean;
  }
};

/// Draws all views of scenes in turn, several times.
void Draw(const std::vector<Scene*>& scenes)
{
  for (int i = 0; i < Rounds * NumberOfViews; ++i)
  {
    for (Scene* scene : scenes)
    {
      scene->Draw(i % NumberOfViews);
    }
  }
}

class IllustratedScene : public Scene
{
public:
  vtkNew<vtkNPRIllustration> Illustration;
  vtkNew<vtkNPRIllustrationStyle> Style;

  IllustratedScene(vtkPolyData* surface, int width, int height, int samples)
    : Scene(width, height, samples)
  {
    this->Mapper->SetInputData(surface);
    this->Viewpoint->Apply(this->Renderer);
    this->Illustration->SetRenderer(this->Renderer);
    this->Illustration->SetStyle(this->Style);
  }

  double GetSeconds(const char* stage) { return this->Illustration->GetStageSeconds(stage); }
};

void PrintRow(const std::string& what, double theirs, double ours)
{
  std::printf("%-44s %7.3fs %7.3fs %7.2f\n", what.c_str(), theirs, ours, ours / theirs);
}

void PrintOurs(const std::string& what, double seconds)
{
  std::printf("%-44s %8s %7.3fs\n", what.c_str(), "", seconds);
}
}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: nprRenderBenchmark MODEL [STYLE] [WIDTH HEIGHT [SAMPLES]]\n");
    return EXIT_FAILURE;
  }
  if (!vtkNPROffscreen::Setup())
  {
    return EXIT_FAILURE;
  }
  const int width = argc > 4 ? std::atoi(argv[3]) : 1600;
  const int height = argc > 4 ? std::atoi(argv[4]) : 1200;
  const int samples =
    argc > 5 ? std::atoi(argv[5]) : vtkOpenGLRenderWindow::GetGlobalMaximumNumberOfMultiSamples();
  const auto measure = [](const auto& work) { return nprbench::Measure(1, work).Wall; };

  vtkNew<vtkNPRModelImporter> importer;
  importer->SetFileName(argv[1]);
  vtkNew<vtkPolyData> surface;
  bool good = false;
  const double read = measure([&]() { good = importer->GetSurface(surface); });
  if (!good)
  {
    return EXIT_FAILURE;
  }

  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  const double vtkNormals = measure([&]() { normals->Update(); });
  Scene plain(width, height, samples);
  plain.Mapper->SetInputConnection(normals->GetOutputPort());
  plain.Viewpoint->Apply(plain.Renderer);
  const double vtkFirst = measure([&]() { plain.Render(); });
  const double vtkMemory = nprbench::ReadMegabytes("VmHWM");

  IllustratedScene whole(surface, width, height, samples);
  if (!whole.Style->Load(argc > 2 ? argv[2] : "technical"))
  {
    return EXIT_FAILURE;
  }
  const double apply = measure([&]() { whole.Illustration->Apply(); });
  const double prepare = whole.GetSeconds("prepare");
  const double curvature = whole.GetSeconds("curvature");
  const double first = measure([&]() { whole.Render(); });
  const double memory = nprbench::ReadMegabytes("VmHWM");
  const double firstLines = whole.GetSeconds("lines");

  // The same while an interactor turns the camera: lines are hidden by the depth buffer.
  IllustratedScene quick(surface, width, height, samples);
  quick.Style->Load(argc > 2 ? argv[2] : "technical");
  quick.Window->SetDesiredUpdateRate(15.0);
  quick.Illustration->Apply();
  quick.Render();

  // The same shading with each of the outlines that need no extraction, and with none.
  IllustratedScene unlined(surface, width, height, samples);
  unlined.Style->Load(argc > 2 ? argv[2] : "technical");
  unlined.Style->SelectLines({});
  const std::vector<std::string> outlines = vtkNPRIllustrationStyle::GetOutlineNames();
  std::vector<nprbench::Cost> unlinedFrames;
  for (std::size_t kind = 0; kind < outlines.size(); ++kind)
  {
    unlined.Style->SetOutline(static_cast<int>(kind));
    unlined.Illustration->Apply();
    unlined.Render();
    unlined.Views.clear();
    if (kind == 0)
    {
      Draw({ &plain, &unlined, &quick, &whole });
    }
    else
    {
      Draw({ &unlined });
    }
    unlinedFrames.push_back(unlined.GetFrame());
  }
  const double lines = (whole.GetSeconds("lines") - firstLines) / (Rounds * NumberOfViews);
  const nprbench::Cost plainFrame = plain.GetFrame();
  const nprbench::Cost wholeFrame = whole.GetFrame();
  const nprbench::Cost quickFrame = quick.GetFrame();

  std::printf("%s: %lld polygons, %dx%d, %d samples, style %s, %s\n", argv[1],
    static_cast<long long>(surface->GetNumberOfPolys()), width, height,
    plain.Window->GetMultiSamples(), whole.Style->GetName().c_str(),
    vtkNPROffscreen::GetGLRenderer(whole.Window).c_str());
  std::printf("%-44s %8s %8s %7s\n", "", "VTK", "vtkNPR", "ratio");
  std::printf("%-44s %7.3fs\n", "reading (both)", read);
  PrintRow("prepared (VTK: normals)", vtkNormals, apply);
  PrintOurs("  surface, normals, refinement", prepare);
  PrintOurs("  curvature and its derivatives", curvature);
  PrintRow("first frame", vtkFirst, first);
  PrintRow("all, from file to first frame", read + vtkNormals + vtkFirst, read + apply + first);
  for (const auto& clock : { std::make_pair("wall", &nprbench::Cost::Wall),
         std::make_pair("processor", &nprbench::Cost::Processor) })
  {
    const double theirs = plainFrame.*clock.second;
    const std::string name = std::string(", ") + clock.first;
    PrintRow("a frame of a new view" + name, theirs, wholeFrame.*clock.second);
    PrintRow("  the mesh alone", theirs, unlinedFrames[0].*clock.second);
    PrintRow("  its lines, extraction to pixels", theirs,
      wholeFrame.*clock.second - unlinedFrames[0].*clock.second);
    PrintRow("  its lines while an interactor turns it", theirs,
      quickFrame.*clock.second - unlinedFrames[0].*clock.second);
    for (std::size_t kind = 1; kind < outlines.size(); ++kind)
    {
      PrintRow(
        "a frame, outline " + outlines[kind] + name, theirs, unlinedFrames[kind].*clock.second);
    }
  }
  PrintOurs("of a frame extraction, wall, mean", lines);
  std::printf("%-44s %6.0fMB %6.0fMB\n", "peak memory to the first frame", vtkMemory, memory);
  return EXIT_SUCCESS;
}
