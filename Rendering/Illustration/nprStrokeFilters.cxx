// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeFilters.h"

#include "nprArrayNames.h"
#include "nprViewQuantities.h"
#include "vtkNPRSplineStrokes.h"
#include "vtkNPRStrokeAttributes.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>

#include <cmath>

namespace npr
{
namespace
{
vtkSmartPointer<vtkNPRStrokeAttributes> MakeAttributes(
  const StrokeStyle& style, const LightStyle& light, vtkMatrix4x4* matrix)
{
  auto attributes = vtkSmartPointer<vtkNPRStrokeAttributes>::New();
  attributes->SetLengthUnitToView();
  attributes->SetMatrix(matrix);
  attributes->SetTaperedWidth(style.TaperedWidth);
  attributes->SetTaperedOpacity(style.TaperedOpacity);
  attributes->SetIsophoteLevel(style.IsophoteLevel);
  attributes->SetSeed(style.Seed);
  const double azimuth = vtkMath::RadiansFromDegrees(light.Azimuth);
  const double elevation = vtkMath::RadiansFromDegrees(light.Elevation);
  attributes->SetLightDirection(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
    std::cos(elevation) * std::cos(azimuth));
  const auto add = [&](int attribute, const std::vector<TermStyle>& terms)
  {
    for (const TermStyle& term : terms)
    {
      const int number = attributes->AddTerm(attribute, term.Array.c_str());
      attributes->SetTermRange(number, term.Range[0], term.Range[1]);
      attributes->SetTermFactors(number, term.Factors[0], term.Factors[1]);
      // Curvatures of a scan have its noise.
      attributes->SetTermAverage(number, FindViewQuantity(term.Array) != nullptr);
      attributes->SetTermShape(
        number, term.Smooth ? vtkNPRStrokeAttributes::SMOOTH : vtkNPRStrokeAttributes::LINEAR);
    }
  };
  add(vtkNPRStrokeAttributes::WIDTH, style.WidthBy);
  add(vtkNPRStrokeAttributes::OPACITY, style.OpacityBy);
  return attributes;
}
}

//------------------------------------------------------------------------------
StrokeFilters::StrokeFilters(
  const LineStyle& line, const LightStyle& light, bool straight, vtkMatrix4x4* matrix)
  : Style(line.Stroke), Width(line.Width), Splines(vtkSmartPointer<vtkNPRSplineStrokes>::New())
{
  this->Splines->SetSplineType(straight || line.Spline == "none" ? vtkNPRSplineStrokes::NONE
      : line.Spline == "b-spline"                                ? vtkNPRSplineStrokes::B_SPLINE
                                  : vtkNPRSplineStrokes::CATMULL_ROM);
  this->Splines->SetSmoothingIterations(straight ? 0 : line.Smoothing);
  if (this->Style.NeedsAttributes())
  {
    this->Attributes = MakeAttributes(this->Style, light, matrix);
    this->Attributes->SetInputConnection(this->Splines->GetOutputPort());
  }
}

StrokeFilters::StrokeFilters(StrokeFilters&&) = default;
StrokeFilters::~StrokeFilters() = default;

//------------------------------------------------------------------------------
vtkAlgorithm* StrokeFilters::GetFirst()
{
  return this->Splines;
}

vtkAlgorithm* StrokeFilters::GetLast() const
{
  if (this->Attributes)
  {
    return this->Attributes;
  }
  return this->Splines;
}

//------------------------------------------------------------------------------
void StrokeFilters::SetScale(const PageScale& scale, vtkCamera* camera)
{
  if (this->Attributes)
  {
    const double heights = scale.ViewHeightsPerUnit;
    this->Attributes->SetCamera(camera);
    this->Attributes->SetReach(heights * this->Style.BendReach);
    this->Attributes->SetTaperLength(heights * this->Style.TaperLength);
    const double width = this->Width * scale.PixelsPerUnitOfWidth / scale.PixelsPerUnit;
    this->Attributes->SetWidthPerSize(this->Style.WidthLimit / (heights * width));
    this->Attributes->SetOvershootLength(heights * this->Style.Overshoot);
    this->Attributes->SetWobbleAmplitude(heights * this->Style.Wobble);
    this->Attributes->SetWobbleWavelength(heights * this->Style.WobbleLength);
    int number = 0;
    for (const auto* terms : { &this->Style.WidthBy, &this->Style.OpacityBy })
    {
      for (const TermStyle& term : *terms)
      {
        if (term.Array == names::IsophoteDistance)
        {
          this->Attributes->SetTermRange(number, heights * term.Range[0], heights * term.Range[1]);
        }
        ++number;
      }
    }
  }
}

//------------------------------------------------------------------------------
void StrokeFilters::SetPixel(double size)
{
  this->Splines->SetMaximumChordError(0.1 * size);
}

//------------------------------------------------------------------------------
void StrokeFilters::SetMaximumBulge(double length)
{
  this->Splines->SetMaximumBulge(length);
}

//------------------------------------------------------------------------------
void StrokeFilters::SetMaximumShift(double length)
{
  this->Splines->SetMaximumShift(length);
}
}
