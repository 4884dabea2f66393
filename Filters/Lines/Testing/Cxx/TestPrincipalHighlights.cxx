// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Principal highlights of a torus, where they have a closed form, and of waves against roots.
#include "nprSeenSurface.h"

#include "vtkNPRPrincipalHighlights.h"

using namespace nprtest;

namespace
{
// On a torus seen along its axis the direction of the tube is level with the eye on the uppermost
// circle, and on it alone.
void TestTorus(Checks& check)
{
  const Torus torus;
  vtkNew<vtkNPRPrincipalHighlights> highlights;
  highlights->SetThreshold(1.0);
  for (bool parallel : { true, false })
  {
    const auto camera = MakeCamera({ 0.0, 0.0, 5.0 }, parallel);
    // Uneven, so that no row of points lies on the line.
    const auto chains = Extract(torus.Make(120, 61), highlights, camera, 1.0);
    CheckSound(chains, check);
    if (check(chains.size() == 1 && chains[0].Closed, "one closed line", double(chains.size())))
    {
      for (const Vector& p : chains[0].Points)
      {
        // Where v is square to the tube, the line from the eye goes through the tube's middle.
        const double middle = parallel ? 0.0 : std::atan2(torus.R, 5.0);
        const double radius = torus.R - torus.r * std::sin(middle);
        check(std::abs(std::hypot(p[0], p[1]) - radius) < 2.0e-3, "it is the uppermost circle",
          std::hypot(p[0], p[1]) - radius);
      }
    }
    highlights->SetSide(-1.0);
    check(Extract(torus.Make(60, 31), highlights, camera, 1.0).empty(), "a torus has no fold");
    highlights->SetSide(1.0);
    check(Extract(torus.Make(60, 31), highlights, camera, 1.0).size() == 1, "it is a crest");
    highlights->SetSide(0.0);
  }
  highlights->SetThreshold(8.0);
  check(Extract(torus.Make(60, 31), highlights, MakeCamera({ 0.0, 0.0, 5.0 }), 1.0).empty(),
    "the threshold holds");
}

void TestWaves(const SeenSurface& seen, Checks& check)
{
  constexpr double threshold = 0.3;
  const std::array<double, 4> range = { -1.0, 1.0, -1.0, 1.2 };
  vtkNew<vtkNPRPrincipalHighlights> highlights;
  highlights->SetThreshold(threshold);
  // The sine of the way to the eye over the first principal direction, which is turned to `axis`.
  const auto getSine = [&](double u, double v, Vector& axis)
  {
    const Truth truth = seen.At(u, v);
    const Vector e1 = PrincipalTruth(truth).E1;
    axis = e1.dot(axis) < 0.0 ? Vector(-e1) : e1;
    return axis.dot(seen.ToEye(truth.Point));
  };
  const auto getTest = [&](double u, double v)
  {
    const PrincipalTruth principal(seen.At(u, v));
    return seen.Cosine(u, v) * (principal.K1 * principal.K1 - principal.K2 * principal.K2);
  };
  const auto roots = FindRoots(getSine, range, 15, 60);
  double lastError = 0.0;
  for (int n : { 40, 80, 160 })
  {
    const auto mesh = MakeSeenMesh(seen.At, range, n, n, n);
    const auto chains = Extract(mesh, highlights, MakeCamera(seen.Eye, seen.Parallel), 1.0);
    CheckSound(chains, check);
    const double h = 2.0 / n;
    double error = 0.0;
    for (const Chain& chain : chains)
    {
      for (const Vector& p : chain.Points)
      {
        Vector axis = Vector::UnitX();
        error = std::max(error, std::abs(getSine(p[0], p[1], axis)));
        check(getTest(p[0], p[1]) > threshold - 6.0 * h, "the test holds", getTest(p[0], p[1]));
      }
    }
    int found = 0;
    for (const Eigen::Vector2d& root : roots)
    {
      if (getTest(root[0], root[1]) > threshold + 6.0 * h)
      {
        ++found;
        error = std::max(error, GetDistance(chains, seen.At(root[0], root[1]).Point));
      }
    }
    check(found > 4, "there are roots", found);
    std::cout << "waves " << n << ": " << chains.size() << " chains, " << found << " roots, error "
              << error << "\n";
    check(
      lastError == 0.0 || error < 0.4 * lastError, "the error falls with h^2", error / lastError);
    lastError = error;
  }

  // Crests and folds are parts of all, which they make up together.
  const auto mesh = MakeSeenMesh(seen.At, range, 80, 80, 7);
  const auto camera = MakeCamera(seen.Eye, seen.Parallel);
  const auto all = GetSegments(Extract(mesh, highlights, camera, 1.0));
  std::vector<Segment> parts;
  for (double side : { 1.0, -1.0 })
  {
    highlights->SetSide(side);
    const auto chains = Extract(mesh, highlights, camera, 1.0);
    for (const Chain& chain : chains)
    {
      for (const Vector& p : chain.Points)
      {
        check(side * PrincipalTruth(seen.At(p[0], p[1])).K1 > 0.0, "the side holds", side);
      }
    }
    const auto segments = GetSegments(chains);
    parts.insert(parts.end(), segments.begin(), segments.end());
  }
  std::sort(parts.begin(), parts.end());
  check(parts == all, "crests and folds make up all", double(parts.size()));

  highlights->SetSide(0.0);
  CheckInvariance(seen, range, highlights, check);
  CheckStrangeEyes(seen, range, "principal-highlights", check);
}
}

int TestPrincipalHighlights(int, char*[])
{
  Checks check;
  TestTorus(check);
  TestWaves({ MakeWavesTruth, { 0.3, -0.4, 2.5 }, false }, check);
  TestWaves({ MakeWavesTruth, { 0.2, 0.1, 1.5 }, true }, check);
  return check.GetResult();
}
