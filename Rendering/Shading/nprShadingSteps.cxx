// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprShadingSteps.h"

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace npr
{
namespace
{
// Strokes know the picture below them, and are laid over it one after another.
bool IsLaidOver(vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  return actor && actor->GetMapper() && actor->GetMapper()->IsA("vtkNPRStrokeMapper");
}

// The renderer knows better than a vtkTranslucentPass how its translucent props are to be drawn,
// but what it does for their order is spent in vain where there are strokes alone.
class TranslucentStep : public vtkRenderPass
{
public:
  static TranslucentStep* New();
  vtkTypeMacro(TranslucentStep, vtkRenderPass);
  void Render(const vtkRenderState* state) override
  {
    this->NumberOfRenderedProps = 0;
    std::vector<vtkProp*> props(
      state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount());
    props.erase(std::remove_if(props.begin(), props.end(),
                  [](vtkProp* prop) { return !prop->HasTranslucentPolygonalGeometry(); }),
      props.end());
    if (!std::all_of(props.begin(), props.end(), IsLaidOver))
    {
      state->GetRenderer()->DeviceRenderTranslucentPolygonalGeometry();
      return;
    }
    for (vtkProp* prop : props)
    {
      this->NumberOfRenderedProps += prop->RenderTranslucentPolygonalGeometry(state->GetRenderer());
    }
  }
};
vtkStandardNewMacro(TranslucentStep);

// Draws opaque props, and what is to come after them and before translucent ones.
class OpaqueStep : public vtkOpaquePass
{
public:
  static OpaqueStep* New();
  vtkTypeMacro(OpaqueStep, vtkOpaquePass);
  void Render(const vtkRenderState* state) override
  {
    this->Superclass::Render(state);
    this->After();
  }
  std::function<void()> After;
};
vtkStandardNewMacro(OpaqueStep);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderPass> MakeShadingSteps(std::function<void()> afterOpaque)
{
  auto steps = vtkSmartPointer<vtkRenderStepsPass>::New();
  auto opaque = vtkSmartPointer<OpaqueStep>::New();
  opaque->After = std::move(afterOpaque);
  steps->SetOpaquePass(opaque);
  steps->SetTranslucentPass(vtkSmartPointer<TranslucentStep>::New());
  return steps;
}
}
