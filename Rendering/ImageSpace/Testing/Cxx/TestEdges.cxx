// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where lines in image space run, how wide they are, and what the thresholds do.

#include "nprImageComparison.h"
#include "nprOutlineTesting.h"
#include "vtkNPREdgePass.h"

#include <vtkPlaneSource.h>
#include <vtkRenderStepsPass.h>

#include <sstream>

using namespace npr::testing;

namespace
{
struct EdgeStage : WhiteStage
{
  vtkNew<vtkNPREdgePass> Edges;

  explicit EdgeStage(int size = 200) : WhiteStage(size)
  {
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetOpaquePass(this->Edges);
    this->Renderer->SetPass(steps);
  }
};

void TestSphere(Checker& check, int argc, char* argv[])
{
  EdgeStage stage;
  stage.AddWhiteSphere();
  // A pixel is large here: next to the outline the sphere bends by more than one.
  stage.Edges->SetDepthThreshold(0.02);
  for (int samples : { 0, 4 })
  {
    stage.Window->SetMultiSamples(samples);
    for (double width : { 1.0, 2.0, 4.5 })
    {
      stage.Edges->SetWidth(width);
      const Image image = stage.Render();
      const double radius = GetOutlineRadius(1.0, 4.0, 30.0, 200);
      const Deviation d = MeasureCircle(image, { 100, 100 }, radius, 0.5 * width + 2.0);
      const std::string what = "sphere, samples " + std::to_string(samples) + Say(d);
      // Samples lie beside the middles of pixels.
      check(d.Offset < (samples ? 0.8 : 0.5), what);
      check(d.LeastWidth > width - 0.2 && d.MostWidth < width + 0.6, what);
      const double ink = 2.0 * 3.14159265 * radius * width;
      check(std::abs(GetInk(image) - ink) < 0.03 * ink, "ink elsewhere than at the outline");
    }
  }
  stage.Window->SetMultiSamples(0);
  stage.Edges->SetWidth(2.0);
  stage.Edges->SetColor(0.6, 0.1, 0.1);
  check(npr::CompareWithBaseline(stage.Window, "EdgeSphere", argc, argv) == EXIT_SUCCESS,
    "the baseline EdgeSphere");
}

// The nine edges of a box of which three faces are seen, in both projections.
void TestBox(Checker& check, int argc, char* argv[])
{
  EdgeStage stage(240);
  const double h = 0.6;
  stage.AddWhiteBox(2.0 * h);
  stage.Renderer->GetActiveCamera()->SetPosition(2.2, 1.7, 2.9);
  const double corners[7][3] = { { h, h, h }, { -h, h, h }, { h, -h, h }, { h, h, -h },
    { -h, -h, h }, { h, -h, -h }, { -h, h, -h } };
  const int edges[9][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 4 }, { 4, 2 }, { 2, 5 }, { 5, 3 },
    { 3, 6 }, { 6, 1 } };
  for (bool parallel : { false, true })
  {
    stage.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    const Image image = stage.Render();
    double length = 0.0;
    for (const auto& edge : edges)
    {
      const double* a = corners[edge[0]];
      const double* b = corners[edge[1]];
      const Place from = stage.Project(a[0], a[1], a[2]);
      const Place to = stage.Project(b[0], b[1], b[2]);
      length += std::hypot(to[0] - from[0], to[1] - from[1]);
      const Deviation d = MeasureStraight(image, from, to, 9.0, 3.0);
      check(d.Offset < 0.5, "box" + Say(d));
      check(d.LeastWidth > 1.8 && d.MostWidth < 2.25, "box" + Say(d));
    }
    check(std::abs(GetInk(image) - 2.0 * length) < 0.03 * 2.0 * length,
      "ink elsewhere than at the box's edges");
  }
  check(npr::CompareWithBaseline(stage.Window, "EdgeBox", argc, argv) == EXIT_SUCCESS,
    "the baseline EdgeBox");

  // Normals of neighbouring faces are 90 degrees apart.
  stage.Edges->SetNormalThreshold(89.0);
  const double all = GetInk(stage.Render());
  stage.Edges->SetNormalThreshold(91.0);
  const Image outline = stage.Render();
  check(GetInk(outline) < 0.8 * all, "a larger angle than the box's does not hide its inner edges");
  const Place corner = stage.Project(h, h, h);
  check(GetInk(outline, corner[0], corner[1]) == 0.0, "an inner edge is still there");
}

// A square before a wall: a line as soon as the step is larger than the share of the distance.
void TestDepth(Checker& check)
{
  EdgeStage stage;
  stage.Edges->ObjectEdgesOff();
  for (double z : { 0.0, 0.1 })
  {
    vtkNew<vtkPlaneSource> plane;
    const double half = z > 0.0 ? 0.5 : 5.0;
    plane->SetOrigin(-half, -half, z);
    plane->SetPoint1(half, -half, z);
    plane->SetPoint2(-half, half, z);
    MakeWhite(stage.Add(plane->GetOutputPort()));
  }
  for (bool parallel : { false, true })
  {
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    const double range =
      parallel ? camera->GetParallelScale() / std::tan(15.0 * 3.14159265 / 180.0) : 3.9;
    stage.Edges->SetDepthThreshold(0.1 / range * 1.03);
    check(GetInk(stage.Render()) == 0.0, "a line at a step below the threshold");
    stage.Edges->SetDepthThreshold(0.1 / range * 0.97);
    check(GetInk(stage.Render()) > 100.0, "no line at a step above the threshold");
  }
  // Of a floor seen nearly edge-on, no depth is a step.
  stage.Renderer->RemoveAllViewProps();
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-50, -0.05, 50);
  floor->SetPoint1(50, -0.05, 50);
  floor->SetPoint2(-50, -0.05, -50);
  MakeWhite(stage.Add(floor->GetOutputPort()));
  stage.Renderer->GetActiveCamera()->ParallelProjectionOff();
  stage.Renderer->GetActiveCamera()->SetClippingRange(0.1, 40);
  stage.Edges->SetDepthThreshold(0.01);
  const Image image = stage.Render();
  check(std::abs(GetInk(image) - 400.0) < 10.0, "lines on a slanted floor");
}

// Two spheres of one colour that touch, told apart by what they are.
void TestObjects(Checker& check)
{
  EdgeStage stage;
  for (double x : { -0.5, 0.5 })
  {
    vtkActor* actor = stage.AddWhiteSphere();
    actor->SetScale(0.6);
    actor->SetPosition(x, 0, 0);
  }
  stage.Edges->SetDepthThreshold(1.0);
  stage.Edges->SetNormalThreshold(180.0);
  // They meet in the plane x = 0.
  check(GetInk(stage.Render(), 100, 105) > 0.9, "no line between two spheres");
  stage.Edges->ObjectEdgesOff();
  const Image image = stage.Render(check.Folder + "/EdgeObjects.png");
  check(GetInk(image, 100, 105) == 0.0, "a line between objects though it is switched off");
  check(GetInk(image) > 100.0, "no line around both");
}

void TestParameters(Checker& check)
{
  vtkNew<vtkNPREdgePass> edges;
  edges->SetWidth(-3.0);
  edges->SetDepthThreshold(7.0);
  edges->SetNormalThreshold(0.0);
  check(edges->GetWidth() == 0.1 && edges->GetDepthThreshold() == 1.0 &&
      edges->GetNormalThreshold() == 1.0,
    "parameters out of range are taken");
  std::ostringstream text;
  edges->Print(text);
  check(text.str().find("NormalThreshold: 1") != std::string::npos, "PrintSelf");
}
}

int TestEdges(int argc, char* argv[])
{
  Checker check(argc, argv);
  TestSphere(check, argc, argv);
  TestBox(check, argc, argv);
  TestDepth(check);
  TestObjects(check);
  TestParameters(check);
  return check.Result();
}
