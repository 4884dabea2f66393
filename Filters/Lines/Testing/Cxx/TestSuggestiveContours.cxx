// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Suggestive contours and highlights of a torus against roots of the radial curvature, found from
// the closed form of the torus without any of the arrays that the lines are made from.
#include "nprLineTesting.h"

#include "vtkNPRSuggestiveContours.h"
#include "vtkNPRSuggestiveHighlights.h"

using namespace nprtest;

namespace
{
struct Truth
{
  Torus Shape;
  Vector Eye;
  bool Parallel;

  Vector ToEye(double u, double v) const
  {
    return (this->Parallel ? this->Eye : Vector(this->Eye - this->Shape.Point(u, v))).normalized();
  }
  double Cosine(double u, double v) const
  {
    return this->Shape.Normal(u, v).dot(this->ToEye(u, v));
  }
  double RadialCurvature(double u, double v) const
  {
    const double a = this->ToEye(u, v).dot(this->Shape.AlongU(u));
    const double b = this->ToEye(u, v).dot(this->Shape.AlongV(u, v));
    return (a * a * this->Shape.CurvatureU(v) + b * b / this->Shape.r) / (a * a + b * b);
  }
  // By differences along the surface towards the eye.
  double Derivative(double u, double v) const
  {
    const double a = this->ToEye(u, v).dot(this->Shape.AlongU(u));
    const double b = this->ToEye(u, v).dot(this->Shape.AlongV(u, v));
    const double w = std::hypot(a, b);
    const double du = a / w / (this->Shape.R + this->Shape.r * std::cos(v));
    const double dv = b / w / this->Shape.r;
    const double h = 1.0e-5;
    return (this->RadialCurvature(u + h * du, v + h * dv) -
             this->RadialCurvature(u - h * du, v - h * dv)) /
      (2.0 * h);
  }
};

// Roots of the radial curvature over v, for one u.
std::vector<double> FindRoots(const Truth& truth, double u)
{
  std::vector<double> roots;
  const int steps = 2000;
  for (int i = 0; i < steps; ++i)
  {
    double low = 2.0 * Pi * i / steps;
    double high = 2.0 * Pi * (i + 1) / steps;
    const bool sign = truth.RadialCurvature(u, low) > 0.0;
    if (sign == (truth.RadialCurvature(u, high) > 0.0))
    {
      continue;
    }
    for (int j = 0; j < 50; ++j)
    {
      const double middle = 0.5 * (low + high);
      (sign == (truth.RadialCurvature(u, middle) > 0.0) ? low : high) = middle;
    }
    roots.push_back(low);
  }
  return roots;
}

// `side` is 1 where the radial curvature is to rise towards the eye, -1 where it is to fall.
void TestTorus(vtkNPRSuggestiveContours* suggestive, double side, const Vector& eye, bool parallel,
  Checks& check)
{
  Truth truth;
  truth.Eye = eye;
  truth.Parallel = parallel;
  const double lengthScale = 1.0;
  const double threshold = 0.3;
  suggestive->SetThreshold(threshold);
  suggestive->SetMinimumAngle(10.0);
  suggestive->SetContourFade(0.2);
  vtkNew<vtkNPRFeatureLines> filter;
  filter->AddDefinition(suggestive);
  filter->SetLengthScale(lengthScale);
  filter->SetCamera(MakeCamera(eye, parallel));

  double lastError = 0.0;
  for (int n : { 60, 120, 240 })
  {
    filter->SetInputData(truth.Shape.Make(2 * n, n));
    filter->Update();
    const auto chains = GetChains(filter->GetOutput());
    CheckSound(chains, check);
    check(!chains.empty(), "there are suggestive contours");
    const double h = 2.0 * Pi * truth.Shape.r / n;

    // Nothing is there that should not be.
    double error = 0.0;
    for (const Chain& chain : chains)
    {
      for (std::size_t i = 0; i < chain.Points.size(); ++i)
      {
        const Vector& p = chain.Points[i];
        const double u = std::atan2(p[1], p[0]);
        const double v = std::atan2(p[2], std::hypot(p[0], p[1]) - truth.Shape.R);
        const double cosine = truth.Cosine(u, v);
        const double sine = std::sqrt(1.0 - cosine * cosine);
        error = std::max(error, std::abs(truth.RadialCurvature(u, v)) * sine * sine);
        const double slack = 20.0 * h * h;
        check(cosine > -slack && sine > std::sin(10.0 * Pi / 180.0) - slack,
          "the surface faces the eye", cosine);
        check(side * truth.Derivative(u, v) > threshold - 200.0 * slack,
          "the derivative is above the threshold", truth.Derivative(u, v));
        // An open chain ends where the test does, and fades out to there.
        if (!chain.Closed && (i == 0 || i + 1 == chain.Points.size()))
        {
          check(chain.Strength[i] < 1.0e-6, "ends have faded out", chain.Strength[i]);
        }
        if (i + 1 < chain.Points.size())
        {
          check(std::abs(chain.Strength[i] - chain.Strength[i + 1]) < 60.0 * h,
            "strength is continuous", chain.Strength[i] - chain.Strength[i + 1]);
        }
      }
    }
    if (lastError > 0.0)
    {
      check(error < 0.35 * lastError, "the radial curvature vanishes with h^2", error / lastError);
    }
    lastError = error;

    // Nothing is missing that should be there.
    int found = 0;
    for (int i = 0; i < 180; ++i)
    {
      const double u = 2.0 * Pi * (i + 0.37) / 180;
      for (double v : FindRoots(truth, u))
      {
        const double cosine = truth.Cosine(u, v);
        if (cosine > 0.05 && std::sqrt(1.0 - cosine * cosine) > 0.25 &&
          side * truth.Derivative(u, v) > threshold + 0.1)
        {
          ++found;
          const double distance = GetDistance(chains, truth.Shape.Point(u, v));
          check(distance < 8.0 * h * h, "each root is on a line", distance / (h * h));
        }
      }
    }
    check(found > 10, "there are roots to be found", found);
  }
}
}

int TestSuggestiveContours(int, char*[])
{
  Checks check;
  vtkNew<vtkNPRSuggestiveContours> contours;
  TestTorus(contours, 1.0, { 3.0, 1.0, 3.0 }, false, check);
  TestTorus(contours, 1.0, { 4.0, 1.0, 2.5 }, true, check);
  vtkNew<vtkNPRSuggestiveHighlights> highlights;
  TestTorus(highlights, -1.0, { 3.0, 1.0, 3.0 }, false, check);
  TestTorus(highlights, -1.0, { 4.0, 1.0, 2.5 }, true, check);
  return check.GetResult();
}
