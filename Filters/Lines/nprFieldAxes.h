// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprFieldAxes_h
#define nprFieldAxes_h

#include "nprLineSurface.h"
#include "vtkNPRFiltersLinesModule.h"

#include <vector>

namespace npr
{
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
 * axis (the principal curvatures may have swapped): no line crosses such an edge.
 */
class VTKNPRFILTERSLINES_EXPORT FieldAxes
{
public:
  using Index = TriangleMesh::Index;

  /// The surface, which has loaded its normals, must outlive this.
  explicit FieldAxes(const LineSurface& surface);

  /// The components of the axes at the points, unit vectors, or 0 where there is none.
  void SetVectors(const std::array<const float*, 3>& axes) { this->Axes = axes; }
  /// Compares axes that no view changes, once for all.
  void Compare();

  /// 1 where the axes at the ends of a half-edge point to the same side, -1 where they point to
  /// opposite ones, 0 where they are not comparable.
  int GetTurn(Index halfEdge) const
  {
    return this->Turns.empty() ? this->CompareQuickly(halfEdge) : this->Turns[halfEdge];
  }

  /// On which side of its axis a point's value lies. A value of exactly 0 counts as if it lay
  /// slightly off, always to the same side in space.
  bool IsPositive(Index point, const float* field) const
  {
    return field[point] > 0.0f || (field[point] == 0.0f && this->IsForward(point));
  }

  /// Whether the field changes its sign between the ends.
  bool IsCrossed(Index halfEdge, const float* field) const
  {
    const bool same = this->IsPositive(this->Surface.GetStart(halfEdge), field) ==
      this->IsPositive(this->Surface.GetEnd(halfEdge), field);
    const int turn = this->GetTurn(halfEdge);
    return turn != 0 && same == (turn < 0);
  }

  /// For some points how fast the field falls along the axis: minus its derivative, a mean over the
  /// triangles at the point by their areas. 0 where no axes are comparable.
  void ComputeFall(
    const float* field, const std::vector<Index>& points, std::vector<float>& fall) const;

private:
  bool IsForward(Index point) const;
  int Compare(Index a, Index b) const;
  /// In the plane of the axes themselves: near enough between neighbours whose axes change in every
  /// view.
  int CompareQuickly(Index halfEdge) const;
  Eigen::Vector3d GetAxis(Index point) const
  {
    return { this->Axes[0][point], this->Axes[1][point], this->Axes[2][point] };
  }

  const LineSurface& Surface;
  std::array<const float*, 3> Axes = { nullptr, nullptr, nullptr };
  std::array<const float*, 3> Normals;
  std::vector<signed char> Turns; // empty where axes are compared when asked for
};
}

#endif
