// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprActorIllustration.h"

#include "nprStyleDocument.h"
#include "nprStyleObjects.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRLineDefinition.h"
#include "vtkNPRLineSelection.h"
#include "vtkNPRSplineStrokes.h"
#include "vtkNPRStrokeMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCompositeDataGeometryFilter.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
/// A port that gives the surface of whatever a mapper shows.
vtkSmartPointer<vtkAlgorithm> MakeSurfaceSource(vtkMapper* mapper)
{
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  vtkSmartPointer<vtkAlgorithm> source;
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    source = vtkSmartPointer<vtkCompositeDataGeometryFilter>::New();
  }
  else
  {
    source = vtkSmartPointer<vtkDataSetSurfaceFilter>::New();
  }
  source->SetInputConnection(mapper->GetInputConnection(0, 0));
  return source;
}

/// In images with a shorter side than this many pixels, lines get no thinner.
constexpr int SmallestSide = 600;

/// How much a matrix enlarges, on the average over directions.
double ScaleOf(vtkMatrix4x4* matrix)
{
  const double volume = std::abs(matrix->Determinant());
  return volume > 0.0 ? std::cbrt(volume) : 1.0;
}

bool HasOwnColor(vtkMapper* mapper, vtkActor* actor)
{
  const double* color = actor->GetProperty()->GetDiffuseColor();
  const bool isWhite = color[0] == 1.0 && color[1] == 1.0 && color[2] == 1.0;
  int cellFlag = 0;
  const bool hasScalars = mapper->GetScalarVisibility() &&
    vtkAbstractMapper::GetScalars(vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0)),
      mapper->GetScalarMode(), mapper->GetArrayAccessMode(), mapper->GetArrayId(),
      mapper->GetArrayName(), cellFlag);
  return !isWhite || hasScalars || actor->GetTexture();
}
}

//------------------------------------------------------------------------------
PageScale PageScale::Of(vtkRenderer* renderer)
{
  const int* size = renderer->GetSize();
  vtkCamera* camera = renderer->GetActiveCamera();
  const double height = camera->GetParallelProjection() ? 2.0 * camera->GetParallelScale()
                                                        : 2.0 * camera->GetDistance() *
      std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  PageScale scale;
  const int shorter = std::max(1, std::min(size[0], size[1]));
  scale.PixelsPerUnit = shorter / 1000.0;
  scale.PixelsPerUnitOfWidth = std::max(shorter, SmallestSide) / 1000.0;
  scale.WorldPerPixel = height / std::max(1, size[1]);
  return scale;
}

//------------------------------------------------------------------------------
double PageScale::GetUnit(vtkMatrix4x4* modelToWorld) const
{
  return this->PixelsPerUnit * this->WorldPerPixel / ScaleOf(modelToWorld);
}

//------------------------------------------------------------------------------
bool ActorIllustration::Accepts(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper || !actor->GetVisibility() || mapper->GetNumberOfInputConnections(0) == 0 ||
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return false;
  }
  mapper->GetInputAlgorithm()->Update();
  if (vtkPolyData* surface = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)))
  {
    return surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0;
  }
  return vtkCompositeDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0)) ||
    vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
}

//------------------------------------------------------------------------------
ActorIllustration::ActorIllustration(
  vtkActor* actor, vtkRenderer* renderer, const StyleDocument& style, const PageScale& scale)
  : Actor(actor), Renderer(renderer), OriginalMapper(actor->GetMapper()),
    OriginalProperty(actor->GetProperty())
{
  vtkPolyData* surface = vtkPolyData::SafeDownCast(this->OriginalMapper->GetInputDataObject(0, 0));
  if (!surface)
  {
    this->Source = MakeSurfaceSource(this->OriginalMapper);
  }
  this->Pipeline.SetInputConnection(
    this->Source ? this->Source->GetOutputPort() : this->OriginalMapper->GetInputConnection(0, 0));

  // Refinement welds points, and a texture needs each of its copies.
  const bool isTextured = actor->GetTexture() && surface && surface->GetPointData()->GetTCoords();
  vtkMatrix4x4* matrix = actor->GetMatrix();
  this->MatrixScale = ScaleOf(matrix);
  this->Pipeline.Tune(style.Geometry, scale.GetUnit(matrix), !isTextured);
  this->ShadeSurface(style, isTextured ? surface : nullptr);

  vtkNPRFeatureLines* lines = this->Pipeline.GetFeatureLines();
  lines->SetCamera(renderer->GetActiveCamera());
  lines->SetMatrix(matrix);
  for (std::size_t i = 0; i < style.Lines.size(); ++i)
  {
    lines->AddDefinition(MakeLineDefinition(style.Lines[i], "/lines/" + std::to_string(i)));
    this->AddStrokes(style.Lines[i], matrix);
  }
  this->SetScale(scale);
}

//------------------------------------------------------------------------------
ActorIllustration::~ActorIllustration()
{
  for (Strokes& strokes : this->AllStrokes)
  {
    this->Renderer->RemoveActor(strokes.Actor);
  }
  if (this->IsCurrent())
  {
    this->Actor->SetMapper(this->OriginalMapper);
    this->Actor->SetProperty(this->OriginalProperty);
  }
}

//------------------------------------------------------------------------------
bool ActorIllustration::IsCurrent() const
{
  return this->Actor->GetMapper() == this->SurfaceMapper;
}

//------------------------------------------------------------------------------
void ActorIllustration::ShadeSurface(const StyleDocument& style, vtkPolyData* textured)
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->vtkMapper::ShallowCopy(this->OriginalMapper);
  if (!textured)
  {
    mapper->SetInputConnection(this->Pipeline.GetSurfacePort());
  }
  else if (textured->GetPointData()->GetNormals())
  {
    mapper->SetInputConnection(this->OriginalMapper->GetInputConnection(0, 0));
  }
  else
  {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(this->OriginalMapper->GetInputConnection(0, 0));
    normals->SetFeatureAngle(style.Geometry.CreaseAngle);
    mapper->SetInputConnection(normals->GetOutputPort());
  }

  vtkNew<vtkProperty> property;
  property->DeepCopy(this->OriginalProperty);
  const ShadingStyle& shading = style.Shading;
  if (IsPaper(shading))
  {
    property->LightingOff();
    property->SetColor(
      style.BackgroundBottom[0], style.BackgroundBottom[1], style.BackgroundBottom[2]);
    property->SetOpacity(1.0);
    mapper->ScalarVisibilityOff();
  }
  else
  {
    property->SetInterpolationToPhong();
    property->SetAmbient(shading.Ambient);
    property->SetDiffuse(shading.Diffuse);
    property->SetSpecular(shading.Specular);
    property->SetSpecularPower(shading.SpecularPower);
    if (!HasOwnColor(this->OriginalMapper, this->Actor))
    {
      property->SetColor(shading.Surface[0], shading.Surface[1], shading.Surface[2]);
    }
  }
  this->SurfaceMapper = mapper;
  this->Actor->SetMapper(mapper);
  this->Actor->SetProperty(property);
}

//------------------------------------------------------------------------------
void ActorIllustration::AddStrokes(const LineStyle& line, vtkMatrix4x4* matrix)
{
  Strokes strokes;
  strokes.WidthInUnits = line.Width;

  strokes.MinimumLengthInUnits = line.MinimumLength;

  strokes.Selection = vtkSmartPointer<vtkNPRLineSelection>::New();
  strokes.Selection->SetInputConnection(this->Pipeline.GetFeatureLines()->GetOutputPort());
  strokes.Selection->SetLineType(line.Type);

  strokes.Splines = vtkSmartPointer<vtkNPRSplineStrokes>::New();
  strokes.Splines->SetInputConnection(strokes.Selection->GetOutputPort());
  const bool straight = line.Spline == "none" || this->Pipeline.IsFaceted();
  strokes.Splines->SetSplineType(straight ? vtkNPRSplineStrokes::NONE
      : line.Spline == "b-spline"         ? vtkNPRSplineStrokes::B_SPLINE
                                          : vtkNPRSplineStrokes::CATMULL_ROM);
  strokes.Splines->SetSmoothingIterations(this->Pipeline.IsFaceted() ? 0 : line.Smoothing);

  strokes.Mapper = vtkSmartPointer<vtkNPRStrokeMapper>::New();
  strokes.Mapper->SetInputConnection(strokes.Splines->GetOutputPort());
  strokes.Mapper->SetStrengthToWidth(line.Taper);
  strokes.Mapper->SetStrengthToOpacity(line.Fade);

  strokes.Actor = vtkSmartPointer<vtkActor>::New();
  strokes.Actor->SetMapper(strokes.Mapper);
  strokes.Actor->SetUserMatrix(matrix);
  strokes.Actor->GetProperty()->SetColor(line.Ink[0], line.Ink[1], line.Ink[2]);
  strokes.Actor->GetProperty()->SetOpacity(line.Opacity);
  strokes.Actor->PickableOff();
  strokes.Actor->UseBoundsOff();
  this->Renderer->AddActor(strokes.Actor);
  this->AllStrokes.push_back(strokes);
}

//------------------------------------------------------------------------------
void ActorIllustration::SetScale(const PageScale& scale)
{
  // Splines are sampled anew only when the view has come notably closer or gone away, so that a
  // turning camera does not.
  const double pixel = scale.WorldPerPixel / this->MatrixScale;
  const bool resample = !(std::abs(pixel - this->SampledPixel) <= 0.25 * this->SampledPixel);
  for (Strokes& strokes : this->AllStrokes)
  {
    strokes.Mapper->SetWidth(strokes.WidthInUnits * scale.PixelsPerUnitOfWidth);
    if (resample)
    {
      strokes.Splines->SetMaximumChordError(0.1 * pixel);
      strokes.Selection->SetMinimumLength(
        strokes.MinimumLengthInUnits * scale.PixelsPerUnit * pixel);
    }
  }
  if (resample)
  {
    this->SampledPixel = pixel;
  }
}

//------------------------------------------------------------------------------
void ActorIllustration::SetWorldLengthScale(double scale)
{
  this->Pipeline.GetFeatureLines()->SetLengthScale(scale / this->MatrixScale);
}
}
