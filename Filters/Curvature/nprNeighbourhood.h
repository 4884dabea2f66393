// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprNeighbourhood.h
 * @brief What lies around a point of a mesh, within a radius, for estimators that look farther than
 * one ring of triangles.
 */
#ifndef nprNeighbourhood_h
#define nprNeighbourhood_h

#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"
#include "vtkNPRFiltersCurvatureModule.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace npr
{
/**
 * @class PointGraph
 * @brief The points that share a triangle with each point, ascending.
 */
class VTKNPRFILTERSCURVATURE_EXPORT PointGraph
{
public:
  using Index = TriangleMesh::Index;

  /// @param mesh with its incidence built
  explicit PointGraph(const TriangleMesh& mesh);

  const Index* Begin(Index point) const
  {
    const Row& row = this->Rows[point];
    return row[0] < 0 ? this->Long.data() + (-1 - row[0]) : row.data();
  }
  const Index* End(Index point) const
  {
    const Row& row = this->Rows[point];
    return row[0] < 0 ? this->Begin(point) + row[1] : std::find(row.begin(), row.end(), point);
  }

  /// The neighbours of nearly all points: rows of one length, in one cache line each, so that the
  /// processor need not guess where they end. What is left of a row is the point itself.
  static constexpr int RowSize = 8;
  struct alignas(32) Row : std::array<Index, RowSize>
  {
  };
  /// The point's row, or null where there are more neighbours than fit.
  const Row* FindRow(Index point) const
  {
    const Row& row = this->Rows[point];
    return row[0] < 0 ? nullptr : &row;
  }

private:
  // Where there are more: -1 minus the place of the first in the long list, and their number.
  std::vector<Row> Rows;
  std::vector<Index> Long;
};

/// The mean length of the edges at each point, averaged once more over the point and its
/// neighbours so that it changes smoothly; length. Zero at points without edges.
VTKNPRFILTERSCURVATURE_EXPORT std::vector<float> ComputeMeanEdges(
  const TriangleMesh& mesh, const PointGraph& graph);

/// A point and its unit normal, side by side in memory; the last components are zero.
struct alignas(32) OrientedPoint
{
  Eigen::Vector4f Place;
  Eigen::Vector4f Normal;
};

VTKNPRFILTERSCURVATURE_EXPORT std::vector<OrientedPoint> MakeOrientedPoints(
  const TriangleMesh& mesh, const Tuples<3>& normals);

/**
 * @class Neighbourhood
 * @brief Collects the points around a point that are joined to it within a ball.
 *
 * One object collects for one point after the other, and allocates nothing once its lists have
 * grown; each thread needs its own. What it finds depends on nothing but the mesh, the normals and
 * the arguments.
 */
class VTKNPRFILTERSCURVATURE_EXPORT Neighbourhood
{
public:
  using Index = TriangleMesh::Index;

  /// A point, and where it lies as seen from the centre.
  struct Member
  {
    Eigen::Vector4f Offset; // from the centre; length; the last component is zero
    float SquaredDistance;  // of Offset, in squared radii
    float Turn;             // cosine of the angle between its normal and the centre's
    Index Point;
  };

  /// As thread locals need it; to be assigned to.
  Neighbourhood() = default;
  /// Both must outlive this object.
  Neighbourhood(const PointGraph& graph, const std::vector<OrientedPoint>& points);

  /**
   * The centre and the points that can be reached from it along edges whose points all lie within
   * the radius and have normals turned by less than 90 degrees from the centre's, ring by ring.
   *
   * @param centre the point
   * @param radius length
   * @param rings as many edges at most are followed
   */
  void Collect(Index centre, double radius, int rings);

  /// What estimators take, in mean edges.
  static constexpr double LeastRadius = 1.5;
  static constexpr double GreatestRadius = 40.0;
  static double ClampRadius(double radius)
  {
    return std::clamp(radius, LeastRadius, GreatestRadius);
  }

  /// Of how many edges a path to a point within a radius, in mean edges, may consist.
  static int GetRings(double radius)
  {
    return 2 * static_cast<int>(std::ceil(ClampRadius(radius))) + 2;
  }

  /// What Collect() found; the centre is the first.
  const std::vector<Member>& GetMembers() const { return this->Members; }

  /// No more points than these are looked at: a hub of a fan may have a hundred thousand.
  static constexpr int MaximumSize = 8192;

private:
  std::uint32_t NextStamp();

  const PointGraph* Graph = nullptr;
  const std::vector<OrientedPoint>* Points = nullptr;
  std::vector<Member> Members;
  std::vector<Index> Candidates;
  std::vector<std::uint32_t> PointStamps;
  std::uint32_t Stamp = 0;
};
}

#endif
