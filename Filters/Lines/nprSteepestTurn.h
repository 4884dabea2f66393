// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSteepestTurn.h
 * @brief The direction in which a surface's curvature along that direction grows fastest.
 */
#ifndef nprSteepestTurn_h
#define nprSteepestTurn_h

#include <cmath>

namespace npr
{
/**
 * The angle from the first principal direction to the unit vector x for which the cubic form
 * C(x,x,x) = P u^3 + 3 Q u^2 v + 3 S u v^2 + T v^3 is greatest. `value` is C there.
 *
 * As a function of the angle f, C is A cos(f - a) + B cos 3(f - b). Its greatest value lies between
 * a and the nearest of the three maxima of the second term, and there it has but one maximum:
 * between them one term falls and the other rises, on either side both fall, and the ratio of their
 * slopes only grows.
 */
inline double FindSteepestTurn(double p, double q, double s, double t, double& value)
{
  const double cos1 = 0.75 * (p + s);
  const double sin1 = 0.75 * (q + t);
  const double cos3 = 0.25 * (p - 3.0 * s);
  const double sin3 = 0.25 * (3.0 * q - t);
  const double slow = std::hypot(cos1, sin1);
  const double fast = std::hypot(cos3, sin3);
  constexpr double Third = 2.0943951023931953; // of a full turn
  const double phase = std::atan2(sin3, cos3) / 3.0;
  const double start = slow > 0.0 ? std::atan2(sin1, cos1) : phase;
  const double nearest = phase + Third * std::round((start - phase) / Third);

  // In between, at most 60 degrees away: the slope is positive at 0 and negative at `length`.
  const double length = std::abs(nearest - start);
  const auto slope = [&](double d)
  { return 3.0 * fast * std::sin(3.0 * (length - d)) - slow * std::sin(d); };
  double low = 0.0;
  double high = length;
  double at = length * (9.0 * fast / (9.0 * fast + slow + 1.0e-300));
  for (int i = 0; i < 40; ++i)
  {
    const double here = slope(at);
    (here > 0.0 ? low : high) = at;
    const double change = -9.0 * fast * std::cos(3.0 * (length - at)) - slow * std::cos(at);
    const double newton = at - here / change;
    // Half of what is left where Newton's step leads away.
    const double next = newton >= low && newton <= high ? newton : 0.5 * (low + high);
    if (std::abs(next - at) < 1.0e-14)
    {
      break;
    }
    at = next;
  }
  value = slow * std::cos(at) + fast * std::cos(3.0 * (length - at));
  return start + (nearest > start ? at : -at);
}
}

#endif
