// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes among everything else in a window: viewports, other windows, translucent things, passes,
// multisampling, selection; and that they leave OpenGL's state as they found it.
#include "nprStrokeTesting.h"
#include "vtkNPROffscreen.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkHardwareSelector.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderStepsPass.h>
#include <vtkSelection.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

using nprtest::Check;
using nprtest::MakeLines;
using nprtest::Picture;

namespace
{
vtkSmartPointer<vtkPolyData> MakeCross()
{
  return MakeLines({ { { 12.3, 20, 0 }, { 85, 71.2, 0 } }, { { 10, 80, 0 }, { 90, 15, 0 } } });
}

vtkSmartPointer<vtkActor> AddSquare(
  vtkRenderer* renderer, double x0, double x1, double z, const double color[3], double opacity)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x0, 10, z);
  plane->SetPoint1(x1, 10, z);
  plane->SetPoint2(x0, 90, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
  return actor;
}

const double Red[] = { 1, 0, 0 };
const double Blue[] = { 0, 0, 1 };

std::vector<unsigned char> GetPixels(Picture& picture)
{
  picture.Render();
  const unsigned char* data = picture.Pixels->GetPointer(0);
  return std::vector<unsigned char>(data, data + picture.Pixels->GetNumberOfValues());
}

/// The largest difference of a colour between one picture and a part of another.
int GetDifference(const Picture& small, const Picture& large, int x0, int y0)
{
  int worst = 0;
  for (int y = 0; y < small.Height; ++y)
  {
    for (int x = 0; x < small.Width; ++x)
    {
      worst = std::max(worst, std::abs(small.GetRed(x, y) - large.GetRed(x + x0, y + y0)));
    }
  }
  return worst;
}

// The same scene alone, and as each of four viewports; then after resizing.
void TestViewports(int argc, char* argv[])
{
  Picture alone(100, 100);
  alone.AddStrokes(MakeCross(), 5);
  AddSquare(alone.Renderer, 30, 60, 10, Blue, 1);
  alone.Render();

  Picture picture(200, 200);
  vtkNew<vtkActor> strokes;
  vtkNew<vtkNPRStrokeMapper> mapper;
  mapper->SetInputData(MakeCross());
  mapper->SetWidth(5);
  strokes->SetMapper(mapper);
  strokes->GetProperty()->SetColor(0, 0, 0);
  picture.Window->RemoveRenderer(picture.Renderer);
  std::vector<vtkSmartPointer<vtkRenderer>> renderers;
  for (int i = 0; i < 4; ++i)
  {
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetViewport(0.5 * (i % 2), 0.5 * (i / 2), 0.5 + 0.5 * (i % 2), 0.5 + 0.5 * (i / 2));
    renderer->SetBackground(1, 1, 1);
    renderer->SetActiveCamera(alone.Renderer->GetActiveCamera());
    renderer->AddActor(strokes); // one mapper in all of them
    AddSquare(renderer, 30, 60, 10, Blue, 1);
    picture.Window->AddRenderer(renderer);
    renderers.push_back(renderer);
  }
  picture.Render();
  picture.Write(argc, argv, "StrokeViewports");
  for (int i = 0; i < 4; ++i)
  {
    Check(GetDifference(alone, picture, 100 * (i % 2), 100 * (i / 2)) <= 1, "a viewport");
  }

  picture.Window->SetSize(160, 160);
  picture.Window->Render();
  picture.Window->SetSize(200, 200);
  picture.Render();
  Check(GetDifference(alone, picture, 100, 100) <= 1, "after resizing");

  for (auto& renderer : renderers)
  {
    renderer->RemoveActor(strokes);
  }
  picture.Render();
  Check(picture.GetRed(15, 22) == 255, "removed");
  renderers[0]->AddActor(strokes);
  picture.Render();
  Check(GetDifference(alone, picture, 0, 0) <= 1, "added again");
}

// One mapper drawn by two windows in turn, and a window that goes away first.
void TestWindows()
{
  Picture first(100, 100);
  vtkSmartPointer<vtkActor> strokes = first.AddStrokes(MakeCross(), 5);
  const std::vector<unsigned char> expected = GetPixels(first);
  {
    Picture second(100, 100);
    second.Renderer->AddActor(strokes);
    for (int turn = 0; turn < 3; ++turn)
    {
      Check(GetPixels(second) == expected, "the second window");
      Check(GetPixels(first) == expected, "the first window after it");
    }
    second.Render();
  }
  Check(GetPixels(first) == expected, "the first window alone again");
  first.Window->Finalize();
  Check(GetPixels(first) == expected, "a window that was finalized");
}

// A stroke over a translucent square is laid over it, by VTK's default and with plain blending.
void TestTranslucent(int argc, char* argv[])
{
  for (bool pass : { false, true })
  {
    for (double opacity : { 1.0, 0.5 })
    {
      Picture picture(100, 100);
      vtkNew<vtkRenderStepsPass> steps;
      if (pass)
      {
        picture.Renderer->SetPass(steps);
      }
      const double green[] = { 0, 0.8, 0 };
      AddSquare(picture.Renderer, 20, 50, 5, green, 0.5);
      vtkSmartPointer<vtkActor> strokes =
        picture.AddStrokes(MakeLines({ { { 5, 50, 0 }, { 95, 50, 0 } } }), 10);
      strokes->GetProperty()->SetColor(0.2, 0, 0.6);
      strokes->GetProperty()->SetOpacity(opacity);
      picture.Render();
      if (opacity == 0.5)
      {
        picture.Write(argc, argv, pass ? "StrokeBlended" : "StrokeOrderIndependent");
      }
      const double ink[] = { 0.2, 0, 0.6 };
      auto check = [&](int x, int y, const double* color, double coverage, const char* what)
      {
        for (int c = 0; c < 3; ++c)
        {
          const double expected = 255 * ((1 - coverage) * color[c] + coverage * ink[c]);
          const double value = picture.Pixels->GetValue(4 * (y * 100 + x) + c);
          Check(std::abs(value - expected) <= 3,
            std::string(what) + ", pass " + std::to_string(pass) + ": " + std::to_string(value) +
              " instead of " + std::to_string(expected));
        }
      };
      const double white[] = { 1, 1, 1 };
      const double mixed[] = { 0.5, 0.9, 0.5 };
      check(75, 50, white, opacity, "on the background");
      check(35, 50, mixed, opacity, "on the translucent square");
      check(35, 70, mixed, 0, "the square beside it");
      picture.Renderer->SetPass(nullptr);
    }
  }
}

// What is drawn after strokes comes out the same as without them.
void TestState()
{
  auto draw = [](bool withStrokes)
  {
    Picture picture(100, 100);
    vtkSmartPointer<vtkActor> strokes =
      picture.AddStrokes(MakeLines({ { { 2, 2, 0 }, { 4, 2, 0 } } }), 1);
    strokes->SetVisibility(withStrokes);
    // Two renderers, the second over the first; opaque and translucent things in each.
    vtkNew<vtkRenderer> second;
    second->SetViewport(0.25, 0.25, 0.9, 0.8);
    second->SetActiveCamera(picture.Renderer->GetActiveCamera());
    second->SetBackground(0.5, 0.7, 0.2);
    for (vtkRenderer* renderer : { static_cast<vtkRenderer*>(picture.Renderer), second.Get() })
    {
      AddSquare(renderer, 20, 70, 0, Red, 1);
      AddSquare(renderer, 40, 90, -5, Blue, 1);
      AddSquare(renderer, 30, 80, 5, Blue, 0.4);
    }
    picture.Window->AddRenderer(second);
    picture.Render();
    std::vector<unsigned char> pixels = GetPixels(picture);
    for (int y = 0; y < 6; ++y)
    {
      std::fill_n(pixels.begin() + 400 * y, 400, 0); // the stroke's own place
    }
    return pixels;
  };
  Check(draw(true) == draw(false), "strokes change nothing else");
}

void TestMultisampling()
{
  Picture picture(100, 100);
  picture.Window->SetMultiSamples(4);
  AddSquare(picture.Renderer, 30, 60, 10, Blue, 1);
  vtkSmartPointer<vtkActor> strokes =
    picture.AddStrokes(MakeLines({ { { 5, 50, 0 }, { 95, 50, 0 } } }), 4);
  picture.Render();
  Check(std::abs(picture.GetInk(65, 0, 90, 100) / 25 - 4) < 0.05, "visible with multisampling");
  Check(picture.Pixels->GetValue(4 * (50 * 100 + 45) + 2) == 255, "hidden with multisampling");
}

void TestSelector()
{
  Picture picture(100, 100);
  AddSquare(picture.Renderer, 30, 60, -10, Blue, 1);
  vtkSmartPointer<vtkActor> strokes =
    picture.AddStrokes(MakeLines({ { { 5, 50, 0 }, { 95, 50, 0 } } }), 10);
  picture.Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(picture.Renderer);
  selector->SetArea(0, 0, 99, 99);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  // Not every offscreen window can select at all.
  Check(!selection || selection->GetNumberOfNodes() <= 1, "only the square can be selected");
  const std::vector<unsigned char> before = GetPixels(picture);
  Check(GetPixels(picture) == before, "and nothing is changed by it");
}

void CountEvents(vtkObject*, unsigned long, void* count, void*)
{
  ++*static_cast<int*>(count);
}

void TestPeeling()
{
  Picture picture(100, 100);
  vtkSmartPointer<vtkActor> strokes = picture.AddStrokes(MakeCross(), 5);
  picture.Renderer->UseDepthPeelingOn();
  int warnings = 0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(CountEvents);
  observer->SetClientData(&warnings);
  strokes->GetMapper()->AddObserver(vtkCommand::WarningEvent, observer);
  picture.Render();
  Check(warnings > 0 && picture.GetInk() == 0, "depth peeling: a warning and no ink");
  picture.Renderer->UseDepthPeelingOff();
  picture.Render();
  Check(picture.GetInk() > 500, "and again without it");
}

void TestObject()
{
  vtkNew<vtkNPRStrokeMapper> mapper;
  mapper->SetInputData(MakeCross());
  mapper->SetWidth(7);
  mapper->SetHiddenOpacity(0.3);
  vtkNew<vtkNPRStrokeMapper> copy;
  copy->ShallowCopy(mapper);
  Check(copy->GetWidth() == 7 && copy->GetHiddenOpacity() == 0.3, "ShallowCopy");
  Check(copy->GetInput() == mapper->GetInput(), "ShallowCopy of the input");
  double bounds[6];
  mapper->GetBounds(bounds);
  Check(bounds[0] == 10 && bounds[1] == 90 && bounds[2] == 15 && bounds[3] == 80, "bounds");
  std::ostringstream text;
  mapper->Print(text);
  Check(text.str().find("HiddenOpacity: 0.3") != std::string::npos, "PrintSelf");
  Check(!mapper->HasOpaqueGeometry() && mapper->HasTranslucentPolygonalGeometry(), "phase");
}
}

int TestStrokeWindows(int argc, char* argv[])
{
  vtkNPROffscreen::Setup();
  TestViewports(argc, argv);
  TestWindows();
  TestTranslucent(argc, argv);
  TestState();
  TestMultisampling();
  TestSelector();
  TestPeeling();
  TestObject();
  return nprtest::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
