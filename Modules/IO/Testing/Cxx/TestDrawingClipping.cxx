// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes are cut at the page and at the near plane: against other ways to find out what is seen.
#include "nprChecks.h"
#include "nprDrawingTesting.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace nprtest;

Checks check;
std::string folder;

/// The part of a segment in [0, 100]^2, by testing many points of it and halving where it changes.
bool CutByBruteForce(const Point2& a, const Point2& b, Point2& from, Point2& to)
{
  const auto isInside = [&](double t)
  {
    const Point2 p = a + t * (b - a);
    return p.minCoeff() >= 0 && p.maxCoeff() <= 100;
  };
  constexpr int Steps = 20000;
  int first = Steps + 1;
  int last = -1;
  for (int i = 0; i <= Steps; ++i)
  {
    if (isInside(static_cast<double>(i) / Steps))
    {
      first = std::min(first, i);
      last = i;
    }
  }
  if (last < first)
  {
    return false;
  }
  const auto refine = [&](double outside, double inside)
  {
    for (int i = 0; i < 60 && outside >= 0 && outside <= 1; ++i)
    {
      const double middle = 0.5 * (outside + inside);
      (isInside(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  from = a + refine((first - 1.0) / Steps, static_cast<double>(first) / Steps) * (b - a);
  to = a + refine((last + 1.0) / Steps, static_cast<double>(last) / Steps) * (b - a);
  return true;
}

void TestSegments()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-150, 150);
  std::vector<Line3> lines;
  std::vector<std::pair<Point2, Point2>> expected;
  for (int i = 0; i < 2000; ++i)
  {
    const Line3 line{ { place(random), place(random), 0 }, { place(random), place(random), 0 } };
    lines.push_back(line);
    Point2 from, to;
    if (CutByBruteForce({ 50 + line[0].x(), 50 - line[0].y() },
          { 50 + line[1].x(), 50 - line[1].y() }, from, to) &&
      (to - from).norm() > 0.1)
    {
      expected.emplace_back(from, to);
    }
  }
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, MakeStrokes(lines));
  const Drawing drawing = Draw(writer, folder + "DrawingClipping.svg");
  std::vector<Path> paths = drawing.Find("lines (visible)")->Paths;
  paths.erase(std::remove_if(paths.begin(), paths.end(),
                [](const Path& path) { return (path.Start() - path.End()).norm() <= 0.1; }),
    paths.end());
  check(expected.size() > 500, "many segments are seen", static_cast<double>(expected.size()));
  if (check(paths.size() == expected.size(), "as many as by brute force",
        static_cast<double>(paths.size()) - static_cast<double>(expected.size())))
  {
    double off = 0.0;
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      off = std::max({ off, (paths[i].Start() - expected[i].first).norm(),
        (paths[i].End() - expected[i].second).norm() });
    }
    check(off < 0.002, "and the same", off);
  }
}

/// A circle around the page's middle that leaves it at four sides, and one that does not.
void TestLoops()
{
  const auto circle = [](double radius, double start)
  {
    Line3 line;
    for (int i = 0; i <= 360; ++i)
    {
      const double t = start + 2 * Pi * (i % 360) / 360;
      line.push_back({ radius * std::cos(t), radius * std::sin(t), 0 });
    }
    return line;
  };
  // Wherever a loop begins, inside or outside, its pieces are four.
  for (const double start : { 0.0, 0.8 })
  {
    vtkNew<vtkNPRSVGWriter> writer;
    SetPlainPage(writer, MakeStrokes({ circle(55, start), circle(45, start) }));
    const Drawing drawing = Draw(writer, folder + "DrawingClipping.svg");
    const std::vector<Path>& paths = drawing.Find("lines (visible)")->Paths;
    if (!check(paths.size() == 5, "four pieces and a loop", static_cast<double>(paths.size())))
    {
      continue;
    }
    double length = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      check(!paths[i].Closed[0], "a piece is open");
      for (const Point2& end : { paths[i].Start(), paths[i].End() })
      {
        const double toEdge = std::min(end.minCoeff(), 100 - end.maxCoeff());
        check(std::abs(toEdge) < 0.002, "a piece ends at an edge of the page", toEdge);
      }
      const std::vector<Point2> points = Sample(paths[i].Parts[0], 100);
      for (std::size_t k = 1; k < points.size(); ++k)
      {
        length += (points[k] - points[k - 1]).norm();
      }
    }
    const double expected = 55 * (2 * Pi - 8 * std::acos(50.0 / 55));
    check(std::abs(length - expected) < 0.05, "the length on the page", length - expected);
    check(paths[4].Closed[0], "the loop inside stays closed");
  }
}

/// In perspective, lines that pass the eye end where they meet the near plane.
void TestNearPlane()
{
  vtkSmartPointer<vtkCamera> camera = LookDown(100);
  camera->ParallelProjectionOff();
  camera->SetPosition(0, 0, 10);
  camera->SetClippingRange(2, 100);
  camera->SetViewAngle(90);
  const Line3 line{ { 0.5, 1, 0 }, { 0.5, 1, 30 } };
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, MakeStrokes({ line, { { 0, 0, 9 }, { 3, 3, 50 } } }));
  writer->SetCamera(camera);
  const Drawing drawing = Draw(writer, folder + "DrawingClipping.svg");
  const std::vector<Path>& paths = drawing.Find("lines (visible)")->Paths;
  if (check(paths.size() == 1, "what is behind is not drawn", static_cast<double>(paths.size())))
  {
    // At depth d, half the page is d wide.
    const auto onPage = [](double depth)
    { return Point2(50 + 0.5 / depth * 50, 50 - 1 / depth * 50); };
    check((paths[0].Start() - onPage(10)).norm() < 0.002, "begins where it is");
    check((paths[0].End() - onPage(2)).norm() < 0.002, "ends at the near plane",
      (paths[0].End() - onPage(2)).norm());
  }
}
}

int TestDrawingClipping(int argc, char* argv[])
{
  folder = OutputFolder(argc, argv);
  TestSegments();
  TestLoops();
  TestNearPlane();
  return check.GetResult();
}
