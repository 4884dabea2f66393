// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes among everything else in a window: viewports, other windows, translucent things, passes,
// multisampling, depth peeling; and that they leave OpenGL's state as they found it.
#include "nprStrokeTesting.h"
#include "vtkNPROffscreen.h"

#include <vtkOpenGLRenderer.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderStepsPass.h>

#include <cmath>
#include <cstdlib>
#include <memory>
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

// With depth peeling strokes come out as without it: hidden by what is opaque, over what is
// translucent; in several viewports with one mapper.
void TestPeeling(int argc, char* argv[])
{
  const double green[] = { 0, 0.8, 0 };
  const auto draw = [&](bool peeling)
  {
    auto picture = std::make_unique<Picture>(200, 100);
    picture->Renderer->SetViewport(0, 0, 0.5, 1);
    vtkNew<vtkRenderer> second;
    second->SetViewport(0.5, 0, 1, 1);
    second->SetBackground(1, 1, 1);
    picture->Window->AddRenderer(second);
    vtkCamera* camera = picture->Renderer->GetActiveCamera();
    camera->SetFocalPoint(50, 50, 0);
    camera->SetPosition(50, 50, 1000);
    second->SetActiveCamera(camera);
    vtkSmartPointer<vtkActor> strokes = picture->AddStrokes(MakeCross(), 5);
    strokes->GetProperty()->SetColor(0.2, 0, 0.6);
    vtkNew<vtkActor> other;
    other->SetMapper(strokes->GetMapper());
    other->GetProperty()->SetColor(0, 0, 0);
    other->GetProperty()->SetOpacity(0.5);
    other->SetPosition(0, -12, 0);
    for (vtkRenderer* renderer : { static_cast<vtkRenderer*>(picture->Renderer), second.Get() })
    {
      AddSquare(renderer, 15, 35, 10, Blue, 1);
      AddSquare(renderer, 40, 65, 5, green, 0.5);
      AddSquare(renderer, 50, 80, -5, green, 0.5);
      renderer->SetUseDepthPeeling(peeling);
    }
    second->AddActor(other);
    picture->Render();
    picture->Write(argc, argv, peeling ? "StrokePeeled" : "StrokeNotPeeled");
    return picture;
  };
  const auto peeled = draw(true);
  const auto plain = draw(false);
  int worst = 0, drawn = 0;
  for (vtkIdType i = 0; i < plain->Pixels->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c) // the windows' alpha is the pass's own affair
    {
      const int value = peeled->Pixels->GetTypedComponent(i, c);
      worst = std::max(worst, std::abs(plain->Pixels->GetTypedComponent(i, c) - value));
      drawn += value < 60;
    }
  }
  Check(drawn > 1000, "peeling draws strokes");
  // Without it VTK takes a mean where translucent things overlap.
  Check(worst <= 16, "peeling differs by " + std::to_string(worst));
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
  TestPeeling(argc, argv);
  TestObject();
  return nprtest::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
