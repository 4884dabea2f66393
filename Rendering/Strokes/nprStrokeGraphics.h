// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeGraphics_h
#define nprStrokeGraphics_h

#include "nprStrokeBuffer.h"
#include "nprStrokeCurves.h"
#include "nprStrokeLayer.h"
#include "nprStrokePicking.h"
#include "nprVTKCompat.h"

#include <vtkNew.h>
#include <vtkTimeStamp.h>
#include <vtkWeakPointer.h>

#include <array>
#include <cstddef>
#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;
class vtkOpenGLBufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkPolyData;
class vtkShaderProgram;
class vtkTextureObject;
class vtkUnsignedCharArray;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class StrokeGraphics
 * @brief What a stroke mapper keeps in OpenGL: the records of the strokes, and the layer of ink.
 *
 * Everything belongs to one window; what was made for another is given back to it. A window that
 * dies says so while its context still lives.
 */
class StrokeGraphics
{
public:
  StrokeGraphics();
  ~StrokeGraphics();
  StrokeGraphics(const StrokeGraphics&) = delete;
  void operator=(const StrokeGraphics&) = delete;

  vtkOpenGLRenderWindow* GetWindow() { return this->Window; }
  void SetWindow(vtkOpenGLRenderWindow* window);
  void Release();

  /// Brings the records up to date with the input, its colours (four numbers for each point, or for
  /// each cell; null: none), how near it is seen, and the curves that it becomes.
  /// @returns whether the shaders compiled that this may need
  bool Upload(vtkPolyData* input, vtkUnsignedCharArray* colors, bool ofCells,
    const StrokeTolerance& needed, const CurveSettings& curves);
  bool HasColors() const { return !this->Records.Colors.empty(); }
  /// Brings the numbers of the cells that segments belong to up to date.
  void UploadCells();
  /// Measures how long strokes are on the page in this view.
  void UploadPageLengths(vtkMatrix4x4* toDevice, const float viewportSize[2]);

  /// Draws all segments with a program, whose uniforms are set but for the textures; that of the
  /// depth may be null.
  void Draw(
    vtkShaderProgram* program, vtkTextureObject* depth, bool pageLengths, bool picked = false);

  std::ptrdiff_t GetNumberOfSegments() const { return this->NumberOfSegments; }
  const StrokeRecords& GetRecords() const { return this->Records; }
  /// Whether the records are but the control points of curves, which were evaluated on the GPU.
  bool AreCurvesEvaluated() const { return this->Evaluated; }

  StrokeLayer Layer;
  StrokePicking Picking;
  std::unique_ptr<vtkOpenGLQuadHelper> Composite;

private:
  bool IsUpToDate(vtkPolyData* input, vtkUnsignedCharArray* colors, bool ofCells,
    const StrokeTolerance& needed, const CurveSettings& curves);
  /// Whether what is left out may be, from where strokes are seen now.
  bool IsSeenAsBefore(const StrokeTolerance& needed) const;
  void MakeTextures(int typeOfColors);

  vtkOpenGLRenderWindow* Window = nullptr;
  unsigned long WindowObserver = 0;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkNew<vtkOpenGLBufferObject> Indices;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> BufferTexture;
  vtkNew<vtkOpenGLBufferObject> Lengths;
  vtkNew<vtkTextureObject> LengthsTexture;
  vtkNew<vtkOpenGLBufferObject> Colors;
  vtkNew<vtkTextureObject> ColorsTexture;
  vtkNew<vtkOpenGLBufferObject> Cells;
  vtkNew<vtkTextureObject> CellsTexture;
  vtkTimeStamp CellsTime;

  StrokeRecords Records;
  std::ptrdiff_t NumberOfSegments = 0;
  bool Evaluated = false;
  vtkTimeStamp UploadTime;
  vtkWeakPointer<vtkPolyData> UploadedInput;
  vtkWeakPointer<vtkUnsignedCharArray> UploadedColors;
  bool ColorsOfCells = false;
  StrokeTolerance Tolerance;
  CurveSettings Curves;
  int FramesTooFine = 0;
};
}

#endif
