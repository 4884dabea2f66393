// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeMeasure.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
constexpr double LeastDepthOfDistance = 1e-3; // of the distance between eye and focal point

Eigen::Map<const Eigen::Vector3d> AsVector(const Vector3& point)
{
  return Eigen::Map<const Eigen::Vector3d>(point.data());
}
}

//------------------------------------------------------------------------------
StrokeMeasure::StrokeMeasure(double unit)
  : Valid(unit > 0.0 && std::isfinite(unit)), Unit(unit), ToView(Eigen::Matrix3d::Identity()),
    Offset(Eigen::Vector3d::Zero()), FromView(Eigen::Matrix3d::Identity())
{
}

//------------------------------------------------------------------------------
StrokeMeasure::StrokeMeasure(vtkCamera* camera, vtkMatrix4x4* modelToWorld)
  : OnPage(true), Parallel(camera->GetParallelProjection() != 0)
{
  vtkNew<vtkMatrix4x4> matrix;
  if (modelToWorld)
  {
    matrix->DeepCopy(modelToWorld);
  }
  vtkMatrix4x4::Multiply4x4(camera->GetViewTransformMatrix(), matrix, matrix);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      this->ToView(row, column) = matrix->GetElement(row, column);
    }
    this->Offset[row] = matrix->GetElement(row, 3);
  }
  this->FromView = this->ToView.inverse();
  this->HeightAtOne = 2.0 *
    (this->Parallel ? camera->GetParallelScale()
                    : std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())));
  this->LeastDepth = LeastDepthOfDistance * camera->GetDistance();
  this->Valid = this->ToView.determinant() != 0.0 && this->FromView.allFinite() &&
    this->HeightAtOne > 0.0 && this->Offset.allFinite();
}

//------------------------------------------------------------------------------
double StrokeMeasure::GetViewHeight(double depth) const
{
  return this->HeightAtOne * (this->Parallel ? 1.0 : std::max(depth, this->LeastDepth));
}

//------------------------------------------------------------------------------
Eigen::Vector3d StrokeMeasure::GetPlace(const Vector3& point) const
{
  if (!this->OnPage)
  {
    return AsVector(point) / this->Unit;
  }
  const Eigen::Vector3d seen = this->ToView * AsVector(point) + this->Offset;
  const double height = this->GetViewHeight(-seen[2]);
  return { seen[0] / height, seen[1] / height, 0.0 };
}

//------------------------------------------------------------------------------
double StrokeMeasure::GetCosine(
  const Eigen::Vector3d& normal, const Eigen::Vector3d& direction) const
{
  const Eigen::Vector3d seen = this->FromView.transpose() * normal;
  const double length = seen.norm();
  return length > 0.0 && std::isfinite(length) ? seen.dot(direction) / length : 0.0;
}

//------------------------------------------------------------------------------
Eigen::Vector3d StrokeMeasure::GetDirectionToEye(const Vector3& point) const
{
  if (this->Parallel)
  {
    return Eigen::Vector3d::UnitZ();
  }
  return -(this->ToView * AsVector(point) + this->Offset).stableNormalized();
}

//------------------------------------------------------------------------------
Vector3 StrokeMeasure::Move(const Vector3& point, const Eigen::Vector3d& by) const
{
  Eigen::Vector3d moved = AsVector(point);
  if (this->OnPage)
  {
    const double depth = -(this->ToView.row(2).dot(moved) + this->Offset[2]);
    moved += this->FromView * (this->GetViewHeight(depth) * by);
  }
  else
  {
    moved += this->Unit * by;
  }
  return { moved[0], moved[1], moved[2] };
}
}
