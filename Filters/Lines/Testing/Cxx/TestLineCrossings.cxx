// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Where lines cross edges, by the cubic with the slopes at their ends; and where points say that
// they are from.
#include "nprHermite.h"
#include "nprLineTesting.h"

#include <vtkIdTypeArray.h>

using namespace nprtest;

namespace
{
void TestRoots(Checks& check)
{
  // (t - a)(t - b)(t - c) and its slopes at 0 and 1, of either sign.
  const double a = 0.2;
  const double b = 0.45;
  const double c = 0.9;
  const auto value = [&](double t) { return (t - a) * (t - b) * (t - c); };
  const auto slope = [&](double t)
  { return (t - b) * (t - c) + (t - a) * (t - c) + (t - a) * (t - b); };
  for (const double sign : { 1.0, -1.0 })
  {
    const auto find = [&](double guess)
    {
      return npr::FindHermiteRoot(
        sign * value(0.0), sign * value(1.0), sign * slope(0.0), sign * slope(1.0), guess);
    };
    for (const auto& [guess, root] : { std::pair(0.0, a), std::pair(0.3, a), std::pair(0.35, b),
           std::pair(0.6, b), std::pair(0.7, c), std::pair(1.0, c) })
    {
      check(std::abs(find(guess) - root) < 1.0e-8, "the root nearest to the guess", find(guess));
    }
  }
  check(
    std::abs(npr::FindHermiteRoot(-1.0, 3.0, 4.0, 4.0, 0.5) - 0.25) < 1.0e-8, "a straight line");
  // t^2 - 1/4
  check(std::abs(npr::FindHermiteRoot(-0.25, 0.75, 0.0, 2.0, 0.25) - 0.5) < 1.0e-8, "a parabola");
  const double infinity = std::numeric_limits<double>::infinity();
  check(npr::FindHermiteRoot(-1.0, 1.0, infinity, 0.0, 0.4) == 0.4, "slopes that are none");
}

//------------------------------------------------------------------------------
// How far the contours of a coarse torus are from where its surface really turns away: n.v with the
// normal of the torus beside each point.
double MeasureContours(int n, int interpolation, bool parallel)
{
  const Torus torus;
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition("contours");
  lines->SetInterpolation(interpolation);
  const Vector eye(2.0, 1.7, 2.4);
  lines->SetCamera(MakeCamera(eye, parallel));
  lines->SetInputData(torus.Make(2 * n, n));
  lines->Update();
  double sum = 0.0;
  std::size_t count = 0;
  for (const Chain& chain : GetChains(lines->GetOutput()))
  {
    for (const Vector& p : chain.Points)
    {
      const double u = std::atan2(p.y(), p.x());
      const double v = std::atan2(p.z(), std::hypot(p.x(), p.y()) - torus.R);
      const Vector direction = parallel ? eye : Vector(eye - torus.Point(u, v));
      sum += std::pow(torus.Normal(u, v).dot(direction.normalized()), 2);
      ++count;
    }
  }
  return std::sqrt(sum / static_cast<double>(count));
}

void TestContours(Checks& check)
{
  // Errors fall with the square of the edges by values alone, and faster by slopes.
  for (const bool parallel : { false, true })
  {
    double last = 0.0;
    for (const int n : { 24, 48, 96 })
    {
      const double linear = MeasureContours(n, vtkNPRFeatureLines::LINEAR, parallel);
      const double hermite = MeasureContours(n, vtkNPRFeatureLines::HERMITE, parallel);
      std::cout << n << ": linear " << linear << ", hermite " << hermite << "\n";
      check(hermite < 0.5 * linear, "slopes make contours better", hermite / linear);
      check(last == 0.0 || hermite < 0.2 * last, "and faster so on finer meshes", hermite / last);
      last = hermite;
    }
  }
}

//------------------------------------------------------------------------------
void TestSources(Checks& check)
{
  const auto surface = Torus().Make(60, 30);
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition("contours");
  lines->AddDefinition("contour-edges");
  lines->SetCamera(MakeCamera({ 2.0, 1.7, 2.4 }));
  lines->SetInputData(surface);
  lines->Update();
  check(!lines->GetOutput()->GetPointData()->HasArray(npr::names::SourceCell), "only if wanted");
  lines->OutputSourcesOn();
  lines->Update();
  vtkPolyData* const output = lines->GetOutput();
  vtkDataArray* const cells = output->GetPointData()->GetArray(npr::names::SourceCell);
  vtkDataArray* const edges = output->GetPointData()->GetArray(npr::names::SourceEdge);
  vtkDataArray* const lengths = output->GetPointData()->GetArray(npr::names::ArcLength);
  vtkDataArray* const distances = output->GetPointData()->GetArray(npr::names::ViewDistance);
  if (!check(cells && edges && lengths && distances, "points have their arrays"))
  {
    return;
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    surface->GetCellPoints(static_cast<vtkIdType>(cells->GetTuple1(i)), corners);
    Vector p, a, b;
    output->GetPoint(i, p.data());
    const auto from = static_cast<vtkIdType>(edges->GetComponent(i, 0));
    const auto to = static_cast<vtkIdType>(edges->GetComponent(i, 1));
    surface->GetPoint(from, a.data());
    surface->GetPoint(to, b.data());
    check(corners->IsId(from) >= 0 && corners->IsId(to) >= 0, "the edge is one of the cell");
    check(std::abs((p - a).norm() + (p - b).norm() - (b - a).norm()) < 1.0e-6,
      "the point is on its edge");
    check(std::abs(distances->GetTuple1(i) - (p - Vector(2.0, 1.7, 2.4)).norm()) < 1.0e-5,
      "the distance is that from the eye");
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < output->GetNumberOfLines(); ++cell)
  {
    output->GetLines()->GetCellAtId(cell, ids);
    double length = 0.0;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      Vector p, q;
      output->GetPoint(ids->GetId(i), p.data());
      output->GetPoint(ids->GetId(std::max<vtkIdType>(i - 1, 0)), q.data());
      length += (p - q).norm();
      const bool isRepeated = i > 0 && ids->GetId(i) == ids->GetId(0);
      check(isRepeated || std::abs(lengths->GetTuple1(ids->GetId(i)) - length) < 1.0e-5,
        "lengths add up along the chain");
    }
  }
}
}

//------------------------------------------------------------------------------
int TestLineCrossings(int, char*[])
{
  Checks check;
  TestRoots(check);
  TestContours(check);
  TestSources(check);
  return check.GetResult();
}
