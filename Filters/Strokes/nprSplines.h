// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSplines.h
 * @brief One span of a cubic spline over four control points, and how finely it must be divided.
 *
 * A span over P0, P1, P2, P3 is evaluated at t in [0, 1]; it runs from (near) P1 to (near) P2.
 * Catmull-Rom with tension (Catmull & Rom 1974; tension 0.5 is the usual one) interpolates its
 * points and is C1; the uniform cubic B-spline stays inside the hull of its points and is C2.
 */
#ifndef nprSplines_h
#define nprSplines_h

#include <algorithm>
#include <array>
#include <cmath>

namespace npr
{
using Vector3 = std::array<double, 3>;

/// A cubic polynomial in t: Coefficients[k] belongs to t^k.
struct CubicSpan
{
  std::array<Vector3, 4> Coefficients;

  Vector3 Evaluate(double t) const
  {
    Vector3 result;
    for (int c = 0; c < 3; ++c)
    {
      result[c] = this->Coefficients[0][c] +
        t *
          (this->Coefficients[1][c] +
            t * (this->Coefficients[2][c] + t * this->Coefficients[3][c]));
    }
    return result;
  }

  Vector3 Derivative(double t) const
  {
    Vector3 result;
    for (int c = 0; c < 3; ++c)
    {
      result[c] = this->Coefficients[1][c] +
        t * (2 * this->Coefficients[2][c] + t * 3 * this->Coefficients[3][c]);
    }
    return result;
  }

  Vector3 SecondDerivative(double t) const
  {
    Vector3 result;
    for (int c = 0; c < 3; ++c)
    {
      result[c] = 2 * this->Coefficients[2][c] + 6 * t * this->Coefficients[3][c];
    }
    return result;
  }
};

/// Element [k][j] is the weight of point j in the coefficient of t^k.
using SplineBasis = std::array<std::array<double, 4>, 4>;

enum class SplineKind
{
  Polyline = 0, // straight from point to point
  CatmullRom = 1,
  BSpline = 2
};

inline SplineBasis GetSplineBasis(SplineKind kind, double tension)
{
  const double s = tension;
  const double u = 1.0 / 6;
  switch (kind)
  {
    case SplineKind::CatmullRom:
      return { { { 0, 1, 0, 0 }, { -s, 0, s, 0 }, { 2 * s, s - 3, 3 - 2 * s, -s },
        { -s, 2 - s, s - 2, s } } };
    case SplineKind::BSpline:
      return { { { u, 4 * u, u, 0 }, { -3 * u, 0, 3 * u, 0 }, { 3 * u, -6 * u, 3 * u, 0 },
        { -u, 3 * u, -3 * u, u } } };
    default:
      return { { { 0, 1, 0, 0 }, { 0, -1, 1, 0 }, { 0, 0, 0, 0 }, { 0, 0, 0, 0 } } };
  }
}

inline CubicSpan MakeSpan(const SplineBasis& basis, const std::array<Vector3, 4>& points)
{
  CubicSpan span;
  for (int k = 0; k < 4; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      span.Coefficients[k][c] = basis[k][0] * points[0][c] + basis[k][1] * points[1][c] +
        basis[k][2] * points[2][c] + basis[k][3] * points[3][c];
    }
  }
  return span;
}

namespace detail
{
inline double SquaredLength(const Vector3& v)
{
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

inline double Length(const Vector3& v)
{
  return std::sqrt(SquaredLength(v));
}
}

/// The square of the longest second derivative. No chord of the span over an interval dt is farther
/// from the curve than the latter times dt^2 / 8, for it is linear in t.
inline double MaximumSquaredSecondDerivative(const CubicSpan& span)
{
  return std::max(detail::SquaredLength(span.SecondDerivative(0)),
    detail::SquaredLength(span.SecondDerivative(1)));
}

/// An upper bound of the speed: the control points of the derivative as a quadratic Bezier curve.
inline double MaximumSpeed(const CubicSpan& span)
{
  const Vector3 first = span.Derivative(0);
  const Vector3 half = span.Derivative(0.5);
  const Vector3 last = span.Derivative(1);
  Vector3 middle;
  for (int c = 0; c < 3; ++c)
  {
    middle[c] = 2 * half[c] - 0.5 * (first[c] + last[c]);
  }
  return std::max({ detail::Length(first), detail::Length(middle), detail::Length(last) });
}

/// An upper bound of the distance of the span from its chord. The span is a Bezier curve; the ways
/// of its inner control points from the chord, weighted with 3 t (1 - t)^2 and 3 t^2 (1 - t), are
/// the curve's. The weights add up to 3/4 at most; where the ways are at right angles or lead to
/// opposite sides, their squares add up to 9/32.
inline double DistanceFromChord(const CubicSpan& span)
{
  const std::array<Vector3, 4>& k = span.Coefficients;
  Vector3 chord, first, second;
  double length2 = 0, along[2] = { 0, 0 };
  for (int c = 0; c < 3; ++c)
  {
    chord[c] = k[1][c] + k[2][c] + k[3][c];
    first[c] = k[1][c] / 3;
    second[c] = (2 * k[1][c] + k[2][c]) / 3;
    length2 += chord[c] * chord[c];
    along[0] += first[c] * chord[c];
    along[1] += second[c] * chord[c];
  }
  double dot = 0;
  for (int c = 0; c < 3; ++c)
  {
    // To the nearest point of the chord.
    first[c] -= length2 > 0 ? std::clamp(along[0] / length2, 0.0, 1.0) * chord[c] : 0.0;
    second[c] -= length2 > 0 ? std::clamp(along[1] / length2, 0.0, 1.0) * chord[c] : 0.0;
    dot += first[c] * second[c];
  }
  return (dot > 0 ? 3.0 / 4 : std::sqrt(9.0 / 32)) *
    std::max(detail::Length(first), detail::Length(second));
}

/// Equal steps in t so that no chord is longer than segmentLength and none is farther than
/// chordError from the curve. A limit that is not positive doesn't count.
inline int NumberOfSteps(const CubicSpan& span, double segmentLength, double chordError, int limit)
{
  double steps = 1;
  if (segmentLength > 0)
  {
    steps = std::max(steps, std::ceil(MaximumSpeed(span) / segmentLength - 1e-9));
  }
  if (chordError > 0)
  {
    const double bend2 = MaximumSquaredSecondDerivative(span);
    if (bend2 > 64 * chordError * chordError)
    {
      steps = std::max(steps, std::ceil(std::sqrt(std::sqrt(bend2) / (8 * chordError)) - 1e-9));
    }
  }
  return static_cast<int>(std::min<double>(steps, limit));
}
}

#endif
