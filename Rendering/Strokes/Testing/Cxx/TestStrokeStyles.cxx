// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Caps, joins, dashes and units of strokes, by the areas that geometry gives.
#include "nprStrokeTesting.h"
#include "vtkNPROffscreen.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using nprtest::Check;
using nprtest::Expect;
using nprtest::GetMapper;
using nprtest::Line;
using nprtest::MakeCircle;
using nprtest::MakeLines;
using nprtest::MakeStraight;
using nprtest::Pi;
using nprtest::Picture;

namespace
{
void TestCaps(int argc, char* argv[])
{
  const double r = 12;
  for (int segments : { 1, 7, 90 })
  {
    Picture picture(200, 100);
    vtkSmartPointer<vtkActor> actor =
      picture.AddStrokes(MakeLines({ MakeStraight(30.3, 80.7, 50.3, segments) }), 2 * r);
    vtkNPRStrokeMapper* mapper = GetMapper(actor);
    mapper->SetJoinToBevel();
    picture.Render();
    Expect(picture.GetInk(), 2 * r * 50.4 + Pi * r * r, 0.005, "round caps");
    mapper->SetCapToButt();
    picture.Render();
    Expect(picture.GetInk(), 2 * r * 50.4, 0.005, "butt caps");
    Expect(picture.GetInk(0, 0, 30, 100), 0, 0, "no ink before the start");
    picture.Write(argc, argv, "StrokeButt" + std::to_string(segments));
  }
}

void TestJoins(int argc, char* argv[])
{
  const double r = 12;
  const Line corner{ { 30, 90, 0 }, { 30, 30, 0 }, { 90, 30, 0 } };
  const double strips = 2 * (2 * r * 60) - r * r;
  Picture picture(120, 120);
  vtkSmartPointer<vtkActor> actor = picture.AddStrokes(MakeLines({ corner }), 2 * r);
  vtkNPRStrokeMapper* mapper = GetMapper(actor);
  mapper->SetCapToButt();
  const auto expect = [&](double area, const char* what)
  {
    picture.Render();
    Expect(picture.GetInk(), area, 0.003, what);
    picture.Write(argc, argv, std::string("Stroke ") + what);
  };
  expect(strips + Pi * r * r / 4, "round join");
  mapper->SetJoinToBevel();
  expect(strips + r * r / 2, "bevel join");
  mapper->SetJoinToMitre();
  expect(strips + r * r, "mitre join");
  mapper->SetMitreLimit(1.4); // a right angle needs the square root of 2
  expect(strips + r * r / 2, "mitre beyond its limit");

  // A sharp turn the other way, and the seam of a closed line.
  mapper->SetMitreLimit(10);
  const double turn = vtkMath::RadiansFromDegrees(140.0);
  mapper->SetInputData(MakeLines({ { { 20, 60, 0 }, { 70, 60, 0 },
    { 70 + 50 * std::cos(turn), 60 + 50 * std::sin(turn), 0 } } }));
  mapper->SetWidth(10);
  // The two strips overlap in a kite, and meet in another.
  const double kite = 25 * std::tan(0.5 * turn);
  expect(2 * 10 * 50 - kite + kite, "sharp mitre");
  mapper->SetInputData(
    MakeLines({ { { 30, 30, 0 }, { 90, 30, 0 }, { 90, 90, 0 }, { 30, 90, 0 }, { 30, 30, 0 } } }));
  expect(70 * 70 - 50 * 50, "closed square");
}

// A smooth stroke is the same however it is joined, of one tone, and has no seam.
void TestSmooth(int argc, char* argv[])
{
  for (int segments : { 60, 250, 2000 })
  {
    Picture plain(200, 200);
    vtkSmartPointer<vtkActor> actor =
      plain.AddStrokes(MakeLines({ MakeCircle(segments, 100.2, 99.7, 80) }), 9);
    actor->GetProperty()->SetOpacity(0.5);
    plain.Render();
    std::vector<double> expected;
    for (int i = 0; i < 200 * 200; ++i)
    {
      expected.push_back(plain.GetInk(i % 200, i / 200));
    }
    GetMapper(actor)->SetCapToButt();
    GetMapper(actor)->SetJoinToMitre();
    plain.Render();
    double worst = 0;
    for (int i = 0; i < 200 * 200; ++i)
    {
      worst = std::max(worst, std::abs(expected[i] - plain.GetInk(i % 200, i / 200)));
    }
    Check(worst < 0.04, "styled as plain: " + std::to_string(worst));
    plain.Write(argc, argv, "StrokeSmooth" + std::to_string(segments));
  }
}

void TestDashes(int argc, char* argv[])
{
  Picture picture(240, 60);
  vtkSmartPointer<vtkActor> actor =
    picture.AddStrokes(MakeLines({ MakeStraight(20, 220, 30, 67) }), 6);
  vtkNPRStrokeMapper* mapper = GetMapper(actor);
  mapper->SetCapToButt();
  mapper->SetDashes(12, 8);
  picture.Render();
  picture.Write(argc, argv, "StrokeDashes");
  Expect(picture.GetInk(), 6 * 200 * 0.6, 0.005, "dashes");
  for (int i = 0; i < 10; ++i)
  {
    Expect(picture.GetInk(21 + 20 * i, 0, 31 + 20 * i, 60), 60, 0.01, "a dash");
    Expect(picture.GetInk(33 + 20 * i, 0, 39 + 20 * i, 60) + 1, 1, 0.02, "a gap");
  }
  mapper->SetCapToRound();
  picture.Render();
  Expect(picture.GetInk(), 6 * 200 * 0.6 + 11 * Pi * 9, 0.01, "round dashes");
  mapper->SetDashes(0, 20);
  picture.Render();
  Expect(picture.GetInk(), 11 * Pi * 9, 0.03, "dots");
  mapper->SetDashes(0.1, 0.1);
  mapper->SetCapToButt();
  picture.Render();
  Expect(picture.GetInk(), 6 * 200 * 0.5, 0.05, "too fine for pixels");

  // In units of the world they follow the scale of the actor, and the array.
  mapper->SetDashUnitToWorld();
  mapper->SetDashes(20, 20);
  actor->SetScale(0.5);
  picture.Render();
  Expect(picture.GetInk(11, 0, 29, 60), 6 * 18, 0.01, "a dash of the world");
  Expect(picture.GetInk(31, 0, 49, 60) + 1, 1, 0.02, "a gap of the world");
  vtkNew<vtkFloatArray> lengths;
  lengths->SetName("ArcLength");
  for (int i = 0; i <= 67; ++i)
  {
    lengths->InsertNextValue(40.0f + 400.0f * i / 67);
  }
  mapper->GetInput()->GetPointData()->AddArray(lengths);
  mapper->GetInput()->Modified();
  picture.Render();
  Expect(picture.GetInk(21, 0, 29, 60), 6 * 8, 0.01, "a dash by the array");
  Expect(picture.GetInk(11, 0, 19, 60) + 1, 1, 0.02, "a gap by the array");
}

void TestHidden(int argc, char* argv[])
{
  Picture picture(240, 60);
  vtkSmartPointer<vtkActor> actor = picture.AddStrokes(
    MakeLines({ MakeStraight(20, 120, 30, 1), MakeStraight(120, 220, 30, 1) }), 6);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(100, 0, 50);
  plane->SetPoint1(180, 0, 50);
  plane->SetPoint2(100, 60, 50);
  vtkNew<vtkPolyDataMapper> planeMapper;
  planeMapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> wall;
  wall->SetMapper(planeMapper);
  wall->GetProperty()->SetColor(1, 1, 1);
  wall->GetProperty()->LightingOff();
  picture.Renderer->AddActor(wall);
  vtkNPRStrokeMapper* mapper = GetMapper(actor);
  mapper->SetCapToButt();
  mapper->SetHiddenOpacity(1);
  mapper->SetHiddenDashes(10, 10);
  picture.Render();
  picture.Write(argc, argv, "StrokeHiddenDashes");
  Expect(picture.GetInk(25, 0, 95, 60), 6 * 70, 0.005, "visible parts are whole");
  Expect(picture.GetInk(105, 0, 175, 60), 6 * 35, 0.07, "hidden parts are dashed");

  vtkNew<vtkIntArray> layers;
  layers->SetName("HidingLayers");
  layers->InsertNextValue(0);
  layers->InsertNextValue(2);
  mapper->GetInput()->GetCellData()->AddArray(layers);
  mapper->GetInput()->Modified();
  mapper->DepthTestOff();
  picture.Render();
  Expect(picture.GetInk(), 6 * 200, 0.005, "nothing hides");
  mapper->UseHidingLayersOn();
  picture.Render();
  Expect(picture.GetInk(20, 0, 118, 60), 6 * 98, 0.005, "visible by the array");
  Expect(picture.GetInk(122, 0, 220, 60), 6 * 48, 0.05, "hidden by the array");
  mapper->SetHiddenOpacity(0);
  picture.Render();
  Expect(picture.GetInk(), 6 * 100, 0.005, "hidden parts are not shown");
}

void TestWorldWidths()
{
  Picture picture(200, 200);
  vtkSmartPointer<vtkActor> actor = picture.AddStrokes(
    MakeLines(
      { { { 100, -300, 0 }, { 100, 500, 0 } }, { { 150, -300, -500 }, { 150, 500, -500 } } }),
    8);
  GetMapper(actor)->SetWidthUnitToWorld();
  picture.Render();
  Expect(picture.GetInk(80, 50, 120, 150), 100 * 8, 0.01, "parallel");
  vtkCamera* camera = picture.Renderer->GetActiveCamera();
  camera->SetParallelScale(50);
  picture.Render();
  Expect(picture.GetInk(80, 50, 120, 150), 100 * 16, 0.01, "twice as near");
  camera->ParallelProjectionOff();
  camera->SetViewAngle(2 * vtkMath::DegreesFromRadians(std::atan(0.1)));
  camera->SetPosition(100, 100, 1000); // a pixel is a unit there
  picture.Render();
  Expect(picture.GetInk(80, 50, 120, 150), 100 * 8, 0.01, "in perspective");
  const double farther = 1.5;
  Expect(picture.GetInk(120, 50, 160, 150), 100 * 8 / farther, 0.01, "farther away");
}
}

int TestStrokeStyles(int argc, char* argv[])
{
  vtkNPROffscreen::Setup();
  TestCaps(argc, argv);
  TestJoins(argc, argv);
  TestSmooth(argc, argv);
  TestDashes(argc, argv);
  TestHidden(argc, argv);
  TestWorldWidths();
  return nprtest::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
