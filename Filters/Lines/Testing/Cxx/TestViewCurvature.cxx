// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The closed form of the view-dependent curvature and of its derivative, against differences of the
// normals of known surfaces as they are seen.
#include "nprSeenSurface.h"

#include "nprViewCurvature.h"

using namespace nprtest;

namespace
{
npr::SeenPoint<float> GetSeenPoint(const Truth& truth, const Vector& toEye, double way)
{
  const PrincipalTruth principal(truth, way);
  const auto convert = [](const Vector& v) -> npr::Vector3<float> {
    return { static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]) };
  };
  return { convert(toEye), convert(truth.Normal), convert(principal.E1),
    static_cast<float>(principal.K1), static_cast<float>(principal.K2),
    static_cast<float>(principal.Cubic[0]), static_cast<float>(principal.Cubic[1]),
    static_cast<float>(principal.Cubic[2]), static_cast<float>(principal.Cubic[3]) };
}

int TestSurface(const SeenSurface& seen, const std::array<double, 4>& range, Checks& check)
{
  int compared = 0;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(5);
  const auto draw = [&](double low, double high)
  {
    random->Next();
    return random->GetRangeValue(low, high);
  };
  for (int i = 0; i < 300; ++i)
  {
    const double u = draw(range[0], range[1]);
    const double v = draw(range[2], range[3]);
    const Truth truth = seen.At(u, v);
    const double cosine = seen.Cosine(u, v);
    if (cosine < 0.15)
    {
      continue;
    }
    ++compared;
    const Vector toEye = seen.Parallel ? seen.Eye : Vector(seen.Eye - truth.Point);
    const auto found = npr::GetViewCurvature(
      GetSeenPoint(truth, toEye, draw(-1.0, 1.0) < 0.0 ? -1.0 : 1.0), seen.Parallel ? 0.0f : 1.0f);
    const Vector axis(found.Axis.X, found.Axis.Y, found.Axis.Z);
    check(std::abs(found.Cosine - cosine) < 1.0e-5, "cosine", found.Cosine - cosine);
    const double curvature = cosine * seen.GetCurvature(u, v);
    check(std::abs(found.Curvature - curvature) < 1.0e-5 * (1.0 + curvature),
      "view-dependent curvature", found.Curvature - curvature);
    check(std::abs(axis.norm() - 1.0) < 1.0e-5, "the axis is a unit vector", axis.norm());
    Vector trueAxis = axis;
    const double derivative = cosine * cosine * seen.GetDerivative(u, v, trueAxis);
    check(axis.dot(trueAxis) > 0.999, "axis", axis.dot(trueAxis));
    check(std::abs(found.Derivative - derivative) < 2.0e-3 * (1.0 + std::abs(derivative)),
      "derivative of view-dependent curvature", found.Derivative - derivative);
    const Vector eye = seen.ToEye(truth.Point);
    const double seenLength = (trueAxis - trueAxis.dot(eye) * eye).norm();
    check(std::abs(found.Stretch * seenLength - cosine) < 1.0e-3, "stretch",
      found.Stretch * seenLength - cosine);
  }
  return compared;
}

// At the contour, on planes, at the eye and behind: finite.
void TestLimits(Checks& check)
{
  const auto isFinite = [](const npr::ViewCurvature<float>& found)
  {
    return std::isfinite(found.Derivative) && std::isfinite(found.Curvature) &&
      std::isfinite(found.Stretch) && std::isfinite(found.Axis.X) && std::isfinite(found.Axis.Y) &&
      std::isfinite(found.Axis.Z);
  };
  const npr::SeenPoint<float> plain = { { 0, 0, 1 }, { 0, 0, 1 }, { 1, 0, 0 }, 2, 1, 1, 1, 1, 1 };
  for (const npr::Vector3<float>& toEye : { npr::Vector3<float>{ 0, 0, 0 },
         npr::Vector3<float>{ 0, 0, 1 }, npr::Vector3<float>{ 0, 0, -1 },
         npr::Vector3<float>{ 1, 0, 0 }, npr::Vector3<float>{ 0, 1, 0 },
         npr::Vector3<float>{ 1e-12f, 0, 1e-12f }, npr::Vector3<float>{ 1e12f, 0, 1e12f } })
  {
    for (float curvature : { 0.0f, 1.0e-9f, 1.0f, 1.0e5f })
    {
      for (float perspective : { 0.0f, 1.0f })
      {
        npr::SeenPoint<float> point = plain;
        point.ToEye = toEye;
        point.Curvature1 *= curvature;
        point.Curvature2 *= curvature;
        check(isFinite(npr::GetViewCurvature(point, perspective)), "finite", curvature);
        point.Curvature2 = point.Curvature1;
        check(isFinite(npr::GetViewCurvature(point, perspective)), "finite at umbilics", curvature);
        point.Curvature2 = -point.Curvature1;
        check(isFinite(npr::GetViewCurvature(point, perspective)), "finite on saddles", curvature);
      }
    }
  }
  // At the contour the axis is the direction to the eye, and the curvature is that along it.
  npr::SeenPoint<float> edge = plain;
  edge.ToEye = { 0, 1, 0 };
  const auto found = npr::GetViewCurvature(edge, 0.0f);
  check(std::abs(std::abs(found.Axis.Y) - 1.0f) < 1.0e-6f, "axis at the contour", found.Axis.Y);
  check(std::abs(found.Curvature - 1.0f) < 1.0e-6f, "curvature at the contour", found.Curvature);
}
}

int TestViewCurvature(int, char*[])
{
  Checks check;
  const Vector axes(1.5, 1.0, 0.6);
  const auto ellipsoid = [&](double u, double v)
  {
    return MakeEllipsoidTruth(
      axes, { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) });
  };
  int compared = 0;
  for (bool parallel : { false, true })
  {
    for (const Vector& eye : { Vector(2.0, 1.5, 2.5), Vector(0.4, -0.3, 1.2) })
    {
      compared += TestSurface({ MakeWavesTruth, eye, parallel }, { -1.0, 1.0, -1.0, 1.2 }, check);
      compared += TestSurface({ ellipsoid, eye, parallel }, { 0.1, 1.4, -0.3, 1.2 }, check);
    }
  }
  check(compared > 600, "there is something to compare", compared);
  TestLimits(check);
  return check.GetResult();
}
