// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeLayer.h"

#include <vtkOpenGLError.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkTextureObject.h>

namespace npr
{
namespace
{
struct StorageFormat
{
  unsigned int Internal = 0; // 0: no depth
  unsigned int External = GL_DEPTH_COMPONENT;
  unsigned int Type = GL_UNSIGNED_INT;
};

/// A blit copies depth only between equal formats, so the copy takes that of the framebuffer.
StorageFormat GetDepthFormat(unsigned int framebuffer)
{
  const GLenum attachment = framebuffer == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  auto query = [attachment](GLenum name)
  {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
    return value;
  };
  StorageFormat format;
  if (query(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
  {
    return format;
  }
  const GLint bits = query(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  const bool stencil = query(GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0;
  const bool real = query(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
  if (stencil)
  {
    format.Internal = real ? GL_DEPTH32F_STENCIL8 : GL_DEPTH24_STENCIL8;
    format.External = GL_DEPTH_STENCIL;
    format.Type = real ? GL_FLOAT_32_UNSIGNED_INT_24_8_REV : GL_UNSIGNED_INT_24_8;
  }
  else if (real)
  {
    format.Internal = GL_DEPTH_COMPONENT32F;
    format.Type = GL_FLOAT;
  }
  else
  {
    format.Internal = bits <= 16 ? GL_DEPTH_COMPONENT16
      : bits <= 24               ? GL_DEPTH_COMPONENT24
                                 : GL_DEPTH_COMPONENT32;
  }
  return format;
}
}

StrokeLayer::StrokeLayer() = default;
StrokeLayer::~StrokeLayer() = default;

bool StrokeLayer::CaptureDepth(
  vtkOpenGLRenderWindow* window, const int viewport[4], const std::array<int, 4>& bounds)
{
  vtkOpenGLState* state = window->GetState();
  unsigned int source = 0;
  unsigned int buffer = 0;
  state->GetCurrentDrawFramebufferState(source, buffer);
  this->IsCopied = !this->FindDepth(window, source, viewport);
  if (!this->IsCopied)
  {
    return true;
  }
  const StorageFormat format = GetDepthFormat(source);
  if (format.Internal == 0)
  {
    return false;
  }

  const unsigned int width = viewport[2];
  const unsigned int height = viewport[3];
  this->DepthFramebuffer->SetContext(window);
  if (this->Depth->GetHandle() != 0 && this->DepthFormat != format.Internal)
  {
    this->DepthFramebuffer->ReleaseGraphicsResources(window);
    this->Depth->ReleaseGraphicsResources(window);
  }
  const bool fresh = this->Depth->GetHandle() == 0;
  if (fresh)
  {
    this->DepthFormat = format.Internal;
    this->Depth->SetContext(window);
    this->Depth->SetInternalFormat(format.Internal);
    this->Depth->SetFormat(format.External);
    this->Depth->SetDataType(format.Type);
    this->Depth->Allocate2D(width, height, 1, VTK_FLOAT);
  }
  this->Depth->Resize(width, height);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, source);
  this->DepthFramebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  if (fresh)
  {
    this->DepthFramebuffer->AddDepthAttachment(this->Depth);
    this->DepthFramebuffer->DeactivateDrawBuffers();
  }
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  const int end[2] = { bounds[0] + bounds[2], bounds[1] + bounds[3] };
  state->vtkglBlitFramebuffer(viewport[0] + bounds[0], viewport[1] + bounds[1],
    viewport[0] + end[0], viewport[1] + end[1], bounds[0], bounds[1], end[0], end[1],
    GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  return true;
}

/// Ink is drawn into another framebuffer, so that the texture may be read meanwhile.
bool StrokeLayer::FindDepth(
  vtkOpenGLRenderWindow* window, unsigned int framebuffer, const int viewport[4])
{
  if (framebuffer == 0 || viewport[0] != 0 || viewport[1] != 0)
  {
    return false;
  }
  const auto query = [](GLenum name)
  {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, name, &value);
    return value;
  };
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  if (samples > 0 || query(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE)
  {
    return false;
  }
  this->FoundDepth->SetContext(window);
  this->FoundDepth->AssignToExistingTexture(
    static_cast<unsigned int>(query(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)), GL_TEXTURE_2D);
  this->FoundDepth->Bind();
  GLint size[2] = { 0, 0 };
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &size[0]);
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &size[1]);
  return size[0] == viewport[2] && size[1] == viewport[3];
}

void StrokeLayer::BindInk(vtkOpenGLRenderWindow* window, int width, int height, bool colored)
{
  if (this->Ink->GetHandle() != 0 && this->InkColored != colored)
  {
    this->InkFramebuffer->ReleaseGraphicsResources(window);
    this->Ink->ReleaseGraphicsResources(window);
    this->InkDepth->ReleaseGraphicsResources(window);
  }
  this->InkColored = colored;
  this->InkFramebuffer->SetContext(window);
  const bool fresh = this->Ink->GetHandle() == 0;
  if (fresh)
  {
    this->Ink->SetContext(window);
    this->Ink->Allocate2D(width, height, colored ? 4 : 1, VTK_UNSIGNED_CHAR);
    if (colored)
    {
      this->InkDepth->SetContext(window);
      this->InkDepth->AllocateDepth(width, height, vtkTextureObject::Float32);
    }
  }
  this->Ink->Resize(width, height);
  if (colored)
  {
    this->InkDepth->Resize(width, height);
  }
  this->InkFramebuffer->Bind();
  if (fresh)
  {
    this->InkFramebuffer->AddColorAttachment(0, this->Ink);
    if (colored)
    {
      this->InkFramebuffer->AddDepthAttachment(this->InkDepth);
    }
  }
  this->InkFramebuffer->ActivateDrawBuffer(0);

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  state->vtkglClearColor(0, 0, 0, 0);
  if (colored)
  {
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglClearDepth(1.0);
  }
  state->vtkglClear(GL_COLOR_BUFFER_BIT | (colored ? GL_DEPTH_BUFFER_BIT : 0));
}

void StrokeLayer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->FoundDepth->ReleaseGraphicsResources(window);
  this->DepthFramebuffer->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->InkFramebuffer->ReleaseGraphicsResources(window);
  this->Ink->ReleaseGraphicsResources(window);
  this->InkDepth->ReleaseGraphicsResources(window);
}
}
