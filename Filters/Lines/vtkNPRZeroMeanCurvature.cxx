// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRZeroMeanCurvature.h"

#include "nprArrayNames.h"

#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(vtkNPRZeroMeanCurvature);

//------------------------------------------------------------------------------
vtkNPRZeroMeanCurvature::vtkNPRZeroMeanCurvature()
{
  this->AddParameter("threshold",
    "least gradient of the mean curvature, times length scale squared", this->Threshold, 0.0,
    1.0e6);
  this->AddParameter("fade", "how far above the threshold lines have their full strength",
    this->Fade, 1.0e-6, 1.0e6);
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRZeroMeanCurvature::GetRequiredArrays() const
{
  return { { npr::names::PrincipalCurvature1, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalCurvature2, 1, "vtkNPRCurvatureTensor" },
    { npr::names::CurvatureDerivatives, 4, "vtkNPRCurvatureTensor" } };
}

//------------------------------------------------------------------------------
void vtkNPRZeroMeanCurvature::EvaluateField(const npr::LineSurface& surface, const npr::LineView&,
  vtkIdType begin, vtkIdType end, float* field) const
{
  const float* k1 = surface.GetComponent(npr::names::PrincipalCurvature1, 0);
  const float* k2 = surface.GetComponent(npr::names::PrincipalCurvature2, 0);
  for (vtkIdType i = begin; i < end; ++i)
  {
    field[i] = 0.5f * (k1[i] + k2[i]);
  }
}

//------------------------------------------------------------------------------
void vtkNPRZeroMeanCurvature::EvaluateTest(const npr::LineSurface& surface, const npr::LineView&,
  const Index* points, vtkIdType count, const float*, float* test) const
{
  const float* p = surface.GetComponent(npr::names::CurvatureDerivatives, 0);
  const float* q = surface.GetComponent(npr::names::CurvatureDerivatives, 1);
  const float* s = surface.GetComponent(npr::names::CurvatureDerivatives, 2);
  const float* t = surface.GetComponent(npr::names::CurvatureDerivatives, 3);
  const double scale = surface.GetLengthScale();
  for (vtkIdType j = 0; j < count; ++j)
  {
    const Index i = points[j];
    const double gradient =
      0.5 * scale * scale * std::hypot(double(p[i]) + s[i], double(q[i]) + t[i]);
    test[j] = static_cast<float>((gradient - this->Threshold) / this->Fade);
  }
}
