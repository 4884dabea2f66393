// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprDepthImage.h"

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
using Matrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

constexpr double RoundingOfSize = 1e-4;
constexpr double SeenEdgeOn = 0.25;     // cosine between the surface and the view
constexpr double LargestRadius = 0.289; // of a sphere in a box, as a share of its diagonal
constexpr double HalfHidden = 1.25;     // tolerances: in the middle of the shader's blend

Eigen::Matrix4d ToEigen(vtkMatrix4x4* matrix)
{
  return Eigen::Map<const Matrix>(matrix->GetData());
}
}

//------------------------------------------------------------------------------
DepthImage::DepthImage(vtkRenderer* renderer, vtkMatrix4x4* strokesToWorld)
  : Width(renderer->GetSize()[0]), Height(renderer->GetSize()[1])
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  const Eigen::Matrix4d projection =
    ToEigen(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  this->ToView = ToEigen(camera->GetViewTransformMatrix());
  if (strokesToWorld)
  {
    this->ToView *= ToEigen(strokesToWorld);
  }
  this->NormalsToView = this->ToView.topLeftCorner<3, 3>().inverse().transpose();
  this->ToClip = projection * this->ToView;
  this->Projection = projection.bottomRightCorner<2, 2>();
  this->PixelScale = 2.0 / (projection(1, 1) * this->Height);

  const int* const origin = renderer->GetOrigin();
  vtkNew<vtkFloatArray> depths;
  renderer->GetRenderWindow()->GetZbufferData(
    origin[0], origin[1], origin[0] + this->Width - 1, origin[1] + this->Height - 1, depths);
  if (depths->GetNumberOfValues() == static_cast<vtkIdType>(this->Width) * this->Height)
  {
    this->Depths.assign(depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfValues());
  }
}

//------------------------------------------------------------------------------
double DepthImage::GetDepth(const Eigen::Vector2d& pixel) const
{
  const int x = std::clamp(static_cast<int>(std::floor(pixel.x())), 0, this->Width - 1);
  const int y = std::clamp(static_cast<int>(std::floor(pixel.y())), 0, this->Height - 1);
  return this->Depths[static_cast<std::size_t>(y) * this->Width + x];
}

//------------------------------------------------------------------------------
double DepthImage::GetViewDepth(double z) const
{
  return (z * this->Projection(1, 1) - this->Projection(0, 1)) /
    (z * this->Projection(1, 0) - this->Projection(0, 0));
}

//------------------------------------------------------------------------------
double DepthImage::GetCosine(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const
{
  const bool isParallel = this->Projection(1, 0) == 0.0;
  const Eigen::Vector3d view = isParallel
    ? Eigen::Vector3d::UnitZ()
    : Eigen::Vector3d((this->ToView * point.homogeneous()).head<3>());
  const Eigen::Vector3d seen = this->NormalsToView * normal;
  const double lengths = view.norm() * seen.norm();
  return lengths > 0.0 && std::isfinite(lengths) ? std::abs(view.dot(seen)) / lengths : 0.0;
}

//------------------------------------------------------------------------------
bool DepthImage::IsHidden(const Eigen::Vector4d& clip, double cosine, const Rule& rule) const
{
  const Eigen::Vector2d pixel = this->GetPixel(clip);
  const double depth = this->GetViewDepth(clip.z() / clip.w());
  const double pixelSize =
    std::abs(this->Projection(1, 1) - this->Projection(1, 0) * depth) * this->PixelScale;
  const double tolerance = rule.Tolerance * pixelSize + RoundingOfSize * rule.ModelSize;
  const auto isBehind = [&](double z, double least)
  { return depth - this->GetViewDepth(2.0 * z - 1.0) > least; };

  double farthest = 0.0;
  for (const double x : { -0.5, 0.5 })
  {
    for (const double y : { -0.5, 0.5 })
    {
      farthest = std::max(farthest, this->GetDepth(pixel + Eigen::Vector2d(x, y)));
    }
  }
  if (!isBehind(farthest, tolerance))
  {
    return false;
  }
  if (cosine > SeenEdgeOn)
  {
    // The surface goes on around the stroke, and rises so much from one pixel to the next.
    const double slope = std::sqrt(1.0 - std::min(1.0, cosine * cosine)) / cosine;
    return isBehind(farthest, tolerance + slope * pixelSize);
  }
  if (isBehind(farthest,
        std::max(2.0 * tolerance,
          std::sqrt(2.0 * rule.Radius * pixelSize * LargestRadius * rule.ModelSize))))
  {
    return true;
  }
  constexpr double diagonal = 0.7071;
  for (const double share : { 0.5, 1.0 })
  {
    for (const auto& [x, y] :
      { std::pair(1.0, 0.0), { 0.0, 1.0 }, { -1.0, 0.0 }, { 0.0, -1.0 }, { diagonal, diagonal },
        { -diagonal, diagonal }, { -diagonal, -diagonal }, { diagonal, -diagonal } })
    {
      farthest =
        std::max(farthest, this->GetDepth(pixel + share * rule.Radius * Eigen::Vector2d(x, y)));
    }
  }
  return isBehind(farthest, HalfHidden * tolerance);
}
}
