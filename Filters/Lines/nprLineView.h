// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLineView.h
 * @brief Cameras as lines need them: where the eye is, and how long a line looks.
 */
#ifndef nprLineView_h
#define nprLineView_h

#include "nprVTKCompat.h"
#include "vtkNPRFiltersLinesModule.h"

#include <Eigen/Core>

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class LineView
 * @brief Where the eye is, in the space of the model and relative to the origin of a LineSurface.
 *
 * The vector from a point p to the eye is Eye - Perspective * p, so that one loop without a branch
 * serves both projections: Perspective is 1 and Eye a position, or Perspective is 0 and Eye the
 * unit vector towards the eye.
 */
struct LineView
{
  std::array<float, 3> Eye = { 0.0f, 0.0f, 1.0f };
  float Perspective = 0.0f;
  /// Directions as the model sees them: to the right of the viewer, upwards, and towards the
  /// viewer. Those between are sums of them; they are no unit vectors where a prop is scaled.
  std::array<Eigen::Vector3f, 3> Axes = { Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitY(),
    Eigen::Vector3f::UnitZ() };
};

/// The view of a camera. \p origin is that of the LineSurface, in the space of the model. False
/// when the matrix has no inverse.
VTKNPRFILTERSLINES_EXPORT bool MakeLineView(vtkCamera* camera, const Eigen::Matrix4d& modelToWorld,
  const Eigen::Vector3d& origin, LineView& view);

/**
 * @class LineRuler
 * @brief Measures lines as a camera sees them, in heights of its view.
 */
class VTKNPRFILTERSLINES_EXPORT LineRuler
{
public:
  LineRuler(vtkCamera* camera, const Eigen::Matrix4d& modelToWorld, const Eigen::Vector3d& origin);

  /// The length of a straight piece, its ends relative to the origin. Pieces behind the eye count
  /// as if they were in front.
  double Measure(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  /// How far a point, relative to the origin, is from the eye in the world; with a parallel
  /// projection, from the plane through the camera across its direction.
  double GetDistance(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d ray = this->Linear * point + this->Offset - this->Eye;
    return this->Parallel ? ray.dot(this->Direction) : ray.norm();
  }

private:
  const Eigen::Matrix3d Linear;
  const Eigen::Vector3d Offset;
  const Eigen::Vector3d Eye;
  const Eigen::Vector3d Direction;
  const bool Parallel;
  const double HalfHeight;
};
}

#endif
