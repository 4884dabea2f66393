// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeMeasure_h
#define nprStrokeMeasure_h

#include "nprSplines.h"
#include "nprVTKCompat.h"

#include <Eigen/Core>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkMatrix4x4;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class StrokeMeasure
 * @brief The space that lengths of strokes are measured in: that of the model, or the page.
 *
 * The page is the plane of the image, in heights of the view; a place on it has a third coordinate
 * of 0.
 */
class StrokeMeasure
{
public:
  /// The model's space, in units of so many of its own.
  explicit StrokeMeasure(double unit);

  /// The page of a camera. `modelToWorld` may be null.
  StrokeMeasure(vtkCamera* camera, vtkMatrix4x4* modelToWorld);

  /// Whether there is such a space: not where the matrix has no inverse.
  bool IsValid() const { return this->Valid; }

  /// Whether it is a page.
  bool IsPage() const { return this->OnPage; }

  Eigen::Vector3d GetPlace(const Vector3& point) const;

  /// The cosine of the angle between a normal of the model and a unit vector: on a page, in the
  /// viewer's axes (right, up, towards him), else in the model's. 0 for a normal without length.
  double GetCosine(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction) const;

  /// The direction to the eye in the viewer's axes. On a page.
  Eigen::Vector3d GetDirectionToEye(const Vector3& point) const;

  /// The point whose place is so much farther; on the page at the same depth.
  Vector3 Move(const Vector3& point, const Eigen::Vector3d& by) const;

private:
  double GetViewHeight(double depth) const;

  bool Valid = true;
  bool OnPage = false;
  bool Parallel = false;
  double Unit = 1.0;
  double HeightAtOne = 1.0; // of the view, at the distance 1 or everywhere; world
  double LeastDepth = 0.0;  // what is nearer or behind the eye counts as there
  Eigen::Matrix3d ToView;   // model to the camera's axes
  Eigen::Vector3d Offset;
  Eigen::Matrix3d FromView;
};
}

#endif
