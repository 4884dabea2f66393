// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeGraphics.h"

#include "nprCurveEvaluation.h"

#include <vtkCommand.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkOpenGLError.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLVertexArrayObject.h>
#include <vtkPolyData.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <utility>

namespace npr
{
namespace
{
// Points left out are left out for views a little nearer, too.
constexpr float Reserve = 0.67f;
// Once a view has been so much farther for some frames, more are left out. Not at once: several
// viewports may draw the same strokes.
constexpr float MostDetail = 0.25f;
constexpr int MostFramesTooFine = 10;

// As many as two bytes can number the vertices of.
constexpr std::ptrdiff_t SegmentsAtOnce = 16384;

/// The two triangles of each quad of four vertices.
std::vector<unsigned short> MakeIndices()
{
  std::vector<unsigned short> indices;
  indices.reserve(6 * SegmentsAtOnce);
  for (std::ptrdiff_t segment = 0; segment < SegmentsAtOnce; ++segment)
  {
    for (const int corner : { 0, 1, 2, 3, 2, 1 })
    {
      indices.push_back(static_cast<unsigned short>(4 * segment + corner));
    }
  }
  return indices;
}

vtkMTimeType GetDataTime(vtkPolyData* input, vtkUnsignedCharArray* colors)
{
  return std::max(input->GetMTime(), colors ? colors->GetMTime() : vtkMTimeType(0));
}
}

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
  this->Indices->ReleaseGraphicsResources();
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
bool StrokeGraphics::IsUpToDate(vtkPolyData* input, vtkUnsignedCharArray* colors, bool ofCells,
  const StrokeTolerance& needed, const CurveSettings& curves)
{
  if (this->UploadTime < GetDataTime(input, colors) || this->UploadedInput != input ||
    this->UploadedColors != colors || this->ColorsOfCells != ofCells || !(this->Curves == curves) ||
    !needed.Allows(this->Tolerance) || !this->IsSeenAsBefore(needed))
  {
    return false;
  }
  const bool tooFine = this->Tolerance.Allows(needed.Scaled(MostDetail));
  this->FramesTooFine = tooFine ? this->FramesTooFine + 1 : 0;
  return this->FramesTooFine < MostFramesTooFine;
}

//------------------------------------------------------------------------------
bool StrokeGraphics::IsSeenAsBefore(const StrokeTolerance& needed) const
{
  return this->Tolerance.Sight.IsAnywhere() || this->Tolerance.Sight == needed.Sight;
}

//------------------------------------------------------------------------------
bool StrokeGraphics::Upload(vtkPolyData* input, vtkUnsignedCharArray* colors, bool ofCells,
  const StrokeTolerance& needed, const CurveSettings& curves)
{
  if (this->IsUpToDate(input, colors, ofCells, needed, curves))
  {
    return true;
  }
  // What has changed may do so with each view, as contours; what is seen in a second one needs to
  // be good for all. Curves are, as they are evaluated before they are seen.
  const bool changed = this->UploadTime < GetDataTime(input, colors);
  this->Tolerance = needed.Scaled(Reserve);
  if (!changed || curves.Kind != SplineKind::Polyline)
  {
    this->Tolerance = this->Tolerance.FromAnywhere();
  }
  this->FramesTooFine = 0;
  this->UploadedInput = input;
  this->UploadedColors = colors;
  this->ColorsOfCells = ofCells;
  this->Curves = curves;
  this->UploadTime.Modified();
  CurveSettings chosen = curves;
  chosen.ChordError /= Reserve; // what it allows in this view
  if (curves.Kind != SplineKind::Polyline && !curves.Measured)
  {
    StrokeCurves made = MakeStrokeCurves(input, colors, ofCells, this->Tolerance, chosen);
    if (made.Strokes.Records.size() <= MostControlPoints)
    {
      this->NumberOfSegments = std::max<std::ptrdiff_t>(made.Points.size(), 1) - 1;
      const bool evaluated = this->NumberOfSegments == 0 ||
        EvaluateCurves(made, this->Window, this->Buffer, this->Colors);
      this->Evaluated = true;
      this->Records = std::move(made.Strokes);
      this->MakeTextures(VTK_FLOAT);
      if (!evaluated)
      {
        this->UploadTime = vtkTimeStamp();
      }
      return evaluated;
    }
  }
  this->Evaluated = false;
  this->Records = curves.Kind == SplineKind::Polyline
    ? MakeStrokeRecords(input, colors, ofCells, this->Tolerance)
    : SampleStrokeCurves(input, colors, ofCells, this->Tolerance, chosen);
  const std::vector<StrokeRecord>& records = this->Records.Records;
  this->NumberOfSegments = std::max<std::ptrdiff_t>(records.size(), 1) - 1;
  if (this->NumberOfSegments > 0)
  {
    this->Buffer->Upload(records[0].Position,
      records.size() * (sizeof(StrokeRecord) / sizeof(float)),
      vtkOpenGLBufferObject::TextureBuffer);
    if (this->HasColors())
    {
      this->Colors->Upload(this->Records.Colors, vtkOpenGLBufferObject::TextureBuffer);
    }
  }
  this->MakeTextures(VTK_UNSIGNED_CHAR);
  return true;
}

//------------------------------------------------------------------------------
void StrokeGraphics::MakeTextures(int typeOfColors)
{
  if (this->NumberOfSegments == 0)
  {
    return;
  }
  const auto count = static_cast<unsigned int>(this->NumberOfSegments + 1);
  constexpr auto texels = static_cast<unsigned int>(sizeof(StrokeRecord) / (4 * sizeof(float)));
  this->BufferTexture->SetContext(this->Window);
  this->BufferTexture->CreateTextureBuffer(texels * count, 4, VTK_FLOAT, this->Buffer);
  if (this->HasColors())
  {
    this->ColorsTexture->SetContext(this->Window);
    this->ColorsTexture->ResetFormatAndType(); // may have been of the other type
    this->ColorsTexture->CreateTextureBuffer(count, 4, typeOfColors, this->Colors);
  }
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
  if (this->HasColors())
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
  if (this->Indices->GetHandle() == 0)
  {
    this->Indices->Upload(MakeIndices(), vtkOpenGLBufferObject::ElementArrayBuffer);
  }
  this->Indices->Bind();
  for (std::ptrdiff_t first = 0; first < this->NumberOfSegments; first += SegmentsAtOnce)
  {
    const std::ptrdiff_t count = std::min(this->NumberOfSegments - first, SegmentsAtOnce);
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(6 * count), GL_UNSIGNED_SHORT,
      nullptr, static_cast<GLint>(4 * first));
  }
  this->Indices->Release();
  this->VertexArray->Release();
  for (vtkTextureObject* texture : bound)
  {
    texture->Deactivate();
  }
}
}
