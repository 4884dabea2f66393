// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprFaceFits.h
 * @brief What one triangle says about the curvature of its surface: the inner loops of
 * FaceAverages.
 *
 * Single precision throughout. A triangle is seen in the plane of its own, with its longest edge as
 * the unit of length and the first axis: the edges, each opposite its corner, are (1, 0), (X, Y)
 * and
 * (-1 - X, -Y) with X in [-1, 0]. So nothing depends on how large it is, and no sum of products of
 * a fit cancels, however thin it is.
 *
 * Forms on a plane are written by how they turn: a quadratic one (uu, uv, vv) as its mean (uu + vv)
 * / 2, which does not turn, and ((uu - vv) / 2, uv), which turns by twice the angle; a cubic one
 * (uuu, uuv, uvv, vvv) as the gradient of the mean ((uuu + uvv) / 2, (uuv + vvv) / 2), which turns
 * by the angle, and ((uuu - 3 uvv) / 4, (3 uuv - vvv) / 4), which turns by three times the angle.
 */
#ifndef nprFaceFits_h
#define nprFaceFits_h

#include "nprLanes.h"

#include <Eigen/Core>

#include <array>

namespace npr
{
/// What the operators of std::complex do, without their care for infinities, which costs a call.
template<typename Real>
struct Complex
{
  Real Re;
  Real Im;
};

template<typename Real>
Complex<Real> operator*(const Complex<Real>& a, const Complex<Real>& b)
{
  return { a.Re * b.Re - a.Im * b.Im, a.Re * b.Im + a.Im * b.Re };
}

template<typename Real>
Complex<Real> Conjugate(const Complex<Real>& a)
{
  return { a.Re, -a.Im };
}

template<typename Real>
struct QuadraticForm
{
  Real Mean;
  Complex<Real> Rest;
};

template<typename Real>
struct CubicForm
{
  Complex<Real> Gradient;
  Complex<Real> Rest;
};

/// A form among the four numbers that FaceAverages has for a point.
inline QuadraticForm<float> ReadQuadratic(const Eigen::Vector4f& numbers)
{
  return { numbers[1], { numbers[2], numbers[3] } };
}
inline CubicForm<float> ReadCubic(const Eigen::Vector4f& numbers)
{
  return { { numbers[0], numbers[1] }, { numbers[2], numbers[3] } };
}

/// uuu, uuv, uvv, vvv.
inline Eigen::Vector4f GetComponents(const CubicForm<float>& form)
{
  const Complex<float>& g = form.Gradient;
  const Complex<float>& r = form.Rest;
  return { 1.5f * g.Re + r.Re, 0.5f * g.Im + r.Im, 0.5f * g.Re - r.Re, 1.5f * g.Im - r.Im };
}

/// The components over a frame whose first axis lies at this angle in the old one.
inline Eigen::Vector4f GetComponents(const CubicForm<float>& form, const Complex<float>& axis)
{
  const Complex<float> back = Conjugate(axis);
  return GetComponents(CubicForm<float>{ form.Gradient * back, form.Rest * (back * back * back) });
}

/// A triangle in its plane. Its corners are numbered so that corner 0 lies opposite the longest
/// edge.
template<typename Real>
struct FaceShape
{
  using Vector = Vector3<Real>;

  explicit FaceShape(const std::array<Vector, 3>& points)
  {
    const Vector longest = points[2] - points[1];
    const Vector next = points[0] - points[2];
    const Vector cross = Cross(longest, next);
    const Real area = SquareRoot(Dot(cross, cross));
    this->Square = Dot(longest, longest);
    const Real perSquare = 1.0f / this->Square;
    this->PerLength = SquareRoot(perSquare);
    this->X = Dot(longest, next) * perSquare;
    this->Y = area * perSquare;
    this->U = longest * this->PerLength;
    this->Normal = cross * (1.0f / area);
    this->V = Cross(this->Normal, this->U);
  }

  /// The value, or zero for triangles without area, or too thin to say anything about the surface:
  /// a height below 1e-6 of the longest edge is within the rounding of single precision points.
  Real IfUsable(const Real& value) const { return this->Y > 1e-6f ? value : Real{}; }

  /// Mixed Voronoi areas (see nprCornerAreas.h; only corner 0 can be obtuse), zero if not usable.
  std::array<Real, 3> GetCornerAreas() const
  {
    const Real rest = 1.0f + this->X;
    const Real yy = this->Y * this->Y;
    const Real cosine = this->X * rest + yy; // at corner 0, times positive lengths
    const Real scale = 0.125f * this->Square / this->Y;
    const Real share0 = scale * cosine;
    const Real share1 = scale * rest * (this->X * this->X + yy);
    const Real share2 = -scale * this->X * (rest * rest + yy);
    const Real eighth = 0.125f * this->Square * this->Y;
    return { this->IfUsable(cosine < 0.0f ? 2.0f * eighth : share1 + share2),
      this->IfUsable(cosine < 0.0f ? eighth : share2 + share0),
      this->IfUsable(cosine < 0.0f ? eighth : share0 + share1) };
  }

  /// Least squares of II (edge) = change of the normal, over the three edges; 1 / length.
  QuadraticForm<Real> FitQuadratic(const std::array<Vector, 3>& normals) const
  {
    const Vector change0 = normals[2] - normals[1];
    const Vector change1 = normals[0] - normals[2];
    const Real u0 = Dot(change0, this->U);
    const Real u1 = Dot(change1, this->U);
    const Real v0 = Dot(change0, this->V);
    const Real v1 = Dot(change1, this->V);
    // The normal equations, solved by their adjugate; what all of it has of Y is cancelled out.
    const Real x = this->X;
    const Real y = this->Y;
    const Real q = 1.0f + 2.0f * x;
    const Real uu = 2.0f * (1.0f + x + x * x);
    const Real right0 = this->SumAlong(u0, u1);
    const Real right1 = y * (u0 + 2.0f * u1) + this->SumAlong(v0, v1);
    const Real right2 = v0 + 2.0f * v1; // over Y
    const Real scale = this->PerLength / (3.0f * (uu + 2.0f * y * y));
    const Real a = (3.0f + 4.0f * y * y) * right0 - 2.0f * y * q * right1 + q * q * y * right2;
    const Real b = 2.0f * (uu * right1 - y * q * right0) - uu * q * right2;
    const Real c = q * q * right0 + ((3.0f * y * y + uu * uu) * right2 - uu * q * right1) / y;
    return { 0.5f * scale * (a + c), { 0.5f * scale * (a - c), scale * b } };
  }

  /// Least squares of C (edge) = change of the form, over the three edges; 1 / length^2.
  CubicForm<Real> FitCubic(const std::array<QuadraticForm<Real>, 3>& forms) const
  {
    const auto changes = [&](const auto& component)
    {
      const Real last = component(forms[2]);
      return std::array<Real, 2>{ last - component(forms[1]), component(forms[0]) - last };
    };
    using Form = QuadraticForm<Real>;
    const auto uu = changes([](const Form& f) -> Real { return f.Mean + f.Rest.Re; });
    const auto uv = changes([](const Form& f) -> Real { return f.Rest.Im; });
    const auto vv = changes([](const Form& f) -> Real { return f.Mean - f.Rest.Re; });
    const auto along = [&](const auto& c) -> Real { return this->SumAlong(c[0], c[1]); };
    const auto across = [&](const auto& c) -> Real { return this->Y * (c[0] + 2.0f * c[1]); };
    // The normal equations are tridiagonal, with these sums of squares of u, of u v and of v.
    const Real s = 2.0f * (1.0f + this->X + this->X * this->X);
    const Real m = this->Y * (1.0f + 2.0f * this->X);
    const Real t = 2.0f * this->Y * this->Y;
    const Real per0 = 1.0f / s;
    const Real right0 = along(uu);
    const Real right1 = across(uu) + 2.0f * along(uv) - m * per0 * right0;
    const Real per1 = 1.0f / (2.0f * s + t - m * per0 * m);
    const Real right2 = 2.0f * across(uv) + along(vv) - 2.0f * m * per1 * right1;
    const Real per2 = 1.0f / (s + 2.0f * t - 4.0f * m * per1 * m);
    const Real right3 = across(vv) - m * per2 * right2;
    const Real vvv = right3 / (t - m * per2 * m);
    const Real uvv = (right2 - m * vvv) * per2;
    const Real uuv = (right1 - 2.0f * m * uvv) * per1;
    const Real uuu = (right0 - m * uuv) * per0;
    const Real half = 0.5f * this->PerLength;
    const Real quarter = 0.25f * this->PerLength;
    return { { half * (uuu + uvv), half * (uuv + vvv) },
      { quarter * (uuu - 3.0f * uvv), quarter * (3.0f * uuv - vvv) } };
  }

  Vector U;
  Vector V;
  Vector Normal;
  Real X;
  Real Y;
  Real PerLength; // 1 / the longest edge
  Real Square;    // of the longest edge

private:
  /// The sum over the edges of their first components times changes, which add up to zero.
  Real SumAlong(const Real& change0, const Real& change1) const
  {
    return (2.0f + this->X) * change0 + (1.0f + 2.0f * this->X) * change1;
  }
};

/**
 * How the tangent plane at a corner, with MakeTangent(normal) as first axis, lies to the plane of
 * the triangle when it is turned there about the line where they meet.
 *
 * Given normals may disagree with the winding: then the triangle is seen from behind, as in a
 * mirror.
 */
template<typename Real>
class CornerTurning
{
public:
  CornerTurning(const FaceShape<Real>& face, const Vector3<Real>& normal)
  {
    // MakeTangent(normal).
    const Real sign = SignOf(normal.Z);
    const Real a = -1.0f / (sign + normal.Z);
    const Vector3<Real> u = { 1.0f + sign * normal.X * normal.X * a, sign * normal.X * normal.Y * a,
      -sign * normal.X };
    const Real cosine = Dot(normal, face.Normal);
    this->Side = SignOf(cosine);
    // The turned u is u - (n + m) (u.m) / (1 + n.m), m the normal of the plane on the side of n.
    const Real part = this->Side * Dot(u, face.Normal) / (1.0f + this->Side * cosine);
    this->Once = { Dot(u, face.U) - part * Dot(normal, face.U),
      Dot(u, face.V) - part * Dot(normal, face.V) };
    this->Twice = this->Once * this->Once;
  }

  QuadraticForm<Real> ToFace(const QuadraticForm<Real>& form) const
  {
    return { form.Mean, this->Mirror(form.Rest) * this->Twice };
  }
  QuadraticForm<Real> ToPoint(const QuadraticForm<Real>& form) const
  {
    return { form.Mean, this->Mirror(form.Rest * Conjugate(this->Twice)) };
  }
  CubicForm<Real> ToPoint(const CubicForm<Real>& form) const
  {
    return { this->Mirror(form.Gradient * Conjugate(this->Once)),
      this->Mirror(form.Rest * Conjugate(this->Twice * this->Once)) };
  }

private:
  Complex<Real> Mirror(const Complex<Real>& a) const { return { a.Re, this->Side * a.Im }; }

  Complex<Real> Once; // the turned axis in the plane of the triangle
  Complex<Real> Twice;
  Real Side;
};
}

#endif
