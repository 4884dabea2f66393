// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPageScale.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
/// In images with a shorter side than this many pixels, lines get no thinner.
constexpr int SmallestSide = 600;
}

//------------------------------------------------------------------------------
PageScale PageScale::Of(vtkRenderer* renderer)
{
  const int width = std::max(1, renderer->GetSize()[0]);
  const int height = std::max(1, renderer->GetSize()[1]);
  vtkCamera* camera = renderer->GetActiveCamera();
  PageScale scale;
  const int shorter = std::min(width, height);
  scale.PixelsPerUnit = shorter / 1000.0;
  scale.PixelsPerUnitOfWidth = std::max(shorter, SmallestSide) / 1000.0;
  scale.ViewHeightsPerUnit = scale.PixelsPerUnit / height;
  if (camera->GetParallelProjection())
  {
    scale.WorldPerPixel = 2.0 * camera->GetParallelScale() / height;
  }
  else
  {
    const double size = 2.0 * camera->GetDistance() *
      std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    scale.WorldPerPixel = size / (camera->GetUseHorizontalViewAngle() ? width : height);
  }
  return scale;
}

//------------------------------------------------------------------------------
double PageScale::GetUnit(vtkMatrix4x4* modelToWorld) const
{
  return this->PixelsPerUnit * this->WorldPerPixel / ComputeScale(modelToWorld);
}

//------------------------------------------------------------------------------
double ComputeScale(vtkMatrix4x4* matrix)
{
  const double volume = std::abs(matrix->Determinant());
  return volume > 0.0 ? std::cbrt(volume) : 1.0;
}
}
