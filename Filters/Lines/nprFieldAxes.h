// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprFieldAxes_h
#define nprFieldAxes_h

#include "nprLineSurface.h"
#include "vtkNPRFiltersLinesModule.h"

#include <array>
#include <cmath>

namespace npr
{
/// What edges compare of a point: side by side, for it is read together.
struct alignas(32) AxisPoint
{
  std::array<float, 3> Axis; ///< a unit vector in the tangent plane, or 0 where there is none
  float Field;               ///< never 0, see FieldAxes::MoveOff()
  std::array<float, 3> Normal;
  float Bound; ///< > 0 where, as far as is known without the test, a line may be
};

/**
 * @class FieldAxes
 * @brief The axes that the sign of a field belongs to, where these are known only up to their sign.
 *
 * A principal direction may point either way, and no choice of ways fits a whole surface; with the
 * direction, what is derived along it changes its sign. So the values at the ends of an edge are
 * compared after one of them has been turned to the other's side: each edge decides for itself,
 * and so the triangles on both of its sides agree. Nothing here changes when an axis is turned over
 * together with the field's value there.
 *
 * Along an edge the axes are compared in one plane, after the turn that takes one end's normal to
 * the other's. Where they are then closer to perpendicular than to parallel, they are not the same
 * axis (the principal curvatures may have swapped): no line crosses such an edge, nor one along
 * which the surface turns by more than a right angle. Nothing is kept for edges, so that axes may
 * change with each view.
 */
class VTKNPRFILTERSLINES_EXPORT FieldAxes
{
public:
  using Index = TriangleMesh::Index;

  /// Both must outlive this. An \p even field keeps its sign when its axis is turned over: then all
  /// that counts is where axes are not comparable.
  FieldAxes(const LineSurface& surface, const AxisPoint* points, bool even = false)
    : Surface(surface), Points(points), Even(even)
  {
  }

  /// A value of exactly 0 counts as if it lay slightly off, always to the same side in space. Of an
  /// even field that is the positive side.
  static float MoveOff(float value, const std::array<float, 3>& axis, bool even);

  /// The edges of a triangle along which the field changes its sign: bit e for edge e. 0 where, as
  /// far as is known without the test, no line may be.
  unsigned int FindCrossed(Index triangle) const
  {
    // Signs are as good as random, so that branches would be slow.
    const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(triangle);
    const AxisPoint& p0 = this->Points[c[0]];
    const AxisPoint& p1 = this->Points[c[1]];
    const AxisPoint& p2 = this->Points[c[2]];
    const bool mayBe = (p0.Bound > 0.0f) | (p1.Bound > 0.0f) | (p2.Bound > 0.0f);
    return mayBe && (MayCross(p0, p1) | MayCross(p1, p2) | MayCross(p2, p0))
      ? this->IsCrossed(p0, p1) | this->IsCrossed(p1, p2) << 1 | this->IsCrossed(p2, p0) << 2
      : 0u;
  }

  /// Whether, as far as is known without the test, a line may be at a point.
  bool MayBeAt(Index point) const { return this->Points[point].Bound > 0.0f; }

  /// How fast the field falls along the axis at a point: minus its derivative, from the values at
  /// the neighbours by least squares. 0 where too few have axes that are comparable.
  float ComputeFall(Index point) const;

private:
  using Vector = std::array<float, 3>;
  // Of axes that are closer to parallel than to right angles.
  static constexpr float LeastCosine = 0.70710678f;
  // No turn by less than a right angle takes a cosine above this below -LeastCosine.
  static constexpr float SureCosine = 1.0f - LeastCosine;

  static float Dot(const Vector& a, const Vector& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /// A number, turned over where another is negative.
  static float Turn(float number, float by) { return std::copysign(1.0f, by) * number; }

  // False for most edges without a crossing, and needs no normals.
  bool MayCross(const AxisPoint& a, const AxisPoint& b) const
  {
    const float cosine = Dot(a.Axis, b.Axis);
    return (Turn(Turn(cosine, a.Field), b.Field) <= SureCosine) | this->Even;
  }
  /// How two axes are to each other.
  struct Relation
  {
    float Cosine; ///< of the angle between them, in one plane, times a positive number
    bool AreComparable;
  };
  static Relation Compare(const AxisPoint& a, const AxisPoint& b)
  {
    // After the shortest turn from one tangent plane to the other, in closed form, times a scale.
    // Both ways round alike, for nothing here depends on the order of the points.
    const float normals = Dot(a.Normal, b.Normal);
    const float scale = 1.0f + normals;
    const float cosine =
      Dot(a.Axis, b.Axis) * scale - Dot(a.Axis, b.Normal) * Dot(b.Axis, a.Normal);
    return { cosine, normals >= 0.0f && std::abs(cosine) > LeastCosine * scale };
  }

  // 1 or 0.
  unsigned int IsCrossed(const AxisPoint& a, const AxisPoint& b) const
  {
    const Relation relation = Compare(a, b);
    const float turn = this->Even ? 1.0f : relation.Cosine;
    return relation.AreComparable && Turn(Turn(a.Field, b.Field), turn) < 0.0f ? 1u : 0u;
  }

  const LineSurface& Surface;
  const AxisPoint* const Points;
  const bool Even;
};
}

#endif
