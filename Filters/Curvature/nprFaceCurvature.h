// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprFaceCurvature_h
#define nprFaceCurvature_h

#include "nprCurvatureEstimator.h"

namespace npr
{
/**
 * @class FaceCurvature
 * @brief Curvature from the triangles at a point: S. Rusinkiewicz, "Estimating Curvatures and Their
 * Derivatives on Triangle Meshes", 3DPVT 2004.
 *
 * The fastest, and exact to second order on regular meshes. On irregular ones the curvature stalls
 * at a few per cent and its derivatives grow with every refinement.
 */
class VTKNPRFILTERSCURVATURE_EXPORT FaceCurvature : public CurvatureEstimator
{
public:
  int GetReach() const override { return 4; }
  CurvatureEstimate Estimate(const TriangleMesh& mesh, const Tuples<3>& normals, bool derivatives,
    const Progress& progress) const override;

  /// The same at some different points only, in their order; takes the time of what lies around
  /// them.
  CurvatureEstimate EstimateAt(const std::vector<TriangleMesh::Index>& points,
    const TriangleMesh& mesh, const Tuples<3>& normals, bool derivatives) const;
};
}

#endif
