// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Properties of the splines, and what bad chains turn into.
#include "nprArrayNames.h"
#include "nprSplines.h"
#include "vtkNPRSplineStrokes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <vector>

namespace
{
using Points = std::vector<npr::Vector3>;

int failures = 0;

void Check(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++failures;
  }
}
#define CHECK(condition) Check(condition, #condition)

vtkIdType AddLine(vtkPolyData* data, const Points& line, bool closeById = false)
{
  if (!data->GetPoints())
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    data->SetPoints(points);
    data->SetLines(vtkNew<vtkCellArray>());
  }
  vtkNew<vtkIdList> ids;
  for (const npr::Vector3& point : line)
  {
    ids->InsertNextId(data->GetPoints()->InsertNextPoint(point.data()));
  }
  if (closeById)
  {
    ids->InsertNextId(ids->GetId(0));
  }
  return data->GetLines()->InsertNextCell(ids);
}

Points GetLine(vtkPolyData* data, vtkIdType line)
{
  vtkNew<vtkIdList> ids;
  data->GetLines()->GetCellAtId(line, ids);
  Points points(ids->GetNumberOfIds());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(ids->GetId(static_cast<vtkIdType>(i)), points[i].data());
  }
  return points;
}

Points Run(vtkNPRSplineStrokes* filter, const Points& line, bool closeById = false)
{
  vtkNew<vtkPolyData> data;
  AddLine(data, line, closeById);
  filter->SetInputData(data);
  filter->Update();
  return filter->GetOutput()->GetNumberOfLines() == 1 ? GetLine(filter->GetOutput(), 0) : Points();
}

double Distance(const npr::Vector3& a, const npr::Vector3& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

double DistanceToLine(const npr::Vector3& p, const Points& line)
{
  double nearest = VTK_DOUBLE_MAX;
  for (const npr::Vector3& q : line)
  {
    nearest = std::min(nearest, Distance(p, q));
  }
  return nearest;
}

npr::Vector3 Difference(const npr::Vector3& a, const npr::Vector3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Points Circle(int n, double radius)
{
  Points points;
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2 * vtkMath::Pi() * i / n;
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.25 * radius });
  }
  return points;
}

const Points Wave = { { 0, 0, 0 }, { 1, 0.4, 0 }, { 2, 0.3, 0.5 }, { 3.5, 0, 0.2 },
  { 4, -0.3, 0 } };

// The bound against the farthest of many points from the segment between the ends.
void TestDistanceFromChord()
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(5);
  const auto next = [&random]()
  {
    random->Next();
    return random->GetRangeValue(-1, 1);
  };
  const npr::SplineBasis basis = npr::GetSplineBasis(npr::SplineKind::CatmullRom, 0.5);
  bool holds = true;
  double tightest = 0;
  for (int i = 0; i < 2000; ++i)
  {
    std::array<npr::Vector3, 4> points;
    for (npr::Vector3& point : points)
    {
      point = { next(), 0.3 * next(), i % 2 == 0 ? 0.0 : next() };
    }
    points[2] = i % 7 == 0 ? points[1] : points[2]; // a chord of no length
    const npr::CubicSpan span = npr::MakeSpan(basis, points);
    const npr::Vector3 start = span.Evaluate(0);
    const npr::Vector3 end = span.Evaluate(1);
    double farthest = 0;
    for (int step = 1; step < 200; ++step)
    {
      const npr::Vector3 place = span.Evaluate(step / 200.0);
      npr::Vector3 way, along;
      vtkMath::Subtract(end.data(), start.data(), way.data());
      vtkMath::Subtract(place.data(), start.data(), along.data());
      const double length2 = vtkMath::Dot(way.data(), way.data());
      const double t = length2 > 0
        ? std::min(std::max(vtkMath::Dot(along.data(), way.data()) / length2, 0.0), 1.0)
        : 0.0;
      const npr::Vector3 nearest = { start[0] + t * way[0], start[1] + t * way[1],
        start[2] + t * way[2] };
      farthest = std::max(
        farthest, std::sqrt(vtkMath::Distance2BetweenPoints(place.data(), nearest.data())));
    }
    const double bound = npr::DistanceFromChord(span);
    holds = holds && farthest <= bound + 1e-12;
    tightest = std::max(tightest, farthest / bound);
  }
  CHECK(holds);
  CHECK(tightest > 0.9);
}

void TestCatmullRomInterpolates()
{
  vtkNew<vtkNPRSplineStrokes> filter;
  filter->SetSubdivisions(7);
  const Points out = Run(filter, Wave);
  CHECK(out.size() == 4 * 7 + 1);
  for (std::size_t i = 0; i < Wave.size() && out.size() == 29; ++i)
  {
    CHECK(Distance(out[7 * i], Wave[i]) < 1e-12);
  }
  // Half way between P1 and P2 the usual Catmull-Rom is (-P0 + 9 P1 + 9 P2 - P3) / 16.
  filter->SetSubdivisions(2);
  const Points half = Run(filter, Wave);
  for (int c = 0; c < 3; ++c)
  {
    CHECK(std::abs(half[3][c] - (-Wave[0][c] + 9 * Wave[1][c] + 9 * Wave[2][c] - Wave[3][c]) / 16) <
      1e-12);
  }
  // Without tension it is the polyline.
  filter->SetTension(0);
  const Points straight = Run(filter, Wave);
  for (int c = 0; c < 3; ++c)
  {
    CHECK(std::abs(straight[3][c] - 0.5 * (Wave[1][c] + Wave[2][c])) < 1e-12);
  }
}

// Where an arc of short spans meets one that is a hundred times longer, as on a sheet of metal.
void TestCatmullRomMakesNoLoops()
{
  vtkNew<vtkNPRSplineStrokes> filter;
  filter->SetSubdivisions(16);
  const Points bend = { { -2.0, -2.4, 0 }, { -1.3, -1.6, 0 }, { -0.65, -0.8, 0 }, { 0, 0, 0 },
    { 100, 0, 0 }, { 200, 0, 0 } };
  const Points out = Run(filter, bend);
  for (std::size_t i = 1; i < out.size(); ++i)
  {
    CHECK(out[i][0] > out[i - 1][0]);
    CHECK(out[i][1] < 1e-12 && out[i][1] > -2.4 - 1e-12);
  }
}

// Where short spans follow a long one straight on, as where the side of a cylinder comes to its
// rim: no stroke goes on beyond the last of them and comes back.
void TestCatmullRomStopsAtCorners()
{
  vtkNew<vtkNPRSplineStrokes> filter;
  filter->SetSubdivisions(16);
  for (const double bend : { 0.0, 0.01, 0.04 })
  {
    const Points side = { { 0, 0, 0 }, { 40, 0, 0 }, { 41, bend, 0 }, { 41.5, 2 * bend, 0 },
      { 41.5, 3, 0 }, { 41.5, 6, 0 } };
    for (const npr::Vector3& p : Run(filter, side))
    {
      CHECK(p[0] < 41.5 + 1e-3);
    }
  }
}

void TestBSplineStaysInside()
{
  vtkNew<vtkNPRSplineStrokes> filter;
  filter->SetSplineTypeToBSpline();
  filter->SetSubdivisions(8);
  filter->SetCornerAngle(180);
  const Points zigzag = { { 0, 0, 0 }, { 1, 1, 0 }, { 2, 0, 0 }, { 3, 1, 0 }, { 4, 0, 0 } };
  const Points out = Run(filter, zigzag);
  CHECK(!out.empty());
  CHECK(Distance(out.front(), zigzag.front()) < 1e-12);
  CHECK(Distance(out.back(), zigzag.back()) < 1e-12);
  double highest = 0;
  double turn = 0;
  for (std::size_t i = 0; i < out.size(); ++i)
  {
    CHECK(out[i][1] > -1e-12 && out[i][1] < 1 + 1e-12);
    highest = std::max(highest, out[i][1]);
    turn = i > 0 ? std::max(turn, std::abs(out[i][1] - out[i - 1][1])) : turn;
  }
  CHECK(highest < 0.75); // it smooths: 2/3 of the amplitude at the first crest
  CHECK(turn < 0.2);
}

// The first and second differences at the seam of a closed chain are as everywhere else.
void TestClosedHasNoSeam()
{
  for (int type : { vtkNPRSplineStrokes::CATMULL_ROM, vtkNPRSplineStrokes::B_SPLINE })
  {
    for (bool closeById : { true, false })
    {
      vtkNew<vtkNPRSplineStrokes> filter;
      filter->SetSplineType(type);
      filter->SetSubdivisions(10);
      Points circle = Circle(16, 2.0);
      if (!closeById)
      {
        circle.push_back(circle.front());
      }
      const Points out = Run(filter, circle, closeById);
      const std::size_t n = out.size() - 1;
      CHECK(n == 160);
      if (n != 160)
      {
        continue;
      }
      CHECK(Distance(out.front(), out.back()) < 1e-12);
      for (std::size_t i = 0; i < n; i += 10)
      {
        const npr::Vector3 after = Difference(out[(i + 1) % n], out[i]);
        const npr::Vector3 before = Difference(out[i], out[(i + n - 1) % n]);
        // C1: 1/100 of the second derivative. C2: that itself is the same at every control point.
        const double second = Distance(after, before) / vtkMath::Norm(after.data());
        CHECK(second < 0.06);
        const npr::Vector3 seam = Difference(out[1], out[0]);
        CHECK(std::abs(vtkMath::Norm(after.data()) - vtkMath::Norm(seam.data())) < 1e-12);
      }
      vtkFloatArray* arc = vtkFloatArray::SafeDownCast(
        filter->GetOutput()->GetPointData()->GetArray(npr::names::ArcLength));
      CHECK(arc && arc->GetValue(0) == 0.0f);
      const double expected = 2 * vtkMath::Pi() * 2.0;
      // The B-spline of a circle's points is a smaller circle: (4 + 2 cos(2 pi / 16)) / 6.
      const double scale =
        type == vtkNPRSplineStrokes::B_SPLINE ? (4 + 2 * std::cos(vtkMath::Pi() / 8)) / 6 : 1.0;
      CHECK(arc && std::abs(arc->GetValue(160) / (expected * scale) - 1) < 1e-3);
    }
  }
}

void TestCornersSurvive()
{
  // Two straight legs that meet at a right angle, each with points on it.
  const Points bend = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 2, 2, 0 } };
  for (int type : { vtkNPRSplineStrokes::CATMULL_ROM, vtkNPRSplineStrokes::B_SPLINE })
  {
    vtkNew<vtkNPRSplineStrokes> filter;
    filter->SetSplineType(type);
    const Points sharp = Run(filter, bend);
    CHECK(DistanceToLine(bend[2], sharp) < 1e-12);
    for (const npr::Vector3& p : sharp)
    {
      CHECK(std::abs(p[1]) < 1e-12 || std::abs(p[0] - 2) < 1e-12);
    }
    filter->SetCornerAngle(120);
    bool leaves = false;
    for (const npr::Vector3& p : Run(filter, bend))
    {
      leaves = leaves || (std::abs(p[1]) > 0.01 && std::abs(p[0] - 2) > 0.01);
    }
    CHECK(leaves);
  }
  // A square with points in the middles of its sides, starting in the middle of one.
  Points square = { { 1, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 2, 2, 0 }, { 1, 2, 0 }, { 0, 2, 0 },
    { 0, 1, 0 }, { 0, 0, 0 } };
  vtkNew<vtkNPRSplineStrokes> filter;
  const Points out = Run(filter, square, true);
  CHECK(Distance(out.front(), out.back()) < 1e-12);
  for (const npr::Vector3& p : out)
  {
    CHECK(
      std::min({ std::abs(p[0]), std::abs(p[0] - 2), std::abs(p[1]), std::abs(p[1] - 2) }) < 1e-12);
  }
  vtkDataArray* arc = filter->GetOutput()->GetPointData()->GetArray(npr::names::ArcLength);
  CHECK(std::abs(arc->GetRange()[1] - 8) < 1e-5);
}

/// That what turns little stays what it is where splines would leave it far, and that round lines
/// of many points stay round.
void TestBulge()
{
  /// How far a curve goes beyond the sides of a regular polygon of radius 1.
  const auto getBulge = [](const Points& curve, int sides)
  {
    const double step = 2 * vtkMath::Pi() / sides;
    double bulge = -1.0;
    for (const npr::Vector3& p : curve)
    {
      for (int i = 0; i < sides; ++i)
      {
        const double angle = (i + 0.5) * step;
        bulge =
          std::max(bulge, p[0] * std::cos(angle) + p[1] * std::sin(angle) - std::cos(0.5 * step));
      }
    }
    return bulge;
  };
  for (const int sides : { 7, 12, 40 })
  {
    const Points polygon = Circle(sides, 1.0);
    vtkNew<vtkNPRSplineStrokes> filter;
    const double free = getBulge(Run(filter, polygon, true), sides);
    // The sagitta of an arc, and nothing where it is more than allowed.
    CHECK(std::abs(free - (1.0 - std::cos(vtkMath::Pi() / sides))) < 0.2 * free);
    filter->SetMaximumBulge(0.5 * free);
    CHECK(getBulge(Run(filter, polygon, true), sides) < 1e-12);
    filter->SetMaximumBulge(1.5 * free);
    CHECK(std::abs(getBulge(Run(filter, polygon, true), sides) - free) < 1e-12);
  }
}

void TestResampling()
{
  vtkNew<vtkNPRSplineStrokes> filter;
  filter->SetMaximumSegmentLength(0.05);
  const Points circle = Circle(12, 1.0);
  Points out = Run(filter, circle, true);
  for (std::size_t i = 1; i < out.size(); ++i)
  {
    CHECK(Distance(out[i - 1], out[i]) < 0.05 + 1e-9);
  }
  CHECK(out.size() > 126 && out.size() < 160);

  // A chord's distance from the spline: compare with a much finer one.
  filter->SetMaximumSegmentLength(0);
  filter->SetMaximumChordError(1e-3);
  out = Run(filter, circle, true);
  CHECK(out.size() > 30 && out.size() < 120);
  filter->SetMaximumChordError(0);
  filter->SetSubdivisions(256);
  const Points fine = Run(filter, circle, true);
  double worst = 0;
  for (std::size_t i = 1; i < out.size(); ++i)
  {
    npr::Vector3 middle;
    for (int c = 0; c < 3; ++c)
    {
      middle[c] = 0.5 * (out[i - 1][c] + out[i][c]);
    }
    worst = std::max(worst, DistanceToLine(middle, fine));
  }
  CHECK(worst < 1.5e-3 && worst > 1e-5);

  // Polylines can be resampled, too.
  filter->SetSplineTypeToNone();
  CHECK(Run(filter, { { 0, 0, 0 }, { 1, 0, 0 } }).size() == 2);
  filter->SetMaximumSegmentLength(0.1);
  CHECK(Run(filter, { { 0, 0, 0 }, { 1, 0, 0 } }).size() == 11);
}

void TestSmoothing()
{
  Points zigzag;
  for (int i = 0; i < 40; ++i)
  {
    zigzag.push_back({ 0.1 * i, i % 2 ? 0.02 : -0.02, 0 });
  }
  vtkNew<vtkNPRSplineStrokes> filter;
  filter->SetSplineTypeToNone();
  filter->SetSmoothingIterations(1);
  const Points out = Run(filter, zigzag);
  CHECK(Distance(out.front(), zigzag.front()) == 0 && Distance(out.back(), zigzag.back()) == 0);
  for (std::size_t i = 2; i + 2 < out.size(); ++i)
  {
    CHECK(std::abs(out[i][1]) < 1e-12 && std::abs(out[i][0] - 0.1 * i) < 1e-12);
  }

  // The zig-zag is smaller than what points may move by, the corner is not.
  const Points corner = { { -9, 0, 0 }, { 0, 0, 0 }, { 0, 9, 0 } };
  filter->SetSmoothingIterations(6);
  filter->SetMaximumShift(0.05);
  CHECK(std::abs(Distance(Run(filter, corner)[1], corner[1]) - 0.05) < 1e-6);
  CHECK(std::abs(Run(filter, zigzag)[zigzag.size() / 2][1]) < 1e-6);
}

double DistanceToPolyline(const npr::Vector3& p, const Points& line)
{
  double nearest = VTK_DOUBLE_MAX;
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    const npr::Vector3 along = Difference(line[i], line[i - 1]);
    const npr::Vector3 way = Difference(p, line[i - 1]);
    const double squared = vtkMath::Dot(along.data(), along.data());
    const double t = squared > 0
      ? std::min(1.0, std::max(0.0, vtkMath::Dot(way.data(), along.data()) / squared))
      : 0.0;
    npr::Vector3 nearestPlace;
    for (int c = 0; c < 3; ++c)
    {
      nearestPlace[c] = line[i - 1][c] + t * along[c];
    }
    nearest = std::min(nearest, Distance(p, nearestPlace));
  }
  return nearest;
}

void TestSimplification()
{
  // An S with a corner of 70 degrees in it, and a closed curve.
  Points bend;
  for (int i = 0; i <= 200; ++i)
  {
    const double x = 0.05 * (i - 100);
    bend.push_back({ x, std::sin(x) + 0.7 * std::abs(x), 0.2 * std::cos(2 * x) });
  }
  const npr::Vector3 corner = bend[100];
  const Points loop = Circle(360, 3.0);
  for (int type :
    { vtkNPRSplineStrokes::NONE, vtkNPRSplineStrokes::CATMULL_ROM, vtkNPRSplineStrokes::B_SPLINE })
  {
    for (bool closed : { false, true })
    {
      vtkNew<vtkNPRSplineStrokes> filter;
      filter->SetSplineType(type);
      filter->SetCornerAngle(20);
      const Points& line = closed ? loop : bend;
      const Points all = Run(filter, line, closed);
      vtkDataArray* arc = filter->GetOutput()->GetPointData()->GetArray(npr::names::ArcLength);
      const double length = arc->GetRange()[1];
      std::size_t last = all.size();
      for (double deviation : { 0.001, 0.01, 0.1 })
      {
        filter->SetMaximumDeviation(deviation);
        const Points few = Run(filter, line, closed);
        CHECK(few.size() >= 2 && few.size() < last);
        last = few.size();
        double worst = 0;
        for (const npr::Vector3& p : all)
        {
          worst = std::max(worst, DistanceToPolyline(p, few));
        }
        CHECK(worst <= deviation * (1 + 1e-9) && worst > 0.2 * deviation);
        for (const npr::Vector3& p : few)
        {
          CHECK(DistanceToLine(p, all) == 0);
        }
        CHECK(Distance(few.front(), all.front()) == 0 && Distance(few.back(), all.back()) == 0);
        CHECK(closed || DistanceToLine(corner, few) < 1e-12);
        arc = filter->GetOutput()->GetPointData()->GetArray(npr::names::ArcLength);
        CHECK(arc->GetRange()[0] == 0 && arc->GetRange()[1] == length);
      }
      // Whatever is left of a loop is one; of an open stroke, the ends and the corner.
      filter->SetMaximumDeviation(100);
      const Points least = Run(filter, line, closed);
      CHECK(least.size() == 3);
      CHECK(closed || DistanceToLine(corner, least) < 1e-12);
      CHECK(!closed || std::abs(Distance(least[0], least[1]) - 6.0) < 0.1);
    }
  }
  // Straight lines need no points between their ends.
  vtkNew<vtkNPRSplineStrokes> filter;
  filter->SetMaximumDeviation(1e-6);
  CHECK(Run(filter, { { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 }, { 4, 8, 12 } }).size() == 2);
}

void TestBadChains(double maximumDeviation)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const npr::Vector3 hole = { nan, 0, 0 };
  vtkNew<vtkNPRSplineStrokes> filter;
  filter->SetMaximumDeviation(maximumDeviation);
  for (int type :
    { vtkNPRSplineStrokes::NONE, vtkNPRSplineStrokes::CATMULL_ROM, vtkNPRSplineStrokes::B_SPLINE })
  {
    filter->SetSplineType(type);
    vtkNew<vtkPolyData> data;
    AddLine(data, { { 0, 0, 0 } });                                              // a point
    AddLine(data, { { 5, 5, 5 }, { 5, 5, 5 }, { 5, 5, 5 } });                    // one place
    AddLine(data, {});                                                           // nothing
    AddLine(data, { { 0, 0, 0 }, { 1, 0, 0 } });                                 // a segment
    AddLine(data, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } });                    // there and back
    AddLine(data, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, true);              // three, closed
    AddLine(data, { { 0, 0, 0 }, { 1, 0, 0 }, hole, { 2, 0, 0 }, { 3, 0, 0 } }); // two pieces
    AddLine(data, { hole, { 7, 0, 0 }, hole });                                  // no piece
    AddLine(data, { { 0, 1, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 1, 1, 0 }, { 2, 1, 0 } });
    vtkNew<vtkIntArray> kind;
    kind->SetName("Kind");
    vtkNew<vtkDoubleArray> x;
    x->SetName("X");
    vtkNew<vtkStringArray> label;
    label->SetName("Label");
    vtkNew<vtkDoubleArray> oldArcLength;
    oldArcLength->SetName(npr::names::ArcLength);
    for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    {
      kind->InsertNextValue(static_cast<int>(i));
    }
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      x->InsertNextValue(data->GetPoint(i)[0]);
      label->InsertNextValue("a");
      oldArcLength->InsertNextValue(-1);
    }
    data->GetCellData()->AddArray(kind);
    data->GetPointData()->AddArray(x);
    data->GetPointData()->AddArray(label);
    data->GetPointData()->AddArray(oldArcLength);
    filter->SetInputData(data);
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    CHECK(output->GetNumberOfLines() == 6);
    vtkDataArray* outKind = output->GetCellData()->GetArray("Kind");
    const int expected[] = { 3, 4, 5, 6, 6, 8 };
    for (int i = 0; i < 6 && outKind && outKind->GetNumberOfTuples() == 6; ++i)
    {
      CHECK(outKind->GetTuple1(i) == expected[i]);
    }
    CHECK(outKind && outKind->GetNumberOfTuples() == 6);
    CHECK(!output->GetPointData()->HasArray("Label"));
    vtkDataArray* outX = output->GetPointData()->GetArray("X");
    vtkDataArray* arc = output->GetPointData()->GetArray(npr::names::ArcLength);
    CHECK(outX && outX->GetNumberOfTuples() == output->GetNumberOfPoints());
    CHECK(
      arc && arc->GetNumberOfTuples() == output->GetNumberOfPoints() && arc->GetRange()[0] == 0);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      CHECK(std::isfinite(output->GetPoint(i)[0]) && std::isfinite(outX->GetTuple1(i)));
    }
  }

  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
}

void TestThreads()
{
  vtkNew<vtkPolyData> data;
  vtkMath::RandomSeed(7);
  for (int line = 0; line < 300; ++line)
  {
    Points points;
    for (int i = 0; i < 3 + line % 17; ++i)
    {
      points.push_back({ vtkMath::Random(), vtkMath::Random(), vtkMath::Random() });
    }
    AddLine(data, points, line % 3 == 0);
  }
  vtkNew<vtkNPRSplineStrokes> filter;
  filter->SetInputData(data);
  vtkNew<vtkPolyData> reference;
  for (int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    filter->Modified();
    filter->Update();
    if (threads == 1)
    {
      reference->DeepCopy(filter->GetOutput());
    }
  }
  vtkSMPTools::Initialize();
  vtkPolyData* output = filter->GetOutput();
  CHECK(output->GetNumberOfLines() == 300);
  CHECK(output->GetNumberOfPoints() == reference->GetNumberOfPoints());
  bool same = true;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double a[3], b[3];
    output->GetPoint(i, a);
    reference->GetPoint(i, b);
    same = same && a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
  }
  CHECK(same);
}
}

int TestSplineStrokes(int, char*[])
{
  TestDistanceFromChord();
  TestCatmullRomInterpolates();
  TestCatmullRomMakesNoLoops();
  TestCatmullRomStopsAtCorners();
  TestBSplineStaysInside();
  TestClosedHasNoSeam();
  TestCornersSurvive();
  TestBulge();
  TestResampling();
  TestSmoothing();
  TestSimplification();
  TestBadChains(0.0);
  TestBadChains(0.3);
  TestThreads();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
