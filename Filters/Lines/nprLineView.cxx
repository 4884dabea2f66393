// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineView.h"

#include "nprTangentFrame.h"

#include <vtkCamera.h>
#include <vtkMath.h>

#include <Eigen/Dense>

#include <cmath>

namespace npr
{
//------------------------------------------------------------------------------
bool MakeLineView(vtkCamera* camera, const Eigen::Matrix4d& modelToWorld,
  const Eigen::Vector3d& origin, LineView& view)
{
  const Eigen::Matrix3d linear = modelToWorld.topLeftCorner<3, 3>();
  const Eigen::Matrix3d inverse = linear.inverse();
  if (!inverse.allFinite() || linear.determinant() == 0.0)
  {
    return false;
  }
  const bool parallel = camera->GetParallelProjection() != 0;
  Eigen::Vector3d eye;
  if (parallel)
  {
    eye = -(inverse * Eigen::Map<const Eigen::Vector3d>(camera->GetDirectionOfProjection()));
    eye.normalize();
  }
  else
  {
    const Eigen::Vector3d translation = modelToWorld.topRightCorner<3, 1>();
    eye =
      inverse * (Eigen::Map<const Eigen::Vector3d>(camera->GetPosition()) - translation) - origin;
  }
  view.Perspective = parallel ? 0.0f : 1.0f;
  for (int i = 0; i < 3; ++i)
  {
    view.Eye[i] = static_cast<float>(eye[i]);
  }
  const Eigen::Vector3d back =
    -Eigen::Map<const Eigen::Vector3d>(camera->GetDirectionOfProjection());
  Eigen::Vector3d right =
    Eigen::Map<const Eigen::Vector3d>(camera->GetViewUp()).cross(back).stableNormalized();
  if (right.squaredNorm() == 0.0)
  {
    right = MakeTangentFrame(back).U; // what is up means nothing
  }
  view.Axes = { (inverse * right).cast<float>(), (inverse * back.cross(right)).cast<float>(),
    (inverse * back).cast<float>() };
  return true;
}

//------------------------------------------------------------------------------
LineRuler::LineRuler(
  vtkCamera* camera, const Eigen::Matrix4d& modelToWorld, const Eigen::Vector3d& origin)
  : Linear(modelToWorld.topLeftCorner<3, 3>()),
    Offset(Linear * origin + modelToWorld.topRightCorner<3, 1>()), Eye(camera->GetPosition()),
    Direction(camera->GetDirectionOfProjection()), Parallel(camera->GetParallelProjection() != 0),
    HalfHeight(Parallel ? camera->GetParallelScale()
                        : std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())))
{
}

//------------------------------------------------------------------------------
double LineRuler::Measure(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
{
  const Eigen::Vector3d from = this->Linear * a + this->Offset;
  const Eigen::Vector3d piece = this->Linear * (b - a);
  const Eigen::Vector3d ray =
    this->Parallel ? this->Direction : Eigen::Vector3d(from + 0.5 * piece - this->Eye);
  const double distance = ray.norm();
  if (distance == 0.0)
  {
    return 0.0;
  }
  const double across = ray.cross(piece).norm() / distance;
  return across / (2.0 * this->HalfHeight * (this->Parallel ? 1.0 : distance));
}
}
