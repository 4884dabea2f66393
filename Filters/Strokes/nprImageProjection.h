// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprImageProjection_h
#define nprImageProjection_h

#include "nprVTKCompat.h"

#include <Eigen/Core>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class ImageProjection
 * @brief Where places are in a camera's image, in pixels.
 *
 * Places are in the world, relative to a centre. Clipping planes do not count: with a perspective
 * projection all is in view that is in front of the plane through the eye, with a parallel one all
 * is.
 */
class ImageProjection
{
public:
  /// \p height of the image in pixels; \p size of what is looked at, in the world.
  ImageProjection(vtkCamera* camera, const Eigen::Vector3d& centre, double height, double size);

  /// Whether the camera looks anywhere and has an angle or a scale.
  bool IsValid() const { return this->Valid; }
  bool IsParallel() const { return this->Parallel; }

  /// A place in the image: x to the right and y upwards from its middle, and the distance from the
  /// plane through the eye.
  struct Place
  {
    Eigen::Vector2d Pixel;
    double Depth;
  };
  /// Pixels mean nothing where IsInFront() is false.
  Place Project(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d seen = this->ToView * (point - this->Eye);
    const double scale = this->Parallel ? this->Scale : this->Scale / seen.z();
    return { scale * seen.head<2>(), seen.z() };
  }
  bool IsInFront(double depth) const { return this->Parallel || depth > this->Nearest; }
  /// The least depth that is in front of the eye.
  double GetNearest() const { return this->Nearest; }

  /// Towards the eye, not normalised: with a perspective projection the vector that ends there.
  Eigen::Vector3d GetRayToEye(const Eigen::Vector3d& point) const
  {
    return this->Parallel ? this->Back : Eigen::Vector3d(this->Eye - point);
  }
  /// How long a pixel is in the world, at that depth.
  double GetPixelSize(double depth) const { return (this->Parallel ? 1.0 : depth) / this->Scale; }
  /// Turns what part of a segment's image lies before a point into what part of the segment.
  double UndoPerspective(double fraction, double startDepth, double endDepth) const
  {
    return this->Parallel ? fraction
                          : fraction * startDepth / (endDepth + fraction * (startDepth - endDepth));
  }

private:
  Eigen::Matrix3d ToView; // rows: to the right, upwards, away from the eye
  Eigen::Vector3d Eye;
  Eigen::Vector3d Back; // unit
  double Scale = 1.0;   // pixels a length at depth 1, or everywhere
  double Nearest = 0.0;
  bool Parallel = false;
  bool Valid = false;
};
}

#endif
