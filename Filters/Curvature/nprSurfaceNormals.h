// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSurfaceNormals.h
 * @brief Vertex normals of triangle meshes.
 */
#ifndef nprSurfaceNormals_h
#define nprSurfaceNormals_h

#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"
#include "nprVTKCompat.h"
#include "vtkNPRFiltersCurvatureModule.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// How much a triangle counts at a corner.
enum class NormalWeights
{
  Max,  ///< area / (|a|^2 |b|^2), a and b its edges there: exact on spheres (Max 1999)
  Area, ///< its area
  Angle ///< its angle there
};

/// Of how many rings of triangles around a point its normal may depend: one, and up to eight
/// more where that of a border follows those of its neighbours, and of those next to them.
inline constexpr int NormalsReach = 9;

/**
 * Unit normals at the points (needs the incidence).
 *
 * On a border half of the neighbourhood is missing, and every weighting leans to one side. There
 * the normal is turned so that it and the normals of its inner neighbours make equal angles with
 * the edges between them, as on a circle: exact to second order. So are those of the corners of
 * strips, which have no inner points, by their neighbours along the border, if they are sampled
 * alike. A point where nothing is known (no triangle, no area) gets the normal of its largest
 * triangle, or else the z axis; never NaN.
 */
VTKNPRFILTERSCURVATURE_EXPORT Tuples<3> ComputeNormals(
  const TriangleMesh& mesh, NormalWeights weights);

/// The normals that an array gives, made unit length; where it gives none that is finite and not
/// zero, or where the array is null or of the wrong size, computed ones (needs the incidence).
VTKNPRFILTERSCURVATURE_EXPORT Tuples<3> GetUnitNormals(
  const TriangleMesh& mesh, vtkDataArray* given);

/// For each point whether it lies on a border, counting splits along creases (needs the incidence).
VTKNPRFILTERSCURVATURE_EXPORT std::vector<unsigned char> ComputeBorderPoints(
  const TriangleMesh& mesh);
}

#endif
