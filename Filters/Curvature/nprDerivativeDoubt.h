// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprDerivativeDoubt.h
 * @brief Where the derivatives of curvature that were estimated on a mesh mean something.
 */
#ifndef nprDerivativeDoubt_h
#define nprDerivativeDoubt_h

#include "nprPlaneFacets.h"
#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"
#include "vtkNPRFiltersCurvatureModule.h"

#include <vector>

namespace npr
{
/// Of how many rings of triangles around a point its doubt depends, beyond those of the estimate.
inline constexpr int DoubtReach = FacetReach;

/**
 * How doubtful the derivatives at the points are: from 1 on they mean nothing. At most 10; 0 where
 * there is no area. No unit: it is the same for every size, place and rotation of a mesh.
 *
 * In meshes of CAD programs a few long, thin triangles span a whole fillet, at whose rims the
 * curvature jumps, and what is estimated there is noise. Four things make the doubt:
 *
 * - Thinness: a triangle's longest edge over the height above it, 1.15 where all edges are equal;
 *   of a point the mean over its triangles, by area, and over the points three rings around, for
 *   single slivers do no harm. An error of the curvature becomes one of its derivative that is
 *   larger by so much. The doubt is thinness / 4.2, or more where steps are large.
 * - Step: by how much, in radians, the turn of the normals along one edge changes to that along the
 *   next, says the derivative C: |C(edge)| |edge|, the mean over the point's triangles. By it the
 *   doubt is thinness^2 step / 20: triangles of thinness 2.5 come into doubt at half a turn.
 * - Plane facets: which share of the edges lies in planes of several triangles (see
 *   MeasurePlaneFacets()). Where these are there is no curvature, but at their points that of what
 *   they stand for, and between the two no derivative. From a share of 0.35, which a grid of plane
 *   quadrangles does not reach, to one of 0.5 the doubt grows to 4.
 * - What C leaves unexplained: the difference between the second fundamental forms at the ends of
 *   edges and C(edge), over the size of both. Where this is less than 0.35 of it the doubt shrinks
 *   with it, so that regular meshes are trusted, however thin their triangles are.
 *
 * The idea and the limits are our own. The limits stand in the gap between scans, isosurfaces and
 * tori on the one side (where they take away at most some 1 % of the length of lines) and CAD
 * models with thin triangles on fillets or coarse ones on cylinders on the other (some 60 to 98 %
 * of suggestive contours).
 *
 * @param mesh with its incidence built
 * @param normals unit normals
 * @param tensors second fundamental forms, as tensors in space
 * @param cubics their derivatives, each over MakeTangentFrame(normal)
 */
VTKNPRFILTERSCURVATURE_EXPORT std::vector<float> ComputeDerivativeDoubt(const TriangleMesh& mesh,
  const Tuples<3>& normals, const Tuples<6>& tensors, const Tuples<4>& cubics);
}

#endif
