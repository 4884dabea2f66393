// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineStrokes.h"

#include "nprSurfacePipeline.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRLineSelection.h"
#include "vtkNPRStrokeMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

namespace npr
{
namespace
{
constexpr double MaximumShift = 1.5;     // thousandths of the image's shorter side
constexpr double MaximumBulge = 1.5;     // the same
constexpr double VisibilityRadius = 2.0; // pixels, of strokes that stay in their place
}

//------------------------------------------------------------------------------
LineStrokes::LineStrokes(const LineStyle& line, int index, const LightStyle& light,
  SurfacePipeline& pipeline, vtkMatrix4x4* matrix)
  : Style(line), Matrix(matrix), Selection(vtkSmartPointer<vtkNPRLineSelection>::New()),
    Filters(line, light, pipeline.IsFaceted(), matrix),
    Parts(vtkSmartPointer<vtkNPRLineSelection>::New()),
    PartFilters(line, light, pipeline.IsFaceted(), nullptr),
    Mapper(vtkSmartPointer<vtkNPRStrokeMapper>::New()), Actor(vtkSmartPointer<vtkActor>::New())
{
  this->Selection->SetInputConnection(pipeline.GetFeatureLines()->GetOutputPort());
  this->Selection->SetLineIndex(index);
  this->Filters.GetFirst()->SetInputConnection(this->Selection->GetOutputPort());
  this->PartFilters.GetFirst()->SetInputConnection(this->Parts->GetOutputPort());

  const StrokeStyle& stroke = line.Stroke;
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
  this->Actor->GetProperty()->SetColor(line.Ink[0], line.Ink[1], line.Ink[2]);
  this->Actor->GetProperty()->SetOpacity(line.Opacity);
  this->Actor->PickableOff();
  this->Actor->UseBoundsOff();
  this->DrawParts(false);
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
vtkAlgorithmOutput* LineStrokes::GetLinesPort()
{
  return this->Selection->GetOutputPort();
}

//------------------------------------------------------------------------------
void LineStrokes::SetParts(vtkAlgorithmOutput* parts, int lineType)
{
  this->Parts->SetInputConnection(parts);
  this->Parts->SetLineIndex(lineType);
}

//------------------------------------------------------------------------------
vtkPolyData* LineStrokes::GetPartStrokes()
{
  vtkAlgorithm* const last = this->PartFilters.GetLast();
  last->Update();
  return vtkPolyData::SafeDownCast(last->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
void LineStrokes::DrawParts(bool parts)
{
  vtkAlgorithm* const last = (parts ? this->PartFilters : this->Filters).GetLast();
  if (this->Mapper->GetNumberOfInputConnections(0) > 0 && this->Mapper->GetInputAlgorithm() == last)
  {
    return;
  }
  this->Mapper->SetInputConnection(last->GetOutputPort());
  this->Mapper->SetUseHidingLayers(parts);
  this->Mapper->SetDepthTest(!parts);
  this->Actor->SetUserMatrix(parts ? nullptr : this->Matrix);
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
  this->Filters.SetScale(scale, camera);
  this->PartFilters.SetScale(scale, camera);
  this->PartFilters.SetPixel(scale.WorldPerPixel);
  // What leaves its surface would show through it.
  this->PartFilters.SetMaximumShift(MaximumShift * pixels * scale.WorldPerPixel);
  this->PartFilters.SetMaximumBulge(MaximumBulge * pixels * scale.WorldPerPixel);
  if (resample)
  {
    this->Filters.SetPixel(modelPixel);
    this->Filters.SetMaximumBulge(MaximumBulge * pixels * modelPixel);
    this->Selection->SetMinimumLength(this->Style.MinimumLength * pixels * modelPixel);
  }
}
}
