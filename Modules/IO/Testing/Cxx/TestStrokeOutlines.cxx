// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes whose width changes: their outlines hold the points that are within half the width.
#include "nprArrayNames.h"
#include "nprChecks.h"
#include "nprDrawingTesting.h"
#include "vtkNPRDrawingStyle.h"

#include <vtkDoubleArray.h>
#include <vtkPointData.h>

#include <cmath>
#include <random>

namespace
{
using namespace nprtest;

Checks check;
std::string folder;

/// How often the parts of a path go around a point.
int GetWinding(const std::vector<std::vector<Point2>>& parts, const Point2& p)
{
  int winding = 0;
  for (const std::vector<Point2>& part : parts)
  {
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      const Point2 a = part[i] - p;
      const Point2 b = part[(i + 1) % part.size()] - p;
      const double cross = a.x() * b.y() - a.y() * b.x();
      if (a.y() <= 0 && b.y() > 0 && cross > 0)
      {
        ++winding;
      }
      else if (a.y() > 0 && b.y() <= 0 && cross < 0)
      {
        --winding;
      }
    }
  }
  return winding;
}

struct Stroke
{
  std::string Name;
  Line3 Line;
  std::vector<double> Widths; // millimetres
  bool Closed = false;
};

/// Distance to the nearest place of the stroke's middle, less its half width there.
double DistanceToStroke(const Stroke& stroke, const Point2& p)
{
  double least = 1e9;
  for (std::size_t i = 1; i < stroke.Line.size(); ++i)
  {
    constexpr int Steps = 64;
    for (int k = 0; k <= Steps; ++k)
    {
      const double t = static_cast<double>(k) / Steps;
      const Eigen::Vector3d q = (1 - t) * stroke.Line[i - 1] + t * stroke.Line[i];
      const double width = (1 - t) * stroke.Widths[i - 1] + t * stroke.Widths[i];
      least = std::min(least, (p - Point2(50 + q.x(), 50 - q.y())).norm() - 0.5 * width);
    }
  }
  return least;
}

void TestAgainstBruteForce(const Stroke& stroke)
{
  vtkSmartPointer<vtkPolyData> strokes = MakeStrokes({ stroke.Line });
  vtkNew<vtkDoubleArray> widths;
  widths->SetName(npr::names::Width);
  for (const double width : stroke.Widths)
  {
    widths->InsertNextValue(width / 0.5);
  }
  strokes->GetPointData()->AddArray(widths);
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, strokes);
  writer->GetStyle()->SetWidth("lines", 0.5);
  const Drawing drawing = Draw(writer, folder + "StrokeOutlines.svg");
  const Layer* const layer = drawing.Find("lines (visible)");
  if (!check(layer && layer->Paths.size() == 1 && layer->Paths[0].Filled, stroke.Name + ": filled"))
  {
    return;
  }
  std::vector<std::vector<Point2>> parts;
  Point2 least(1e9, 1e9);
  Point2 most(-1e9, -1e9);
  for (const std::vector<Cubic>& part : layer->Paths[0].Parts)
  {
    parts.push_back(Sample(part, 40));
    for (const Point2& p : parts.back())
    {
      least = least.cwiseMin(p);
      most = most.cwiseMax(p);
    }
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(least.x() - 0.2, most.x() + 0.2);
  std::uniform_real_distribution<double> y(least.y() - 0.2, most.y() + 0.2);
  int inside = 0;
  int missing = 0;
  int astray = 0;
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i)
  {
    const Point2 p(x(random), y(random));
    const double distance = DistanceToStroke(stroke, p);
    const int winding = GetWinding(parts, p);
    constexpr double Tolerance = 0.06; // of two fits, and of widths between points
    inside += distance < 0;
    missing += distance < -Tolerance && winding == 0;
    astray += distance > Tolerance && winding != 0;
    worst = (distance > 0) == (winding != 0) ? std::max(worst, std::abs(distance)) : worst;
  }
  check(inside > 200, stroke.Name + ": points inside", inside);
  check(missing == 0, stroke.Name + ": points that should be filled", worst);
  check(astray == 0, stroke.Name + ": points that should not be filled", worst);
}

std::vector<Stroke> MakeTestStrokes()
{
  std::vector<Stroke> strokes;
  Stroke wave{ "wave", {}, {}, false };
  Stroke spring{ "tight bends", {}, {}, false };
  Stroke zigzag{ "corners", {}, {}, false };
  for (int i = 0; i <= 400; ++i)
  {
    const double t = i / 400.0;
    wave.Line.push_back({ 40 * t - 20, 3 * std::sin(12 * t), 0 });
    wave.Widths.push_back(0.2 + 2.0 * t * (1 - t));
    spring.Line.push_back({ 10 * t - 5 + 0.5 * std::sin(30 * t), 0.5 * std::cos(30 * t), 0 });
    spring.Widths.push_back(0.3 + 1.3 * t);
    const double u = 8 * t;
    zigzag.Line.push_back({ 30 * t - 15, 4 * std::abs(u - 2 * std::round(u / 2)), 0 });
    zigzag.Widths.push_back(1.5 - t);
  }
  Stroke taper{ "taper", { { -10, -3, 0 }, { 0, 0, 0 }, { 10, 3, 0 } }, { 0.0, 1.0, 2.0 }, false };
  Stroke ring{ "ring", {}, {}, true };
  Stroke square{ "square", {}, {}, true };
  for (int i = 0; i <= 200; ++i)
  {
    const double t = 2 * Pi * (i % 200) / 200;
    ring.Line.push_back({ 8 * std::cos(t), 5 * std::sin(t), 0 });
    ring.Widths.push_back(1.0 + 0.5 * std::sin(2 * t));
    const double s = (i % 200) / 50.0;
    const int side = static_cast<int>(s);
    const double along = 10 * (s - side) - 5;
    const Eigen::Vector3d places[] = { { along, -5, 0 }, { 5, along, 0 }, { -along, 5, 0 },
      { -5, -along, 0 } };
    square.Line.push_back(places[side]);
    square.Widths.push_back(1.0 + 0.4 * std::sin(t));
  }
  // Wider than they are large: nothing is left of the hole.
  Stroke dot{ "small ring", {}, {}, true };
  Stroke coil{ "coil", {}, {}, false };
  for (int i = 0; i <= 100; ++i)
  {
    const double t = 2 * Pi * (i % 100) / 100;
    dot.Line.push_back({ 0.4 * std::cos(t), 0.4 * std::sin(t), 0 });
    dot.Widths.push_back(1.2);
    coil.Line.push_back({ 0.4 * std::cos(0.064 * i), 0.4 * std::sin(0.064 * i), 0 });
    coil.Widths.push_back(1.2);
  }
  strokes = { dot, coil, wave, spring, zigzag, taper, ring, square };
  return strokes;
}

/// Strength tapers what has a taper, by half a width for half the strength and a fifth at none.
void TestTaper()
{
  vtkSmartPointer<vtkPolyData> strokes =
    MakeStrokes({ { { -20, 0, 0 }, { 0, 0, 0 }, { 20, 0, 0 } } });
  vtkNew<vtkDoubleArray> strength;
  strength->SetName(npr::names::Strength);
  for (const double value : { 0.0, 0.5, 1.0 })
  {
    strength->InsertNextValue(value);
  }
  strokes->GetPointData()->AddArray(strength);
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, strokes);
  writer->GetStyle()->SetWidth("lines", 2.0);
  Drawing drawing = Draw(writer, folder + "StrokeOutlines.svg");
  check(drawing.Find("lines (visible)") && !drawing.Find("lines (visible)")->Paths[0].Filled,
    "no taper by default");
  writer->GetStyle()->SetTaper("lines", 0.2);
  drawing = Draw(writer, folder + "StrokeOutlines.svg");
  const Layer* const layer = drawing.Find("lines (visible)");
  if (check(layer && layer->Paths[0].Filled, "a taper is filled"))
  {
    std::vector<std::vector<Point2>> parts{ Sample(layer->Paths[0].Parts[0], 40) };
    const double widths[] = { 0.4, 1.2, 2.0 };
    for (int i = 0; i < 3; ++i)
    {
      const double x = 50 + 19.99 * (i - 1);
      check(GetWinding(parts, { x, 50 + 0.5 * widths[i] - 0.01 }) != 0 &&
          GetWinding(parts, { x, 50 + 0.5 * widths[i] + 0.01 }) == 0,
        "width at a strength", 0.5 * i);
    }
  }
  // A jump from nothing to all is drawn as a point that opens over some millimetres.
  strength->SetValue(0, 0.0);
  strength->SetValue(1, 1.0);
  strokes->GetPoints()->SetPoint(1, -19.9, 0, 0);
  strokes->Modified();
  writer->GetStyle()->SetTaper("lines", 0.0);
  drawing = Draw(writer, folder + "StrokeOutlines.svg");
  std::vector<std::vector<Point2>> parts{ Sample(
    drawing.Find("lines (visible)")->Paths[0].Parts[0], 40) };
  check(GetWinding(parts, { 31.0, 50.3 }) == 0 && GetWinding(parts, { 31.0, 50.02 }) != 0,
    "no width jumps");
}
}

int TestStrokeOutlines(int argc, char* argv[])
{
  folder = OutputFolder(argc, argv);
  for (const Stroke& stroke : MakeTestStrokes())
  {
    TestAgainstBruteForce(stroke);
  }
  TestTaper();
  return check.GetResult();
}
