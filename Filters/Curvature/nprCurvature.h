// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCurvature.h
 * @brief The second fundamental form of triangle meshes.
 */
#ifndef nprCurvature_h
#define nprCurvature_h

#include "nprTangentFrame.h"
#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"
#include "vtkNPRFiltersCurvatureModule.h"

#include <array>
#include <cmath>
#include <vector>

namespace npr
{
/// A triangle's edges (edge i lies opposite corner i), a frame of its plane, and its shares of
/// area.
struct VTKNPRFILTERSCURVATURE_EXPORT FaceFrame
{
  FaceFrame(const TriangleMesh& mesh, const TriangleMesh::Triangle& corners);

  /// Mixed Voronoi areas of the corners (see nprCornerAreas.h).
  Eigen::Vector3d GetCornerAreas() const;

  /// The normal of the plane towards the side that a point's normal points to: given normals may
  /// disagree with the winding.
  Eigen::Vector3d GetNormalTowards(const Eigen::Vector3d& pointNormal) const
  {
    return this->Normal.dot(pointNormal) < 0.0 ? Eigen::Vector3d(-this->Normal) : this->Normal;
  }

  std::array<Eigen::Vector3d, 3> Edges;
  Eigen::Vector3d Normal;
  TangentFrame Frame;
  double Area;
  /// False without area, or where the triangle is too thin to say anything about the surface.
  bool IsUsable;
};

/// Principal curvatures, |K1| >= |K2|, and directions, E1 x E2 = normal.
struct PrincipalFrame
{
  double K1;
  double K2;
  Eigen::Vector3d E1;
  Eigen::Vector3d E2;
};

/// At an umbilic (K1 = K2) the directions are arbitrary, but always the same.
VTKNPRFILTERSCURVATURE_EXPORT PrincipalFrame Diagonalise(
  const SymmetricTensor& tensor, const Eigen::Vector3d& normal);

/// Mixed Voronoi areas of the points (needs the incidence); length^2. They add up to the surface's
/// area.
VTKNPRFILTERSCURVATURE_EXPORT std::vector<float> ComputePointAreas(const TriangleMesh& mesh);

/// Principal curvatures and directions of a whole surface.
struct PrincipalFrames
{
  std::vector<float> K1;
  std::vector<float> K2;
  Tuples<3> E1;
  Tuples<3> E2;
};

/// J. J. Koenderink, A. J. van Doorn, "Surface shape and curvature scales", Image and Vision
/// Computing 10(8), 1992: the kind of shape, from -1 (cup) by -0.5 (valley), 0 (saddle) and 0.5
/// (ridge) to 1 (cap). On planes, where it is not defined, 0.
inline float ComputeShapeIndex(float k1, float k2)
{
  return k1 == 0.0f && k2 == 0.0f
    ? 0.0f
    : 0.6366197724f * std::atan2(k1 + k2, std::abs(k1 - k2)); // 2 / pi
}

/// Koenderink and van Doorn 1992: how much shape there is, whatever its kind; 1/length.
inline float ComputeCurvedness(float k1, float k2)
{
  return std::hypot(k1, k2) * 0.7071067812f;
}

VTKNPRFILTERSCURVATURE_EXPORT PrincipalFrames ComputePrincipalFrames(
  const Tuples<6>& tensors, const Tuples<3>& normals);
}

#endif
