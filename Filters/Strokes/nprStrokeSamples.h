// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprStrokeSamples.h
 * @brief From samples along chains of points to polylines again.
 */
#ifndef nprStrokeSamples_h
#define nprStrokeSamples_h

#include "nprStrokeChains.h"
#include "nprVTKCompat.h"

#include <vtkType.h>

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
struct StrokeSample
{
  Vector3 Position;
  double ArcLength;
  // The points of the input around the sample, and where it lies between them.
  vtkIdType From;
  vtkIdType To;
  double T;
};

/// What one input polyline turns into: strokes one after another.
struct SampledStrokes
{
  std::vector<StrokeSample> Samples;
  std::vector<vtkIdType> Sizes;
};

/// Sets the ArcLength of the samples after that at `start`, from that one's on.
void MeasureArcLength(std::vector<StrokeSample>& samples, std::size_t start);

/// As WriteStrokes() takes them; of a class derived from SampledStrokes, too.
template<typename Strokes>
std::vector<const SampledStrokes*> PointersTo(const std::vector<Strokes>& strokes)
{
  std::vector<const SampledStrokes*> pointers;
  for (const Strokes& each : strokes)
  {
    pointers.push_back(&each);
  }
  return pointers;
}

/**
 * Writes points, lines and their arrays: numeric point arrays of the input are interpolated, cell
 * arrays copied, and ArcLength added.
 *
 * @param strokes those of each line of the input
 */
void WriteStrokes(
  vtkPolyData* input, const std::vector<const SampledStrokes*>& strokes, vtkPolyData* output);
}

#endif
