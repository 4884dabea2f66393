// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprImplicitCurvature.h"

#include "nprTangentFrame.h"

#include <algorithm>

namespace npr
{
namespace
{
using Eigen::Vector3d;

/// Of the gradient along a line.
struct LineDerivatives
{
  Vector3d First;
  Vector3d Second;
  double LargestChange;
};
}

//------------------------------------------------------------------------------
bool ComputeLevelSetJet(const std::function<Vector3d(const Vector3d&)>& gradient,
  const Vector3d& point, double step, LevelSetJet& jet)
{
  const Vector3d here = gradient(point);
  const double length = here.norm();
  if (!(length > 0.0) || !here.allFinite())
  {
    return false;
  }
  const Vector3d normal = here / length;
  const TangentFrame frame = MakeTangentFrame(normal);
  const auto differentiate = [&](const Vector3d& direction)
  {
    // Relative to the gradient here, so that a large constant part costs no digits.
    const Vector3d behind2 = gradient(point - 2.0 * step * direction) - here;
    const Vector3d behind = gradient(point - step * direction) - here;
    const Vector3d ahead = gradient(point + step * direction) - here;
    const Vector3d ahead2 = gradient(point + 2.0 * step * direction) - here;
    return LineDerivatives{ (8.0 * (ahead - behind) - (ahead2 - behind2)) / (12.0 * step),
      (16.0 * (ahead + behind) - (ahead2 + behind2)) / (12.0 * step * step),
      std::max(behind2.norm(), ahead2.norm()) };
  };
  const LineDerivatives u = differentiate(frame.U);
  const LineDerivatives v = differentiate(frame.V);
  if (!(std::max(u.LargestChange, v.LargestChange) < 0.5 * length))
  {
    return false;
  }
  const Vector3d form(u.First.dot(frame.U) / length,
    0.5 * (u.First.dot(frame.V) + v.First.dot(frame.U)) / length, v.First.dot(frame.V) / length);
  const double nu = u.First.dot(normal) / length;
  const double nv = v.First.dot(normal) / length;
  jet.Normal = normal;
  jet.Form = form;
  jet.Cubic = { u.Second.dot(frame.U) / length - 3.0 * form[0] * nu,
    u.Second.dot(frame.V) / length - form[0] * nv - 2.0 * form[1] * nu,
    v.Second.dot(frame.U) / length - form[2] * nu - 2.0 * form[1] * nv,
    v.Second.dot(frame.V) / length - 3.0 * form[2] * nv };
  return jet.Form.allFinite() && jet.Cubic.allFinite();
}
}
