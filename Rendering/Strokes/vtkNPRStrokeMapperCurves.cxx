// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The curves that a stroke mapper draws, how exactly, and where they may be.
#include "vtkNPRStrokeMapper.h"

#include "nprStrokeCurves.h"

#include <vtkMath.h>
#include <vtkPolyData.h>

//------------------------------------------------------------------------------
// Of axes and edges that are drawn with fewer points, pixels.
double vtkNPRStrokeMapper::GetMaximumError() const
{
  constexpr double maximumError = 0.0625;
  // Joins other than round ones look longer than round ones where points are left out.
  return this->IsStyled() ? 0.25 * maximumError : maximumError;
}

//------------------------------------------------------------------------------
npr::CurveSettings vtkNPRStrokeMapper::GetCurves() const
{
  npr::CurveSettings curves;
  curves.Kind = static_cast<npr::SplineKind>(this->SplineType);
  curves.CornerAngle = this->SplineCornerAngle;
  curves.ChordError = this->SplineChordError / this->GetMaximumError();
  curves.Measured = this->IsStyled();
  return curves;
}

//------------------------------------------------------------------------------
void vtkNPRStrokeMapper::ComputeBounds()
{
  vtkPolyData* const input = this->GetInput();
  if (this->SplineType == NONE || !input)
  {
    this->Superclass::ComputeBounds();
    return;
  }
  input->GetCellsBounds(this->Bounds);
  if (!vtkMath::AreBoundsInitialized(this->Bounds))
  {
    return;
  }
  if (this->OvershootTime < this->GetMTime() || this->OvershootTime < input->GetMTime())
  {
    this->Overshoot = npr::FindOvershoot(input, static_cast<npr::SplineKind>(this->SplineType));
    this->OvershootTime.Modified();
  }
  for (int i = 0; i < 6; ++i)
  {
    this->Bounds[i] += i % 2 == 0 ? -this->Overshoot : this->Overshoot;
  }
}
