// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRParabolicLines.h"

#include "nprArrayNames.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkNPRParabolicLines);

//------------------------------------------------------------------------------
vtkNPRParabolicLines::vtkNPRParabolicLines()
{
  this->AddParameter("threshold",
    "least gradient of the Gaussian curvature, times length scale cubed", this->Threshold, 0.0,
    1.0e9);
  this->AddParameter("fade", "how far above the threshold lines have their full strength",
    this->Fade, 1.0e-6, 1.0e9);
  this->AddParameter("steepness",
    "least gradient of the lesser curvature, over the greater one squared", this->Steepness, 0.0,
    1.0e6);
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRParabolicLines::GetRequiredArrays() const
{
  return { { npr::names::PrincipalCurvature1, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalCurvature2, 1, "vtkNPRCurvatureTensor" },
    { npr::names::CurvatureDerivatives, 4, "vtkNPRCurvatureTensor" } };
}

//------------------------------------------------------------------------------
void vtkNPRParabolicLines::EvaluateField(const npr::LineSurface& surface, const npr::LineView&,
  vtkIdType begin, vtkIdType end, float* field) const
{
  const float* k1 = surface.GetComponent(npr::names::PrincipalCurvature1, 0);
  const float* k2 = surface.GetComponent(npr::names::PrincipalCurvature2, 0);
  // Without a unit, so that nothing vanishes on huge surfaces.
  const float scale = static_cast<float>(surface.GetLengthScale());
  for (vtkIdType i = begin; i < end; ++i)
  {
    field[i] = (scale * k1[i]) * (scale * k2[i]);
  }
}

//------------------------------------------------------------------------------
void vtkNPRParabolicLines::EvaluateTest(const npr::LineSurface& surface, const npr::LineView&,
  const Index* points, vtkIdType count, const float*, float* test) const
{
  const float* k1 = surface.GetComponent(npr::names::PrincipalCurvature1, 0);
  const float* k2 = surface.GetComponent(npr::names::PrincipalCurvature2, 0);
  const float* p = surface.GetComponent(npr::names::CurvatureDerivatives, 0);
  const float* q = surface.GetComponent(npr::names::CurvatureDerivatives, 1);
  const float* s = surface.GetComponent(npr::names::CurvatureDerivatives, 2);
  const float* t = surface.GetComponent(npr::names::CurvatureDerivatives, 3);
  const double scale = surface.GetLengthScale();
  for (vtkIdType j = 0; j < count; ++j)
  {
    const Index i = points[j];
    const double c1 = scale * k1[i];
    const double c2 = scale * k2[i];
    const double gradient =
      scale * scale * std::hypot(c1 * s[i] + c2 * p[i], c1 * t[i] + c2 * q[i]);
    // The error of either curvature is a share of the greater one, so a slow change of the lesser
    // one's sign on a strong bend is noise: lines that wriggle across each fold of a scan.
    const double least = this->Steepness * c1 * c1;
    const double excess = scale * scale * std::hypot(s[i], t[i]) - least;
    const double strength = (gradient - this->Threshold) / this->Fade;
    test[j] = static_cast<float>(excess < least ? std::min(strength, excess / least) : strength);
  }
}
