// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprRendererIllustration.h"

#include "nprPageScale.h"
#include "nprStyleObjects.h"
#include "vtkNPREdgePass.h"
#include "vtkNPRShadingPass.h"
#include "vtkNPRShadingStyle.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>

namespace npr
{
//------------------------------------------------------------------------------
RendererIllustration::RendererIllustration(vtkRenderer* renderer, const StyleDocument& style)
  : Renderer(renderer), Pass(renderer->GetPass()),
    AutomaticLights(renderer->GetAutomaticLightCreation() != 0),
    Gradient(renderer->GetGradientBackground()), DepthPeeling(renderer->GetUseDepthPeeling() != 0)
{
  // With it strokes would lie over volumes and annotations, too.
  renderer->UseDepthPeelingOff();
  renderer->GetBackground(this->Background);
  renderer->GetBackground2(this->Background2);
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    this->Lights.emplace_back(light);
  }

  const Color& bottom = style.BackgroundBottom;
  const Color& top = style.BackgroundTop;
  renderer->SetBackground(bottom[0], bottom[1], bottom[2]);
  renderer->SetBackground2(top[0], top[1], top[2]);
  renderer->SetGradientBackground(bottom != top);
  if (!style.Lights.empty())
  {
    this->SetLights(style.Lights);
  }
  if (NeedsShading(style))
  {
    this->SetShading(style);
  }
}

//------------------------------------------------------------------------------
RendererIllustration::~RendererIllustration()
{
  this->Renderer->SetPass(this->Pass);
  this->Renderer->SetUseDepthPeeling(this->DepthPeeling);
  this->Renderer->SetBackground(this->Background);
  this->Renderer->SetBackground2(this->Background2);
  this->Renderer->SetGradientBackground(this->Gradient);
  this->Renderer->RemoveAllLights();
  for (const auto& light : this->Lights)
  {
    this->Renderer->AddLight(light);
  }
  this->Renderer->SetAutomaticLightCreation(this->AutomaticLights);
}

//------------------------------------------------------------------------------
void RendererIllustration::Follow(const PageScale& scale)
{
  if (this->Shading)
  {
    this->Shading->SetOutlineWidth(this->OutlineWidth * scale.PixelsPerUnitOfWidth);
  }
  if (this->Edges)
  {
    this->Edges->SetWidth(this->OutlineWidth * scale.PixelsPerUnitOfWidth);
  }
}

//------------------------------------------------------------------------------
void RendererIllustration::SetLights(const std::vector<LightStyle>& lights)
{
  this->Renderer->RemoveAllLights();
  this->Renderer->AutomaticLightCreationOff();
  for (const LightStyle& style : lights)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetDirectionAngle(style.Elevation, style.Azimuth);
    light->SetIntensity(style.Intensity);
    light->SetColor(style.Tint[0], style.Tint[1], style.Tint[2]);
    this->Renderer->AddLight(light);
  }
}

//------------------------------------------------------------------------------
void RendererIllustration::SetShading(const StyleDocument& style)
{
  this->Shading = vtkSmartPointer<vtkNPRShadingPass>::New();
  this->Shading->SetStyle(MakeShadingStyle(style.Shading));
  this->Shading->SetDelegatePass(this->Pass);
  this->SetOutline(style.Outline);
  this->Renderer->SetPass(this->Shading);
}

//------------------------------------------------------------------------------
void RendererIllustration::SetOutline(const OutlineStyle& outline)
{
  this->OutlineWidth = outline.Width;
  this->Shading->SetOutlineColor(outline.Ink[0], outline.Ink[1], outline.Ink[2]);
  this->Shading->SetOutlineThreshold(outline.GrazingThreshold);
  this->Shading->SetOutlineSoftness(outline.GrazingSoftness);
  switch (outline.Kind)
  {
    case OutlineStyle::BackFaces:
      this->Shading->SetOutline(vtkNPRShadingPass::BackFaces);
      break;
    case OutlineStyle::Grazing:
      this->Shading->SetOutline(vtkNPRShadingPass::Grazing);
      break;
    case OutlineStyle::ImageEdges:
      // The steps are those of the shading pass where the renderer brings no pass of its own.
      this->OutlineIsDrawn = !this->Pass;
      break;
    default:
      break;
  }
  auto* steps = vtkRenderStepsPass::SafeDownCast(this->Shading->GetDelegatePass());
  if (outline.Kind == OutlineStyle::ImageEdges && this->OutlineIsDrawn && steps)
  {
    this->Edges = vtkSmartPointer<vtkNPREdgePass>::New();
    this->Edges->SetColor(outline.Ink[0], outline.Ink[1], outline.Ink[2]);
    this->Edges->SetDepthThreshold(outline.DepthThreshold);
    this->Edges->SetNormalThreshold(outline.NormalThreshold);
    this->Edges->SetObjectEdges(outline.ObjectEdges);
    steps->SetOpaquePass(this->Edges);
  }
}
}
