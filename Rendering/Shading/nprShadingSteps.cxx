// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprShadingSteps.h"

#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

namespace npr
{
namespace
{
// The renderer knows better than a vtkTranslucentPass how its translucent props are to be drawn.
class TranslucentStep : public vtkRenderPass
{
public:
  static TranslucentStep* New();
  vtkTypeMacro(TranslucentStep, vtkRenderPass);
  void Render(const vtkRenderState* state) override
  {
    this->NumberOfRenderedProps = 0;
    vtkProp** props = state->GetPropArray();
    if (std::any_of(props, props + state->GetPropArrayCount(),
          [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; }))
    {
      state->GetRenderer()->DeviceRenderTranslucentPolygonalGeometry();
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
