// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprEdgeBuffers.h"

#include <vtkOpenGLError.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <algorithm>

namespace npr
{
namespace
{
// Far from those that render passes use for themselves; eight are in every OpenGL 3.
constexpr GLenum SurfaceAttachment = GL_COLOR_ATTACHMENT0 + 7;

int GetInteger(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

void MakeTarget(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  vtkOpenGLFramebufferObject* framebuffer, const int size[2], int components)
{
  texture->SetContext(window);
  texture->Allocate2D(size[0], size[1], components, VTK_UNSIGNED_CHAR);
  framebuffer->SetContext(window);
  framebuffer->Bind();
  framebuffer->AddColorAttachment(0, texture);
}

void BindTarget(vtkOpenGLFramebufferObject* framebuffer)
{
  framebuffer->Bind();
  framebuffer->ActivateDrawBuffer(0);
}
}

//------------------------------------------------------------------------------
void EdgeBuffers::Allocate(vtkOpenGLRenderWindow* window, const int viewport[4], int samples)
{
  if (this->Surfaces->GetHandle() != 0 && samples == this->Samples &&
    std::equal(viewport, viewport + 4, this->Viewport))
  {
    return;
  }
  this->ReleaseGraphicsResources(window);
  std::copy_n(viewport, 4, this->Viewport);
  this->Samples = samples;
  this->Surfaces->SetContext(window);
  this->Surfaces->SetSamples(samples);
  this->Surfaces->Allocate2D(viewport[0] + viewport[2], viewport[1] + viewport[3], 4, VTK_FLOAT);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  MakeTarget(window, this->Edges, this->EdgeFramebuffer, this->Viewport + 2, 2);
  MakeTarget(window, this->Linked, this->LinkedFramebuffer, this->Viewport + 2, 2);
  MakeTarget(window, this->Lines, this->LineFramebuffer, this->Viewport + 2, 4);
  const int blocks[2] = { (viewport[2] + BlockSize - 1) / BlockSize,
    (viewport[3] + BlockSize - 1) / BlockSize };
  MakeTarget(window, this->Blocks, this->BlockFramebuffer, blocks, 1);
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
bool EdgeBuffers::BeginSurfaces(vtkOpenGLRenderWindow* window, const int viewport[4])
{
  // The framebuffer of a window system takes no attachments.
  if (GetInteger(GL_DRAW_FRAMEBUFFER_BINDING) == 0 || GetInteger(GL_DRAW_BUFFER1) != GL_NONE ||
    viewport[2] < 1 || viewport[3] < 1)
  {
    return false;
  }
  this->Allocate(window, viewport, GetInteger(GL_SAMPLES));
  this->FirstBuffer = GetInteger(GL_DRAW_BUFFER0);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, SurfaceAttachment, this->Surfaces->GetTarget(),
    this->Surfaces->GetHandle(), 0);
  this->EnableSurfaces(true);
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    this->EndSurfaces();
    return false;
  }
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 1, nothing);
  return true;
}

//------------------------------------------------------------------------------
void EdgeBuffers::EnableSurfaces(bool enabled)
{
  // Not by vtkOpenGLState, which takes one buffer after two for no change. It is left in the right
  // by EndSurfaces().
  const GLenum buffers[] = { this->FirstBuffer, SurfaceAttachment };
  glDrawBuffers(enabled ? 2 : 1, buffers);
}

//------------------------------------------------------------------------------
void EdgeBuffers::EndSurfaces()
{
  this->EnableSurfaces(false);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, SurfaceAttachment, this->Surfaces->GetTarget(), 0, 0);
}

//------------------------------------------------------------------------------
void EdgeBuffers::BindEdges()
{
  BindTarget(this->EdgeFramebuffer);
}

//------------------------------------------------------------------------------
void EdgeBuffers::BindLinked()
{
  BindTarget(this->LinkedFramebuffer);
}

//------------------------------------------------------------------------------
void EdgeBuffers::BindLines()
{
  BindTarget(this->LineFramebuffer);
}

//------------------------------------------------------------------------------
void EdgeBuffers::BindBlocks()
{
  BindTarget(this->BlockFramebuffer);
}

//------------------------------------------------------------------------------
void EdgeBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->EdgeFramebuffer->ReleaseGraphicsResources(window);
  this->LinkedFramebuffer->ReleaseGraphicsResources(window);
  this->BlockFramebuffer->ReleaseGraphicsResources(window);
  this->LineFramebuffer->ReleaseGraphicsResources(window);
  this->Surfaces->ReleaseGraphicsResources(window);
  this->Edges->ReleaseGraphicsResources(window);
  this->Linked->ReleaseGraphicsResources(window);
  this->Blocks->ReleaseGraphicsResources(window);
  this->Lines->ReleaseGraphicsResources(window);
}
}
