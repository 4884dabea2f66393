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

#include "nprCornerAreas.h"
#include "nprTangentFrame.h"
#include "nprTriangleMesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace npr
{
/// What the operators of std::complex do, without their care for infinities, which costs a call.
struct Complex
{
  float Re;
  float Im;
};

inline Complex operator*(const Complex& a, const Complex& b)
{
  return { a.Re * b.Re - a.Im * b.Im, a.Re * b.Im + a.Im * b.Re };
}

inline Complex Conjugate(const Complex& a)
{
  return { a.Re, -a.Im };
}

struct QuadraticForm
{
  float Mean;
  Complex Rest;
};

struct CubicForm
{
  Complex Gradient;
  Complex Rest;
};

/// A form among the four numbers that FaceAverages has for a point.
inline QuadraticForm ReadQuadratic(const Eigen::Vector4f& numbers)
{
  return { numbers[1], { numbers[2], numbers[3] } };
}
inline CubicForm ReadCubic(const Eigen::Vector4f& numbers)
{
  return { { numbers[0], numbers[1] }, { numbers[2], numbers[3] } };
}

/// uuu, uuv, uvv, vvv.
inline Eigen::Vector4f GetComponents(const CubicForm& form)
{
  const Complex& g = form.Gradient;
  const Complex& r = form.Rest;
  return { 1.5f * g.Re + r.Re, 0.5f * g.Im + r.Im, 0.5f * g.Re - r.Re, 1.5f * g.Im - r.Im };
}

/// The components over a frame whose first axis lies at this angle in the old one.
inline Eigen::Vector4f GetComponents(const CubicForm& form, const Complex& axis)
{
  const Complex back = Conjugate(axis);
  return GetComponents(CubicForm{ form.Gradient * back, form.Rest * (back * back * back) });
}

/// A triangle in its plane. Its corners are numbered so that corner 0 lies opposite the longest
/// edge.
struct FaceShape
{
  using Vector = TriangleMesh::Vector;

  /// Lengths are in units of the mesh, TriangleMesh::GetUnit().
  FaceShape(const TriangleMesh& mesh, const TriangleMesh::Triangle& corners)
  {
    const float perUnit = 1.0f / mesh.GetUnit();
    const std::array<Vector, 3> points = { mesh.GetPoint(corners[0]), mesh.GetPoint(corners[1]),
      mesh.GetPoint(corners[2]) };
    const std::array<Vector, 3> edges = { (points[2] - points[1]) * perUnit,
      (points[0] - points[2]) * perUnit, (points[1] - points[0]) * perUnit };
    const float squares[3] = { edges[0].squaredNorm(), edges[1].squaredNorm(),
      edges[2].squaredNorm() };
    int first = squares[1] > squares[0] ? 1 : 0;
    first = squares[2] > squares[first] ? 2 : first;
    this->Slots = { first, Next[first], Next[first + 1] };
    for (int i = 0; i < 3; ++i)
    {
      this->Points[i] = corners[this->Slots[i]];
    }
    const float square = squares[first];
    const Vector& longest = edges[first];
    const Vector& next = edges[this->Slots[1]];
    const Vector cross = longest.cross(next);
    const float area = cross.norm();
    // A height below 1e-6 of the longest edge is within the rounding of single precision points.
    this->IsUsable = area > 1e-6f * square;
    if (this->IsUsable)
    {
      const float perSquare = 1.0f / square;
      this->PerLength = std::sqrt(perSquare);
      this->Square = square;
      this->X = longest.dot(next) * perSquare;
      this->Y = area * perSquare;
      this->U = longest * this->PerLength;
      this->Normal = cross / area;
      this->V = this->Normal.cross(this->U);
    }
  }

  /// Mixed Voronoi areas, in square units of the mesh.
  std::array<float, 3> GetCornerAreas() const
  {
    const float x = this->X;
    const float rest = 1.0f + x;
    const float yy = this->Y * this->Y;
    std::array<float, 3> areas = ComputeCornerAreas<float>(
      { x * rest + yy, rest, -x }, { 1.0f, x * x + yy, rest * rest + yy }, this->Y);
    for (float& area : areas)
    {
      area *= this->Square;
    }
    return areas;
  }

  /// Least squares of II (edge) = change of the normal, over the three edges; 1 / units.
  QuadraticForm FitQuadratic(
    const Vector& normal0, const Vector& normal1, const Vector& normal2) const
  {
    const Vector change0 = normal2 - normal1;
    const Vector change1 = normal0 - normal2;
    const float u0 = change0.dot(this->U);
    const float u1 = change1.dot(this->U);
    const float v0 = change0.dot(this->V);
    const float v1 = change1.dot(this->V);
    // The normal equations, solved by their adjugate; what all of it has of Y is cancelled out.
    const float x = this->X;
    const float y = this->Y;
    const float q = 1.0f + 2.0f * x;
    const float uu = 2.0f * (1.0f + x + x * x);
    const float right0 = this->SumAlong(u0, u1);
    const float right1 = y * (u0 + 2.0f * u1) + this->SumAlong(v0, v1);
    const float right2 = v0 + 2.0f * v1; // over Y
    const float scale = this->PerLength / (3.0f * (uu + 2.0f * y * y));
    const float a = (3.0f + 4.0f * y * y) * right0 - 2.0f * y * q * right1 + q * q * y * right2;
    const float b = 2.0f * (uu * right1 - y * q * right0) - uu * q * right2;
    const float c = q * q * right0 + ((3.0f * y * y + uu * uu) * right2 - uu * q * right1) / y;
    return { 0.5f * scale * (a + c), { 0.5f * scale * (a - c), scale * b } };
  }

  /// Least squares of C (edge) = change of the form, over the three edges; 1 / square units.
  CubicForm FitCubic(const std::array<QuadraticForm, 3>& forms) const
  {
    const auto changes = [&](const auto& component)
    {
      const float last = component(forms[2]);
      return std::array<float, 2>{ last - component(forms[1]), component(forms[0]) - last };
    };
    const auto uu = changes([](const QuadraticForm& f) { return f.Mean + f.Rest.Re; });
    const auto uv = changes([](const QuadraticForm& f) { return f.Rest.Im; });
    const auto vv = changes([](const QuadraticForm& f) { return f.Mean - f.Rest.Re; });
    const auto along = [&](const auto& c) { return this->SumAlong(c[0], c[1]); };
    const auto across = [&](const auto& c) { return this->Y * (c[0] + 2.0f * c[1]); };
    // The normal equations are tridiagonal, with these sums of squares of u, of u v and of v.
    const float s = 2.0f * (1.0f + this->X + this->X * this->X);
    const float m = this->Y * (1.0f + 2.0f * this->X);
    const float t = 2.0f * this->Y * this->Y;
    const float per0 = 1.0f / s;
    const float right0 = along(uu);
    const float right1 = across(uu) + 2.0f * along(uv) - m * per0 * right0;
    const float per1 = 1.0f / (2.0f * s + t - m * per0 * m);
    const float right2 = 2.0f * across(uv) + along(vv) - 2.0f * m * per1 * right1;
    const float per2 = 1.0f / (s + 2.0f * t - 4.0f * m * per1 * m);
    const float right3 = across(vv) - m * per2 * right2;
    const float vvv = right3 / (t - m * per2 * m);
    const float uvv = (right2 - m * vvv) * per2;
    const float uuv = (right1 - 2.0f * m * uvv) * per1;
    const float uuu = (right0 - m * uuv) * per0;
    const float half = 0.5f * this->PerLength;
    const float quarter = 0.25f * this->PerLength;
    return { { half * (uuu + uvv), half * (uuv + vvv) },
      { quarter * (uuu - 3.0f * uvv), quarter * (3.0f * uuv - vvv) } };
  }

  static constexpr int Next[4] = { 1, 2, 0, 1 };

  std::array<TriangleMesh::Index, 3> Points;
  std::array<int, 3> Slots; // the corners' numbers in the mesh
  Vector U;
  Vector V;
  Vector Normal;
  float X;
  float Y;
  float PerLength; // 1 / the longest edge
  float Square;    // of the longest edge
  /// False without area, or where the triangle is too thin to say anything about the surface; the
  /// rest is then not set.
  bool IsUsable;

private:
  /// The sum over the edges of their first components times changes, which add up to zero.
  float SumAlong(float change0, float change1) const
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
class CornerTurning
{
public:
  CornerTurning(const FaceShape& face, const Eigen::Vector3f& normal)
  {
    const Eigen::Vector3f u = MakeTangent(normal);
    const float cosine = normal.dot(face.Normal);
    this->Side = std::copysign(1.0f, cosine);
    // The turned u is u - (n + m) (u.m) / (1 + n.m), m the normal of the plane on the side of n.
    const float part = this->Side * u.dot(face.Normal) / (1.0f + std::abs(cosine));
    this->Once = { u.dot(face.U) - part * normal.dot(face.U),
      u.dot(face.V) - part * normal.dot(face.V) };
    this->Twice = this->Once * this->Once;
  }

  QuadraticForm ToFace(const QuadraticForm& form) const
  {
    return { form.Mean, Complex{ form.Rest.Re, this->Side * form.Rest.Im } * this->Twice };
  }
  QuadraticForm ToPoint(const QuadraticForm& form) const
  {
    return { form.Mean, this->Mirror(form.Rest * Conjugate(this->Twice)) };
  }
  CubicForm ToPoint(const CubicForm& form) const
  {
    return { this->Mirror(form.Gradient * Conjugate(this->Once)),
      this->Mirror(form.Rest * Conjugate(this->Twice * this->Once)) };
  }

private:
  Complex Mirror(const Complex& a) const { return { a.Re, this->Side * a.Im }; }

  Complex Once; // the turned axis in the plane of the triangle
  Complex Twice;
  float Side;
};
}

#endif
