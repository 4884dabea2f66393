// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprMidpointTurns.h
 * @brief Keeps triangles that are parted at moved midpoints from turning away from their normals.
 */
#ifndef nprMidpointTurns_h
#define nprMidpointTurns_h

#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"

#include <vector>

namespace npr
{
/// How often moves are lessened.
inline constexpr int MidpointTurnsRounds = 3;
/// Of how many rings of triangles around an edge it may depend how its move is lessened. Each round
/// goes from an edge of a triangle to another one, and the two have a point in common: so two
/// rounds see the triangles around the same points, and every second goes one ring farther.
inline constexpr int MidpointTurnsReach = (MidpointTurnsRounds + 1) / 2;

/**
 * Lessens moves of midpoints of edges where they would turn a part of a triangle farther from the
 * normals at its corners than the whole triangle is from those at its own. Of a smooth surface,
 * parts are nearer to it than the whole. But in a row of slivers, such as a finely sampled fillet
 * along a plane, an edge that rises no farther than its chord's error says, beside one that stays,
 * can tip the sliver between the two over; where all edges of the row rise alike, none does.
 *
 * The longest move at such a triangle is halved, a few times over, and for all triangles at once,
 * so that the result does not depend on their order.
 *
 * @param mesh with its edges built
 * @param normals unit normals at its points
 * @param firstCopies for each edge that whose move it shares
 * @param moves from the middle of each edge that is its own first copy
 */
void LimitTurns(const TriangleMesh& mesh, const Tuples<3>& normals,
  const std::vector<TriangleMesh::Index>& firstCopies, std::vector<Eigen::Vector3d>& moves);
}

#endif
