// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprFieldAxes_h
#define nprFieldAxes_h

#include "nprLineSurface.h"
#include "vtkNPRFiltersLinesModule.h"

#include <array>

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
 * axis (the principal curvatures may have swapped): no line crosses such an edge, nor one along
 * which the surface turns by more than a right angle. Nothing is kept for edges, so that axes may
 * change with each view.
 */
class VTKNPRFILTERSLINES_EXPORT FieldAxes
{
public:
  using Index = TriangleMesh::Index;

  /// \p axes are the components of unit vectors in the tangent planes at the points, or 0 where
  /// there is none. They must outlive this, as must the surface, which has loaded its normals.
  /// An \p even field keeps its sign when its axis is turned over: then all that counts is where
  /// axes are not comparable.
  FieldAxes(const LineSurface& surface, const std::array<const float*, 3>& axes, bool even = false);

  /// 1 where the axes at two points point to the same side, -1 where they point to opposite ones, 0
  /// where they are not comparable.
  int GetTurn(Index a, Index b) const { return this->GetTurn(a, b, this->GetCosine(a, b)); }

  /// On which side of its axis a point's value lies. A value of exactly 0 counts as if it lay
  /// slightly off, always to the same side in space.
  bool IsPositive(Index point, const float* field) const
  {
    return field[point] > 0.0f || (field[point] == 0.0f && (this->Even || this->IsForward(point)));
  }

  /// Whether the field changes its sign between the ends.
  bool IsCrossed(Index halfEdge, const float* field) const
  {
    const Index a = this->Surface.GetStart(halfEdge);
    const Index b = this->Surface.GetEnd(halfEdge);
    const bool same = this->IsPositive(a, field) == this->IsPositive(b, field);
    if (this->Even)
    {
      return !same && this->GetTurn(a, b) != 0;
    }
    const float cosine = this->GetCosine(a, b);
    // Few edges pass this, which needs no normals.
    if ((same ? cosine : -cosine) > SureCosine)
    {
      return false;
    }
    const int turn = this->GetTurn(a, b, cosine);
    return turn != 0 && same == (turn < 0);
  }

  /// How fast the field falls along the axis at a point: minus its derivative, from the values at
  /// the neighbours by least squares. 0 where too few have axes that are comparable.
  float ComputeFall(Index point, const float* field) const;

private:
  // Of axes that are closer to parallel than to right angles.
  static constexpr float LeastCosine = 0.70710678f;
  // No turn by less than a right angle takes a cosine above this below -LeastCosine.
  static constexpr float SureCosine = 1.0f - LeastCosine;

  bool IsForward(Index point) const;
  int GetTurn(Index a, Index b, float cosine) const;
  float GetCosine(Index a, Index b) const
  {
    return this->Axes[0][a] * this->Axes[0][b] + this->Axes[1][a] * this->Axes[1][b] +
      this->Axes[2][a] * this->Axes[2][b];
  }
  Eigen::Vector3f GetNormal(Index point) const
  {
    return { this->Normals[0][point], this->Normals[1][point], this->Normals[2][point] };
  }
  Eigen::Vector3f GetAxis(Index point) const
  {
    return { this->Axes[0][point], this->Axes[1][point], this->Axes[2][point] };
  }

  const LineSurface& Surface;
  const bool Even;
  std::array<const float*, 3> Axes;
  std::array<const float*, 3> Normals;
};
}

#endif
