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

#include <cstddef>

namespace npr
{
struct SurfaceDecimationOptions
{
  std::size_t NumberOfTriangles = 0; ///< to stop at
  double MaximumError = 0.0;         ///< in units of the mesh; 0: any
  double MinimumAngle = 0.0;         ///< degrees
};

/**
 * Collapses edges into one of their ends, the cheapest first, until no more can be or enough are.
 *
 * What a collapse costs is the quadric error of M. Garland, P. Heckbert, "Surface Simplification
 * Using Quadric Error Metrics", SIGGRAPH 1997, with their planes at right angles to the borders, so
 * that these keep their shape; so large triangles come where curvature is small. Where the surface
 * is flat, short edges go first. A collapse must keep the topology; must not turn a triangle by
 * more than 60 degrees; must not make an angle below the minimum, unless it was no larger before;
 * and must leave all points that are gone within the maximum error of the triangles that took their
 * place. Locked points stay.
 *
 * The mesh is not cleaned of what is deleted: points and triangles keep their numbers.
 */
void DecimateSurface(
  HalfEdgeMesh& mesh, const SurfaceDecimationOptions& options, const Progress& progress);
}

#endif
