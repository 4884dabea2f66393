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
#include <cmath>
#include <cstdint>
#include <vector>

namespace npr
{
/**
 * @class PointGraph
 * @brief The points that share a triangle with each point, ascending, in one flat list.
 */
class VTKNPRFILTERSCURVATURE_EXPORT PointGraph
{
public:
  using Index = TriangleMesh::Index;

  /// @param mesh with its incidence built
  explicit PointGraph(const TriangleMesh& mesh);

  const Index* Begin(Index point) const { return this->Neighbours.data() + this->Offsets[point]; }
  const Index* End(Index point) const { return this->Neighbours.data() + this->Offsets[point + 1]; }
  Index GetNumberOfPoints() const { return static_cast<Index>(this->Offsets.size()) - 1; }

private:
  std::vector<Index> Offsets;
  std::vector<Index> Neighbours;
};

/// The mean length of the edges at each point, averaged once more over the point and its
/// neighbours so that it changes smoothly; length. Zero at points without edges.
VTKNPRFILTERSCURVATURE_EXPORT std::vector<float> ComputeMeanEdges(
  const TriangleMesh& mesh, const PointGraph& graph);

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
    Index Point;
    float Turn;             // cosine of the angle between its normal and the centre's
    Eigen::Vector3d Offset; // from the centre; length
    double SquaredDistance; // of Offset
  };

  /// As thread locals need it; to be assigned to.
  Neighbourhood() = default;
  /// All three must outlive this object. The mesh needs its incidence.
  Neighbourhood(const TriangleMesh& mesh, const PointGraph& graph, const Tuples<3>& normals);

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

  const TriangleMesh* Mesh = nullptr;
  const PointGraph* Graph = nullptr;
  const Tuples<3>* Normals = nullptr;
  std::vector<Member> Members;
  std::vector<Index> Candidates;
  std::vector<std::uint32_t> PointStamps;
  std::uint32_t Stamp = 0;
};
}

#endif
