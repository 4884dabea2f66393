// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeBuffer_h
#define nprStrokeBuffer_h

#include <array>
#include <vector>

class vtkPolyData;

namespace npr
{
/// One point of a stroke as the vertex shader fetches it: two texels of four floats.
struct StrokeRecord
{
  float Position[3]; // relative to StrokeRecords::Origin
  float Width;       // 1 without a Width array
  float Strength;    // 1 without a Strength array
  float Connected;   // 1 if a segment runs from here to the next record
  float Unused[2];
};

struct StrokeRecords
{
  std::vector<StrokeRecord> Records;
  // The centre of the bounds, taken off in double precision: nothing is lost far from the origin.
  std::array<double, 3> Origin = { 0, 0, 0 };
  float MaximumWidth = 1;
};

/// Lays the lines of strokes out one after another. Segments with a point that is not finite are
/// left out.
StrokeRecords MakeStrokeRecords(vtkPolyData* strokes);
}

#endif
