// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The outlines of the shading pass: where they are, and that nothing else changes.

#include "nprImageComparison.h"
#include "nprOutlineTesting.h"
#include "vtkNPROutlineNormals.h"
#include "vtkNPRShadingPass.h"

#include <vtkPlaneSource.h>
#include <vtkRenderStepsPass.h>

#include <sstream>

using namespace npr::testing;

namespace
{
struct OutlineStage : WhiteStage
{
  vtkNew<vtkNPRShadingPass> Pass;

  explicit OutlineStage(int kind, int size = 200) : WhiteStage(size)
  {
    this->AddLight(0, 0, 1);
    this->Pass->SetOutline(kind);
    this->Renderer->SetPass(this->Pass);
  }
};

constexpr int BackFaces = vtkNPRShadingPass::BackFaces;
constexpr int Grazing = vtkNPRShadingPass::Grazing;

// The rim begins at the sphere's outline and is as wide as it should be.
void TestRim(Checker& check, int argc, char* argv[])
{
  for (bool parallel : { false, true })
  {
    for (int samples : { 0, 8 })
    {
      OutlineStage stage(BackFaces);
      stage.Window->SetMultiSamples(samples);
      stage.AddWhiteSphere();
      stage.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      const double radius = parallel ? 100.0 / 1.1 : GetOutlineRadius(1.0, 4.0, 30.0, 200);
      for (double width : { 2.0, 3.0 })
      {
        stage.Pass->SetOutlineWidth(width);
        const Image image = stage.Render();
        const Deviation d =
          MeasureCircle(image, { 100, 100 }, radius + 0.5 * width, 0.5 * width + 2.0);
        const std::string what = "rim, samples " + std::to_string(samples) + Say(d);
        const double limit = samples ? 0.4 : 1.0;
        check(d.Offset < limit, what);
        check(d.LeastWidth > width - limit && d.MostWidth < width + limit, what);
        const double ink = 2.0 * 3.14159265 * (radius + 0.5 * width) * width;
        check(std::abs(GetInk(image) - ink) < 0.04 * ink, "ink elsewhere than in the rim");
      }
    }
  }
  OutlineStage stage(BackFaces);
  stage.AddWhiteSphere();
  stage.Pass->SetOutlineColor(0.1, 0.2, 0.5);
  check(npr::CompareWithBaseline(stage.Window, "OutlineBackFaces", argc, argv) == EXIT_SUCCESS,
    "the baseline OutlineBackFaces");
}

// In parallel projection the cosine is t where the radius is sqrt(1 - t^2) of the outline's.
void TestGrazing(Checker& check, int argc, char* argv[])
{
  OutlineStage stage(Grazing);
  stage.AddWhiteSphere();
  stage.Renderer->GetActiveCamera()->ParallelProjectionOn();
  stage.Pass->SetOutlineSoftness(0.0);
  const double radius = 100.0 / 1.1;
  for (double threshold : { 0.25, 0.4, 0.6 })
  {
    stage.Pass->SetOutlineThreshold(threshold);
    const double width = radius * (1.0 - std::sqrt(1.0 - threshold * threshold));
    const Deviation d =
      MeasureCircle(stage.Render(), { 100, 100 }, radius - 0.5 * width, 0.5 * width + 2.0);
    const std::string what = "dark where grazing" + Say(d);
    check(d.Offset < 0.6, what);
    check(d.LeastWidth > width - 1.0 && d.MostWidth < width + 1.0, what);
  }
  // Softness: half way at the threshold, and nothing of it beyond half of the softness.
  stage.Pass->SetOutlineThreshold(0.5);
  stage.Pass->SetOutlineSoftness(0.4);
  const Image soft = stage.Render();
  const auto at = [&](double cosine)
  { return GetInk(soft, 100.0 + radius * std::sqrt(1.0 - cosine * cosine), 100.0); };
  check(std::abs(at(0.5) - 0.5) < 0.05, "softness: not half way at the threshold");
  check(std::abs(at(0.6) - 0.25) < 0.05, "softness: not a quarter at a quarter");
  check(at(0.72) < 0.02 && at(0.28) > 0.98, "softness: too wide");
  stage.Renderer->GetActiveCamera()->ParallelProjectionOff();
  check(npr::CompareWithBaseline(stage.Window, "OutlineGrazing", argc, argv) == EXIT_SUCCESS,
    "the baseline OutlineGrazing");
}

// The outline of a box, whose corners have three normals each, is closed by their means.
void TestCorners(Checker& check)
{
  OutlineStage stage(BackFaces);
  const double h = 0.55;
  vtkNew<vtkCubeSource> box;
  box->SetXLength(2.0 * h);
  box->SetYLength(2.0 * h);
  box->SetZLength(2.0 * h);
  vtkNew<vtkNPROutlineNormals> normals;
  normals->SetInputConnection(box->GetOutputPort());
  vtkActor* actor = stage.Add(box->GetOutputPort());
  MakeWhite(actor);
  stage.Renderer->GetActiveCamera()->SetPosition(2.2, 1.7, 2.9);
  stage.Pass->SetOutlineWidth(5.0);
  // The six corners of the outline.
  const double corners[6][3] = { { -h, h, h }, { -h, -h, h }, { h, -h, h }, { h, -h, -h },
    { h, h, -h }, { -h, h, -h } };
  const auto countGaps = [&]()
  {
    const Image image = stage.Render(check.Folder + "/OutlineCorners.png");
    const Place middle = stage.Project(0, 0, 0);
    int gaps = 0;
    for (const double* corner : corners)
    {
      Place place = stage.Project(corner[0], corner[1], corner[2]);
      const double length = std::hypot(place[0] - middle[0], place[1] - middle[1]);
      for (int i : { 0, 1 })
      {
        place[i] += 2.5 * (place[i] - middle[i]) / length;
      }
      gaps += GetInk(image, place[0], place[1]) < 0.9;
    }
    return gaps;
  };
  check(countGaps() > 0, "a box without gaps: is there anything to mend?");
  actor->GetMapper()->SetInputConnection(normals->GetOutputPort());
  vtkNPROutlineNormals::PassTo(vtkPolyDataMapper::SafeDownCast(actor->GetMapper()));
  check(countGaps() == 0, "gaps at the corners of a box");

  vtkNew<vtkSphereSource> bare;
  bare->GenerateNormalsOff();
  normals->SetInputConnection(bare->GetOutputPort());
  vtkNew<MessageCatcher> messages;
  messages->Watch(normals);
  normals->Update();
  check(messages->Errors.size() == 1, "a surface without normals is not refused");
}

// Without an outline again, and beside it, it is the picture of before to the last bit.
void TestRemoval(Checker& check)
{
  for (int samples : { 0, 4 })
  {
    OutlineStage stage(vtkNPRShadingPass::NoOutline);
    stage.Window->SetMultiSamples(samples);
    stage.Renderer->SetBackground(0.7, 0.8, 0.6);
    stage.AddSphere()->GetProperty()->SetColor(0.9, 0.5, 0.3);
    stage.AddSphere(40)->GetProperty()->SetOpacity(0.4);
    const Image before = stage.Render();
    for (int kind : { BackFaces, Grazing })
    {
      stage.Pass->SetOutline(kind);
      const Image with = stage.Render();
      check(MeanDifference(before, with) > 0.2, "no outline");
      check(before.At(100, 100) == with.At(100, 100), "an outline changes what is inside");
      check(before.At(3, 3) == with.At(3, 3), "an outline changes the background");
    }
    stage.Pass->SetOutline(vtkNPRShadingPass::NoOutline);
    check(MeanDifference(before, stage.Render()) == 0.0, "something is left of the outline");
  }
}

// What is translucent has no back faces drawn, and lies over those of others.
void TestTranslucent(Checker& check)
{
  OutlineStage stage(BackFaces);
  vtkActor* sphere = stage.AddWhiteSphere();
  sphere->GetProperty()->SetOpacity(0.5);
  check(GetInk(stage.Render()) == 0.0, "a rim around a translucent sphere");
  sphere->GetProperty()->SetOpacity(1.0);
  const Image bare = stage.Render();
  vtkActor* glass = stage.AddWhiteBox(0.4);
  glass->GetProperty()->SetOpacity(0.5);
  glass->SetPosition(0.75, 0, 1.0);
  const Image covered = stage.Render();
  const double x = 101.5 + GetOutlineRadius(1.0, 4.0, 30.0, 200);
  check(GetInk(bare, x, 100) > 0.9, "no rim at the right");
  check(
    GetInk(covered, x, 100) < 0.6 * GetInk(bare, x, 100), "a rim shows through a thing before it");
}

// Back faces that are seen, as of an open surface, keep their shading.
void TestOpen(Checker& check)
{
  OutlineStage stage(BackFaces);
  vtkNew<vtkSphereSource> bowl;
  bowl->SetRadius(1.0);
  bowl->SetThetaResolution(100);
  bowl->SetPhiResolution(100);
  bowl->SetStartPhi(90.0);
  vtkNew<vtkPlaneSource> plane;
  plane->SetNormal(0.0, 0.0, -1.0);
  for (vtkAlgorithm* source :
    { static_cast<vtkAlgorithm*>(bowl), static_cast<vtkAlgorithm*>(plane) })
  {
    for (double angle : { 0.0, 25.0 })
    {
      vtkActor* actor = stage.Add(source->GetOutputPort());
      MakeWhite(actor);
      actor->RotateX(angle);
      const Image image = stage.Render();
      double ink = 0.0;
      for (int y = 60; y < 140; ++y)
      {
        for (int x = 60; x < 140; ++x)
        {
          ink += GetInk(image, x + 0.5, y + 0.5);
        }
      }
      check(ink == 0.0, "a back face that is seen is dark");
      stage.Renderer->RemoveActor(actor);
    }
  }
}

// Another delegate, another style, viewports, another size: the same rim.
void TestFrames(Checker& check)
{
  OutlineStage stage(BackFaces);
  vtkActor* sphere = stage.AddWhiteSphere();
  const Image first = stage.Render();
  vtkNew<vtkRenderStepsPass> steps;
  stage.Pass->SetDelegatePass(steps);
  check(MeanDifference(first, stage.Render()) == 0.0, "another delegate gives another rim");
  stage.Pass->SetDelegatePass(nullptr);

  vtkNew<vtkRenderer> right;
  right->SetBackground(1, 1, 1);
  right->AddActor(sphere);
  right->SetActiveCamera(stage.Renderer->GetActiveCamera());
  right->AddLight(vtkSmartPointer<vtkLight>::New());
  right->SetViewport(0.5, 0, 1, 1);
  right->SetPass(stage.Pass);
  stage.Renderer->SetViewport(0, 0, 0.5, 1);
  stage.Window->AddRenderer(right);
  stage.Window->SetSize(300, 300);
  stage.Render();
  stage.Window->SetSize(400, 200);
  const Image both = stage.Render(check.Folder + "/OutlineViewports.png");
  int worst = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      worst = std::max({ worst, std::abs(both.At(x, y)[0] - first.At(x, y)[0]),
        std::abs(both.At(x + 200, y)[0] - first.At(x, y)[0]) });
    }
  }
  check(worst <= 1, "viewports have another rim");
}

void TestParameters(Checker& check)
{
  vtkNew<vtkNPRShadingPass> pass;
  check(pass->GetOutline() == vtkNPRShadingPass::NoOutline, "there is an outline by default");
  pass->SetOutline(17);
  pass->SetOutlineWidth(-1.0);
  pass->SetOutlineThreshold(3.0);
  check(pass->GetOutline() == Grazing && pass->GetOutlineWidth() == 0.0 &&
      pass->GetOutlineThreshold() == 1.0,
    "parameters out of range are taken");
  std::ostringstream text;
  pass->Print(text);
  check(text.str().find("OutlineThreshold: 1") != std::string::npos, "PrintSelf");
}
}

int TestShadingOutlines(int argc, char* argv[])
{
  Checker check(argc, argv);
  TestRim(check, argc, argv);
  TestGrazing(check, argc, argv);
  TestCorners(check);
  TestRemoval(check);
  TestTranslucent(check);
  TestOpen(check);
  TestFrames(check);
  TestParameters(check);
  return check.Result();
}
