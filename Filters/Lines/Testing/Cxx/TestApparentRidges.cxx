// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Apparent ridges of waves and an ellipsoid, against maxima of the view-dependent curvature that
// are found from the surface's normals alone.
#include "nprSeenSurface.h"

#include "vtkNPRApparentRidges.h"

using namespace nprtest;

namespace
{
// A point at which the surface is known to have a line, and what the test sees there.
struct Root
{
  Vector Point;
  double Curvature;
  double Cosine;
  double Sharpness;
};

// From the point where the derivative f would vanish, were it linear along its axis.
struct Slope
{
  double Value;
  double Fall;
};
Slope GetSlope(const SeenSurface& seen, double u, double v)
{
  Eigen::Vector2d step;
  seen.GetCurvature(u, v, step);
  Vector axis = seen.GetSteps(u, v).Point * step;
  const double h = 1.0e-3;
  Vector back = axis;
  Vector forth = axis;
  const double fall = (seen.GetDerivative(u - h * step[0], v - h * step[1], back) -
                        seen.GetDerivative(u + h * step[0], v + h * step[1], forth)) /
    (2.0 * h);
  return { seen.GetDerivative(u, v, axis), fall };
}

double GetSharpness(const SeenSurface& seen, double u, double v)
{
  Eigen::Vector2d step;
  const double curvature = seen.GetCurvature(u, v, step);
  const double perScreen = 1.0 / (seen.GetSteps(u, v).Screen * step).norm();
  return GetSlope(seen, u, v).Fall * perScreen * perScreen / (curvature * curvature * curvature);
}

struct Case
{
  SeenSurface Seen;
  std::array<double, 4> Range;
  std::function<Eigen::Vector2d(const Vector& p)> GetParameters;
  const char* Name;
};

void TestCase(const Case& test, Checks& check)
{
  constexpr double threshold = 0.8;
  constexpr double sharpness = 0.1;
  const SeenSurface& seen = test.Seen;
  vtkNew<vtkNPRApparentRidges> ridges;
  ridges->SetThreshold(threshold);
  ridges->SetSharpness(sharpness);

  std::vector<Root> roots;
  for (const Eigen::Vector2d& place :
    FindRoots([&](double u, double v, Vector&axis) { return seen.GetDerivative(u, v, axis); },
      test.Range, 15, 60))
  {
    roots.push_back({ seen.At(place[0], place[1]).Point, seen.GetCurvature(place[0], place[1]),
      seen.Cosine(place[0], place[1]), GetSharpness(seen, place[0], place[1]) });
  }

  double lastError = 0.0;
  for (int n : { 40, 80, 160 })
  {
    const auto mesh = MakeSeenMesh(seen.At, test.Range, n, n, n);
    const auto chains = Extract(mesh, ridges, MakeCamera(seen.Eye, seen.Parallel), 1.0);
    CheckSound(chains, check);
    const double h = (test.Range[1] - test.Range[0]) / n;

    // Nothing is there that should not be.
    double error = 0.0;
    for (const Chain& chain : chains)
    {
      for (const Vector& p : chain.Points)
      {
        const Eigen::Vector2d place = test.GetParameters(p);
        const Slope slope = GetSlope(seen, place[0], place[1]);
        const double distance =
          (seen.At(place[0], place[1]).Point - p).norm() + std::abs(slope.Value / slope.Fall);
        error = std::max(error, distance);
        const double slack = 6.0 * h;
        check(seen.Cosine(place[0], place[1]) > -slack, "the surface faces the eye",
          seen.Cosine(place[0], place[1]));
        check(seen.GetCurvature(place[0], place[1]) > threshold - slack,
          "it turns faster than the threshold", seen.GetCurvature(place[0], place[1]));
        check(GetSharpness(seen, place[0], place[1]) > sharpness - 2.0 * slack, "it is a maximum",
          GetSharpness(seen, place[0], place[1]));
      }
    }
    // Nothing is missing that should be there.
    int found = 0;
    for (const Root& root : roots)
    {
      if (root.Curvature > threshold + 3.0 * h && root.Cosine > 3.0 * h &&
        root.Sharpness > sharpness + 6.0 * h)
      {
        ++found;
        error = std::max(error, GetDistance(chains, root.Point));
      }
    }
    check(found > 4, test.Name, found);
    std::cout << test.Name << " " << n << ": " << chains.size() << " chains, " << found
              << " roots, error " << error << "\n";
    check(error < h, "lines are within a triangle", error / h);
    check(lastError == 0.0 || error < 0.55 * lastError, "the error falls at least with h",
      error / lastError);
    lastError = error;
  }
}
}

int TestApparentRidges(int, char*[])
{
  Checks check;
  const std::array<double, 4> square = { -1.0, 1.0, -1.0, 1.2 };
  const auto fromPlane = [](const Vector& p) { return Eigen::Vector2d(p[0], p[1]); };
  TestCase({ { MakeWavesTruth, { 1.0, -2.0, 2.5 }, false }, square, fromPlane, "waves" }, check);
  TestCase(
    { { MakeWavesTruth, { 2.0, 1.0, 1.5 }, true }, square, fromPlane, "waves, parallel" }, check);
  const Vector axes(1.5, 1.2, 0.4);
  const auto ellipsoid = [&](double u, double v)
  {
    return MakeEllipsoidTruth(
      axes, { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) });
  };
  const auto fromSphere = [&](const Vector& p) -> Eigen::Vector2d
  {
    const Vector direction = p.cwiseQuotient(axes).normalized();
    return { std::atan2(direction[1], direction[0]), std::asin(direction[2]) };
  };
  TestCase(
    { { ellipsoid, { 5.0, 2.0, 1.5 }, false }, { -1.0, 1.4, -0.8, 1.1 }, fromSphere, "ellipsoid" },
    check);

  vtkNew<vtkNPRApparentRidges> ridges;
  ridges->SetThreshold(0.5);
  const SeenSurface seen = { MakeWavesTruth, { 1.0, -2.0, 2.5 }, false };
  CheckInvariance(seen, square, ridges, check);
  CheckInvariance({ MakeWavesTruth, { 2.0, 1.0, 1.5 }, true }, square, ridges, check);
  CheckStrangeEyes(seen, square, "apparent-ridges", check);
  return check.GetResult();
}
