// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokePicking.h"

#include <vtkCollection.h>
#include <vtkHardwareSelector.h>
#include <vtkOpenGLError.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>

namespace npr
{
namespace
{
thread_local bool DrawingDepth = false;
}

StrokePicking::StrokePicking() = default;
StrokePicking::~StrokePicking() = default;

bool StrokePicking::IsDrawingDepth()
{
  return DrawingDepth;
}

void StrokePicking::DrawDepth(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, int width, int height)
{
  const bool isFirstPass =
    renderer->GetSelector()->GetCurrentPass() == vtkHardwareSelector::ACTOR_PASS;
  if (this->Renderer == renderer && !isFirstPass)
  {
    return;
  }
  this->Renderer = renderer;
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport savedViewport(state);
  vtkOpenGLState::ScopedglDepthMask savedDepthMask(state);
  vtkOpenGLState::ScopedglDepthFunc savedDepthFunc(state);
  vtkOpenGLState::ScopedglEnableDisable savedDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedScissor(state, GL_SCISSOR_TEST);
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  const bool fresh = this->Depth->GetHandle() == 0;
  if (fresh)
  {
    this->Depth->SetContext(window);
    this->Depth->AllocateDepth(width, height, vtkTextureObject::Float32);
  }
  this->Depth->Resize(width, height);
  this->Framebuffer->Bind();
  if (fresh)
  {
    this->Framebuffer->AddDepthAttachment(this->Depth);
    this->Framebuffer->DeactivateDrawBuffers();
  }
  state->vtkglViewport(0, 0, width, height);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  DrawingDepth = true;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop->GetVisibility() && prop->IsA("vtkProp3D"))
    {
      prop->RenderOpaqueGeometry(renderer);
    }
  }
  DrawingDepth = false;
  state->PopFramebufferBindings();
}

void StrokePicking::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->Renderer = nullptr;
}
}
