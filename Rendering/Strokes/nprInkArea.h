// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprInkArea_h
#define nprInkArea_h

#include "nprVTKCompat.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;
VTK_ABI_NAMESPACE_END

namespace npr
{
struct StrokeRecords;

/// A rectangle of pixels: x, y, width and height.
using PixelRectangle = std::array<int, 4>;

/// The pixels of a viewport that strokes may be drawn to.
struct InkArea
{
  std::vector<PixelRectangle> Rectangles; // do not overlap
  PixelRectangle Bounds = { 0, 0, 0, 0 }; // of all of them

  bool IsEmpty() const { return this->Rectangles.empty(); }
};

/**
 * Where segments between records are, and so far around them, in tiles: strokes are thin, and what
 * is done for each pixel of their bounds takes longer than they do.
 *
 * @param toDevice from the records to clip coordinates, transposed as VTK hands it to shaders
 */
InkArea FindInkArea(
  const StrokeRecords& records, vtkMatrix4x4* toDevice, const float viewportSize[2], double reach);

/// One rectangle, where all is that the bounds of the records hold.
InkArea FindInkBounds(
  const StrokeRecords& records, vtkMatrix4x4* toDevice, const float viewportSize[2], double reach);
}

#endif
