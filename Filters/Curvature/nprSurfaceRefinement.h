// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSurfaceRefinement.h
 * @brief Splits triangles so that a coarse mesh follows the smooth surface its normals describe.
 */
#ifndef nprSurfaceRefinement_h
#define nprSurfaceRefinement_h

#include "nprProgress.h"
#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"
#include "vtkNPRFiltersCurvatureModule.h"

#include <array>
#include <vector>

namespace npr
{
/**
 * Of how many rings of triangles around it it may depend how a triangle is parted: in each pass of
 * so many as MidpointTurnsReach says, and one more for the edges around the ends of the farthest.
 * Where all edges are parted, each pass has rings half as wide as the one before, and so the sum
 * has a limit. Where some are not, triangles may stay as long as they are while they are parted,
 * along a cylinder for instance, and each of 12 passes may go as far as the first.
 *
 * @param numberOfLevels passes that part every edge; negative: passes that part some
 */
VTKNPRFILTERSCURVATURE_EXPORT int GetRefinementReach(int numberOfLevels);

struct SurfaceRefinementOptions
{
  /// Passes that split every edge; negative: passes split the edges that are too long and turn too
  /// much or have too large a chord error, or without limits to both, are not flat.
  int NumberOfLevels = -1;
  double MaximumEdgeLength = 0.0; // length
  double MaximumTurn = 0.0;       // degrees; 0: of no matter
  double MaximumChordError = 0.0; // length; 0: of no matter
  vtkIdType MaximumNumberOfTriangles = 2000000;
};

/// The points of the coarse mesh come first, then the midpoints, level by level.
struct RefinedSurface
{
  std::vector<TriangleMesh::Vector> Points; ///< relative to the mesh's origin
  Tuples<3> Normals;
  std::vector<TriangleMesh::Triangle> Triangles;
  std::vector<TriangleMesh::Index> SourceTriangles; ///< for each triangle, that of the coarse mesh
  std::vector<TriangleMesh::Index> WeldedPointIds;
  std::vector<unsigned char> BorderPoints;
  /// For each midpoint the ends of its edge: points of the coarse mesh or of earlier levels.
  std::vector<std::array<TriangleMesh::Index, 2>> Parents;
  /// The first midpoint of each level, as an index into Parents, and their number at the end.
  std::vector<TriangleMesh::Index> LevelStarts;

  vtkIdType GetNumberOfCoarsePoints() const
  {
    return static_cast<vtkIdType>(this->Points.size() - this->Parents.size());
  }
};

/**
 * Refines a mesh by midpoints of its edges.
 *
 * A midpoint is moved from the chord to the curve that leaves both ends at right angles to their
 * normals: the edge rule of A. Vlachos et al., "Curved PN Triangles", I3D 2001, scaled so
 * that it is exact not only for parabolas but for spheres and round cylinders. On edges that the
 * preparation has split, all copies move alike: by the shortest way that has the offset of each
 * side along the normal of that side, so that the rim of a cylinder becomes round while its cap
 * stays flat. No move is longer than a fifth of the edge, none folds a triangle at it over or turns
 * a part of it farther from the normals there than the whole was (see nprMidpointTurns.h), and
 * there is none where the normals differ by more than 60 degrees.
 *
 * New normals are the means of those at the ends.
 *
 * Which edges are split depends on the edge alone and is the same for all copies of it, and a
 * triangle is parted by how many of its edges are: so there are no cracks.
 *
 * @param normals unit normals
 * @param weldedPointIds for each point its first copy
 * @param progress when it answers false, the result is incomplete and must not be used
 */
VTKNPRFILTERSCURVATURE_EXPORT RefinedSurface RefineSurface(const TriangleMesh& mesh,
  const Tuples<3>& normals, const std::vector<TriangleMesh::Index>& weldedPointIds,
  const SurfaceRefinementOptions& options, const Progress& progress = IgnoreProgress);
}

#endif
