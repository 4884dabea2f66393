// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprViewCurvature.h
 * @brief How fast a surface turns as it is seen: the view-dependent curvature and its derivative.
 *
 * Source: T. Judd, F. Durand, E. Adelson, "Apparent ridges for line drawing", SIGGRAPH 2007. There
 * the derivative is a difference between neighbouring points; here it comes from the derivatives
 * of curvature at the point itself.
 *
 * With S the shape operator, n the normal, v the unit vector to the eye at the distance d (infinite
 * in parallel projection), c = n.v and w = v - c n, the inverse of the projection from the tangent
 * plane to the screen is
 *
 *   A = I + w w' / (c (1 + c)),
 *
 * which stretches by 1/c along w. The view-dependent curvature q is the greatest singular value of
 * S A: how fast the normal turns on the screen, at most. s is the direction on the screen in which
 * it does, A s the same on the surface. Toward the contour q grows as 1/c, so all is multiplied by
 * powers of c: with B = c A, which is finite everywhere, c^2 q^2 is the greatest eigenvalue of
 * B S S B, and by first-order perturbation, with b = B s and y = S b,
 *
 *   D_b (c q) = y . (D_b S b + S D_b B s) / (c q)    where D_b S = C(b, ., .)
 *   D_b B = D_b c I + h (D_b w w' + w D_b w') - h^2 D_b c w w'    where h = 1 / (1 + c)
 *   D_b c = y . w + c (b . w) / d
 *   D_b w = ((b . w) w - b) / d - c y
 *
 * and c^2 D_b q = c D_b (c q) - (c q) D_b c. Vectors of the tangent plane have their components in
 * the frame of the principal directions.
 */
#ifndef nprViewCurvature_h
#define nprViewCurvature_h

#include "nprLanes.h"

#include <limits>

namespace npr
{
/// A point of a surface and the way to the eye. A unit of length is chosen by the caller, but for
/// ToEye, which is in the unit of PerLength.
template<typename Real>
struct SeenPoint
{
  Vector3<Real> ToEye;
  Vector3<Real> Normal;
  Vector3<Real> Direction1; ///< the principal directions; the other is Normal x Direction1
  Real Curvature1;
  Real Curvature2;
  Real P; ///< the derivatives of curvature
  Real Q;
  Real S;
  Real T;
};

template<typename Real>
struct ViewCurvature
{
  Real Cosine;        ///< of the angle between normal and eye: c above
  Real Curvature;     ///< c q
  Real Derivative;    ///< c^2 times the derivative of q along the axis
  Real Stretch;       ///< c times the length on the surface of a unit along the axis on the screen
  Vector3<Real> Axis; ///< the unit tangent along which the normal turns most on the screen, or 0
};

/// Front faces only: behind the contour the values are finite and have no meaning. `perspective`
/// is 0 or the chosen unit of length over the unit of ToEye, for parallel and perspective
/// projection. Inlined, so that what the caller does not use is not computed.
template<typename Real>
[[gnu::always_inline]] inline ViewCurvature<Real> GetViewCurvature(
  const SeenPoint<Real>& p, float perspective)
{
  // Added where something may be 0, at no cost where it is not.
  constexpr float tiny = std::numeric_limits<float>::min();
  ViewCurvature<Real> result;
  const Real perDistance = 1.0f / SquareRoot(Real(Dot(p.ToEye, p.ToEye) + tiny));
  const Vector3<Real> v = p.ToEye * perDistance;
  const Real nearness = perDistance * perspective; // 1 / d
  const Vector3<Real> direction2 = Cross(p.Normal, p.Direction1);
  const Real c = Dot(p.Normal, v);
  const Real w1 = Dot(p.Direction1, v);
  const Real w2 = Dot(direction2, v);
  const Real h = 1.0f / (1.0f + (c < 0.0f ? -c : c));

  const Real hw1 = h * w1;
  const Real hw2 = h * w2;
  const Real b11 = c + hw1 * w1;
  const Real b12 = hw1 * w2;
  const Real b22 = c + hw2 * w2;

  // The eigenvector of B S S B with the greatest eigenvalue, from whichever row has more digits.
  const Real sb11 = p.Curvature1 * b11;
  const Real sb12 = p.Curvature1 * b12;
  const Real sb21 = p.Curvature2 * b12;
  const Real sb22 = p.Curvature2 * b22;
  const Real half = 0.5f * (sb11 * sb11 + sb21 * sb21 - sb12 * sb12 - sb22 * sb22);
  const Real off = sb11 * sb12 + sb21 * sb22;
  const Real major = (half < 0.0f ? -half : half) + SquareRoot(Real(half * half + off * off));
  const Real perLength = 1.0f / SquareRoot(Real(major * major + off * off + tiny));
  const Real s1 = (half < 0.0f ? off : major) * perLength;
  const Real s2 = (half < 0.0f ? major : off) * perLength;

  const Real tangent1 = b11 * s1 + b12 * s2; // b
  const Real tangent2 = b12 * s1 + b22 * s2;
  const Real turn1 = p.Curvature1 * tangent1; // y
  const Real turn2 = p.Curvature2 * tangent2;
  const Real square = turn1 * turn1 + turn2 * turn2; // c^2 q^2

  const Real along = tangent1 * w1 + tangent2 * w2;
  const Real dc = turn1 * w1 + turn2 * w2 + c * along * nearness;
  const Real dw1 = (along * w1 - tangent1) * nearness - c * turn1;
  const Real dw2 = (along * w2 - tangent2) * nearness - c * turn2;
  const Real sw = h * (s1 * w1 + s2 * w2);
  const Real sdw = h * (s1 * dw1 + s2 * dw2 - sw * dc);
  const Real db1 = dc * s1 + dw1 * sw + w1 * sdw; // D_b B s
  const Real db2 = dc * s2 + dw2 * sw + w2 * sdw;
  const Real c11 = p.P * tangent1 + p.Q * tangent2; // D_b S
  const Real c12 = p.Q * tangent1 + p.S * tangent2;
  const Real c22 = p.S * tangent1 + p.T * tangent2;
  const Real rise = turn1 * (c11 * tangent1 + c12 * tangent2 + p.Curvature1 * db1) +
    turn2 * (c12 * tangent1 + c22 * tangent2 + p.Curvature2 * db2);

  result.Cosine = c;
  result.Curvature = SquareRoot(square);
  result.Stretch = SquareRoot(Real(tangent1 * tangent1 + tangent2 * tangent2));
  result.Derivative = (c * rise - square * dc) / (result.Curvature * result.Stretch + tiny);
  const Real perStretch = 1.0f / (result.Stretch + tiny);
  const Real axis1 = tangent1 * perStretch;
  const Real axis2 = tangent2 * perStretch;
  result.Axis = { axis1 * p.Direction1.X + axis2 * direction2.X,
    axis1 * p.Direction1.Y + axis2 * direction2.Y, axis1 * p.Direction1.Z + axis2 * direction2.Z };
  return result;
}
}

#endif
