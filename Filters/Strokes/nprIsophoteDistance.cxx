// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprIsophoteDistance.h"

#include <algorithm>
#include <cmath>

namespace npr
{
//------------------------------------------------------------------------------
double GetIsophoteDistance(
  double radialCurvature, double normalCosine, double eyeCosine, double level, double most)
{
  constexpr double pi = 3.14159265358979323846;
  if (!(normalCosine < level))
  {
    return 0.0;
  }
  // Around the circle the normal turns from n to v: at the angle t it is n cos t + v sin t, and
  // n.l is a sin(t + first).
  const double a = std::hypot(normalCosine, eyeCosine);
  const double first = std::atan2(normalCosine, eyeCosine);
  double turn = 0.5 * pi;
  if (level < a)
  {
    const double here = std::asin(std::max(level / a, -1.0)) - first;
    turn = std::min(here < 0.0 ? here + 2.0 * pi : here, turn);
  }
  return radialCurvature > 0.0 ? std::min((1.0 - std::cos(turn)) / radialCurvature, most) : most;
}
}
