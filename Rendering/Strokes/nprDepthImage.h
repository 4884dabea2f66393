// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprDepthImage_h
#define nprDepthImage_h

#include "nprVTKCompat.h"

#include <Eigen/Geometry>

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class DepthImage
 * @brief A renderer's depth buffer, and which points of strokes it hides: as vtkNPRStrokeFS.glsl,
 * which says why.
 */
class DepthImage
{
public:
  /// The buffer as it stands. The matrix, which may be null, takes strokes to the world.
  DepthImage(vtkRenderer* renderer, vtkMatrix4x4* strokesToWorld);

  /// False where the window has no depth to read.
  bool IsValid() const { return !this->Depths.empty(); }

  /// A place in clip coordinates. It is linear in the point.
  Eigen::Vector4d Project(const Eigen::Vector3d& point) const
  {
    return this->ToClip * point.homogeneous();
  }
  bool IsInView(const Eigen::Vector4d& clip) const
  {
    return clip.w() > 0.0 && (clip.head<3>().array().abs() <= clip.w()).all();
  }
  /// From the lower left corner of the viewport.
  Eigen::Vector2d GetPixel(const Eigen::Vector4d& clip) const
  {
    return (0.5 * clip.head<2>() / clip.w() + Eigen::Vector2d(0.5, 0.5))
      .cwiseProduct(Eigen::Vector2d(this->Width, this->Height));
  }

  /// Lengths that IsHidden() goes by.
  struct Rule
  {
    double Tolerance; ///< pixels
    double Radius;    ///< pixels
    double ModelSize; ///< of all strokes, in the world
  };
  /// The cosine is that between the surface that the point lies on and the view; 0: not known.
  bool IsHidden(const Eigen::Vector4d& clip, double cosine, const Rule& rule) const;

  /// The cosine between a normal of the strokes' surface and the view there, not negative.
  double GetCosine(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const;

private:
  double GetDepth(const Eigen::Vector2d& pixel) const;
  /// Distance from the plane of the eye, of a depth in normalised device coordinates.
  double GetViewDepth(double z) const;

  int Width;
  int Height;
  Eigen::Matrix4d ToClip;
  Eigen::Matrix4d ToView;
  Eigen::Matrix3d NormalsToView;
  Eigen::Matrix2d Projection; // rows 2 and 3, columns 2 and 3 of the projection
  double PixelScale;          // size of a pixel where the clip coordinate w is 1, in the world
  std::vector<float> Depths;
};
}

#endif
