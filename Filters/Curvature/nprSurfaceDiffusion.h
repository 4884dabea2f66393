// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSurfaceDiffusion.h
 * @brief Smoothing of normals, tensors and cubic forms along a surface.
 *
 * The heat equation, run for the time radius^2 / 2: on a plane the same as a Gaussian filter whose
 * standard deviation is the radius. The Laplacian is the cotangent one, so that the result depends
 * on the surface and not (to first order) on its triangles; what lies in tangent planes is turned
 * from one to the other, so that nothing is lost on curved surfaces. Nothing flows across borders,
 * and so none across creases where the preparation has split them.
 *
 * The work grows with radius / edge length, and ends at 1000 evaluations of the Laplacian: at about
 * 100 edges.
 */
#ifndef nprSurfaceDiffusion_h
#define nprSurfaceDiffusion_h

#include "nprProgress.h"
#include "nprTangentFrame.h"
#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"
#include "vtkNPRFiltersCurvatureModule.h"

#include <complex>
#include <vector>

namespace npr
{
/// Of how many rings of triangles a filter that smooths asks other pieces for. How many a radius is
/// can not be known before the triangles are; these hold six radii of four edges each, beyond which
/// a Gaussian has nothing.
inline constexpr int DiffusionReach = 24;

/// The weights of one surface, for any number of fields on it.
class VTKNPRFILTERSCURVATURE_EXPORT SurfaceDiffusion
{
public:
  /// Smooths nothing.
  SurfaceDiffusion() = default;
  /// Needs the mesh's incidence, and keeps no reference to mesh or normals.
  SurfaceDiffusion(const TriangleMesh& mesh, const Tuples<3>& normals);

  /**
   * Lets less flow where the surface bends, so that ridges stay sharp while flat parts are
   * smoothed, and a ridge is smoothed along itself: along an edge over whose length l the normals
   * turn by the angle a, the flow is reduced by exp(-(strength radius a / l)^2). The angles are
   * those of normals smoothed by half the radius, so that noise does not pass for a feature (as P.
   * Perona, J. Malik, PAMI 12(7), 1990, and F. Catte et al., SIAM J. Numer. Anal. 29(1), 1992, do
   * for images).
   *
   * @param mesh the one that this object was made from
   * @param strength 0 changes nothing; at 1, what bends with a radius of curvature of `radius` lets
   * a third through
   * @param radius of the smoothing to come; length
   */
  void PreserveFeatures(const TriangleMesh& mesh, double strength, double radius);

  /// The frame that a point's complex values refer to.
  TangentFrame GetFrame(TriangleMesh::Index point) const;

  /// A field of values that turn by `spin` times the angle by which their frame turns: 0 for pairs
  /// of scalars, 1 for tangent vectors, 2 and 3 for the parts of tensors and cubic forms.
  using Field = std::vector<std::complex<float>>;
  /// @param radius standard deviation of the smoothing; length
  /// @param progress when it answers false, the result is incomplete and must not be used
  void Smooth(
    Field& field, int spin, double radius, const Progress& progress = IgnoreProgress) const;

  void SmoothNormals(
    Tuples<3>& normals, double radius, const Progress& progress = IgnoreProgress) const;
  void SmoothTensors(
    Tuples<6>& tensors, double radius, const Progress& progress = IgnoreProgress) const;
  /// @param e1 first unit vectors of the frames that the cubic forms refer to
  void SmoothCubics(Tuples<4>& cubics, const Tuples<3>& e1, double radius,
    const Progress& progress = IgnoreProgress) const;

private:
  double GetHeatCapacity(double largestRate) const;

  struct Link
  {
    TriangleMesh::Index To;
    float Weight;                // 1 / length^2
    std::complex<float> Turning; // from the neighbour's frame to one's own
  };

  std::vector<TriangleMesh::Index> Offsets; // of each point's first link
  std::vector<TriangleMesh::Index> Ends;    // behind each point's last link
  std::vector<Link> Links;
  std::vector<float> Rates; // sums of the weights' magnitudes
  std::vector<float> Areas;
  double MeanRate = 0.0; // over the area
  Tuples<3> Normals;
};
}

#endif
