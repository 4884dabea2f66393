// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRIllustration.h"

#include "nprActorIllustration.h"
#include "nprArrayNames.h"
#include "nprCutLines.h"
#include "nprInteraction.h"
#include "nprPageScale.h"
#include "nprPaperStrokes.h"
#include "nprRendererIllustration.h"
#include "nprStyleDocument.h"
#include "nprStyleObjects.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPRStrokeVisibility.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>
#include <map>
#include <vector>

vtkStandardNewMacro(vtkNPRIllustration);

namespace
{
// Those that are on, by their renderers.
std::map<vtkRenderer*, vtkNPRIllustration*>& GetIllustrations()
{
  static std::map<vtkRenderer*, vtkNPRIllustration*> illustrations;
  return illustrations;
}
}

//------------------------------------------------------------------------------
class vtkNPRIllustration::Internals
{
public:
  explicit Internals(vtkNPRIllustration* self) : Self(self) {}

  int GetNumberOfLineTypes() const
  {
    return this->IsOn() ? static_cast<int>(this->LineNames.size()) : 0;
  }

  bool IsOn() const { return this->OnRenderer != nullptr; }

  void Clear()
  {
    if (this->Renderer)
    {
      this->Renderer->RemoveObserver(this->StartObserver);
      GetIllustrations().erase(this->Renderer);
    }
    this->Cut.reset();
    this->Actors.clear();
    this->OnRenderer.reset();
    this->Renderer = nullptr;
  }

  void Apply(vtkRenderer* renderer, const npr::StyleDocument& style)
  {
    // What another has changed would come back, or go, in the wrong order.
    const auto other = GetIllustrations().find(renderer);
    if (other != GetIllustrations().end())
    {
      other->second->Remove();
    }
    GetIllustrations()[renderer] = this->Self;
    this->Renderer = renderer;
    this->OnRenderer = std::make_unique<npr::RendererIllustration>(renderer, style);
    if (!this->OnRenderer->HasOutline())
    {
      vtkWarningWithObjectMacro(this->Self,
        "the outline image-edges is not drawn: the renderer has a render pass of its own; take it "
        "off, or choose back-faces or grazing");
    }
    this->Cut = std::make_unique<npr::CutLines>();
    this->LineNames = npr::GetLineNames(style);

    // Only what stands in the renderer itself: the parts of an assembly have its matrix, too.
    std::vector<vtkActor*> actors;
    vtkPropCollection* props = renderer->GetViewProps();
    vtkCollectionSimpleIterator cookie;
    props->InitTraversal(cookie);
    while (vtkProp* prop = props->GetNextProp(cookie))
    {
      vtkActor* actor = vtkActor::SafeDownCast(prop);
      if (actor && npr::ActorIllustration::Accepts(actor))
      {
        actors.push_back(actor);
      }
    }
    const npr::PageScale scale = npr::PageScale::Of(renderer);
    for (std::size_t i = 0; i < actors.size(); ++i)
    {
      const auto progress = [&, i](double fraction)
      {
        double whole = (static_cast<double>(i) + fraction) / static_cast<double>(actors.size());
        this->Self->InvokeEvent(vtkCommand::ProgressEvent, &whole);
      };
      this->Actors.push_back(
        std::make_unique<npr::ActorIllustration>(actors[i], renderer, style, scale, progress));
      this->Actors.back()->GetPipeline().SetProgress(nullptr);
    }
    this->ShareLengthScale();
    this->StartObserver = renderer->AddObserver(
      vtkCommand::StartEvent, this, &vtkNPRIllustration::Internals::OnStartOfRender);
  }

  void GetLines(vtkPolyData* lines)
  {
    lines->Initialize();
    vtkNew<vtkAppendPolyData> append;
    vtkSmartPointer<vtkFieldData> names;
    for (const auto& actor : this->Actors)
    {
      actor->Follow(npr::PageScale::Of(this->Renderer));
      vtkNew<vtkTransform> transform;
      transform->SetMatrix(actor->GetActor()->GetMatrix());
      vtkNew<vtkTransformPolyDataFilter> toWorld;
      toWorld->SetTransform(transform);
      toWorld->SetInputConnection(actor->GetPipeline().GetFeatureLines()->GetOutputPort());
      toWorld->Update();
      append->AddInputData(toWorld->GetOutput());
      names = toWorld->GetOutput()->GetFieldData();
    }
    if (names)
    {
      append->Update();
      lines->ShallowCopy(append->GetOutput());
      lines->GetFieldData()->AddArray(names->GetAbstractArray(npr::names::LineTypeNames));
    }
  }

  void GetStrokes(vtkPolyData* strokes, int maximumLayers)
  {
    const npr::PageScale scale = npr::PageScale::Of(this->Renderer);
    for (const auto& actor : this->Actors)
    {
      actor->Follow(scale);
    }
    this->Cut->Update(this->Actors, this->Renderer, scale, maximumLayers, false);
    npr::CollectStrokes(this->Actors, this->LineNames, strokes);
  }

  void SetLineVisibility(int lineType, bool visible)
  {
    for (const auto& actor : this->Actors)
    {
      actor->SetLineVisibility(lineType, visible);
    }
  }

  double GetSeconds(const std::string& stage) const
  {
    if (this->Cut && (stage == "visibility" || stage == "strokes"))
    {
      return stage == "strokes" ? this->Cut->GetStrokesSeconds()
                                : this->Cut->GetVisibilitySeconds();
    }
    double seconds = 0.0;
    for (const auto& actor : this->Actors)
    {
      seconds += actor->GetPipeline().GetSeconds(stage);
    }
    return seconds;
  }

private:
  /// Thresholds mean the same on all parts of a model: those of its largest part.
  void ShareLengthScale()
  {
    double largest = 0.0;
    for (const auto& actor : this->Actors)
    {
      largest = std::max(largest, actor->GetWorldLengthScale());
    }
    for (const auto& actor : this->Actors)
    {
      actor->SetWorldLengthScale(largest);
    }
  }

  void OnStartOfRender()
  {
    const npr::PageScale scale = npr::PageScale::Of(this->Renderer);
    this->OnRenderer->Follow(scale);
    for (const auto& actor : this->Actors)
    {
      actor->Follow(scale);
      actor->CullBackFaces();
    }
    this->ShareLengthScale();
    const bool exact = this->Self->GetStrokeVisibility() == EXACT &&
      !npr::IsInteractive(this->Renderer->GetRenderWindow());
    for (const auto& actor : this->Actors)
    {
      for (npr::LineStrokes& strokes : actor->GetStrokes())
      {
        strokes.DrawParts(exact);
      }
    }
    if (exact)
    {
      this->Cut->Update(this->Actors, this->Renderer, scale, 1, true);
    }
  }

  vtkNPRIllustration* Self;
  vtkSmartPointer<vtkRenderer> Renderer;
  std::unique_ptr<npr::RendererIllustration> OnRenderer;
  std::vector<std::unique_ptr<npr::ActorIllustration>> Actors;
  std::unique_ptr<npr::CutLines> Cut;
  std::vector<std::string> LineNames;
  unsigned long StartObserver = 0;
};

//------------------------------------------------------------------------------
vtkNPRIllustration::vtkNPRIllustration()
  : Internal(std::make_unique<Internals>(this)),
    Style(vtkSmartPointer<vtkNPRIllustrationStyle>::New()),
    StrokeVisibility(vtkNPRStrokeVisibility::IsAvailable() ? EXACT : DEPTH_BUFFER)
{
}

//------------------------------------------------------------------------------
vtkNPRIllustration::~vtkNPRIllustration()
{
  this->Internal->Clear();
}

//------------------------------------------------------------------------------
void vtkNPRIllustration::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != renderer)
  {
    this->Remove();
    this->Renderer = renderer;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkNPRIllustration::GetRenderer() const
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
void vtkNPRIllustration::SetStyle(vtkNPRIllustrationStyle* style)
{
  if (this->Style != style && style)
  {
    this->Style = style;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkNPRIllustrationStyle* vtkNPRIllustration::GetStyle() const
{
  return this->Style;
}

//------------------------------------------------------------------------------
void vtkNPRIllustration::SetStrokeVisibility(int visibility)
{
  const int clamped = std::clamp<int>(visibility, DEPTH_BUFFER, EXACT);
  if (clamped == this->StrokeVisibility)
  {
    return;
  }
  if (clamped == EXACT && !CheckEmbree())
  {
    return;
  }
  this->StrokeVisibility = clamped;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkNPRIllustration::CheckEmbree()
{
  const bool good = vtkNPRStrokeVisibility::IsAvailable();
  if (!good)
  {
    vtkErrorMacro("what is hidden can not be found by this build, which has no Embree; configure "
                  "it with -DNPR_USE_EMBREE=ON");
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkNPRIllustration::Apply()
{
  if (!this->Renderer)
  {
    vtkErrorMacro("there is no renderer to illustrate; call SetRenderer() first");
    return false;
  }
  this->Internal->Clear();
  this->Internal->Apply(this->Renderer, *this->Style->Document);
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRIllustration::GetLines(vtkPolyData* lines)
{
  if (!this->Internal->IsOn() || !lines)
  {
    vtkErrorMacro(
      "there are no lines before Apply(), and none without a vtkPolyData to put them in");
    return false;
  }
  this->Internal->GetLines(lines);
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRIllustration::GetStrokes(vtkPolyData* strokes, int maximumLayers)
{
  if (!this->Internal->IsOn() || !strokes)
  {
    vtkErrorMacro(
      "there are no strokes before Apply(), and none without a vtkPolyData to put them in");
    return false;
  }
  if (!this->CheckEmbree())
  {
    return false;
  }
  this->Internal->GetStrokes(strokes, std::max(maximumLayers, 1));
  return true;
}

//------------------------------------------------------------------------------
int vtkNPRIllustration::GetNumberOfLineTypes() const
{
  return this->Internal->GetNumberOfLineTypes();
}

//------------------------------------------------------------------------------
void vtkNPRIllustration::SetLineVisibility(int lineType, bool visible)
{
  this->Internal->SetLineVisibility(lineType, visible);
}

//------------------------------------------------------------------------------
void vtkNPRIllustration::Remove()
{
  this->Internal->Clear();
}

//------------------------------------------------------------------------------
double vtkNPRIllustration::GetStageSeconds(const std::string& stage) const
{
  return this->Internal->GetSeconds(stage);
}

//------------------------------------------------------------------------------
void vtkNPRIllustration::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
  os << indent
     << "StrokeVisibility: " << (this->StrokeVisibility == EXACT ? "Exact" : "Depth buffer")
     << "\n";
  os << indent << "Style:\n";
  this->Style->PrintSelf(os, indent.GetNextIndent());
}
