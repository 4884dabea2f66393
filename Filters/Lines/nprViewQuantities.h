// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprViewQuantities.h
 * @brief What is known at each point of a surface in a view, by the names of the literature.
 *
 * Lines of our own, expressions and callbacks all take their values from here, so that the same
 * formula gives the same bits wherever it is written.
 *
 * Curvatures have no unit: k1, k2, H and kr are multiplied by the surface's length scale, and K, P,
 * Q, S, T and dwkr by its square.
 */
#ifndef nprViewQuantities_h
#define nprViewQuantities_h

#include "vtkNPRFiltersLinesModule.h"
#include "vtkNPRLineDefinition.h"

#include <string>
#include <vector>

namespace npr
{
/// Points of a surface: a range, or a list.
class PointSpan
{
public:
  using Index = TriangleMesh::Index;

  /// The points begin <= i < end.
  static PointSpan Range(vtkIdType begin, vtkIdType end) { return { nullptr, begin, end - begin }; }
  static PointSpan List(const Index* points, vtkIdType count) { return { points, 0, count }; }

  vtkIdType GetNumberOfPoints() const { return this->Count; }
  Index operator[](vtkIdType i) const
  {
    return this->Points ? this->Points[i] : static_cast<Index>(this->First + i);
  }
  /// The points from <= i < to of this one.
  PointSpan GetPart(vtkIdType from, vtkIdType to) const
  {
    return this->Points ? List(this->Points + from, to - from)
                        : Range(this->First + from, this->First + to);
  }

private:
  PointSpan(const Index* points, vtkIdType first, vtkIdType count)
    : Points(points), First(first), Count(count)
  {
  }

  const Index* Points; // null for a range
  vtkIdType First;
  vtkIdType Count;
};

/// A quantity by its name.
struct ViewQuantity
{
  const char* Name;
  const char* Description;
  int Components; ///< 1, or 3 for a vector.
  bool ViewDependent;
  std::vector<vtkNPRLineDefinition::RequiredArray> Arrays; ///< What it is made from.
  /// Writes one component at so many points. Safe to call from several threads.
  void (*Evaluate)(const LineSurface& surface, const LineView& view, const PointSpan& points,
    int component, double* values);
};

/// All of them: ndotv, sintheta, kr, dwkr, k1, k2, K, H, P, Q, S, T, e1, e2, n, v, w, p.
VTKNPRFILTERSLINES_EXPORT const std::vector<ViewQuantity>& GetViewQuantities();

/// Null when there is none of the name.
VTKNPRFILTERSLINES_EXPORT const ViewQuantity* FindViewQuantity(const std::string& name);

/// Their names, parted by commas.
VTKNPRFILTERSLINES_EXPORT std::string DescribeViewQuantities();

/// radialCurvature[i - begin] = kr at the points begin <= i < end: II(w,w) / |w|^2 times the length
/// scale, where w is the part of the direction to the eye in the tangent plane. 0 where the surface
/// is seen head-on.
VTKNPRFILTERSLINES_EXPORT void EvaluateRadialCurvature(const LineSurface& surface,
  const LineView& view, vtkIdType begin, vtkIdType end, float* radialCurvature);

/// The cosine (ndotv) and sine (sintheta) of the angle between normal and eye, and the derivative
/// of kr towards the eye where kr is 0 (dwkr): C(w,w,w) / |w|^3 + 2 K cot, times the length scale
/// squared; 0 where the surface is seen head-on. Any of the three may be null.
VTKNPRFILTERSLINES_EXPORT void EvaluateRadialDerivative(const LineSurface& surface,
  const LineView& view, const PointSpan& points, double* cosine, double* sine, double* derivative);
}

#endif
