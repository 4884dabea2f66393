// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSurfaceSubdivision.h
 * @brief One step of Loop's or of the modified butterfly scheme, as weights.
 */
#ifndef nprSurfaceSubdivision_h
#define nprSurfaceSubdivision_h

#include "nprOpenMesh.h"
#include "nprPointStencils.h"

#include <vector>

namespace npr
{
enum class SubdivisionScheme
{
  Loop,
  Butterfly
};

/// Old points keep their numbers; the midpoint of edge e of the half-edge mesh follows as e-th.
struct SubdivisionStep
{
  PointStencils Stencils;
  std::vector<TriangleMesh::Triangle> Triangles; ///< four for each, in its place
  std::vector<TriangleMesh::Index> WeldedPointIds;
};

/**
 * Parts each triangle into four.
 *
 * Loop: C. Loop, "Smooth Subdivision Surfaces Based on Triangles", 1987, with his weights. On
 * borders the rule is that of the cubic B-spline. Butterfly: D. Zorin, P. Schroeder, W. Sweldens,
 * "Interpolating Subdivision for Meshes with Arbitrary Topology", SIGGRAPH 1996; on borders the
 * four-point rule, and points that it wants beyond a border mirrored across it. So a border depends
 * on nothing but itself, and two patches that the preparation has split along a crease stay
 * together; where creases meet, end or reach a border, the point stays in its place.
 *
 * @param weldedPointIds for each point its first copy
 */
SubdivisionStep SubdivideSurface(const HalfEdgeMesh& mesh,
  const std::vector<TriangleMesh::Index>& weldedPointIds, SubdivisionScheme scheme);
}

#endif
