// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeGraphics.h"

#include <vtkCommand.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkOpenGLError.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLVertexArrayObject.h>
#include <vtkPolyData.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

#include <algorithm>

namespace npr
{
StrokeGraphics::StrokeGraphics() = default;

StrokeGraphics::~StrokeGraphics()
{
  this->Release();
}

//------------------------------------------------------------------------------
void StrokeGraphics::SetWindow(vtkOpenGLRenderWindow* window)
{
  if (this->Window == window)
  {
    return;
  }
  this->Release();
  this->Window = window;
  this->WindowObserver =
    window->AddObserver(vtkCommand::DeleteEvent, this, &StrokeGraphics::Release);
}

//------------------------------------------------------------------------------
void StrokeGraphics::Release()
{
  if (!this->Window)
  {
    return;
  }
  this->Window->PushContext();
  this->Composite.reset();
  this->Layer.ReleaseGraphicsResources(this->Window);
  this->Picking.ReleaseGraphicsResources(this->Window);
  this->VertexArray->ReleaseGraphicsResources();
  this->Buffer->ReleaseGraphicsResources();
  this->BufferTexture->ReleaseGraphicsResources(this->Window);
  this->Lengths->ReleaseGraphicsResources();
  this->LengthsTexture->ReleaseGraphicsResources(this->Window);
  this->Colors->ReleaseGraphicsResources();
  this->ColorsTexture->ReleaseGraphicsResources(this->Window);
  this->Cells->ReleaseGraphicsResources();
  this->CellsTexture->ReleaseGraphicsResources(this->Window);
  this->CellsTime = vtkTimeStamp();
  this->NumberOfSegments = 0;
  this->UploadTime = vtkTimeStamp();
  this->Window->PopContext();
  this->Window->RemoveObserver(this->WindowObserver);
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
void StrokeGraphics::Upload(vtkPolyData* input)
{
  if (this->UploadTime > input->GetMTime() && this->UploadedInput == input)
  {
    return;
  }
  this->Records = MakeStrokeRecords(input);
  const std::vector<StrokeRecord>& records = this->Records.Records;
  this->NumberOfSegments = std::max<std::ptrdiff_t>(records.size(), 1) - 1;
  if (this->NumberOfSegments > 0)
  {
    const std::size_t size = records.size() * (sizeof(StrokeRecord) / sizeof(float));
    this->Buffer->Upload(records[0].Position, size, vtkOpenGLBufferObject::TextureBuffer);
    this->BufferTexture->SetContext(this->Window);
    this->BufferTexture->CreateTextureBuffer(
      static_cast<unsigned int>(size / 4), 4, VTK_FLOAT, this->Buffer);
  }
  this->UploadedInput = input;
  this->UploadTime.Modified();
}

//------------------------------------------------------------------------------
void StrokeGraphics::UploadColors(vtkUnsignedCharArray* colors, bool ofCells)
{
  this->Colored = colors != nullptr && this->NumberOfSegments > 0;
  if (!this->Colored)
  {
    return;
  }
  const std::vector<unsigned char> ordered =
    OrderColors(this->Records, this->UploadedInput, colors, ofCells);
  this->Colors->Upload(ordered, vtkOpenGLBufferObject::TextureBuffer);
  this->ColorsTexture->SetContext(this->Window);
  this->ColorsTexture->CreateTextureBuffer(
    static_cast<unsigned int>(ordered.size() / 4), 4, VTK_UNSIGNED_CHAR, this->Colors);
}

//------------------------------------------------------------------------------
void StrokeGraphics::UploadCells()
{
  if (this->CellsTime > this->UploadTime)
  {
    return;
  }
  const std::vector<unsigned char> cells =
    NumberCells(this->Records, this->UploadedInput->GetNumberOfVerts());
  this->Cells->Upload(cells, vtkOpenGLBufferObject::TextureBuffer);
  this->CellsTexture->SetContext(this->Window);
  this->CellsTexture->CreateTextureBuffer(
    static_cast<unsigned int>(cells.size() / 4), 4, VTK_UNSIGNED_CHAR, this->Cells);
  this->CellsTime.Modified();
}

//------------------------------------------------------------------------------
void StrokeGraphics::UploadPageLengths(vtkMatrix4x4* toDevice, const float viewportSize[2])
{
  const std::vector<float> lengths = MeasurePageLengths(this->Records, toDevice, viewportSize);
  this->Lengths->Upload(lengths, vtkOpenGLBufferObject::TextureBuffer);
  this->LengthsTexture->SetContext(this->Window);
  this->LengthsTexture->CreateTextureBuffer(
    static_cast<unsigned int>(lengths.size()), 1, VTK_FLOAT, this->Lengths);
}

//------------------------------------------------------------------------------
void StrokeGraphics::Draw(
  vtkShaderProgram* program, vtkTextureObject* depth, bool pageLengths, bool picked)
{
  std::vector<vtkTextureObject*> bound;
  const auto bind = [&](const char* name, vtkTextureObject* texture)
  {
    texture->Activate();
    program->SetUniformi(name, texture->GetTextureUnit());
    bound.push_back(texture);
  };
  bind("nprRecords", this->BufferTexture);
  if (pageLengths)
  {
    bind("nprPageLengths", this->LengthsTexture);
  }
  if (this->Colored)
  {
    bind("nprColors", this->ColorsTexture);
  }
  if (picked)
  {
    bind("nprCells", this->CellsTexture);
  }
  if (depth)
  {
    bind("nprDepthTexture", depth);
  }
  else
  {
    // Samplers of two kinds must not share a unit, even where one is not used.
    int unused = 0;
    for (vtkTextureObject* texture : bound)
    {
      unused = std::max(unused, texture->GetTextureUnit() + 1);
    }
    program->SetUniformi("nprDepthTexture", unused);
  }
  this->VertexArray->Bind(); // OpenGL wants one, even without attributes
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * this->NumberOfSegments));
  this->VertexArray->Release();
  for (vtkTextureObject* texture : bound)
  {
    texture->Deactivate();
  }
}
}
