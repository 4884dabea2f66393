// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRApparentRidges.h"

#include "nprArrayNames.h"
#include "nprViewCurvature.h"

#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(vtkNPRApparentRidges);

namespace
{
// The arrays that view-dependent curvature is made from. The unit of length is the length scale.
class SeenPoints
{
public:
  SeenPoints(const npr::LineSurface& surface, const npr::LineView& view)
    : View(view), Scale(static_cast<float>(surface.GetLengthScale())), Square(Scale * Scale),
      Curvature1(surface.GetComponent(npr::names::PrincipalCurvature1, 0)),
      Curvature2(surface.GetComponent(npr::names::PrincipalCurvature2, 0))
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Points[i] = surface.GetCoordinate(i);
      this->Normals[i] = surface.GetComponent(npr::names::Normals, i);
      this->Directions[i] = surface.GetComponent(npr::names::PrincipalDirection1, i);
    }
    for (int i = 0; i < 4; ++i)
    {
      this->Derivatives[i] = surface.GetComponent(npr::names::CurvatureDerivatives, i);
    }
  }

  // `load` takes from a span what belongs to the points.
  template<typename Real, typename Loader>
  npr::ViewCurvature<Real> Get(const Loader& load) const
  {
    const float perspective = this->View.Perspective;
    npr::SeenPoint<Real> point;
    point.ToEye = { this->View.Eye[0] - perspective * load(this->Points[0]),
      this->View.Eye[1] - perspective * load(this->Points[1]),
      this->View.Eye[2] - perspective * load(this->Points[2]) };
    point.Normal = { load(this->Normals[0]), load(this->Normals[1]), load(this->Normals[2]) };
    point.Direction1 = { load(this->Directions[0]), load(this->Directions[1]),
      load(this->Directions[2]) };
    point.Curvature1 = this->Scale * load(this->Curvature1);
    point.Curvature2 = this->Scale * load(this->Curvature2);
    point.P = this->Square * load(this->Derivatives[0]);
    point.Q = this->Square * load(this->Derivatives[1]);
    point.S = this->Square * load(this->Derivatives[2]);
    point.T = this->Square * load(this->Derivatives[3]);
    return npr::GetViewCurvature(point, perspective * this->Scale);
  }

private:
  const npr::LineView View;
  const float Scale;
  const float Square;
  const float* Curvature1;
  const float* Curvature2;
  std::array<const float*, 3> Points;
  std::array<const float*, 3> Normals;
  std::array<const float*, 3> Directions;
  std::array<const float*, 4> Derivatives;
};
}

//------------------------------------------------------------------------------
vtkNPRApparentRidges::vtkNPRApparentRidges()
{
  this->AddParameter(
    "threshold", "least view-dependent curvature, times length scale", this->Threshold, 0.0, 1.0e6);
  this->AddParameter("fade", "how far above the threshold lines have their full strength",
    this->Fade, 1.0e-6, 1.0e6);
  this->AddParameter("sharpness",
    "how sharp the maximum is at least as it is seen: -1 for a circle, 2 for a parabola",
    this->Sharpness, 1.0e-6, 1.0e6);
  this->AddParameter("contourFade",
    "cosine of the angle between normal and eye where lines start to fade towards the contour",
    this->ContourFade, 1.0e-6, 1.0);
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRApparentRidges::GetRequiredArrays() const
{
  return { { npr::names::Normals, 3, "vtkNPRSurfaceNormals" },
    { npr::names::PrincipalCurvature1, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalCurvature2, 1, "vtkNPRCurvatureTensor" },
    { npr::names::PrincipalDirection1, 3, "vtkNPRCurvatureTensor" },
    { npr::names::CurvatureDerivatives, 4, "vtkNPRCurvatureTensor" } };
}

//------------------------------------------------------------------------------
void vtkNPRApparentRidges::EvaluateFieldAndAxes(const npr::LineSurface& surface,
  const npr::LineView& view, vtkIdType begin, vtkIdType end, float* field,
  const std::array<float*, 3>& axes, float* bound) const
{
  const SeenPoints points(surface, view);
  const float threshold = static_cast<float>(this->Threshold);
  // `store` puts values in a span where they belong.
  const auto evaluate = [&](const auto& load, const auto& store)
  {
    const auto seen = points.Get<npr::Lanes>(load);
    store(seen.Derivative, field);
    store(seen.Axis.X, axes[0]);
    store(seen.Axis.Y, axes[1]);
    store(seen.Axis.Z, axes[2]);
    const npr::Lanes above = seen.Curvature - threshold * seen.Cosine;
    store(npr::Lanes(above < seen.Cosine ? above : seen.Cosine), bound);
  };
  vtkIdType i = begin;
  for (; i + npr::NumberOfLanes <= end; i += npr::NumberOfLanes)
  {
    evaluate([i](const float* values) { return npr::Load<npr::Lanes>(values + i); },
      [i](const npr::Lanes& value, float* values) { npr::Store(value, values + i); });
  }
  if (i < end)
  {
    const int rest = static_cast<int>(end - i);
    evaluate([i, rest](const float* values)
      { return npr::LoadFirst<npr::Lanes>(values + i, rest); },
      [i, rest](const npr::Lanes& value, float* values)
      { npr::StoreFirst(value, values + i, rest); });
  }
}

//------------------------------------------------------------------------------
void vtkNPRApparentRidges::EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view,
  const Index* points, vtkIdType count, const float* fall, float* test) const
{
  const SeenPoints all(surface, view);
  const double scale = surface.GetLengthScale();
  for (vtkIdType j = 0; j < count; ++j)
  {
    const Index i = points[j];
    const auto seen = all.Get<float>([i](const float* values) { return values[i]; });
    const double facing = seen.Cosine / this->ContourFade;
    if (facing <= 0.0)
    {
      test[j] = static_cast<float>(facing);
      continue;
    }
    const double curvature = double(seen.Curvature) / seen.Cosine;
    const double rise = (curvature - this->Threshold) / this->Fade;
    // In this order a NaN stays.
    double result = facing < rise ? facing : rise;
    if (result > 0.0)
    {
      // The field falls with c^2, on the surface; on the screen it falls faster by the stretch.
      const double stretch = double(seen.Stretch) / seen.Cosine;
      const double onScreen =
        scale * fall[j] * stretch * stretch / (double(seen.Cosine) * seen.Cosine);
      const double least = this->Sharpness * curvature * curvature * curvature;
      const double sharp = (onScreen - least) / least;
      result = result < sharp ? result : sharp;
    }
    test[j] = static_cast<float>(result);
  }
}
