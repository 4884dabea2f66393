// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineStrokes.h"

#include "nprSurfacePipeline.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRLineSelection.h"
#include "vtkNPRSplineStrokes.h"
#include "vtkNPRStrokeAttributes.h"
#include "vtkNPRStrokeMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkProperty.h>

#include <cmath>

namespace npr
{
namespace
{
constexpr double VisibilityRadius = 2.0; // pixels, of strokes that stay in their place

vtkSmartPointer<vtkNPRStrokeAttributes> MakeAttributes(
  const StrokeStyle& style, const LightStyle& light, vtkMatrix4x4* matrix)
{
  auto attributes = vtkSmartPointer<vtkNPRStrokeAttributes>::New();
  attributes->SetLengthUnitToView();
  attributes->SetMatrix(matrix);
  attributes->SetTaperedWidth(style.TaperedWidth);
  attributes->SetTaperedOpacity(style.TaperedOpacity);
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
LineStrokes::LineStrokes(const LineStyle& line, int index, const LightStyle& light,
  SurfacePipeline& pipeline, vtkMatrix4x4* matrix)
  : Style(line), Selection(vtkSmartPointer<vtkNPRLineSelection>::New()),
    Splines(vtkSmartPointer<vtkNPRSplineStrokes>::New()),
    Mapper(vtkSmartPointer<vtkNPRStrokeMapper>::New()), Actor(vtkSmartPointer<vtkActor>::New())
{
  this->Selection->SetInputConnection(pipeline.GetFeatureLines()->GetOutputPort());
  this->Selection->SetLineIndex(index);

  this->Splines->SetInputConnection(this->Selection->GetOutputPort());
  const bool straight = line.Spline == "none" || pipeline.IsFaceted();
  this->Splines->SetSplineType(straight ? vtkNPRSplineStrokes::NONE
      : line.Spline == "b-spline"       ? vtkNPRSplineStrokes::B_SPLINE
                                        : vtkNPRSplineStrokes::CATMULL_ROM);
  this->Splines->SetSmoothingIterations(pipeline.IsFaceted() ? 0 : line.Smoothing);

  const StrokeStyle& stroke = line.Stroke;
  vtkAlgorithm* last = this->Splines;
  if (stroke.NeedsAttributes())
  {
    this->Attributes = MakeAttributes(stroke, light, matrix);
    this->Attributes->SetInputConnection(this->Splines->GetOutputPort());
    last = this->Attributes;
  }
  this->Mapper->SetInputConnection(last->GetOutputPort());
  this->Mapper->SetStrengthToWidth(line.Taper);
  this->Mapper->SetStrengthToOpacity(line.Fade);
  this->Mapper->SetCap(stroke.Cap);
  this->Mapper->SetJoin(stroke.Join);
  this->Mapper->SetMitreLimit(stroke.MitreLimit);
  this->Mapper->SetHiddenOpacity(stroke.HiddenOpacity);
  this->Mapper->SetMedium(stroke.Medium);
  this->Mapper->SetPaperGrain(stroke.Grain);
  this->Mapper->SetSeed(stroke.Seed);

  this->Actor->SetMapper(this->Mapper);
  this->Actor->SetUserMatrix(matrix);
  this->Actor->GetProperty()->SetColor(line.Ink[0], line.Ink[1], line.Ink[2]);
  this->Actor->GetProperty()->SetOpacity(line.Opacity);
  this->Actor->PickableOff();
  this->Actor->UseBoundsOff();
}

LineStrokes::LineStrokes(LineStrokes&&) = default;
LineStrokes::~LineStrokes() = default;

//------------------------------------------------------------------------------
vtkActor* LineStrokes::GetActor()
{
  return this->Actor;
}

//------------------------------------------------------------------------------
vtkNPRStrokeMapper* LineStrokes::GetMapper()
{
  return this->Mapper;
}

//------------------------------------------------------------------------------
void LineStrokes::SetScale(
  const PageScale& scale, vtkCamera* camera, double modelPixel, bool resample)
{
  const StrokeStyle& stroke = this->Style.Stroke;
  const double pixels = scale.PixelsPerUnit;
  this->Mapper->SetWidth(this->Style.Width * scale.PixelsPerUnitOfWidth);
  this->Mapper->SetDashes(pixels * stroke.Dashes[0], pixels * stroke.Dashes[1]);
  this->Mapper->SetHiddenDashes(pixels * stroke.HiddenDashes[0], pixels * stroke.HiddenDashes[1]);
  this->Mapper->SetGrainSize(pixels * stroke.GrainSize);
  // A line that has strayed from its surface must still be known as lying on it.
  this->Mapper->SetVisibilityRadius(VisibilityRadius + pixels * stroke.Wobble);
  if (this->Attributes)
  {
    const double heights = scale.ViewHeightsPerUnit;
    this->Attributes->SetCamera(camera);
    this->Attributes->SetReach(heights * stroke.BendReach);
    this->Attributes->SetTaperLength(heights * stroke.TaperLength);
    this->Attributes->SetOvershootLength(heights * stroke.Overshoot);
    this->Attributes->SetWobbleAmplitude(heights * stroke.Wobble);
    this->Attributes->SetWobbleWavelength(heights * stroke.WobbleLength);
  }
  if (resample)
  {
    this->Splines->SetMaximumChordError(0.1 * modelPixel);
    this->Selection->SetMinimumLength(this->Style.MinimumLength * pixels * modelPixel);
  }
}
}
