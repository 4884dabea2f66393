// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What an illustration costs beside VTK's plain picture of the same model, in one run:
//   nprRenderBenchmark MODEL [STYLE] [WIDTH HEIGHT]
#include "vtkNPRIllustration.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPRModelImporter.h"
#include "vtkNPROffscreen.h"
#include "vtkNPRViewpoint.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{
constexpr int NumberOfFrames = 8;

double Measure(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double GetPeakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.0;
}

/// Seconds of a frame from a new viewpoint each, the least of several.
double MeasureFrames(vtkRenderWindow* window, vtkRenderer* renderer)
{
  double least = 1.0e9;
  for (int i = 0; i < NumberOfFrames; ++i)
  {
    renderer->GetActiveCamera()->Azimuth(3.0);
    renderer->ResetCameraClippingRange();
    least = std::min(least,
      Measure(
        [&]()
        {
          window->Render();
          window->WaitForCompletion();
        }));
  }
  return least;
}
}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: nprRenderBenchmark MODEL [STYLE] [WIDTH HEIGHT]\n");
    return EXIT_FAILURE;
  }
  if (!vtkNPROffscreen::Setup())
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkNPRModelImporter> importer;
  importer->SetFileName(argv[1]);
  vtkNew<vtkPolyData> surface;
  bool good = false;
  const double read = Measure([&]() { good = importer->GetSurface(surface); });
  if (!good)
  {
    return EXIT_FAILURE;
  }

  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(argc > 4 ? std::atoi(argv[3]) : 1600, argc > 4 ? std::atoi(argv[4]) : 1200);
  window->AddRenderer(renderer);
  vtkNew<vtkNPRViewpoint> viewpoint;
  const double vtkNormals = Measure([&]() { normals->Update(); });
  viewpoint->Apply(renderer);
  const auto render = [&]()
  {
    window->Render();
    window->WaitForCompletion();
  };
  const double vtkFirst = Measure(render);
  const double vtkFrame = MeasureFrames(window, renderer);
  const double vtkMemory = GetPeakMegabytes();

  mapper->SetInputData(surface);
  viewpoint->Apply(renderer);
  vtkNew<vtkNPRIllustrationStyle> style;
  if (!style->Load(argc > 2 ? argv[2] : "technical"))
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkNPRIllustration> illustration;
  illustration->SetRenderer(renderer);
  illustration->SetStyle(style);
  const double apply = Measure([&]() { illustration->Apply(); });
  const double prepare = illustration->GetStageSeconds("prepare");
  const double curvature = illustration->GetStageSeconds("curvature");
  const double first = Measure(render);
  const double lines = illustration->GetStageSeconds("lines");
  const double frame = MeasureFrames(window, renderer);
  const double laterLines = (illustration->GetStageSeconds("lines") - lines) / NumberOfFrames;

  std::printf("%s: %lld polygons, %dx%d, style %s, %s\n", argv[1],
    static_cast<long long>(surface->GetNumberOfPolys()), window->GetSize()[0], window->GetSize()[1],
    style->GetName().c_str(), vtkNPROffscreen::GetGLRenderer(window).c_str());
  std::printf("%-38s %8s %8s %7s\n", "", "VTK", "vtkNPR", "ratio");
  const auto row = [](const char* what, double theirs, double ours)
  { std::printf("%-38s %7.3fs %7.3fs %7.2f\n", what, theirs, ours, ours / theirs); };
  std::printf("%-38s %7.3fs\n", "reading (both)", read);
  row("prepared (VTK: normals)", vtkNormals, apply);
  std::printf("%-38s %8s %7.3fs\n", "  surface, normals, refinement", "", prepare);
  std::printf("%-38s %8s %7.3fs\n", "  curvature and its derivatives", "", curvature);
  row("first frame", vtkFirst, first);
  row("a frame from a new viewpoint", vtkFrame, frame);
  std::printf("%-38s %8s %7.3fs\n", "  of it lines", "", laterLines);
  row("all, from file to first frame", read + vtkNormals + vtkFirst, read + apply + first);
  // The same shading with each of the outlines that need no extraction, and with none.
  style->SelectLines({});
  const std::vector<std::string> outlines = vtkNPRIllustrationStyle::GetOutlineNames();
  for (int kind = 0; kind < static_cast<int>(outlines.size()); ++kind)
  {
    style->SetOutline(kind);
    illustration->Apply();
    render();
    const std::string what = "a frame, no lines, outline " + outlines[kind];
    row(what.c_str(), vtkFrame, MeasureFrames(window, renderer));
  }
  std::printf("%-38s %6.0fMB %6.0fMB\n", "peak memory so far", vtkMemory, GetPeakMegabytes());
  return EXIT_SUCCESS;
}
