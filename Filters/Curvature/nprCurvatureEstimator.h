// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCurvatureEstimator.h
 * @brief What every way to estimate the curvature of a mesh takes and gives.
 */
#ifndef nprCurvatureEstimator_h
#define nprCurvatureEstimator_h

#include "nprProgress.h"
#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"
#include "vtkNPRFiltersCurvatureModule.h"

#include <vector>

namespace npr
{
/// The geometry of a surface at its points. Signs as everywhere: a sphere with outward normals has
/// positive curvature.
struct CurvatureEstimate
{
  /// Unit normals that all else refers to: those given, or better ones that the estimator found.
  Tuples<3> Normals;
  /// Second fundamental forms, as tensors in space; 1/length.
  Tuples<6> Tensors;
  /// The derivatives of the form, C(u,u,u), C(u,u,v), C(u,v,v), C(v,v,v), over the frame (u, v) =
  /// MakeTangentFrame(normal); 1/length^2. Empty unless asked for.
  Tuples<4> Derivatives;
  /// 1 where nothing can be said; tensor and derivatives are zero there.
  std::vector<unsigned char> Unknown;
  /// The radius of the neighbourhoods in mean edges, where the estimator has one for all points.
  double Radius = 0.0;
};

/**
 * @class CurvatureEstimator
 * @brief A way to estimate the second fundamental form at the points of a triangle mesh, and its
 * derivatives.
 *
 * The result is the same for any number of threads, and depends on nothing farther from a point
 * than GetReach() rings of triangles.
 */
class VTKNPRFILTERSCURVATURE_EXPORT CurvatureEstimator
{
public:
  virtual ~CurvatureEstimator() = default;

  /// Of how many rings of triangles around a point its estimate may depend, derivatives included.
  virtual int GetReach() const = 0;

  /// Whether the normals of the result are the estimator's own.
  virtual bool FindsNormals() const { return false; }

  /**
   * @param mesh with its incidence built
   * @param normals unit normals, one for each point
   * @param derivatives whether these are wanted
   * @param progress when it answers false, the result is incomplete and must not be used
   */
  virtual CurvatureEstimate Estimate(const TriangleMesh& mesh, const Tuples<3>& normals,
    bool derivatives, const Progress& progress) const = 0;
};
}

#endif
