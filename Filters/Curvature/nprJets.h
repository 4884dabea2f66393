// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprJets_h
#define nprJets_h

#include "nprCurvatureEstimator.h"
#include "nprNeighbourhood.h"

namespace npr
{
/**
 * @class Jets
 * @brief Curvature from polynomials fitted to the points around: F. Cazals, M. Pouget, "Estimating
 * Differential Quantities Using Polynomial Fitting of Osculating Jets", Computer Aided Geometric
 * Design 22(2), 2005.
 *
 * At each point a polynomial of the given degree in the tangent plane is fitted to the heights of
 * the points within a radius, weighted so that a point's influence fades to nothing at the radius;
 * the surface's normal, second fundamental form and its derivative are those of the polynomial's
 * graph at the centre. With the degree d and the radius r the form's error falls as r^(d-1) and its
 * derivative's as r^(d-2), on meshes as irregular as you like, at borders too.
 *
 * Noise of the points is divided by r^2 in the form and by r^3 in its derivative. So the automatic
 * radius is as small as the fit allows on clean meshes, and on noisy ones as large as it takes to
 * balance the noise, which the residuals of fits at a sample of points tell, against what a
 * polynomial can not follow. There is one for the whole surface, in units of the edges around each
 * point: radii chosen one by one would make the fields jump.
 *
 * Where too few points are near, or they lie badly, the radius grows, then the degree falls; where
 * not even a quadric can be fitted, the triangles around the point must do (nprFaceCurvature.h).
 */
class VTKNPRFILTERSCURVATURE_EXPORT Jets : public CurvatureEstimator
{
public:
  struct Options
  {
    /// Of the polynomials, 2 to 4. With 2 the derivatives do not converge.
    int Degree = 4;
    /// Radius in mean edges; 0 chooses it. Clamped to [LeastRadius, GreatestRadius].
    double Radius = 0.0;
    /// The radius as a length instead, where it is positive; it is clamped likewise.
    double Length = 0.0;
  };
  static constexpr double LeastRadius = Neighbourhood::LeastRadius;
  static constexpr double GreatestRadius = Neighbourhood::GreatestRadius;

  Jets() = default;
  explicit Jets(const Options& options) : Fit(options) {}

  int GetReach() const override;
  bool FindsNormals() const override { return true; }
  CurvatureEstimate Estimate(const TriangleMesh& mesh, const Tuples<3>& normals, bool derivatives,
    const Progress& progress) const override;

private:
  Options Fit;
};
}

#endif
