// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPlaneBounds.h
 * @brief On which side of the planes of many triangles the eye is.
 */
#ifndef nprPlaneBounds_h
#define nprPlaneBounds_h

#include "nprLineView.h"
#include "nprTriangleMesh.h"
#include "vtkNPRFiltersLinesModule.h"

#include <Eigen/Core>

#include <array>

namespace npr
{
/// The plane of a triangle. Differences of floats are exact in double precision, and so is all else
/// while coordinates are small whole numbers.
struct TrianglePlane
{
  TrianglePlane(const TriangleMesh& mesh, TriangleMesh::Index triangle);
  Eigen::Vector3d Corner;
  Eigen::Vector3d Normal; ///< as long as twice the area
};

/**
 * @class PlaneBounds
 * @brief A box around the unit normals of some triangles, and how far their planes are from a point
 * between them.
 */
class VTKNPRFILTERSLINES_EXPORT PlaneBounds
{
public:
  using Index = TriangleMesh::Index;

  /// Of the triangles begin <= t < end.
  PlaneBounds(const TriangleMesh& mesh, Index begin, Index end);

  /// Bounds of n.(eye - p), where n is the unit normal and p a point of a triangle; in parallel
  /// projection of n.eye. They are wider by a millionth of the distances than they need be: outside
  /// of them no rounding of the sums for a single triangle, nor of the eye, changes a sign.
  std::array<double, 2> GetRange(const LineView& view) const;

private:
  std::array<float, 3> Centre;
  std::array<float, 3> Low; // of the unit normals
  std::array<float, 3> High;
  std::array<double, 2> Offsets; // n.(p - Centre)
};
}

#endif
