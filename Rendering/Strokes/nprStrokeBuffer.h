// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeBuffer_h
#define nprStrokeBuffer_h

#include "nprStrokeSimplification.h"
#include "nprVTKCompat.h"

#include <array>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;
class vtkPolyData;
class vtkUnsignedCharArray;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// What StrokeRecord::Kind says, besides the number of its stroke.
enum StrokeKind
{
  Drawn = 1,     // a segment runs from here to the next record
  HasBefore = 2, // the record before is the neighbour on the stroke
  HasAfter = 4,  // the record after is it
  Hidden = 8,    // by a surface, as HidingLayers says
  Steep = 16,    // next to a segment that soon gets wider, thinner or fainter
  StrokeNumber = 32
};
/// Numbers of strokes begin again here: a float holds every Kind.
constexpr int MostStrokeNumbers = 1 << 19;

/// One point of a stroke as the vertex shader fetches it: two texels of four floats.
struct StrokeRecord
{
  float Position[3]; // relative to StrokeRecords::Origin
  float Width;       // 1 without a Width array
  float Strength;    // 1 without a Strength array
  float Opacity;     // 1 without an Opacity array
  float ArcLength;   // from the array, or measured; in the coordinates of the input
  float Kind;        // a sum of StrokeKind, and StrokeNumber times the number of the stroke
};

struct StrokeRecords
{
  std::vector<StrokeRecord> Records;
  // The centre of the bounds, taken off in double precision: nothing is lost far from the origin.
  std::array<double, 3> Origin = { 0, 0, 0 };
  std::array<double, 3> HalfSize = { 0, 0, 0 }; // of the bounds
  float MaximumWidth = 1;
  // The first record of each stroke, and the end of all.
  std::vector<std::ptrdiff_t> Begins;
  // Their numbers among the lines of the input; empty: one after another.
  std::vector<std::ptrdiff_t> Lines;
  // The colours of the records, four numbers each; empty: none.
  std::vector<unsigned char> Colors;
};

/**
 * Lays the lines of strokes out one after another; closed ones with the neighbours of their seam
 * before and after them. Segments with a point that is not finite are left out, and so are points
 * without which strokes look the same.
 *
 * @param colors four numbers for each point, or for each cell; null: none
 */
StrokeRecords MakeStrokeRecords(vtkPolyData* strokes, vtkUnsignedCharArray* colors, bool ofCells,
  const StrokeTolerance& tolerance);

/// The number of the cell that each record belongs to, by bytes, the lowest first; for lines that
/// come after other cells.
std::vector<unsigned char> NumberCells(const StrokeRecords& records, std::ptrdiff_t otherCells);

/**
 * How far along its stroke each record is in the picture, in pixels.
 *
 * @param toDevice from the records to clip coordinates, transposed as VTK hands it to shaders
 */
std::vector<float> MeasurePageLengths(
  const StrokeRecords& records, vtkMatrix4x4* toDevice, const float viewportSize[2]);
}

#endif
