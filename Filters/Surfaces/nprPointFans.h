// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPointFans.h
 * @brief The fans of triangles around points, and a point of its own for each of them.
 *
 * A surface is a manifold if each edge has at most two triangles and each point one fan.
 * Cutting it where it is not, without joining anything again, is the first half of Gueziec,
 * Taubin, Lazarus and Horn, "Cutting and Stitching: Converting Sets of Polygons to Manifold
 * Surfaces", IEEE TVCG 7(2), 2001.
 */
#ifndef nprPointFans_h
#define nprPointFans_h

#include "nprTriangleMesh.h"
#include "vtkNPRFiltersSurfacesModule.h"

#include <array>
#include <vector>

namespace npr
{
/// For each triangle, for each of its edges, whether it has some property, such as to be a crease.
using EdgeFlags = std::vector<std::array<unsigned char, 3>>;

/// Which corner of a triangle a point is.
inline int FindCorner(const TriangleMesh::Triangle& corners, TriangleMesh::Index point)
{
  return corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
}

/// Whether a triangle at the edge from `from` to `to` runs through it the other way.
inline bool RunsOppositely(
  const TriangleMesh::Triangle& corners, TriangleMesh::Index from, TriangleMesh::Index to)
{
  return corners[(FindCorner(corners, to) + 1) % 3] == from;
}

/// Where the mesh is no manifold.
struct NonManifoldCounts
{
  vtkIdType Edges = 0;  ///< with more than two triangles
  vtkIdType Points = 0; ///< with more than one fan of triangles, at none of those edges
};
/// Needs the neighbours.
VTKNPRFILTERSSURFACES_EXPORT NonManifoldCounts CountNonManifold(const TriangleMesh& mesh);

/// Edges whose two triangles are oriented against each other (needs the neighbours). After
/// OrientTriangles() there are some only where it can not be otherwise, as on a Moebius strip.
VTKNPRFILTERSSURFACES_EXPORT EdgeFlags FindDisagreements(const TriangleMesh& mesh);

/// How many edges have a flag that their triangles on both sides have.
VTKNPRFILTERSSURFACES_EXPORT vtkIdType CountEdges(const EdgeFlags& flags);

/**
 * Gives each fan of triangles around a point a copy of the point of its own (needs the
 * neighbours). Fans are parted by borders, non-manifold edges and the cuts. The first fan keeps the
 * point; the copies are numbered from the number of points on. Afterwards the mesh is a manifold.
 *
 * @param cuts edges to part fans at; may be empty for none
 * @param onlyAtCuts points that no cut touches stay as they are, manifold or not
 * @param triangles in: those of the mesh; out: with the copies in place
 * @return for each copy, the point that it is a copy of
 */
VTKNPRFILTERSSURFACES_EXPORT std::vector<TriangleMesh::Index> SplitPoints(const TriangleMesh& mesh,
  const EdgeFlags& cuts, bool onlyAtCuts, std::vector<TriangleMesh::Triangle>& triangles);
}

#endif
