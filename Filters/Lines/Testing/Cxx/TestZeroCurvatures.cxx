// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Parabolic lines and lines of zero mean curvature: on surfaces where they are known, and nowhere
// on flat, round and cylindrical ones, also where their curvature is noisy; and on bumpy ones those
// of the shape, not those around its bumps.
#include "nprTrueCurves.h"

#include "vtkNPRParabolicLines.h"
#include "vtkNPRZeroMeanCurvature.h"

#include <vtkMath.h>
#include <vtkSmartPointer.h>

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

namespace
{
// By their own thresholds.
std::vector<Chain> ExtractByDefault(vtkPolyData* surface, const char* name)
{
  const auto definition = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(name));
  return ExtractLines(surface, definition, 0.0);
}

// The radius of a torus is 1; of its tube r. K is 0 along the circles at its top and its bottom, H
// where 1 + 2 r cos v is 0.
void TestTorus(Checks& check)
{
  for (const double r : { 0.7, 0.4, 0.1, 0.03 })
  {
    AnalyticSurface torus = MakeTorus(1.0, r, r < 0.1 ? 400 : 200, 40);
    AddExactArrays(torus);
    const auto chains = ExtractByDefault(torus.Mesh, "parabolic");
    check(chains.size() == 2, "the two circles of every torus, however slender", r);
    for (const Chain& chain : chains)
    {
      check(chain.Closed, "all around", r);
      for (const Vector3d& p : chain.Points)
      {
        // Smoothing moves them by less than a fifth of its own width.
        check(std::abs(std::hypot(p[0], p[1]) - 1.0) < 0.2 * 0.05, "where they belong",
          std::hypot(p[0], p[1]) - 1.0);
      }
    }
  }
  AnalyticSurface torus = MakeTorus(1.0, 0.7, 200, 80);
  AddExactArrays(torus);
  const auto chains = ExtractByDefault(torus.Mesh, "mean-curvature");
  check(chains.size() == 2, "two circles of zero mean curvature", double(chains.size()));
  for (const Chain& chain : chains)
  {
    for (const Vector3d& p : chain.Points)
    {
      check(std::abs(std::hypot(p[0], p[1]) - 0.5) < 0.01, "where they belong",
        std::hypot(p[0], p[1]) - 0.5);
    }
  }
}

// A scan of a torus, with bumps much smaller than it.
void TestBumps(Checks& check)
{
  AnalyticSurface torus = MakeTorus(1.0, 0.4, 300, 120);
  for (std::size_t i = 0; i < torus.Truths.size(); ++i)
  {
    const Vector3d& p = torus.Truths[i].Point;
    const double bump =
      0.0015 * (std::sin(45.0 * p[0]) + std::sin(45.0 * p[1]) + std::sin(45.0 * p[2] + 1.0));
    torus.Mesh->GetPoints()->SetPoint(
      static_cast<vtkIdType>(i), Vector3d(p + bump * torus.Truths[i].Normal).data());
  }
  const auto surface = EstimateArrays(torus);
  const auto chains = ExtractByDefault(surface, "parabolic");
  check(chains.size() == 2, "the circles of a torus with bumps", double(chains.size()));
  for (const Chain& chain : chains)
  {
    for (const Vector3d& p : chain.Points)
    {
      check(std::abs(std::hypot(p[0], p[1]) - 1.0) < 0.15, "about where they belong",
        std::hypot(p[0], p[1]) - 1.0);
    }
  }
  check(ExtractByDefault(surface, "mean-curvature").empty(), "and no line around a bump");
  vtkNew<vtkNPRParabolicLines> all;
  all->SetSmoothing(0.0);
  const auto large = ExtractLines(surface, all, 0.0).size();
  all->SetRegion(0.0);
  const auto every = ExtractLines(surface, all, 0.0).size();
  check(every > 100 && large < every / 4, "slight regions alone are many", double(large));
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

  TestTorus(check);
  TestBumps(check);

  for (vtkNPRZeroCurvatureLines* definition : { static_cast<vtkNPRZeroCurvatureLines*>(parabolic),
         static_cast<vtkNPRZeroCurvatureLines*>(mean) })
  {
    definition->SetThreshold(0.0);
    definition->SetSmoothing(0.0);
    definition->SetRegion(0.0);
  }
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
  parabolic->SetThreshold(0.0);
  // The solid angle of the normals, from the top of the bump to its steepest slope; what is beyond
  // has nearly as much.
  const double region = 2.0 * vtkMath::Pi() * (1.0 - 1.0 / std::sqrt(1.0 + f * f));
  parabolic->SetRegion(0.85 * region);
  check(ExtractLines(bump.Mesh, parabolic).size() == 1, "round a bump that bends enough, a line");
  parabolic->SetRegion(1.03 * region);
  check(ExtractLines(bump.Mesh, parabolic).empty(), "round one that does not, none");
  return check.GetResult();
}
