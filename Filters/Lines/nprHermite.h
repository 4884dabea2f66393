// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprHermite_h
#define nprHermite_h

#include <algorithm>
#include <array>
#include <cmath>

namespace npr
{
/**
 * Where the cubic through two values of different signs, with these slopes, is 0: t in [0, 1]. Of
 * several places the one nearest to `guess`. Always the same bits for the same numbers; slopes that
 * are not finite leave the guess.
 */
inline double FindHermiteRoot(
  double atStart, double atEnd, double slopeAtStart, double slopeAtEnd, double guess)
{
  // ((a t + b) t + slopeAtStart) t + atStart
  const double a = 2.0 * (atStart - atEnd) + slopeAtStart + slopeAtEnd;
  const double b = 3.0 * (atEnd - atStart) - 2.0 * slopeAtStart - slopeAtEnd;
  const auto evaluate = [&](double t) { return ((a * t + b) * t + slopeAtStart) * t + atStart; };
  if (!std::isfinite(a) || !std::isfinite(b))
  {
    return guess;
  }
  // Between its extrema the cubic is monotone.
  std::array<double, 4> bounds = { 0.0, 1.0, 1.0, 1.0 };
  int last = 0;
  const double discriminant = b * b - 3.0 * a * slopeAtStart;
  if (discriminant > 0.0)
  {
    const double root = -(b + std::copysign(std::sqrt(discriminant), b));
    std::array<double, 2> extrema = { a != 0.0 ? root / (3.0 * a) : -1.0,
      root != 0.0 ? slopeAtStart / root : -1.0 };
    std::sort(extrema.begin(), extrema.end());
    for (const double t : extrema)
    {
      if (t > 0.0 && t < 1.0)
      {
        bounds[++last] = t;
      }
    }
  }
  bounds[++last] = 1.0;
  double best = guess;
  double least = 2.0;
  for (int i = 0; i < last; ++i)
  {
    double low = bounds[i];
    double high = bounds[i + 1];
    const bool isPositive = evaluate(low) >= 0.0;
    if (isPositive == (evaluate(high) >= 0.0))
    {
      continue;
    }
    constexpr int bisections = 30; // beyond single precision
    for (int step = 0; step < bisections; ++step)
    {
      const double middle = 0.5 * (low + high);
      ((evaluate(middle) >= 0.0) == isPositive ? low : high) = middle;
    }
    const double root = 0.5 * (low + high);
    if (std::abs(root - guess) < least)
    {
      least = std::abs(root - guess);
      best = root;
    }
  }
  return best;
}
}

#endif
