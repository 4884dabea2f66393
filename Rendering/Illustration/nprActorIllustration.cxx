// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprActorIllustration.h"

#include "nprStyleDocument.h"
#include "nprStyleObjects.h"
#include "nprSurfaceSource.h"
#include "nprVisibleSides.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRLineDefinition.h"
#include "vtkNPROutlineNormals.h"
#include "vtkNPRStrokeMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace npr
{
namespace
{
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

std::set<std::string> GetQuantities(const StyleDocument& style)
{
  std::set<std::string> quantities(style.Quantities.begin(), style.Quantities.end());
  for (const LineStyle& line : GetDrawnLines(style))
  {
    for (const std::string& quantity : line.Stroke.GetQuantities())
    {
      quantities.insert(quantity);
    }
  }
  return quantities;
}
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
  const vtkSmartPointer<vtkAlgorithm> source = MakeSurfaceSource(mapper);
  if (source)
  {
    source->Update();
  }
  auto surface = vtkPolyData::SafeDownCast(
    source ? source->GetOutputDataObject(0) : mapper->GetInputDataObject(0, 0));
  return surface && surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0;
}

//------------------------------------------------------------------------------
ActorIllustration::ActorIllustration(vtkActor* actor, vtkRenderer* renderer,
  const StyleDocument& style, const PageScale& scale, std::function<void(double)> progress)
  : Actor(actor), Renderer(renderer), OriginalMapper(actor->GetMapper()),
    OriginalProperty(actor->GetProperty()), OriginalTexture(actor->GetTexture()),
    SurfaceMapper(vtkSmartPointer<vtkPolyDataMapper>::New())
{
  this->Pipeline.SetProgress(std::move(progress));
  // Refinement welds points, and a texture needs each of its copies.
  auto surface = vtkPolyData::SafeDownCast(this->OriginalMapper->GetInputDataObject(0, 0));
  this->IsTextured = this->OriginalTexture && !IsPaper(style.Shading) && surface &&
    surface->GetPointData()->GetTCoords();
  if (this->IsTextured && !surface->GetPointData()->GetNormals())
  {
    this->ShownNormals = vtkSmartPointer<vtkPolyDataNormals>::New();
    this->ShownNormals->SetFeatureAngle(style.Geometry.CreaseAngle);
  }
  this->SurfaceMapper->vtkMapper::ShallowCopy(this->OriginalMapper);
  if (style.Outline.Kind == OutlineStyle::BackFaces)
  {
    this->OutlineNormals = vtkSmartPointer<vtkNPROutlineNormals>::New();
    vtkNPROutlineNormals::PassTo(this->SurfaceMapper);
  }
  this->Connect();
  this->MatrixScale = ComputeScale(actor->GetMatrix());
  this->Pipeline.Tune(style.Geometry, scale.GetUnit(actor->GetMatrix()), !this->IsTextured);
  this->ShadeSurface(style);

  vtkNPRFeatureLines* lines = this->Pipeline.GetFeatureLines();
  lines->SetMatrix(actor->GetMatrix());
  for (const LineStyle& line : GetDrawnLines(style))
  {
    this->AllStrokes.emplace_back(line, lines->GetNumberOfDefinitions(),
      style.Lights.empty() ? LightStyle() : style.Lights.front(), this->Pipeline,
      actor->GetMatrix());
    LineStrokes& strokes = this->AllStrokes.back();
    strokes.GetMapper()->SetClippingPlanes(this->OriginalMapper->GetClippingPlanes());
    renderer->AddActor(strokes.GetActor());
    lines->AddDefinition(MakeLineDefinition(line, "/lines"));
  }
  for (const std::string& quantity : GetQuantities(style))
  {
    lines->AddQuantity(quantity.c_str());
  }
  if (lines->GetNumberOfDefinitions() == 0)
  {
    this->Pipeline.SkipCurvature();
  }
  this->Follow(scale);
  this->Pipeline.Update();
}

//------------------------------------------------------------------------------
ActorIllustration::~ActorIllustration()
{
  for (LineStrokes& strokes : this->AllStrokes)
  {
    this->Renderer->RemoveActor(strokes.GetActor());
  }
  if (this->Actor->GetMapper() == this->SurfaceMapper)
  {
    this->Actor->SetMapper(this->OriginalMapper);
    this->Actor->SetProperty(this->OriginalProperty);
    this->Actor->SetTexture(this->OriginalTexture);
  }
}

//------------------------------------------------------------------------------
void ActorIllustration::Connect()
{
  this->Input = this->OriginalMapper->GetInputConnection(0, 0);
  this->Source = MakeSurfaceSource(this->OriginalMapper);
  this->Pipeline.SetInputConnection(
    this->Source ? this->Source->GetOutputPort() : this->Input.Get());
  vtkAlgorithmOutput* shown = this->IsTextured ? this->Input.Get() : this->Pipeline.GetShadedPort();
  if (this->ShownNormals)
  {
    this->ShownNormals->SetInputConnection(shown);
    shown = this->ShownNormals->GetOutputPort();
  }
  if (this->OutlineNormals)
  {
    this->OutlineNormals->SetInputConnection(shown);
    shown = this->OutlineNormals->GetOutputPort();
  }
  this->SurfaceMapper->SetInputConnection(shown);
}

//------------------------------------------------------------------------------
void ActorIllustration::SetLineVisibility(int index, bool visible)
{
  if (index >= 0 && index < static_cast<int>(this->AllStrokes.size()))
  {
    this->AllStrokes[index].IsVisible = visible;
  }
}

//------------------------------------------------------------------------------
bool ActorIllustration::IsShown()
{
  return this->Actor->GetVisibility() && this->Actor->GetMapper() == this->SurfaceMapper &&
    this->Renderer->HasViewProp(this->Actor);
}

//------------------------------------------------------------------------------
void ActorIllustration::Follow(const PageScale& scale)
{
  const bool isShown = this->IsShown();
  for (LineStrokes& strokes : this->AllStrokes)
  {
    strokes.GetActor()->SetVisibility(isShown && strokes.IsVisible);
  }
  if (!isShown)
  {
    return;
  }
  if (this->OriginalMapper->GetNumberOfInputConnections(0) > 0 &&
    this->OriginalMapper->GetInputConnection(0, 0) != this->Input)
  {
    this->Connect();
  }
  // Asking for the matrix brings it up to date; lines and strokes hold on to the object.
  this->MatrixScale = ComputeScale(this->Actor->GetMatrix());
  this->Pipeline.GetFeatureLines()->SetCamera(this->Renderer->GetActiveCamera());
  this->SetScale(scale);
}

//------------------------------------------------------------------------------
// The far side of what is closed is never seen, but takes nearly half of the time to draw.
void ActorIllustration::CullBackFaces()
{
  if (!this->IsShown())
  {
    return;
  }
  vtkPlaneCollection* const planes = this->OriginalMapper->GetClippingPlanes();
  const bool isSeenInside = this->IsTextured || (planes && planes->GetNumberOfItems() > 0) ||
    this->Actor->HasTranslucentPolygonalGeometry() ||
    this->Actor->GetMatrix()->Determinant() <= 0.0 || !this->Pipeline.ShowsOnlyFronts() ||
    !IsInFrontOf(this->Renderer->GetActiveCamera(), this->Actor->GetBounds());
  this->Actor->GetProperty()->SetBackfaceCulling(this->CullsBackFaces || !isSeenInside);
}

//------------------------------------------------------------------------------
void ActorIllustration::SetScale(const PageScale& scale)
{
  // Splines are sampled anew only when the view has come notably closer or gone away, so that a
  // turning camera does not.
  const double pixel = scale.WorldPerPixel / this->MatrixScale;
  const bool resample = !(std::abs(pixel - this->SampledPixel) <= 0.25 * this->SampledPixel);
  for (LineStrokes& strokes : this->AllStrokes)
  {
    strokes.SetScale(scale, this->Renderer->GetActiveCamera(), pixel, resample);
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

//------------------------------------------------------------------------------
void ActorIllustration::ShadeSurface(const StyleDocument& style)
{
  vtkNew<vtkProperty> property;
  property->DeepCopy(this->OriginalProperty);
  this->CullsBackFaces = property->GetBackfaceCulling() != 0;
  const ShadingStyle& shading = style.Shading;
  if (IsPaper(shading))
  {
    const Color& paper = style.BackgroundBottom;
    property->SetLighting(NeedsShading(style)); // an outline needs normals
    property->SetInterpolationToPhong();
    property->SetColor(paper[0], paper[1], paper[2]);
    property->SetDiffuse(1.0);
    property->SetOpacity(1.0);
    this->SurfaceMapper->ScalarVisibilityOff();
    this->Actor->SetTexture(nullptr);
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
  this->Actor->SetMapper(this->SurfaceMapper);
  this->Actor->SetProperty(property);
}
}
