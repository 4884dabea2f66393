// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprFieldAxes_h
#define nprFieldAxes_h

#include "nprLanes.h"
#include "nprLineSurface.h"
#include "vtkNPRFiltersLinesModule.h"

#include <array>

namespace npr
{
/// What edges compare of a point: side by side, for it is read together.
struct alignas(32) AxisPoint
{
  std::array<float, 3> Axis; ///< a unit vector in the tangent plane, or 0 where there is none
  float Field; ///< never 0 nor infinite, see FieldAxes::MakeField(); perhaps not a number
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

  /// What stands for a value of the field. Exactly 0 counts as if it lay slightly off, always to
  /// the same side in space; of an even field that is the positive side. What is infinite is no
  /// number.
  static float MakeField(float value, const std::array<float, 3>& axis, bool even);

  /// The edges of triangles, one in each lane, along which the field changes its sign: bit e for
  /// edge e. 0 where, as far as is known without the test, no line may be, or where the field is
  /// not a number.
  std::array<unsigned int, NumberOfLanes> FindCrossed(
    const std::array<Index, NumberOfLanes>& triangles) const
  {
    const TriangleMesh& mesh = this->Surface.GetMesh();
    std::array<const TriangleMesh::Triangle*, NumberOfLanes> corners;
    for (int i = 0; i < NumberOfLanes; ++i)
    {
      corners[i] = &mesh.GetTriangle(triangles[i]);
    }
    const auto load = [&](int corner)
    {
      std::array<Index, NumberOfLanes> points;
      for (int i = 0; i < NumberOfLanes; ++i)
      {
        points[i] = (*corners[i])[corner];
      }
      return this->Load(points);
    };
    const AxisPoints first = load(0);
    const AxisPoints second = load(1);
    const AxisPoints third = load(2);
    const Lanes zero = {};
    const Lanes some = this->IsCrossed(first, second) + 2.0f * this->IsCrossed(second, third) +
      4.0f * this->IsCrossed(third, first);
    const auto mayBe = [&zero, &some](const Lanes& bound, const Lanes& otherwise)
    { return bound > zero ? some : otherwise; };
    std::array<float, NumberOfLanes> row;
    Store(mayBe(first.Bound, mayBe(second.Bound, mayBe(third.Bound, zero))), row.data());
    std::array<unsigned int, NumberOfLanes> crossed;
    for (int i = 0; i < NumberOfLanes; ++i)
    {
      crossed[i] = static_cast<unsigned int>(row[i]);
    }
    return crossed;
  }

  /// Starts to load what FindCrossed() will read.
  void PrefetchTriangle(Index triangle) const
  {
    for (const Index point : this->Surface.GetMesh().GetTriangle(triangle))
    {
      Prefetch(&this->Points[point]);
    }
  }

  /// Whether, as far as is known without the test, a line may be at a point.
  bool MayBeAt(Index point) const { return this->Points[point].Bound > 0.0f; }

  /// How fast the field falls along the axis at a point: minus its derivative, from the values at
  /// the neighbours by least squares. 0 where too few have axes that are comparable.
  float ComputeFall(Index point) const;
  /// Starts to load what ComputeFall() will read.
  void PrefetchNeighbours(Index point) const
  {
    for (const Index* neighbour = this->Surface.NeighboursBegin(point);
         neighbour != this->Surface.NeighboursEnd(point); ++neighbour)
    {
      Prefetch(&this->Points[*neighbour]);
      Prefetch(&this->Surface.GetMesh().GetPoint(*neighbour));
    }
  }

private:
  // Of axes that are closer to parallel than to right angles.
  static constexpr float LeastCosine = 0.70710678f;

  // Points, one in each lane.
  struct AxisPoints
  {
    Vector3<Lanes> Axis;
    Lanes Field;
    Vector3<Lanes> Normal;
    Lanes Bound;
  };
  AxisPoints Load(const std::array<Index, NumberOfLanes>& points) const
  {
    std::array<const float*, NumberOfLanes> axes;
    std::array<const float*, NumberOfLanes> normals;
    for (int i = 0; i < NumberOfLanes; ++i)
    {
      axes[i] = this->Points[points[i]].Axis.data();
      normals[i] = this->Points[points[i]].Normal.data();
    }
    const std::array<Lanes, 4> axis = LoadColumns(axes);
    const std::array<Lanes, 4> normal = LoadColumns(normals);
    return { { axis[0], axis[1], axis[2] }, axis[3], { normal[0], normal[1], normal[2] },
      normal[3] };
  }

  /// How two axes are to each other.
  struct Relation
  {
    Lanes Cosine;        ///< of the angle between them, in one plane, times a positive number
    Lanes AreComparable; ///< 1 or 0
  };
  static Relation Compare(const AxisPoints& a, const AxisPoints& b)
  {
    // After the shortest turn from one tangent plane to the other, in closed form, times a scale.
    // Both ways round alike, for nothing here depends on the order of the points.
    const Lanes zero = {};
    const Lanes normals = Dot(a.Normal, b.Normal);
    const Lanes scale = 1.0f + normals;
    const Lanes cosine =
      Dot(a.Axis, b.Axis) * scale - Dot(a.Axis, b.Normal) * Dot(b.Axis, a.Normal);
    const Lanes size = SignOf(cosine) * cosine;
    const Lanes areClose = size > LeastCosine * scale ? zero + 1.0f : zero;
    return { cosine, normals >= zero ? areClose : zero };
  }

  // 1 or 0.
  Lanes IsCrossed(const AxisPoints& a, const AxisPoints& b) const
  {
    const Lanes zero = {};
    const Relation relation = Compare(a, b);
    const Lanes product = a.Field * SignOf(b.Field);
    const Lanes turned = this->Even ? product : Lanes(product * SignOf(relation.Cosine));
    return turned < zero ? relation.AreComparable : zero;
  }

  const LineSurface& Surface;
  const AxisPoint* const Points;
  const bool Even;
};
}

#endif
