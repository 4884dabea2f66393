// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes look as if all of their points and all of their joints were drawn: random chains of long
// and short segments against the discs along them, sampled by brute force; dense curves; widths,
// opacities and colours that change at single points; views that come closer; and lines that go to
// and fro along the sight, from there and from aside.
#include "nprStrokeTesting.h"
#include "vtkNPROffscreen.h"

#include <vtkFloatArray.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using nprtest::Check;
using nprtest::Line;
using nprtest::MakeLines;
using nprtest::Pi;
using nprtest::Picture;
using nprtest::Point;

namespace
{
double GetDistance(double x, double y, const Point& a, const Point& b)
{
  const double way[2] = { b[0] - a[0], b[1] - a[1] };
  const double size2 = way[0] * way[0] + way[1] * way[1];
  const double along = (x - a[0]) * way[0] + (y - a[1]) * way[1];
  const double t = size2 > 0 ? std::min(std::max(along / size2, 0.0), 1.0) : 0.0;
  return std::hypot(x - a[0] - t * way[0], y - a[1] - t * way[1]);
}

/// The share of a pixel that is within a radius of a line, by so many samples each way.
double SampleInk(int x, int y, const Line& line, double radius)
{
  constexpr int Samples = 8;
  Line near;
  int inside = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    if (GetDistance(x + 0.5, y + 0.5, line[i], line[i + 1]) < radius + 1)
    {
      near.push_back(line[i]);
      near.push_back(line[i + 1]);
    }
  }
  for (int k = 0; k < Samples * Samples && !near.empty(); ++k)
  {
    const double at[2] = { x + (k % Samples + 0.5) / Samples, y + (k / Samples + 0.5) / Samples };
    bool covered = false;
    for (std::size_t i = 0; i < near.size() && !covered; i += 2)
    {
      covered = GetDistance(at[0], at[1], near[i], near[i + 1]) < radius;
    }
    inside += covered ? 1 : 0;
  }
  return static_cast<double>(inside) / (Samples * Samples);
}

struct Difference
{
  double Largest = 0;
  double Mean = 0; // over pixels with ink
};

Difference CompareWithSamples(const Picture& picture, const Line& line, double radius)
{
  Difference difference;
  int inked = 0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const double expected = SampleInk(x, y, line, radius);
      const double error = std::abs(picture.GetInk(x, y) - expected);
      difference.Largest = std::max(difference.Largest, error);
      difference.Mean += error;
      inked += expected > 0 ? 1 : 0;
    }
  }
  difference.Mean /= std::max(inked, 1);
  return difference;
}

void ExpectSamples(const Line& line, double width, double largest, const std::string& what)
{
  Picture picture(100, 100);
  picture.AddStrokes(MakeLines({ line }), width);
  picture.Render();
  const Difference difference = CompareWithSamples(picture, line, 0.5 * width);
  std::cout << what << ": largest difference " << difference.Largest << ", mean " << difference.Mean
            << "\n";
  Check(difference.Largest < largest && difference.Mean < 0.07, what);
}

/// Walks about, with turns and steps of all sizes.
Line MakeWalk(int seed, double shortest, double longest, double turn)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(seed);
  const auto next = [&random](double low, double high)
  {
    random->Next();
    return random->GetRangeValue(low, high);
  };
  Line line = { { 50, 50, 0 } };
  double angle = next(0, 2 * Pi);
  for (int i = 0; i < 300; ++i)
  {
    angle += next(-turn, turn);
    const double step = shortest * std::pow(longest / shortest, next(0, 1));
    Point to = { line.back()[0] + step * std::cos(angle), line.back()[1] + step * std::sin(angle),
      next(-1, 1) };
    if (std::min(to[0], to[1]) < 12 || std::max(to[0], to[1]) > 88)
    {
      angle += Pi / 2;
      continue;
    }
    line.push_back(to);
    if (i % 50 == 0)
    {
      line.push_back(to); // twice in one place
    }
  }
  return line;
}

void TestShapes()
{
  for (const double width : { 1.0, 5.0 })
  {
    const std::string name = "width " + std::to_string(width);
    ExpectSamples(nprtest::MakeCircle(500, 50.3, 49.8, 30), width, 0.1, "a dense circle, " + name);
    ExpectSamples(nprtest::MakeCircle(500, 50.3, 49.8, 2), width, 0.25, "a small circle, " + name);
    // Where parts of a stroke cross, the most ink of them counts, not the sum of their areas.
    ExpectSamples(MakeWalk(1, 0.05, 12, 0.5), width, 0.45, "a bending walk, " + name);
    ExpectSamples(MakeWalk(2, 0.05, 3, 3.1), width, 0.45, "a walk to and fro, " + name);
  }
}

/// A straight line of so many points, with values of `value` at places from 0 to 1.
template<typename Value>
vtkSmartPointer<vtkPolyData> MakeValued(int points, const char* name, const Value& value)
{
  vtkSmartPointer<vtkPolyData> data =
    MakeLines({ nprtest::MakeStraight(10, 90, 50.2, points - 1) });
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  for (int i = 0; i < points; ++i)
  {
    array->InsertNextValue(static_cast<float>(value(i / (points - 1.0))));
  }
  data->GetPointData()->AddArray(array);
  return data;
}

double Compare(const Picture& a, const Picture& b)
{
  int worst = 0;
  for (vtkIdType i = 0; i < a.Pixels->GetNumberOfValues(); ++i)
  {
    worst = std::max(worst, std::abs(a.Pixels->GetValue(i) - b.Pixels->GetValue(i)));
  }
  return worst / 255.0;
}

/// That many points show the corners of their values just as the corners alone do.
void TestValues()
{
  const auto roof = [](double t) { return 1.0 - 0.9 * std::abs(2.0 * t - 1.0); };
  for (const char* name : { "Width", "Opacity", "Strength" })
  {
    Picture dense(100, 100);
    Picture sparse(100, 100);
    for (Picture* picture : { &dense, &sparse })
    {
      const int points = picture == &dense ? 161 : 3;
      vtkActor* const strokes = picture->AddStrokes(MakeValued(points, name, roof), 9);
      nprtest::GetMapper(strokes)->StrengthToWidthOn();
      nprtest::GetMapper(strokes)->StrengthToOpacityOn();
      picture->Render();
    }
    Check(Compare(dense, sparse) < 0.03, std::string("corners of the array ") + name);
    Check(dense.GetInk(50, 50) > 0.97 && dense.GetInk(50, 53) > dense.GetInk(12, 53) + 0.5,
      std::string("the array shows: ") + name);
  }
  Picture dense(100, 100);
  Picture sparse(100, 100);
  for (Picture* picture : { &dense, &sparse })
  {
    const int points = picture == &dense ? 161 : 3;
    vtkSmartPointer<vtkPolyData> data = MakeValued(points, "value", roof);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    for (int i = 0; i < points; ++i)
    {
      const auto red = static_cast<unsigned char>(200 * roof(i / (points - 1.0)));
      const unsigned char color[4] = { red, 50, 50, 255 };
      colors->InsertNextTypedTuple(color);
    }
    data->GetPointData()->SetScalars(colors);
    picture->AddStrokes(data, 9)->GetMapper()->ScalarVisibilityOn();
    picture->Render();
  }
  Check(Compare(dense, sparse) < 0.03, "corners of colours");
  Check(dense.GetRed(50, 50) > dense.GetRed(12, 50) + 100, "colours show");
}

/// That a round end is seen also where the last point, near to the one before, is thin or faint.
void TestTips()
{
  for (const char* name : { "Width", "Opacity" })
  {
    Picture blunt(40, 40);
    Picture tipped(40, 40);
    for (Picture* picture : { &blunt, &tipped })
    {
      Line line = { { 8, 20, 0 }, { 25, 20, 0 } };
      if (picture == &tipped)
      {
        line.push_back({ 25.2, 20, 0 });
      }
      vtkSmartPointer<vtkPolyData> data = MakeLines({ line });
      vtkNew<vtkFloatArray> array;
      array->SetName(name);
      for (std::size_t i = 0; i < line.size(); ++i)
      {
        array->InsertNextValue(i == 2 ? 0 : 1);
      }
      data->GetPointData()->AddArray(array);
      picture->AddStrokes(data, 9);
      picture->Render();
    }
    Check(blunt.GetInk(27, 20) > 0.97, "a round end");
    Check(Compare(blunt, tipped) < 0.05, std::string("a tip by the array ") + name);
  }
}

/// That what was left out for a far view is there for a near one, and the other way round.
void TestViews()
{
  vtkSmartPointer<vtkPolyData> circle = MakeLines({ nprtest::MakeCircle(500, 50, 50, 30) });
  Picture moving(100, 100);
  moving.AddStrokes(circle, 3);
  const double scale = moving.Renderer->GetActiveCamera()->GetParallelScale();
  for (const double zoom : { 0.05, 1.0, 8.0, 1.0 })
  {
    const double middle = zoom > 1 ? 80 : 50;
    vtkCamera* const camera = moving.Renderer->GetActiveCamera();
    camera->SetParallelScale(scale / zoom);
    camera->SetFocalPoint(middle, 50, 0);
    camera->SetPosition(middle, 50, 1000);
    moving.Render();
    Line seen;
    for (const Point& point : nprtest::MakeCircle(500, 50, 50, 30))
    {
      seen.push_back({ (point[0] - middle) * zoom + 50, (point[1] - 50) * zoom + 50, 0 });
    }
    const Difference difference = CompareWithSamples(moving, seen, 1.5);
    std::cout << "zoom " << zoom << ": " << difference.Largest << "\n";
    Check(difference.Largest < (zoom < 1 ? 0.3 : 0.1), "a view " + std::to_string(zoom));
  }
}
}

/// That strokes are a little less exact while something moves, and as they were when it stops.
void TestInteraction()
{
  const Line circle = nprtest::MakeCircle(500, 50.3, 49.8, 30);
  Picture picture(100, 100);
  picture.AddStrokes(MakeLines({ circle }), 3);
  for (const bool moves : { true, false })
  {
    picture.Window->SetDesiredUpdateRate(moves ? 15.0 : 0.0001);
    picture.Render();
    const double largest = CompareWithSamples(picture, circle, 1.5).Largest;
    std::cout << (moves ? "moving: " : "still: ") << largest << "\n";
    Check(largest < (moves ? 0.25 : 0.1), moves ? "a circle that moves" : "a circle at rest");
  }
}

/// That what was left out because it lies on sight lines is there when seen from aside.
void TestSights()
{
  Line straight;
  Line zigzag;
  for (int i = 0; i <= 800; ++i)
  {
    const double x = 10 + 0.1 * i;
    straight.push_back({ x, 50.2, 0 });
    zigzag.push_back({ x, 50.2, i % 2 == 0 ? 20.0 : -20.0 });
  }
  for (const bool parallel : { true, false })
  {
    const std::string name = parallel ? " in parallel projection" : " with perspective";
    Picture flat(100, 100);
    Picture turned(100, 100);
    Picture fresh(100, 100);
    for (Picture* picture : { &flat, &turned, &fresh })
    {
      vtkActor* const strokes =
        picture->AddStrokes(MakeLines({ picture == &flat ? straight : zigzag }), 3);
      nprtest::GetMapper(strokes)->DepthTestOff(); // which would need it all
      vtkCamera* const camera = picture->Renderer->GetActiveCamera();
      camera->SetParallelProjection(parallel);
      camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(0.05)));
      // At the height of the line, where all of it is on sight lines.
      camera->SetFocalPoint(50, 50.2, 0);
      camera->SetPosition(50, 50.2, 1000);
    }
    flat.Render();
    turned.Render();
    Check(!parallel || Compare(flat, turned) < 0.05, "a zigzag seen along it" + name);
    for (const int x : { 20, 50, 80 })
    {
      Check(flat.GetInk(x, 50) > 0.97 && std::abs(flat.GetInk(x, 52) - turned.GetInk(x, 52)) < 0.02,
        "a zigzag seen along it" + name + " at " + std::to_string(x));
    }
    for (Picture* picture : { &turned, &fresh })
    {
      picture->Renderer->GetActiveCamera()->Elevation(60.0);
      picture->Render();
    }
    Check(fresh.GetInk(50, 60) > 0.97, "a zigzag seen from aside" + name);
    Check(Compare(turned, fresh) < 0.1, "the same zigzag seen first along it" + name);
  }
}

int TestStrokeSimplification(int, char*[])
{
  if (!vtkNPROffscreen::Setup())
  {
    return EXIT_FAILURE;
  }
  TestShapes();
  TestValues();
  TestTips();
  TestViews();
  TestSights();
  TestInteraction();
  return nprtest::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
