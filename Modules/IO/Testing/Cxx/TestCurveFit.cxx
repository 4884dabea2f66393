// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes as curves: how near they come to what was meant, where they are smooth, and how small.
#include "nprChecks.h"
#include "nprDrawingTesting.h"

#include <vtkTimerLog.h>

#include <cmath>
#include <functional>

namespace
{
using namespace nprtest;

Checks check;
std::string folder;

Point2 OnPage(const Eigen::Vector3d& p)
{
  return { 50 + p.x(), 50 - p.y() };
}

std::vector<Path> DrawLines(const std::vector<Line3>& lines, double tolerance = 0.02)
{
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, MakeStrokes(lines));
  writer->SetTolerance(tolerance);
  const Drawing drawing = Draw(writer, folder + "CurveFit.svg");
  const Layer* const layer = drawing.Find("lines (visible)");
  return layer ? layer->Paths : std::vector<Path>();
}

Line3 SampleCurve(
  const std::function<Eigen::Vector3d(double)>& curve, int segments, double from, double to)
{
  Line3 line;
  for (int i = 0; i <= segments; ++i)
  {
    line.push_back(curve(from + (to - from) * i / segments));
  }
  return line;
}

double TurnDegrees(const Cubic& before, const Cubic& after)
{
  const Point2 in = before[3] - before[2];
  const Point2 out = after[1] - after[0];
  return std::atan2(std::abs(in.x() * out.y() - in.y() * out.x()), in.dot(out)) * 180 / Pi;
}

/// The largest turn where two curves of a part meet; where it is closed, at its seam, too.
double LargestTurn(const Path& path)
{
  const std::vector<Cubic>& curves = path.Parts[0];
  double largest = path.Closed[0] ? TurnDegrees(curves.back(), curves.front()) : 0.0;
  for (std::size_t i = 1; i < curves.size(); ++i)
  {
    largest = std::max(largest, TurnDegrees(curves[i - 1], curves[i]));
  }
  return largest;
}

struct Shape
{
  const char* Name;
  std::function<Eigen::Vector3d(double)> Curve;
  double To;
  bool Closed;
};

/// All points lie within the tolerance of the curves, and the curves within it of the truth.
void TestTolerance()
{
  const Shape shapes[] = {
    { "circle", [](double t) { return Eigen::Vector3d(20 * std::cos(t), 20 * std::sin(t), t); },
      2 * Pi, true },
    { "ellipse", [](double t) { return Eigen::Vector3d(40 * std::cos(t), 8 * std::sin(t), 0); },
      2 * Pi, true },
    { "wave", [](double t) { return Eigen::Vector3d(10 * t - 40, 5 * std::sin(3 * t), 0); }, 8,
      false },
    { "spiral", [](double t) { return Eigen::Vector3d(t * std::cos(t), t * std::sin(t), 0); }, 40,
      false },
  };
  for (const Shape& shape : shapes)
  {
    for (const double tolerance : { 0.005, 0.02, 0.1 })
    {
      for (const int segments : { 300, 5000 })
      {
        Line3 line = SampleCurve(shape.Curve, segments, 0, shape.To);
        if (shape.Closed)
        {
          line.back() = line.front();
        }
        const std::vector<Path> paths = DrawLines({ line }, tolerance);
        const std::string what = std::string(shape.Name) + ", tolerance " +
          std::to_string(tolerance) + ", " + std::to_string(segments) + " segments: ";
        if (!check(paths.size() == 1, what + "one path"))
        {
          continue;
        }
        const std::vector<Cubic>& curves = paths[0].Parts[0];
        // Places are written to a tenth of the tolerance, or better.
        const double allowed = 1.1 * tolerance;
        const std::vector<Point2> drawn = Sample(curves, 200);
        double off = 0.0;
        for (const Eigen::Vector3d& point : line)
        {
          off = std::max(off, DistanceToPolyline(OnPage(point), drawn));
        }
        check(off < allowed, what + "points are near the curves", off);

        std::vector<Point2> truth;
        for (const Eigen::Vector3d& point : SampleCurve(shape.Curve, 20000, 0, shape.To))
        {
          truth.push_back(OnPage(point));
        }
        double astray = 0.0;
        for (const Point2& point : Sample(curves, 8))
        {
          astray = std::max(astray, DistanceToPolyline(point, truth));
        }
        check(astray < allowed + 0.005, what + "curves are near the truth", astray);
        check(paths[0].Closed[0] == shape.Closed, what + "is closed as it should be");
        check(
          LargestTurn(paths[0]) < 3.0, what + "smooth, also at the seam", LargestTurn(paths[0]));
        check(curves.size() < 120, what + "few curves", static_cast<double>(curves.size()));
      }
    }
  }
}

bool HasNode(const Path& path, const Point2& place)
{
  for (const Cubic& curve : path.Parts[0])
  {
    if ((curve[0] - place).norm() < 0.002)
    {
      return true;
    }
  }
  return false;
}

void TestCorners()
{
  // Of a square with many points, and of one with none between the corners.
  for (const int steps : { 1, 100 })
  {
    Line3 square;
    const Eigen::Vector3d corners[] = { { -20, -20, 0 }, { 20, -20, 0 }, { 20, 20, 0 },
      { -20, 20, 0 } };
    for (int side = 0; side < 4; ++side)
    {
      for (int i = 0; i < steps; ++i)
      {
        square.push_back(corners[side] + (corners[(side + 1) % 4] - corners[side]) * i / steps);
      }
    }
    square.push_back(square.front());
    const std::vector<Path> paths = DrawLines({ square });
    check(paths.size() == 1 && paths[0].Parts[0].size() == 4 && paths[0].Closed[0],
      "a square is four lines", static_cast<double>(paths.at(0).Parts[0].size()));
    for (const Eigen::Vector3d& corner : corners)
    {
      check(HasNode(paths.at(0), OnPage(corner)), "a square keeps its corners");
    }
  }

  // A hexagon from the side: its corners are blunt on the page, but its sides are meant straight.
  Line3 hexagon;
  for (int i = 0; i <= 6; ++i)
  {
    const double t = Pi * (i + 0.3) / 3;
    hexagon.push_back({ 20 * std::cos(t), 4 * std::sin(t), 19.6 * std::sin(t) });
  }
  hexagon.back() = hexagon.front();
  const std::vector<Path> hexagons = DrawLines({ hexagon });
  check(hexagons.size() == 1 && hexagons[0].Parts[0].size() == 6, "a hexagon is six lines");
  double bulge = 0.0;
  std::vector<Point2> outline;
  for (const Eigen::Vector3d& point : hexagon)
  {
    outline.push_back(OnPage(point));
  }
  for (const Point2& point : Sample(hexagons.at(0).Parts[0], 20))
  {
    bulge = std::max(bulge, DistanceToPolyline(point, outline));
  }
  check(bulge < 0.002, "its sides are straight", bulge);

  // A circle of sixteen sides is meant to be round, from the side, too.
  Line3 coarse;
  for (int i = 0; i <= 16; ++i)
  {
    const double t = 2 * Pi * (i % 16) / 16;
    coarse.push_back({ 30 * std::cos(t), 12 * std::sin(t), 27 * std::sin(t) });
  }
  const std::vector<Path> circles = DrawLines({ coarse });
  check(circles.size() == 1 && circles[0].Closed[0] && LargestTurn(circles[0]) < 3.0,
    "a coarse circle is round", LargestTurn(circles.at(0)));
  double dent = 0.0;
  for (const Point2& p : Sample(circles.at(0).Parts[0], 20))
  {
    dent = std::max(dent, std::abs(std::hypot((p.x() - 50) / 30, (p.y() - 50) / 12) - 1));
  }
  check(dent < 0.01, "and as a circle is", dent);

  // A straight side that goes over into an arc: one tangent, and no bulge.
  Line3 bend{ { -40, 0, 0 } };
  for (int i = 0; i <= 40; ++i)
  {
    bend.push_back({ 3 * std::sin(Pi * i / 80), 3 - 3 * std::cos(Pi * i / 80), 0 });
  }
  bend.push_back({ 3, 40, 0 });
  const std::vector<Path> bends = DrawLines({ bend });
  check(bends.size() == 1 && LargestTurn(bends[0]) < 2.0, "straight sides touch the arc");
  double off = 0.0;
  for (const Point2& p : Sample(bends.at(0).Parts[0], 50))
  {
    const Eigen::Vector2d w(p.x() - 50, 50 - p.y());
    const double truth = w.x() < 0 ? std::abs(w.y())
      : w.y() > 3                  ? std::abs(w.x() - 3)
                                   : std::abs((w - Eigen::Vector2d(0, 3)).norm() - 3);
    off = std::max(off, truth);
  }
  check(off < 0.025, "and lie where they should", off);
}

/// A wave of tiny turns, such as chains along triangles have, is not taken for corners, nor may a
/// sharp corner among them be lost.
void TestNoise()
{
  Line3 line;
  for (int i = 0; i <= 4000; ++i)
  {
    const double x = 0.02 * i - 40;
    line.push_back({ x, std::abs(x) + 0.004 * ((i * 7919) % 13 - 6) / 6.0, 0 });
  }
  const std::vector<Path> paths = DrawLines({ line });
  check(paths.size() == 1 && paths[0].Parts[0].size() <= 6, "noise below the tolerance goes",
    static_cast<double>(paths.at(0).Parts[0].size()));
  check(LargestTurn(paths.at(0)) > 80, "a corner stays");
}

void TestSizeAndTime()
{
  std::vector<Line3> lines;
  for (int i = 0; i < 100; ++i)
  {
    lines.push_back(SampleCurve(
      [i](double t) {
        return Eigen::Vector3d(t - 45, 0.9 * i - 45 + 0.5 * std::sin(t) + 0.2 * std::sin(3 * t), 0);
      },
      999, 0, 90));
  }
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, MakeStrokes(lines));
  const std::string file = folder + "CurveFitSize.svg";
  double least = 1e9;
  for (int i = 0; i < 5; ++i)
  {
    const double start = vtkTimerLog::GetUniversalTime();
    writer->SetFileName(file.c_str());
    writer->Write();
    least = std::min(least, vtkTimerLog::GetUniversalTime() - start);
  }
  const double bytes = static_cast<double>(ReadFile(file).size()) / 100000;
  std::cout << "100000 points in 100 strokes: " << 1000 * least << " ms, " << bytes
            << " bytes a point\n";
  check(bytes < 2.5, "bytes a point", bytes);
  check(least < 1.0, "seconds", least);
}
}

int TestCurveFit(int argc, char* argv[])
{
  folder = OutputFolder(argc, argv);
  TestTolerance();
  TestCorners();
  TestNoise();
  TestSizeAndTime();
  return check.GetResult();
}
