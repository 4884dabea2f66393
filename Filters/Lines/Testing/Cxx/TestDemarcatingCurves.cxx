// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Demarcating curves: on the inflection of a step, on a wavy surface where brute force finds them,
// and never where the direction of the step jumps.
#include "nprTrueCurves.h"

#include "nprSteepestTurn.h"
#include "vtkNPRDemarcatingCurves.h"

#include <random>

using namespace nprtest;

namespace
{
// The components in the truth's frame of the unit vector whose cubic form is greatest, from all
// directions.
Eigen::Vector2d FindStep(const Truth& truth)
{
  const auto at = [&](double angle)
  {
    const Eigen::Vector2d x(std::cos(angle), std::sin(angle));
    return EvaluateCubic(truth, x, x, x);
  };
  double best = 0.0;
  for (int i = 1; i < 180; ++i)
  {
    best = at(2.0 * Pi * i / 180.0) > at(best) ? 2.0 * Pi * i / 180.0 : best;
  }
  for (double width = 2.0 * Pi / 180.0; width > 1.0e-10; width *= 0.5)
  {
    best = at(best - width) > at(best) ? best - width
      : at(best + width) > at(best)    ? best + width
                                       : best;
  }
  return { std::cos(best), std::sin(best) };
}

double GetAcross(const Truth& truth)
{
  const Eigen::Vector2d g = FindStep(truth);
  return truth.Form[0] * g[0] * g[0] + 2.0 * truth.Form[1] * g[0] * g[1] +
    truth.Form[2] * g[1] * g[1];
}

double GetSteepness(const Truth& truth)
{
  const Eigen::Vector2d g = FindStep(truth);
  return EvaluateCubic(truth, g, g, g);
}

// z = a tanh(x + y / 2 + wave y^2): its inflection is where the argument is 0, if it is straight.
ParametricSurface Step(double wave)
{
  const auto at = [=](double x, double y)
  {
    const double t = std::tanh(x + 0.5 * y + wave * y * y);
    const double a = 0.6;
    // The derivatives by the argument, and those of the argument by y.
    const double d1 = a * (1.0 - t * t);
    const double d2 = -2.0 * t * d1;
    const double d3 = -2.0 * d1 * (1.0 - t * t) - 2.0 * t * d2;
    const double s = 0.5 + 2.0 * wave * y;
    const double c = 2.0 * wave;
    return MakeHeightTruth(x, y,
      { a * t, { d1, d1 * s }, { d2, d2 * s, d2 * s * s + d1 * c },
        { d3, d3 * s, d3 * s * s + d2 * c, d3 * s * s * s + 3.0 * d2 * s * c } });
  };
  return { at, { -1.6, 1.6, -1.6, 1.6 } };
}

// A saddle for three and one for two: the three directions of the first are as steep as one another
// near the middle, and the second bends up along one of them and down along the others.
ParametricSurface Saddles()
{
  const auto at = [](double x, double y)
  {
    return MakeHeightTruth(x, y,
      { x * x * x - 3 * x * y * y + 2 * (x * x - y * y),
        { 3 * (x * x - y * y) + 4 * x, -6 * x * y - 4 * y }, { 6 * x + 4, -6 * y, -6 * x - 4 },
        { 6, 0, -6, 0 } });
  };
  return { at, { -0.12, 0.12, -0.11, 0.13 } };
}

void TestSteepestTurn(Checks& check)
{
  std::mt19937 random(5);
  const auto number = [&] { return random() / 2147483648.0 - 1.0; };
  for (int i = 0; i < 3000; ++i)
  {
    Truth truth;
    truth.Cubic = { number(), number(), number(), number() };
    if (i % 3 == 1)
    {
      truth.Cubic = { 1.0, 1.0e-9 * number(), -1.0 + 1.0e-6 * number(), 1.0e-9 * number() };
    }
    if (i % 3 == 2)
    {
      const double a = number();
      const double b = number();
      truth.Cubic = { a, b / 3.0, a / 3.0, b }; // only the slow part
    }
    double value = 0.0;
    const double angle =
      npr::FindSteepestTurn(truth.Cubic[0], truth.Cubic[1], truth.Cubic[2], truth.Cubic[3], value);
    const Eigen::Vector2d g(std::cos(angle), std::sin(angle));
    const double size = truth.Cubic.norm();
    check(std::abs(EvaluateCubic(truth, g, g, g) - value) < 1.0e-12 * size, "the value is C there");
    check(value > GetSteepness(truth) - 1.0e-12 * size, "no direction is steeper",
      GetSteepness(truth) - value);
  }
  double value = 1.0;
  const double angle = npr::FindSteepestTurn(0.0, 0.0, 0.0, 0.0, value);
  check(std::isfinite(angle) && value == 0.0, "nothing turns on a sphere", angle);
}

void TestStep(Checks& check)
{
  vtkNew<vtkNPRDemarcatingCurves> definition;
  definition->SetThreshold(0.2);
  const AnalyticSurface step = MakeSurface(Step(0.0), 60, 60, { 0.25, 7 });
  AddExactArrays(step);
  const auto chains = ExtractLines(step.Mesh, definition);
  check(chains.size() == 1 && !chains[0].Closed, "one curve", double(chains.size()));
  for (const Chain& chain : chains)
  {
    check(GetLength(chain) > 3.2 * std::sqrt(1.25) - 1.0e-2, "from side to side", GetLength(chain));
    for (const Vector& p : chain.Points)
    {
      check(std::abs(p[0] + 0.5 * p[1]) < 1.0e-3, "on the inflection", p[0] + 0.5 * p[1]);
    }
  }
  // At the inflection the steepness is that of the second derivative along the slope, turned into
  // curvature: f''' / (1 + f'^2)^2 with the derivatives across the step.
  const double scale = std::sqrt(1.25);
  const double slope = 0.6 * scale;
  const double steepness = 1.2 * scale * scale * scale / std::pow(1.0 + slope * slope, 2.0);
  definition->SetThreshold(0.97 * steepness);
  check(ExtractLines(step.Mesh, definition).size() == 1, "steep enough");
  definition->SetThreshold(1.03 * steepness);
  check(ExtractLines(step.Mesh, definition).empty(), "not steep enough");
}

void TestJump(Checks& check)
{
  vtkNew<vtkNPRDemarcatingCurves> definition;
  definition->SetThreshold(0.0);
  const TrueCurve curve = { Saddles(), GetAcross };
  const AnalyticSurface surface = MakeSurface(curve.Surface, 60, 60, { 0.25, 7 });
  AddExactArrays(surface);
  int jumps = 0;
  for (int i = 0; i < 60; ++i)
  {
    const Truth& here = surface.Truths[30 * 61 + i];
    const Truth& next = surface.Truths[30 * 61 + i + 1];
    jumps += GetAcross(here) * GetAcross(next) < 0.0 &&
      std::min(std::abs(GetAcross(here)), std::abs(GetAcross(next))) > 0.5;
  }
  check(jumps > 0, "the surface has a jump from one sign to the other", jumps);
  for (const Chain& chain : ExtractLines(surface.Mesh, definition))
  {
    for (const Vector3d& p : chain.Points)
    {
      check(std::abs(curve.At(p[0], p[1])) < 0.1, "no line at a jump", curve.At(p[0], p[1]));
    }
  }
}
}

int TestDemarcatingCurves(int, char*[])
{
  Checks check;
  TestSteepestTurn(check);
  TestStep(check);
  TestJump(check);
  vtkNew<vtkNPRDemarcatingCurves> definition;
  definition->SetThreshold(0.1);
  CheckConvergence(definition, { Step(0.08), GetAcross }, 1, check);
  definition->SetThreshold(0.3);
  CheckInvariance(definition, Step(0.08), check);
  for (const ParametricSurface& shape : { SpherePatch(1.0), Cylinder(1.0, 3.0) })
  {
    const AnalyticSurface surface = MakeSurface(shape, 40, 40);
    AddExactArrays(surface);
    check(ExtractLines(surface.Mesh, definition).empty(), "none where no curvature changes");
  }
  return check.GetResult();
}
