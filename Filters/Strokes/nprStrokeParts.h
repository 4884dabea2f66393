// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeParts_h
#define nprStrokeParts_h

#include "vtkNPRFiltersStrokesModule.h"

#include <cstddef>
#include <vector>

namespace npr
{
/// A stretch of a stroke with one number of layers. Places on a stroke are the number of a point
/// and what part of the way to the next has been gone. On a closed stroke a part that does not end
/// after its begin goes over the first point.
struct StrokePart
{
  /// The number of layers of what is not in the image: behind the eye, or no number.
  static constexpr int Nowhere = -1;

  int Layers = 0;
  double Begin = 0.0;
  double End = 0.0;
  double Length = 0.0; // in the image, in pixels

  bool IsOverFirstPoint() const { return this->End <= this->Begin; }
};

/// Parts shorter than \p least become part of their neighbours: the shortest first, if both
/// neighbours are alike with both of them, else with the longer one (or the one that there is; of
/// two as long, the one before). Hidden parts at the ends of open strokes stay. The last part of a
/// closed stroke is a neighbour of its first.
/// \p size is the number of segments of the stroke.
VTKNPRFILTERSSTROKES_EXPORT std::vector<StrokePart> MergeParts(
  std::vector<StrokePart> parts, double least, bool isClosed, std::size_t size);
}

#endif
