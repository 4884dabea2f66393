// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The ink of strokes against what geometry says: widths, areas, caps, joins, overlaps, tapers.
#include "nprStrokeTesting.h"
#include "vtkNPROffscreen.h"

#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <cmath>
#include <cstdlib>
#include <limits>

using nprtest::Check;
using nprtest::Expect;
using nprtest::Line;
using nprtest::MakeLines;
using nprtest::Picture;

namespace
{
// Ink of a long line inside a slab across it, divided by the slab's length: its width.
void TestWidths()
{
  Picture picture(128, 128);
  vtkSmartPointer<vtkActor> actor = picture.AddStrokes(MakeLines({}), 2);
  vtkNPRStrokeMapper* mapper = vtkNPRStrokeMapper::SafeDownCast(actor->GetMapper());
  for (double width : { 0.3, 0.7, 1.0, 1.5, 2.0, 5.0, 12.0 })
  {
    mapper->SetWidth(width);
    for (double angle = 0; angle < 180; angle += 11.25)
    {
      const double offset = 0.37 * angle - std::floor(0.37 * angle);
      const double c = std::cos(vtkMath::RadiansFromDegrees(angle));
      const double s = std::sin(vtkMath::RadiansFromDegrees(angle));
      const double x = 64 + offset, y = 64 - 0.5 * offset;
      mapper->SetInputData(
        MakeLines({ { { x - 300 * c, y - 300 * s, 0 }, { x + 300 * c, y + 300 * s, 0 } } }));
      picture.Render();
      // Columns for flat lines, rows for steep ones.
      const bool flat = std::abs(c) >= std::abs(s);
      const double ink = flat ? picture.GetInk(44, 0, 84, 128) : picture.GetInk(0, 44, 128, 84);
      const double measured = ink / 40 * std::max(std::abs(c), std::abs(s));
      Expect(measured, width, 0.05,
        "width " + std::to_string(width) + " at " + std::to_string(angle) + " degrees");
      if (angle == 0 && width >= 1)
      {
        int fringe = 0;
        for (int row = 0; row < 128; ++row)
        {
          const double value = picture.GetInk(64, row);
          fringe += value > 0.01 && value < 0.99;
        }
        Check(fringe <= 2, "the fringe is at most a pixel on either side");
      }
    }
  }
}

void TestCircle(int argc, char* argv[])
{
  for (int segments : { 48, 400 })
  {
    Picture picture(200, 200);
    Line circle;
    for (int i = 0; i <= segments; ++i)
    {
      const double angle = 2 * vtkMath::Pi() * i / segments;
      circle.push_back({ 100 + 80 * std::cos(angle), 100 + 80 * std::sin(angle), 0 });
    }
    vtkSmartPointer<vtkActor> actor = picture.AddStrokes(MakeLines({ circle }), 3);
    picture.Render();
    // A polygon of n sides is shorter than its circle.
    const double length = 2 * 80 * segments * std::sin(vtkMath::Pi() / segments);
    Expect(picture.GetInk(), 3 * length, 0.01, "ink of a circle");
    for (int x = 0; x < 200; ++x)
    {
      for (int y = 0; y < 200; ++y)
      {
        const double distance = std::abs(std::hypot(x + 0.5 - 100, y + 0.5 - 100) - 80);
        Check(distance > 0.8 || picture.GetInk(x, y) > 0.97, "a hole in the circle");
        Check(distance < 2.3 || picture.GetInk(x, y) < 0.03, "ink beside the circle");
      }
    }
    picture.Write(argc, argv, "StrokeCircle" + std::to_string(segments));
  }
}

void TestCapsAndJoins(int argc, char* argv[])
{
  Picture picture(200, 100);
  const double r = 12;
  picture.AddStrokes(MakeLines({ { { 30, 50.3, 0 }, { 80.4, 50.3, 0 } } }), 2 * r);
  picture.Render();
  const double capsule = 2 * r * 50.4 + vtkMath::Pi() * r * r;
  Expect(picture.GetInk(), capsule, 0.005, "a capsule's area");
  picture.Write(argc, argv, "StrokeCapsule");

  // A right angle: two capsules, less the quarter disc and the square that both cover.
  Picture corner(120, 120);
  corner.AddStrokes(MakeLines({ { { 30, 90, 0 }, { 30, 30, 0 }, { 90, 30, 0 } } }), 2 * r);
  corner.Render();
  const double both = r * r + 3 * vtkMath::Pi() * r * r / 4;
  Expect(corner.GetInk(), 2 * (2 * r * 60 + vtkMath::Pi() * r * r) - both, 0.005, "a round join");
  corner.Write(argc, argv, "StrokeJoin");

  // One place: a dot.
  Picture dot(60, 60);
  dot.AddStrokes(MakeLines({ { { 30.2, 29.7, 0 }, { 30.2, 29.7, 0 } } }), 20);
  dot.Render();
  Expect(dot.GetInk(), vtkMath::Pi() * 100, 0.01, "a dot");
}

// Crossing and doubling back make nothing darker.
void TestOverlap(int argc, char* argv[])
{
  Picture picture(120, 120);
  vtkSmartPointer<vtkActor> actor = picture.AddStrokes(
    MakeLines({ { { 20, 20, 0 }, { 100, 100, 0 }, { 20, 100, 0 }, { 100, 20, 0 } },
      { { 60, 10, 0 }, { 60, 110, 0 }, { 60, 40, 0 } } }),
    14);
  actor->GetProperty()->SetOpacity(0.5);
  picture.Render();
  int full = 0;
  for (int x = 0; x < 120; ++x)
  {
    for (int y = 0; y < 120; ++y)
    {
      Check(picture.GetRed(x, y) >= 127 - 1, "one tone");
      full += picture.GetRed(x, y) <= 128 + 1;
    }
  }
  Check(full > 2500, "the tone is there");
  picture.Write(argc, argv, "StrokeOverlap");
}

void TestArrays(int argc, char* argv[])
{
  const int n = 101;
  Line line;
  vtkNew<vtkFloatArray> strength;
  strength->SetName("Strength");
  vtkNew<vtkFloatArray> widths;
  widths->SetName("Width");
  for (int i = 0; i < n; ++i)
  {
    line.push_back({ 20.0 + 2 * i, 25.4, 0 });
    strength->InsertNextValue(i / (n - 1.0f));
    widths->InsertNextValue(2.0f);
  }
  vtkSmartPointer<vtkPolyData> data = MakeLines({ line });
  data->GetPointData()->AddArray(strength);
  Picture picture(240, 50);
  vtkSmartPointer<vtkActor> actor = picture.AddStrokes(data, 10);
  vtkNPRStrokeMapper* mapper = vtkNPRStrokeMapper::SafeDownCast(actor->GetMapper());
  auto column = [&](int x) { return picture.GetInk(x, 0, x + 1, 50); };
  picture.Render();
  Expect(column(70), 10, 0.01, "strength switched off");
  mapper->StrengthToWidthOn();
  mapper->SetMinimumWidthFactor(0.1);
  picture.Render();
  for (int x = 40; x < 210; x += 10)
  {
    const double s = (x + 0.5 - 20) / 200;
    Expect(column(x), 10 * (0.1 + 0.9 * s), 0.03, "width by strength");
  }
  picture.Write(argc, argv, "StrokeTaper");
  mapper->StrengthToWidthOff();
  mapper->StrengthToOpacityOn();
  picture.Render();
  for (int x = 40; x < 210; x += 10)
  {
    // The stronger neighbours' round ends reach back by a radius.
    const double s = (x + 0.5 - 20) / 200;
    Check(column(x) > 10 * s * 0.98 && column(x) < 10 * (s + 5.0 / 200), "opacity by strength");
  }
  mapper->StrengthToOpacityOff();
  data->GetPointData()->AddArray(widths);
  data->Modified();
  picture.Render();
  Expect(column(70), 20, 0.01, "width array");
  mapper->UseWidthArrayOff();
  picture.Render();
  Expect(column(70), 10, 0.01, "width array switched off");
}

void TestThin(int argc, char* argv[])
{
  // A thin slanted line is light, and nowhere broken.
  Picture picture(128, 128);
  picture.AddStrokes(MakeLines({ { { -50, 31.2, 0 }, { 180, 80.7, 0 } } }), 0.3);
  picture.Render();
  for (int x = 0; x < 128; ++x)
  {
    double most = 0;
    double column = 0;
    for (int y = 0; y < 128; ++y)
    {
      most = std::max(most, picture.GetInk(x, y));
      column += picture.GetInk(x, y);
    }
    Check(most > 0.12 && most < 0.35, "a thin line is light");
    Expect(column, 0.3 * std::hypot(49.5, 230) / 230, 0.15, "a thin line is nowhere broken");
  }
  picture.Write(argc, argv, "StrokeThin");
}

void TestBadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Picture picture(64, 64);
  vtkSmartPointer<vtkActor> actor = picture.AddStrokes(MakeLines({}), 2);
  picture.Render();
  Check(picture.GetInk() == 0, "no lines, no ink");
  actor->GetMapper()->SetInputDataObject(MakeLines({ {}, { { 1, 1, 0 } }, { { nan, 1, 0 } } }));
  picture.Render();
  Check(picture.GetInk() == 0, "no segments, no ink");
  actor->GetMapper()->SetInputDataObject(
    MakeLines({ { { 10, 32, 0 }, { 20, 32, 0 }, { nan, 32, 0 }, { 40, 32, 0 }, { 50, 32, 0 } } }));
  picture.Render();
  Expect(picture.GetInk(), 2 * (20 + vtkMath::Pi()), 0.05, "only the segments around the hole");
}
}

int TestStrokeCoverage(int argc, char* argv[])
{
  vtkNPROffscreen::Setup();
  TestWidths();
  TestCircle(argc, argv);
  TestCapsAndJoins(argc, argv);
  TestOverlap(argc, argv);
  TestArrays(argc, argv);
  TestThin(argc, argv);
  TestBadInput();
  return nprtest::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
