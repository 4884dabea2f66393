// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRTopographicLines.h"

#include <vtkObjectFactory.h>

#include <Eigen/Core>

vtkStandardNewMacro(vtkNPRTopographicLines);

namespace
{
constexpr double DefaultLevels = 20.0;

// The unit vector of the height; 0 where there is none.
Eigen::Vector3d GetUnit(const double (&direction)[3])
{
  return Eigen::Map<const Eigen::Vector3d>(direction).stableNormalized();
}
}

//------------------------------------------------------------------------------
vtkNPRTopographicLines::vtkNPRTopographicLines() : Superclass(DefaultLevels)
{
  this->AddParameter("direction", "the direction of the height in the coordinates of the model",
    this->Direction, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX);
}

//------------------------------------------------------------------------------
double vtkNPRTopographicLines::GetLevelOffset(const npr::LineSurface& surface) const
{
  return GetUnit(this->Direction).dot(surface.GetMesh().GetOrigin());
}

//------------------------------------------------------------------------------
void vtkNPRTopographicLines::EvaluateField(const npr::LineSurface& surface, const npr::LineView&,
  vtkIdType begin, vtkIdType end, float* field) const
{
  const Eigen::Vector3f a = GetUnit(this->Direction).cast<float>();
  const float* x = surface.GetCoordinate(0);
  const float* y = surface.GetCoordinate(1);
  const float* z = surface.GetCoordinate(2);
  for (vtkIdType i = begin; i < end; ++i)
  {
    field[i] = a[0] * x[i] + a[1] * y[i] + a[2] * z[i];
  }
}

//------------------------------------------------------------------------------
std::string vtkNPRTopographicLines::FindError(const npr::LineSurface& surface) const
{
  return GetUnit(this->Direction).squaredNorm() == 0.0
    ? "the direction of the height must not be 0 0 0"
    : this->Superclass::FindError(surface);
}
