// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRApparentRidges.h"

#include "nprArrayNames.h"
#include "nprFieldAxes.h"
#include "nprViewCurvature.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <array>

vtkStandardNewMacro(vtkNPRApparentRidges);

namespace
{
using Row = std::array<float, npr::NumberOfLanes>;
Row ToRow(const npr::Lanes& lanes)
{
  Row row;
  npr::Store(lanes, row.data());
  return row;
}

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
  template<typename Loader>
  [[gnu::always_inline]] npr::ViewCurvature<npr::Lanes> Get(const Loader& load) const
  {
    const float perspective = this->View.Perspective;
    npr::SeenPoint<npr::Lanes> point;
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
  npr::AxisPoint* points) const
{
  const SeenPoints all(surface, view);
  const float threshold = static_cast<float>(this->Threshold);
  const auto evaluate = [&](vtkIdType first, int count, const auto& load)
  {
    const auto seen = all.Get(load);
    const npr::Lanes above = seen.Curvature - threshold * seen.Cosine;
    const Row x = ToRow(seen.Axis.X);
    const Row y = ToRow(seen.Axis.Y);
    const Row z = ToRow(seen.Axis.Z);
    const Row bound = ToRow(npr::Lanes(above < seen.Cosine ? above : seen.Cosine));
    npr::StoreFirst(seen.Derivative, field + first, count);
    for (int i = 0; i < count; ++i)
    {
      points[first + i].Axis = { x[i], y[i], z[i] };
      points[first + i].Bound = bound[i];
    }
  };
  vtkIdType i = begin;
  for (; i + npr::NumberOfLanes <= end; i += npr::NumberOfLanes)
  {
    evaluate(i, npr::NumberOfLanes,
      [i](const float* values) { return npr::Load<npr::Lanes>(values + i); });
  }
  if (i < end)
  {
    const int rest = static_cast<int>(end - i);
    evaluate(i, rest,
      [i, rest](const float* values) { return npr::LoadFirst<npr::Lanes>(values + i, rest); });
  }
}

//------------------------------------------------------------------------------
void vtkNPRApparentRidges::EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view,
  const Index* points, vtkIdType count, const float* fall, float* test) const
{
  const SeenPoints all(surface, view);
  const double scale = surface.GetLengthScale();
  const auto getTest = [&](double cosine, double seenCurvature, double seenStretch, double falling)
  {
    const double facing = cosine / this->ContourFade;
    if (facing <= 0.0)
    {
      return facing;
    }
    const double curvature = seenCurvature / cosine;
    const double rise = (curvature - this->Threshold) / this->Fade;
    // In this order a NaN stays.
    const double result = facing < rise ? facing : rise;
    if (!(result > 0.0))
    {
      return result;
    }
    // The field falls with c^2, on the surface; on the screen it falls faster by the stretch.
    const double stretch = seenStretch / cosine;
    const double onScreen = scale * falling * stretch * stretch / (cosine * cosine);
    const double least = this->Sharpness * curvature * curvature * curvature;
    const double sharp = (onScreen - least) / least;
    return result < sharp ? result : sharp;
  };
  for (vtkIdType first = 0; first < count; first += npr::NumberOfLanes)
  {
    const int size = static_cast<int>(std::min<vtkIdType>(npr::NumberOfLanes, count - first));
    std::array<Index, npr::NumberOfLanes> here;
    for (int i = 0; i < npr::NumberOfLanes; ++i)
    {
      here[i] = points[first + std::min(i, size - 1)];
    }
    const auto seen = all.Get([&here](const float* values)
      { return npr::MakeLanes([&](int i) { return values[here[i]]; }); });
    const Row cosine = ToRow(seen.Cosine);
    const Row curvature = ToRow(seen.Curvature);
    const Row stretch = ToRow(seen.Stretch);
    for (int i = 0; i < size; ++i)
    {
      test[first + i] =
        static_cast<float>(getTest(cosine[i], curvature[i], stretch[i], fall[first + i]));
    }
  }
}
