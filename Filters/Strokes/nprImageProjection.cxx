// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprImageProjection.h"

#include "nprTangentFrame.h"

#include <vtkCamera.h>
#include <vtkMath.h>

#include <Eigen/Geometry>

#include <cmath>

namespace npr
{
//------------------------------------------------------------------------------
ImageProjection::ImageProjection(
  vtkCamera* camera, const Eigen::Vector3d& centre, double height, double size)
  : Eye(Eigen::Map<const Eigen::Vector3d>(camera->GetPosition()) - centre),
    Parallel(camera->GetParallelProjection() != 0)
{
  this->Back = (Eigen::Map<const Eigen::Vector3d>(camera->GetPosition()) -
    Eigen::Map<const Eigen::Vector3d>(camera->GetFocalPoint()))
                 .stableNormalized();
  Eigen::Vector3d right =
    Eigen::Map<const Eigen::Vector3d>(camera->GetViewUp()).cross(this->Back).stableNormalized();
  if (right.squaredNorm() == 0.0)
  {
    right = MakeTangentFrame(this->Back).U; // what is up means nothing
  }
  this->ToView.row(0) = right;
  this->ToView.row(1) = this->Back.cross(right);
  this->ToView.row(2) = -this->Back;
  const double halfView = this->Parallel
    ? camera->GetParallelScale()
    : std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  this->Scale = 0.5 * height / halfView;
  constexpr double nearlyNothing = 1e-6;
  this->Nearest = nearlyNothing * (size + this->Eye.norm());
  this->Valid = this->Back.squaredNorm() > 0.5 && this->ToView.allFinite() &&
    this->Eye.allFinite() && this->Scale > 0.0 && std::isfinite(this->Scale);
}
}
