// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSurfaceDecimation.h
 * @brief Takes points from a half-edge mesh, where they change its shape least.
 */
#ifndef nprSurfaceDecimation_h
#define nprSurfaceDecimation_h

#include "nprOpenMesh.h"
#include "nprProgress.h"
#include "nprTriangleMesh.h"

#include <cstddef>
#include <vector>

namespace npr
{
struct SurfaceDecimationOptions
{
  std::size_t NumberOfTriangles = 0; ///< to stop at
  double MaximumError = 0.0;         ///< in units of the mesh; 0: any
  double MinimumAngle = 0.0;         ///< degrees
};

/// One point became a part of another, which may have moved.
struct PointMerge
{
  TriangleMesh::Index Kept;
  TriangleMesh::Index Gone;
  double Share; ///< of what is gone, in [0, 1]
};

/**
 * Collapses edges into points, the cheapest first, until no more can be or enough are.
 *
 * What a collapse costs, and where its point comes to lie, is by the quadric error of M. Garland,
 * P. Heckbert, "Surface Simplification Using Quadric Error Metrics", SIGGRAPH 1997, with their
 * planes at right angles to the borders, so that these keep their shape; so large triangles come
 * where curvature is small. Where that leaves the point free, as on flat parts, it takes the middle
 * of the edge, and short edges go first. A collapse must keep the topology; must not turn a
 * triangle by more than 60 degrees; must not make an angle below the minimum, unless it was no
 * larger before; and must leave all points of the input within the maximum error of the triangles
 * that took their place. Where the best place would break one of these, the middle of the edge and
 * its ends are tried. Locked points stay; a point of a border moves only along with its border.
 *
 * The mesh is not cleaned of what is deleted: points and triangles keep their numbers.
 *
 * @return what went where, in the order in which it did
 */
std::vector<PointMerge> DecimateSurface(
  HalfEdgeMesh& mesh, const SurfaceDecimationOptions& options, const Progress& progress);
}

#endif
