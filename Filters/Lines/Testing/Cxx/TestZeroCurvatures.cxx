// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Parabolic lines and lines of zero mean curvature: on surfaces where they are known, and nowhere
// on flat, round and cylindrical ones, also where their curvature is noisy.
#include "nprTrueCurves.h"

#include "vtkNPRParabolicLines.h"
#include "vtkNPRZeroMeanCurvature.h"

#include <random>

using namespace nprtest;

namespace
{
double GetGaussian(const Truth& truth)
{
  return truth.Form[0] * truth.Form[2] - truth.Form[1] * truth.Form[1];
}

double GetMean(const Truth& truth)
{
  return 0.5 * (truth.Form[0] + truth.Form[2]);
}

// A part of the domain as flat as a table.
ParametricSurface Plane()
{
  const auto at = [](double x, double y) {
    return MakeHeightTruth(x, y, { 0.3 * x, { 0.3, 0.0 }, { 0, 0, 0 }, { 0, 0, 0, 0 } });
  };
  return { at, { -1.0, 1.0, -1.0, 1.0 } };
}

void TestNoise(
  vtkNPRLineDefinition* definition, const ParametricSurface& shape, const char* name, Checks& check)
{
  for (const double noise : { 0.0, 1.0e-7, 1.0e-3 })
  {
    AnalyticSurface surface = MakeSurface(shape, 50, 50);
    std::mt19937 random(3);
    for (Truth& truth : surface.Truths)
    {
      for (int i = 0; i < 3; ++i)
      {
        truth.Form[i] += noise * (random() / 2147483648.0 - 1.0);
      }
    }
    AddExactArrays(surface);
    check(ExtractLines(surface.Mesh, definition, 0.0).empty(),
      std::string(definition->GetName()) + ": none on a " + name, noise);
  }
}
}

int TestZeroCurvatures(int, char*[])
{
  Checks check;
  vtkNew<vtkNPRParabolicLines> parabolic;
  vtkNew<vtkNPRZeroMeanCurvature> mean;
  for (vtkNPRLineDefinition* definition :
    { static_cast<vtkNPRLineDefinition*>(parabolic), static_cast<vtkNPRLineDefinition*>(mean) })
  {
    TestNoise(definition, Plane(), "plane", check);
    TestNoise(definition, SpherePatch(1.0), "sphere", check);
    TestNoise(definition, Cylinder(1.0, 3.0), "cylinder", check);
  }

  parabolic->SetThreshold(0.0);
  mean->SetThreshold(0.0);
  for (const auto& chain : ExtractLines(
         []
         {
           const AnalyticSurface bump = MakeSurface(Bump(1.2), 60, 60);
           AddExactArrays(bump);
           return bump.Mesh;
         }(),
         parabolic))
  {
    check(chain.Closed, "a bump's parabolic line goes round it");
    for (const Vector3d& p : chain.Points)
    {
      check(std::abs(std::hypot(p[0], p[1]) - 1.0) < 5.0e-3, "where its slope is greatest",
        std::hypot(p[0], p[1]));
    }
  }
  CheckConvergence(parabolic, { Bump(1.2), GetGaussian }, 1, check);
  CheckConvergence(mean, { Bump(1.2), GetMean }, 1, check);

  parabolic->SetThreshold(0.5);
  mean->SetThreshold(0.2);
  CheckInvariance(parabolic, Bump(1.2), check);
  CheckInvariance(mean, Bump(1.2), check);

  // The threshold is that of the gradient's length: at r = 1 of the flatter bump it is known. There
  // f' = -f, f'' = 0 and f''' = 2 f with f = h exp(-1/2); K = f' f'' / (r (1 + f'^2)^2).
  const double f = 0.5 * std::exp(-0.5);
  const double gradient = 2.0 * f * f / std::pow(1.0 + f * f, 2.5);
  const AnalyticSurface bump = MakeSurface(Bump(0.5), 120, 120);
  AddExactArrays(bump);
  parabolic->SetThreshold(0.97 * gradient);
  check(ExtractLines(bump.Mesh, parabolic).size() == 1, "a steep enough crossing is a line");
  parabolic->SetThreshold(1.03 * gradient);
  check(ExtractLines(bump.Mesh, parabolic).empty(), "one that is not is none");
  // The other curvature there is f / (1 + f'^2)^(1/2).
  parabolic->SetThreshold(0.0);
  const double steepness = 2.0 / (f * (1.0 + f * f));
  parabolic->SetSteepness(0.9 * steepness);
  check(ExtractLines(bump.Mesh, parabolic).size() == 1, "where the bend is slight enough, a line");
  parabolic->SetSteepness(1.1 * steepness);
  check(ExtractLines(bump.Mesh, parabolic).empty(), "on a stronger bend none");
  return check.GetResult();
}
