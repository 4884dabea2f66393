// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRDemarcatingCurves.h"

#include "nprArrayNames.h"
#include "nprFieldAxes.h"
#include "nprSteepestTurn.h"

#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(vtkNPRDemarcatingCurves);

namespace
{
// The direction g as its components along the principal directions, and C(g,g,g).
struct Step
{
  double Along1;
  double Along2;
  double Steepness;
};

class Steps
{
public:
  explicit Steps(const npr::LineSurface& surface)
    : P(surface.GetComponent(npr::names::CurvatureDerivatives, 0)),
      Q(surface.GetComponent(npr::names::CurvatureDerivatives, 1)),
      S(surface.GetComponent(npr::names::CurvatureDerivatives, 2)),
      T(surface.GetComponent(npr::names::CurvatureDerivatives, 3)),
      Square(surface.GetLengthScale() * surface.GetLengthScale())
  {
  }
  Step operator[](vtkIdType i) const
  {
    Step step;
    const double angle = npr::FindSteepestTurn(this->Square * this->P[i], this->Square * this->Q[i],
      this->Square * this->S[i], this->Square * this->T[i], step.Steepness);
    step.Along1 = std::cos(angle);
    step.Along2 = std::sin(angle);
    return step;
  }

private:
  const float* P;
  const float* Q;
  const float* S;
  const float* T;
  const double Square;
};
}

//------------------------------------------------------------------------------
vtkNPRDemarcatingCurves::vtkNPRDemarcatingCurves()
{
  this->AddParameter("threshold",
    "least derivative of the curvature across the step, times length scale squared",
    this->Threshold, 0.0, 1.0e6);
  this->AddParameter("fade", "how far above the threshold lines have their full strength",
    this->Fade, 1.0e-6, 1.0e6);
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRDemarcatingCurves::GetRequiredArrays() const
{
  return { { npr::names::Normals, 3, "vtkNPRSurfaceNormals" },
    { npr::names::PrincipalCurvature1, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalCurvature2, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalDirection1, 3, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalDirection2, 3, "vtkNPRCurvatureTensor" },
    { npr::names::CurvatureDerivatives, 4, "vtkNPRCurvatureTensor" } };
}

//------------------------------------------------------------------------------
void vtkNPRDemarcatingCurves::EvaluateFieldAndAxes(const npr::LineSurface& surface,
  const npr::LineView&, vtkIdType begin, vtkIdType end, float* field, npr::AxisPoint* points) const
{
  const Steps steps(surface);
  const float* k1 = surface.GetComponent(npr::names::PrincipalCurvature1, 0);
  const float* k2 = surface.GetComponent(npr::names::PrincipalCurvature2, 0);
  std::array<const float*, 3> e1;
  std::array<const float*, 3> e2;
  for (int c = 0; c < 3; ++c)
  {
    e1[c] = surface.GetComponent(npr::names::PrincipalDirection1, c);
    e2[c] = surface.GetComponent(npr::names::PrincipalDirection2, c);
  }
  for (vtkIdType i = begin; i < end; ++i)
  {
    const Step step = steps[i];
    field[i] =
      static_cast<float>(step.Along1 * step.Along1 * k1[i] + step.Along2 * step.Along2 * k2[i]);
    for (int c = 0; c < 3; ++c)
    {
      points[i].Axis[c] = static_cast<float>(step.Along1 * e1[c][i] + step.Along2 * e2[c][i]);
    }
    points[i].Bound = static_cast<float>(step.Steepness - this->Threshold);
  }
}

//------------------------------------------------------------------------------
void vtkNPRDemarcatingCurves::EvaluateTest(const npr::LineSurface& surface, const npr::LineView&,
  const Index* points, vtkIdType count, const float*, float* test) const
{
  const Steps steps(surface);
  for (vtkIdType j = 0; j < count; ++j)
  {
    test[j] = static_cast<float>((steps[points[j]].Steepness - this->Threshold) / this->Fade);
  }
}
