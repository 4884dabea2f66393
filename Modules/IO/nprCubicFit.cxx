// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCubicFit.h"

#include "nprChainTangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace npr
{
namespace
{
using Cubic = std::array<PagePoint, 4>; // control points

/// The same curve as a polynomial: coefficients of powers of t.
Cubic ToPowers(const Cubic& c)
{
  return { { c[0], 3.0 * (c[1] - c[0]), 3.0 * (c[2] - 2.0 * c[1] + c[0]),
    c[3] - 3.0 * c[2] + 3.0 * c[1] - c[0] } };
}

PagePoint Evaluate(const Cubic& powers, double t)
{
  return powers[0] + t * (powers[1] + t * (powers[2] + t * powers[3]));
}

class SectionFit
{
public:
  SectionFit(const std::vector<PagePoint>& points, const FitSettings& settings, PagePath& path)
    : Points(points), Settings(settings), Path(path), Lengths(points.size(), 0.0),
      Parameters(points.size(), 0.0)
  {
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      this->Lengths[i] = this->Lengths[i - 1] + (points[i] - points[i - 1]).norm();
    }
  }

  PagePoint GetTangent(std::size_t i) const
  {
    const auto point = [this](std::ptrdiff_t k) -> const PagePoint& { return this->Points[k]; };
    const auto last = static_cast<std::ptrdiff_t>(this->Points.size()) - 1;
    return ChainTangents(point, 0, last, this->Settings.Tolerance)
      .Get(static_cast<std::ptrdiff_t>(i));
  }

  void Fit(std::size_t first, std::size_t last, const PagePoint& start, const PagePoint& end)
  {
    const std::size_t n = last - first + 1;
    if (n == 2)
    {
      const double third = (this->Points[last] - this->Points[first]).norm() / 3.0;
      this->Add(this->MakeCubic(first, last, start, end, third, third));
      return;
    }
    const double tolerance = this->Settings.Tolerance * this->Settings.Tolerance;
    const double length = this->Lengths[last] - this->Lengths[first];
    for (std::size_t i = first; i <= last; ++i)
    {
      this->Parameters[i] = (this->Lengths[i] - this->Lengths[first]) / length;
    }
    std::size_t worst = first + n / 2;
    // A long section is first looked at in steps: most can't be one curve, and that shows.
    const std::size_t step = n > 4 * StepsToLook ? n / StepsToLook : 1;
    double error = 0.0;
    if (step > 1)
    {
      const Cubic curve = this->Approximate(first, last, start, end, step);
      error = this->GetError(curve, first, last, step, worst);
    }
    if (error <= 4.0 * tolerance)
    {
      Cubic curve = this->Approximate(first, last, start, end, 1);
      error = this->GetError(curve, first, last, 1, worst);
      for (int i = 0; i < Improvements && error > tolerance && error < 25.0 * tolerance; ++i)
      {
        this->Improve(curve, first, last);
        curve = this->Approximate(first, last, start, end, 1);
        error = this->GetError(curve, first, last, 1, worst);
      }
      if (error <= tolerance)
      {
        this->Add(curve);
        return;
      }
    }
    // Neither part may be so short that the sections' number or the depth of calls gets out of
    // hand.
    const std::size_t least = std::max<std::size_t>(1, n / 8);
    const std::size_t middle = std::clamp(worst, first + least, last - least);
    const PagePoint tangent = this->GetTangent(middle);
    this->Fit(first, middle, start, tangent);
    this->Fit(middle, last, tangent, end);
  }

private:
  static constexpr std::size_t StepsToLook = 24;
  static constexpr int Improvements = 3;

  void Add(const Cubic& curve) { this->Path.CurveTo(curve[1], curve[2], curve[3]); }

  Cubic MakeCubic(std::size_t first, std::size_t last, const PagePoint& start, const PagePoint& end,
    double alpha, double beta) const
  {
    return { { this->Points[first], this->Points[first] + alpha * start,
      this->Points[last] - beta * end, this->Points[last] } };
  }

  /// Least squares for the lengths of both handles.
  Cubic Approximate(std::size_t first, std::size_t last, const PagePoint& start,
    const PagePoint& end, std::size_t step) const
  {
    const PagePoint& p0 = this->Points[first];
    const PagePoint& p3 = this->Points[last];
    double c11 = 0.0;
    double c12 = 0.0;
    double c22 = 0.0;
    double x1 = 0.0;
    double x2 = 0.0;
    for (std::size_t i = first + step; i < last; i += step)
    {
      const double u = this->Parameters[i];
      const double v = 1.0 - u;
      const double b1 = 3.0 * u * v * v;
      const double b2 = 3.0 * u * u * v;
      const double b0 = v * v * v + b1;
      const PagePoint rest = this->Points[i] - b0 * p0 - (1.0 - b0) * p3;
      c11 += b1 * b1;
      c12 -= b1 * b2;
      c22 += b2 * b2;
      x1 += b1 * start.dot(rest);
      x2 -= b2 * end.dot(rest);
    }
    c12 *= start.dot(end);
    const double determinant = c11 * c22 - c12 * c12;
    const double third = (p3 - p0).norm() / 3.0;
    const double length = this->Lengths[last] - this->Lengths[first];
    double alpha = third;
    double beta = third;
    if (determinant > 1e-12 * c11 * c22)
    {
      const double solved1 = (x1 * c22 - x2 * c12) / determinant;
      const double solved2 = (x2 * c11 - x1 * c12) / determinant;
      const double least = 1e-3 * length;
      // Handles that point backwards, or beyond the whole way, make loops.
      if (solved1 > least && solved2 > least && solved1 < length && solved2 < length)
      {
        alpha = solved1;
        beta = solved2;
      }
    }
    return this->MakeCubic(first, last, start, end, alpha, beta);
  }

  /// The largest squared distance, and where it is. Between points that are far apart the curve
  /// must not leave the piece there by much more than an arc would.
  double GetError(const Cubic& curve, std::size_t first, std::size_t last, std::size_t step,
    std::size_t& worst) const
  {
    const Cubic powers = ToPowers(curve);
    const double tolerance = this->Settings.Tolerance * this->Settings.Tolerance;
    const double longPiece = 8.0 * this->Settings.Tolerance;
    double most = 0.0;
    for (std::size_t i = first + step; i <= last; i += step)
    {
      double error = (Evaluate(powers, this->Parameters[i]) - this->Points[i]).squaredNorm();
      if (step == 1 && this->Lengths[i] - this->Lengths[i - 1] > longPiece)
      {
        const PagePoint middle =
          Evaluate(powers, 0.5 * (this->Parameters[i - 1] + this->Parameters[i]));
        const PagePoint piece = this->Points[i] - this->Points[i - 1];
        const PagePoint off = middle - this->Points[i - 1];
        const double across = std::abs(piece.x() * off.y() - piece.y() * off.x());
        const double bend = 1.5 * this->GetBend(i - 1) + this->Settings.Tolerance;
        error = std::max(error, across * across / piece.squaredNorm() * tolerance / (bend * bend));
      }
      if (error > most && i < last)
      {
        most = error;
        worst = i;
      }
      else if (error > most)
      {
        most = error;
        worst = i - step;
      }
    }
    worst = std::clamp(worst, first + 1, last - 1);
    return most;
  }

  /// How far an arc that turns as the points do leaves the piece from a point to the next.
  double GetBend(std::size_t i) const
  {
    const auto getTurn = [this](std::size_t k)
    {
      if (k == 0 || k + 1 == this->Points.size())
      {
        return 0.0;
      }
      const PagePoint in = this->Points[k] - this->Points[k - 1];
      const PagePoint out = this->Points[k + 1] - this->Points[k];
      return std::atan2(std::abs(in.x() * out.y() - in.y() * out.x()), in.dot(out));
    };
    const double turn = std::max(getTurn(i), getTurn(i + 1));
    return (this->Lengths[i + 1] - this->Lengths[i]) * turn / 8;
  }

  /// A step of Newton's method for where on the curve each point is nearest.
  void Improve(const Cubic& curve, std::size_t first, std::size_t last)
  {
    const Cubic p = ToPowers(curve);
    for (std::size_t i = first + 1; i < last; ++i)
    {
      const double t = this->Parameters[i];
      const PagePoint off = Evaluate(p, t) - this->Points[i];
      const PagePoint speed = p[1] + t * (2.0 * p[2] + 3.0 * t * p[3]);
      const PagePoint change = 2.0 * p[2] + 6.0 * t * p[3];
      const double slope = speed.squaredNorm() + off.dot(change);
      const double moved = slope > 0.0 ? t - off.dot(speed) / slope : t;
      this->Parameters[i] = std::clamp(moved, this->Parameters[i - 1], 1.0);
    }
  }

  const std::vector<PagePoint>& Points;
  const FitSettings& Settings;
  PagePath& Path;
  std::vector<double> Lengths;
  std::vector<double> Parameters;
};

/// Whether all points are as good as on the straight way from the first to the last, in order.
bool IsStraight(const std::vector<PagePoint>& points, double distance)
{
  const PagePoint chord = points.back() - points.front();
  const double length = chord.norm();
  double last = 0.0;
  for (const PagePoint& point : points)
  {
    const PagePoint off = point - points.front();
    const double along = off.dot(chord);
    if (std::abs(off.x() * chord.y() - off.y() * chord.x()) > distance * length || along < last)
    {
      return false;
    }
    last = along;
  }
  return length > 0.0;
}

/// Of an arc between two points that has a tangent at one of them: that at the other.
PagePoint Mirror(const PagePoint& tangent, const PagePoint& from, const PagePoint& to)
{
  const PagePoint chord = (to - from).normalized();
  return 2.0 * chord.dot(tangent) * chord - tangent;
}
}

//------------------------------------------------------------------------------
void FitSection(const std::vector<PagePoint>& points, const GivenTangent& start,
  const GivenTangent& end, const FitSettings& settings, PagePath& path)
{
  const std::size_t last = points.size() - 1;
  if (!start && !end && (last == 1 || IsStraight(points, 0.1 * settings.Tolerance)))
  {
    path.LineTo(points.back());
    return;
  }
  SectionFit fit(points, settings, path);
  const PagePoint first = start ? *start
    : last == 1                 ? Mirror(*end, points[0], points[1])
                                : fit.GetTangent(0);
  const PagePoint final = end ? *end
    : last == 1               ? Mirror(*start, points[0], points[1])
                              : fit.GetTangent(last);
  fit.Fit(0, last, first, final);
}
}
