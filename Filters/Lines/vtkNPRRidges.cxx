// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRRidges.h"

#include "nprArrayNames.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPRRidges);

//------------------------------------------------------------------------------
vtkNPRRidges::vtkNPRRidges()
{
  this->AddParameter("threshold", "least curvature across the line, times length scale",
    this->Threshold, 0.0, 1.0e6);
  this->AddParameter("fade", "how far above the threshold lines have their full strength",
    this->Fade, 1.0e-6, 1.0e6);
  this->AddParameter("sharpness",
    "how sharp the maximum of curvature is at least: 0 for a circle, 3 for a parabola",
    this->Sharpness, 1.0e-6, 1.0e6);
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRRidges::GetRequiredArrays() const
{
  return { { npr::names::Normals, 3, "vtkNPRSurfaceNormals" },
    { npr::names::PrincipalCurvature1, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalDirection1, 3, "vtkNPRCurvatureTensor" },
    { npr::names::CurvatureDerivatives, 4, "vtkNPRCurvatureTensor" } };
}

//------------------------------------------------------------------------------
const char* vtkNPRRidges::GetAxes() const
{
  return npr::names::PrincipalDirection1;
}

//------------------------------------------------------------------------------
void vtkNPRRidges::EvaluateField(const npr::LineSurface& surface, const npr::LineView&,
  vtkIdType begin, vtkIdType end, float* field) const
{
  const float* p = surface.GetComponent(npr::names::CurvatureDerivatives, 0);
  const float side = this->GetSide();
  for (vtkIdType i = begin; i < end; ++i)
  {
    field[i] = side * p[i];
  }
}

//------------------------------------------------------------------------------
void vtkNPRRidges::EvaluateTest(const npr::LineSurface& surface, const npr::LineView&,
  const Index* points, vtkIdType count, const float* fall, float* test) const
{
  const float* k1 = surface.GetComponent(npr::names::PrincipalCurvature1, 0);
  const double scale = surface.GetLengthScale();
  for (vtkIdType j = 0; j < count; ++j)
  {
    // Without a unit, so that nothing vanishes on tiny surfaces.
    const double curvature = double(this->GetSide()) * k1[points[j]] * scale;
    const double rise = (curvature - this->Threshold) / this->Fade;
    if (rise <= 0.0)
    {
      test[j] = static_cast<float>(rise);
      continue;
    }
    const double least = this->Sharpness * curvature * curvature * curvature;
    const double sharp = (scale * scale * scale * fall[j] - least) / least;
    // In this order a NaN stays.
    test[j] = static_cast<float>(rise < sharp ? rise : sharp);
  }
}
