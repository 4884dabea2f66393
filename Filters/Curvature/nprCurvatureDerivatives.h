// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCurvatureDerivatives.h
 * @brief The derivative-of-curvature tensor of triangle meshes.
 */
#ifndef nprCurvatureDerivatives_h
#define nprCurvatureDerivatives_h

#include "nprTangentFrame.h"
#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"
#include "vtkNPRFiltersCurvatureModule.h"

namespace npr
{
/// The cubic form C(a,a,a), C(a,a,b), C(a,b,b), C(b,b,b) over a frame (a, b), from the same over
/// (u, v); a and b must lie in the plane of u and v.
VTKNPRFILTERSCURVATURE_EXPORT Eigen::Vector4d ChangeFrame(
  const Eigen::Vector4d& cubic, const TangentFrame& from, const TangentFrame& to);

/**
 * P, Q, S, T at the points in the principal frames (needs the incidence).
 *
 * S. Rusinkiewicz 2004: in each triangle the least squares solution of C(edge) = difference of the
 * second fundamental forms; at a point their mean, weighted by its share of the area.
 *
 * The forms at a border are one-sided, and their error there does not shrink faster than the
 * differences; so triangles at a border count only where there are no others, and a border point
 * takes what its inner neighbours have.
 *
 * @param tensors second fundamental forms, as tensors in space
 * @param normals unit normals
 * @param e1 first principal directions, unit, in the tangent planes
 */
VTKNPRFILTERSCURVATURE_EXPORT Tuples<4> ComputeCurvatureDerivatives(const TriangleMesh& mesh,
  const Tuples<6>& tensors, const Tuples<3>& normals, const Tuples<3>& e1);
}

#endif
