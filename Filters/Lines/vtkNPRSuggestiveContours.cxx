// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSuggestiveContours.h"

#include "nprArrayNames.h"
#include "nprViewQuantities.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkNPRSuggestiveContours);

//------------------------------------------------------------------------------
vtkNPRSuggestiveContours::vtkNPRSuggestiveContours()
{
  this->AddParameter("threshold",
    "least derivative of the radial curvature, times length scale squared", this->Threshold, 0.0,
    1.0e6);
  this->AddParameter("fade", "how far above the threshold lines have their full strength",
    this->Fade, 1.0e-6, 1.0e6);
  this->AddParameter("minimumAngle", "least angle between normal and eye, in degrees",
    this->MinimumAngle, 0.0, 45.0);
  this->AddParameter("contourFade",
    "cosine of the angle between normal and eye where lines start to fade towards the contour",
    this->ContourFade, 1.0e-6, 1.0);
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRSuggestiveContours::GetRequiredArrays() const
{
  return { { npr::names::Normals, 3, "vtkNPRSurfaceNormals" },
    { npr::names::PrincipalCurvature1, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalCurvature2, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalDirection1, 3, "vtkNPRCurvatureTensor" },
    { npr::names::CurvatureDerivatives, 4, "vtkNPRCurvatureTensor" } };
}

//------------------------------------------------------------------------------
void vtkNPRSuggestiveContours::EvaluateField(const npr::LineSurface& surface,
  const npr::LineView& view, vtkIdType begin, vtkIdType end, float* field) const
{
  npr::EvaluateRadialCurvature(surface, view, begin, end, field + begin);
}

//------------------------------------------------------------------------------
void vtkNPRSuggestiveContours::BoundField(
  const npr::LineSurface& surface, vtkIdType begin, vtkIdType end, signed char* sign) const
{
  // Where both principal curvatures have one sign, so has the curvature in every direction. The
  // margin is for the rounding in the tensor.
  const float* k1 = surface.GetComponent(npr::names::PrincipalCurvature1, 0);
  const float* k2 = surface.GetComponent(npr::names::PrincipalCurvature2, 0);
  for (vtkIdType i = begin; i < end; ++i)
  {
    const float margin = 1.0e-3f * std::abs(k1[i]);
    sign[i] = std::min(k1[i], k2[i]) > margin ? 1 : std::max(k1[i], k2[i]) < -margin ? -1 : 0;
  }
}

//------------------------------------------------------------------------------
void vtkNPRSuggestiveContours::EvaluateTest(const npr::LineSurface& surface,
  const npr::LineView& view, const Index* points, vtkIdType count, const float*, float* test) const
{
  const double side = this->GetSide();
  const double least = std::sin(vtkMath::RadiansFromDegrees(this->MinimumAngle));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr vtkIdType Size = 256;
  std::array<double, Size> cosine;
  std::array<double, Size> sine;
  std::array<double, Size> derivative;
  for (vtkIdType first = 0; first < count; first += Size)
  {
    const vtkIdType size = std::min(Size, count - first);
    npr::EvaluateRadialDerivative(surface, view, npr::PointSpan::List(points + first, size),
      cosine.data(), sine.data(), derivative.data());
    for (vtkIdType i = 0; i < size; ++i)
    {
      // As the expression in the comment on the class. In this order a NaN stays.
      const double headOn = least > 0.0 ? (sine[i] - least) / least : infinity;
      const double facing = std::min(headOn, cosine[i] / this->ContourFade);
      const double rise = (side * derivative[i] - this->Threshold) * sine[i] / this->Fade;
      test[first + i] = static_cast<float>(facing <= 0.0 || facing < rise ? facing : rise);
    }
  }
}
