// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines in image space among everything else in a window: viewports, sizes, translucent things,
// other passes, and that nothing is left of them afterwards.

#include "nprOutlineTesting.h"
#include "vtkNPREdgePass.h"

#include <vtkActor2D.h>
#include <vtkRenderStepsPass.h>

using namespace npr::testing;

namespace
{
vtkSmartPointer<vtkRenderStepsPass> MakePass(vtkNPREdgePass* edges)
{
  auto steps = vtkSmartPointer<vtkRenderStepsPass>::New();
  steps->SetOpaquePass(edges);
  return steps;
}

int GetDifference(const Image& small, const Image& large, int x0, int y0)
{
  int worst = 0;
  for (int y = 0; y < small.Height; ++y)
  {
    for (int x = 0; x < small.Width; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        worst = std::max(worst, std::abs(small.At(x, y)[c] - large.At(x + x0, y + y0)[c]));
      }
    }
  }
  return worst;
}

// The same scene alone and in four viewports, with one pass or several; then after resizing.
void TestViewports(Checker& check)
{
  WhiteStage alone(100);
  vtkNew<vtkNPREdgePass> edges;
  vtkActor* actor = alone.AddWhiteSphere();
  alone.Renderer->SetPass(MakePass(edges));
  const Image small = alone.Render();
  check(GetInk(small) > 200.0, "no line");
  for (bool shared : { false, true })
  {
    vtkNew<vtkRenderWindow> window;
    WhiteStage large(200);
    large.Window->RemoveRenderer(large.Renderer);
    std::vector<vtkSmartPointer<vtkRenderer>> renderers;
    const auto pass = MakePass(vtkSmartPointer<vtkNPREdgePass>::New());
    for (int i = 0; i < 4; ++i)
    {
      auto renderer = vtkSmartPointer<vtkRenderer>::New();
      renderer->SetViewport(0.5 * (i % 2), 0.5 * (i / 2), 0.5 + 0.5 * (i % 2), 0.5 + 0.5 * (i / 2));
      renderer->SetBackground(1, 1, 1);
      renderer->SetActiveCamera(alone.Renderer->GetActiveCamera());
      renderer->AddActor(actor);
      renderer->SetPass(shared ? pass : MakePass(vtkSmartPointer<vtkNPREdgePass>::New()));
      large.Window->AddRenderer(renderer);
      renderers.push_back(renderer);
    }
    Image four = large.Render();
    for (int i = 0; i < 4; ++i)
    {
      check(GetDifference(small, four, 100 * (i % 2), 100 * (i / 2)) <= 1, "a viewport differs");
    }
    for (int size : { 140, 320, 200 })
    {
      large.Window->SetSize(size, size);
      four = large.Render();
    }
    check(GetDifference(small, four, 100, 100) <= 1, "after resizing it is another picture");
    for (auto& renderer : renderers)
    {
      large.Window->RemoveRenderer(renderer);
    }
  }
}

// Without the pass again it is the first picture to the last bit, and nothing is left bound.
void TestRemoval(Checker& check)
{
  for (int samples : { 0, 4 })
  {
    WhiteStage stage;
    stage.Window->SetMultiSamples(samples);
    stage.Renderer->SetBackground(0.2, 0.4, 0.6);
    stage.Renderer->SetBackground2(0.9, 0.9, 0.5);
    stage.Renderer->GradientBackgroundOn();
    stage.AddSphere();
    stage.AddLight(1, 1, 1);
    const Image before = stage.Render();
    vtkNew<vtkNPREdgePass> edges;
    stage.Renderer->SetPass(MakePass(edges));
    const Image with = stage.Render();
    check(MeanDifference(before, with) > 0.5, "no lines");
    int farther = 0;
    for (int y = 0; y < 200; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        const double radius = std::hypot(x + 0.5 - 100.0, y + 0.5 - 100.0);
        farther += std::abs(radius - 96.4) > 3.0 && before.At(x, y) != with.At(x, y);
      }
    }
    check(farther == 0, "surface or background differ beside the lines");
    stage.Renderer->SetPass(nullptr);
    check(MeanDifference(before, stage.Render()) == 0.0, "something is left of the pass");
    stage.Renderer->SetPass(MakePass(edges));
    stage.Render();
    edges->ReleaseGraphicsResources(stage.Window);
    check(MeanDifference(with, stage.Render()) == 0.0, "after releasing its resources");
  }
}

// A translucent square over the outline dims it; one that is alone gets none.
void TestTranslucent(Checker& check)
{
  WhiteStage stage;
  vtkNew<vtkNPREdgePass> edges;
  stage.Renderer->SetPass(MakePass(edges));
  vtkActor* box = stage.AddWhiteBox(0.8);
  box->GetProperty()->SetOpacity(0.5);
  const Image alone = stage.Render();
  check(alone.Colors().size() <= 2, "a translucent box has an outline");
  stage.Renderer->RemoveActor(box);
  stage.AddWhiteSphere();
  const Image bare = stage.Render();
  vtkActor* glass = stage.AddWhiteBox(0.4);
  glass->GetProperty()->SetOpacity(0.5);
  glass->SetPosition(0.75, 0, 1.0);
  const Image covered = stage.Render(check.Folder + "/EdgeTranslucent.png");
  const double x = 100.0 + GetOutlineRadius(1.0, 4.0, 30.0, 200);
  check(GetInk(bare, x, 100) > 0.9, "no line at the right");
  check(
    GetInk(covered, x, 100) < 0.6 * GetInk(bare, x, 100), "a line shows through a thing before it");
}

// An unlit thing and a flat one in the same frame; a pass in two windows by turns.
void TestMixed(Checker& check)
{
  WhiteStage stage;
  vtkNew<vtkNPREdgePass> edges;
  const auto pass = MakePass(edges);
  stage.Renderer->SetPass(pass);
  vtkActor* unlit = stage.AddWhiteSphere();
  unlit->GetProperty()->LightingOff();
  unlit->GetProperty()->SetColor(1, 1, 1);
  const Image image = stage.Render();
  const Deviation d =
    MeasureCircle(image, { 100, 100 }, GetOutlineRadius(1.0, 4.0, 30.0, 200), 3.0);
  check(d.Offset < 0.5 && d.LeastWidth > 1.8 && d.MostWidth < 2.2, "an unlit sphere's outline");
  WhiteStage other(120);
  other.AddWhiteBox(1.0);
  other.Renderer->SetPass(pass);
  const Image second = other.Render();
  check(GetInk(second) > 200.0, "one pass does not serve two windows");
  check(MeanDifference(image, stage.Render()) == 0.0, "the first window differs after the second");
  check(MeanDifference(second, other.Render()) == 0.0, "the second window differs");

  // Nothing at all to draw.
  WhiteStage empty;
  empty.Renderer->SetPass(MakePass(edges));
  check(GetInk(empty.Render()) == 0.0, "lines of nothing");
}
}

int TestEdgeWindows(int argc, char* argv[])
{
  Checker check(argc, argv);
  TestViewports(check);
  TestRemoval(check);
  TestTranslucent(check);
  TestMixed(check);
  return check.Result();
}
