// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSurfaceTruths.h
 * @brief What is true at the points of surfaces that are known by formula.
 */
#ifndef nprSurfaceTruths_h
#define nprSurfaceTruths_h

#include "nprTangentFrame.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace nprtest
{
using Eigen::Vector3d;
using Eigen::Vector4d;

/// What is true at a point. The forms refer to Frame, U x V = Normal.
struct Truth
{
  Vector3d Point;
  Vector3d Normal;
  npr::TangentFrame Frame;
  Vector3d Form;  // II: UU, UV, VV
  Vector4d Cubic; // C: UUU, UUV, UVV, VVV
};

/// The ellipsoid with these semi-axes at the point that belongs to a direction: its components
/// times the axes. F = x^2 / a^2 + y^2 / b^2 + z^2 / c^2 has the gradient g and the Hessian A, and
/// with n = g / |g| the second fundamental form is A(x, y) / |g|, its derivative
/// -(II(x, y) A(n, z) + II(y, z) A(n, x) + II(z, x) A(n, y)) / |g|.
inline Truth MakeEllipsoidTruth(const Vector3d& axes, const Vector3d& direction)
{
  Truth truth;
  truth.Point = axes.cwiseProduct(direction);
  const Vector3d hessian = 2.0 * axes.cwiseAbs2().cwiseInverse();
  const Vector3d gradient = hessian.cwiseProduct(truth.Point);
  const double length = gradient.norm();
  truth.Normal = gradient / length;
  truth.Frame = npr::MakeTangentFrame(truth.Normal);
  const Vector3d& u = truth.Frame.U;
  const Vector3d& v = truth.Frame.V;
  const auto form = [&](const Vector3d& a, const Vector3d& b)
  { return hessian.cwiseProduct(a).dot(b) / length; };
  const auto cubic = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c)
  {
    const Vector3d& n = truth.Normal;
    return -(form(a, b) * form(n, c) + form(b, c) * form(n, a) + form(c, a) * form(n, b));
  };
  truth.Form = { form(u, u), form(u, v), form(v, v) };
  truth.Cubic = { cubic(u, u, u), cubic(u, u, v), cubic(u, v, v), cubic(v, v, v) };
  return truth;
}

/// The derivatives of a height: x, y; xx, xy, yy; xxx, xxy, xyy, yyy.
struct HeightJet
{
  double Value;
  double First[2];
  double Second[3];
  double Third[4];
};

/**
 * The graph z = f(x, y), normal upwards. With W^2 = 1 + fx^2 + fy^2 the second fundamental form in
 * the basis of the coordinates is -f_ij / W (convex upwards is positive), the Christoffel symbols
 * are f_l f_ij / W^2, and so the covariant derivative of the form is C_ijk = -f_ijk / W + (f_ij g_k
 * + f_ik g_j + f_jk g_i) / W^3 with g_i = f_l f_li.
 */
inline Truth MakeHeightTruth(double x, double y, const HeightJet& f)
{
  Truth truth;
  const double w = std::sqrt(1.0 + f.First[0] * f.First[0] + f.First[1] * f.First[1]);
  truth.Point = { x, y, f.Value };
  truth.Normal = Vector3d(-f.First[0], -f.First[1], 1.0) / w;
  truth.Frame = npr::MakeTangentFrame(truth.Normal);
  // A tangent vector's components in the coordinate basis are its x and y.
  const double* const s = f.Second;
  const double g[2] = { f.First[0] * s[0] + f.First[1] * s[1],
    f.First[0] * s[1] + f.First[1] * s[2] };
  const auto form = [&](const Vector3d& a, const Vector3d& b)
  {
    return -(s[0] * a.x() * b.x() + s[1] * (a.x() * b.y() + a.y() * b.x()) + s[2] * a.y() * b.y()) /
      w;
  };
  const auto cubic = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c)
  {
    const double third = f.Third[0] * a.x() * b.x() * c.x() +
      f.Third[1] * (a.x() * b.x() * c.y() + a.x() * b.y() * c.x() + a.y() * b.x() * c.x()) +
      f.Third[2] * (a.x() * b.y() * c.y() + a.y() * b.x() * c.y() + a.y() * b.y() * c.x()) +
      f.Third[3] * a.y() * b.y() * c.y();
    const auto slope = [&](const Vector3d& d) { return g[0] * d.x() + g[1] * d.y(); };
    return -third / w -
      (form(a, b) * slope(c) + form(a, c) * slope(b) + form(b, c) * slope(a)) / (w * w);
  };
  const Vector3d& u = truth.Frame.U;
  const Vector3d& v = truth.Frame.V;
  truth.Form = { form(u, u), form(u, v), form(v, v) };
  truth.Cubic = { cubic(u, u, u), cubic(u, u, v), cubic(u, v, v), cubic(v, v, v) };
  return truth;
}

/// z = 0.3 sin 2x cos y.
inline Truth MakeWavesTruth(double x, double y)
{
  const double s = 0.3 * std::sin(2.0 * x);
  const double c = 0.3 * std::cos(2.0 * x);
  const double cy = std::cos(y);
  const double sy = std::sin(y);
  return MakeHeightTruth(x, y,
    { s * cy, { 2.0 * c * cy, -s * sy }, { -4.0 * s * cy, -2.0 * c * sy, -s * cy },
      { -8.0 * c * cy, 4.0 * s * sy, -2.0 * c * cy, s * sy } });
}
}

#endif
