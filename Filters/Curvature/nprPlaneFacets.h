// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPlaneFacets.h
 * @brief How much of a mesh consists of plane facets that several triangles share.
 */
#ifndef nprPlaneFacets_h
#define nprPlaneFacets_h

#include "nprTriangleMesh.h"
#include "vtkNPRFiltersCurvatureModule.h"

#include <vector>

namespace npr
{
/// How many rings the means are taken over.
inline constexpr int FacetRings = 3;

/// Of how many rings of triangles around a point its share depends: twice the means, and the ring
/// that turns are measured in.
inline constexpr int FacetReach = 2 * FacetRings + 1;

/**
 * Which share of the edges of the triangles at each point lies inside a plane, from 0 to 1: those
 * across which the surface turns by less than a fiftieth of what it does in the quadratic mean
 * around, or by no more than what rounding may do. Triangles count by their areas, and the share is
 * the mean over the points three rings around, as the turn is.
 *
 * Programs for CAD put points only where a face's curvature asks for them, so between two lines of
 * a cylinder, and all over flat faces, many triangles lie in one plane. On scans and isosurfaces
 * hardly any two do. In a grid of plane quadrangles, as of a surface of revolution, a third of the
 * edges are such. No unit, and the same at every size, place and rotation.
 *
 * @param mesh with its incidence built
 */
VTKNPRFILTERSCURVATURE_EXPORT std::vector<float> MeasurePlaneFacets(const TriangleMesh& mesh);
}

#endif
