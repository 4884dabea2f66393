// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprDirectionTracer.h
 * @brief Evenly spaced curves along a field of axes on a triangle mesh.
 */
#ifndef nprDirectionTracer_h
#define nprDirectionTracer_h

#include "nprProgress.h"
#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace npr
{
/// A point of a curve; its place is relative to the mesh's origin.
struct TracedPoint
{
  Eigen::Vector3d Position;
  Eigen::Vector3d Normal; ///< of the triangle
  double Strength;
};
using TracedCurve = std::vector<TracedPoint>;

/**
 * Follows axes along a surface. Curves are seeded at random places, evenly over the area, and one
 * after another keep their distance from those before (B. Jobard, W. Lefer 1997).
 */
class DirectionTracer
{
public:
  /**
   * @param mesh with its neighbours built
   * @param axes for each point; the sign plays no part
   * @param strengths for each point, or empty for 1
   * @param spacing distance between curves; length
   * @param length of the longest curves; length
   */
  DirectionTracer(const TriangleMesh& mesh, const Tuples<3>& axes,
    const std::vector<float>& strengths, double spacing, double length);

  std::vector<TracedCurve> Trace(const Progress& progress);

private:
  struct Place
  {
    TriangleMesh::Index Triangle;
    Eigen::Vector3d Weights;
  };

  Eigen::Vector3d GetPosition(const Place& place) const;
  Eigen::Vector3d GetNormal(TriangleMesh::Index triangle) const;
  double GetStrength(const Place& place) const;
  /// The axis there, with the sign that is nearer to `towards`; zero where the corners disagree.
  Eigen::Vector3d GetDirection(const Place& place, const Eigen::Vector3d& towards) const;
  /// One half of a curve, without its beginning.
  TracedCurve Follow(Place place, Eigen::Vector3d towards) const;
  TracedPoint MakePoint(const Place& place) const;

  bool IsCrowded(const TracedPoint& point, double distance) const;
  void Remember(const TracedCurve& curve);
  std::array<std::int64_t, 3> GetCell(const Eigen::Vector3d& position) const;

  struct Hash
  {
    std::size_t operator()(const std::array<std::int64_t, 3>& cell) const
    {
      return static_cast<std::size_t>(cell[0] * 73856093 ^ cell[1] * 19349663 ^ cell[2] * 83492791);
    }
  };

  const TriangleMesh& Mesh;
  const Tuples<3>& Axes;
  const std::vector<float>& Strengths;
  double Spacing;
  double HalfLength;
  std::unordered_map<std::array<std::int64_t, 3>, std::vector<TracedPoint>, Hash> Taken;
};
}

#endif
