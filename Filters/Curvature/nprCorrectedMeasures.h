// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprCorrectedMeasures_h
#define nprCorrectedMeasures_h

#include "nprCurvatureEstimator.h"

namespace npr
{
/**
 * @class CorrectedMeasures
 * @brief Curvature from measures over a neighbourhood: J.-O. Lachaud, P. Romon, B. Thibert, D.
 * Coeurjolly, "Interpolated Corrected Curvature Measures for Polygonal Surfaces", Computer Graphics
 * Forum 39(5), 2020.
 *
 * Over a triangle along which the normals are interpolated, the area and the second fundamental
 * form have integrals in closed form, and these hold for whatever normals are better than those of
 * the triangles themselves. They are collected at the points, a third at each corner of the
 * triangle, which is to say that a neighbourhood's weight is interpolated, too. Around a point they
 * are added up with a weight that fades to nothing at the radius, each form turned into the point's
 * tangent plane; their quotient is the curvature. In place of the plain mean, a linear function is
 * fitted to the forms over the tangent plane: at the centre it is the mean where the neighbourhood
 * lies all around, and right to second order also where it does not, as at borders; and its slope
 * is the derivative of the form.
 *
 * Normals computed from the triangles around a point are right to first order only on irregular
 * meshes. So all is done twice: with the forms of the first round, the normals are fitted to the
 * edges so that the surface between two points bends as the forms at its ends say. That makes them
 * right to third order, and the second round gets curvature to second, its derivative to about
 * first order in the radius.
 *
 * What the edges leave over after that fit tells the noise of the points. The automatic radius is
 * small on clean meshes, and on noisy ones as large as it takes to balance the noise against the
 * change of curvature within the radius. There is one for the whole surface, in units of the edges
 * around each point.
 */
class VTKNPRFILTERSCURVATURE_EXPORT CorrectedMeasures : public CurvatureEstimator
{
public:
  struct Options
  {
    /// Radius in mean edges; 0 chooses it. Clamped to the least and the greatest of Neighbourhood.
    double Radius = 0.0;
    /// The radius as a length instead, where it is positive; it is clamped likewise.
    double Length = 0.0;
  };
  CorrectedMeasures() = default;
  explicit CorrectedMeasures(const Options& options) : Wanted(options) {}

  int GetReach() const override;
  bool FindsNormals() const override { return true; }
  CurvatureEstimate Estimate(const TriangleMesh& mesh, const Tuples<3>& normals, bool derivatives,
    const Progress& progress) const override;

private:
  Options Wanted;
};
}

#endif
