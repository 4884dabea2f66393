// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLineLevels.h
 * @brief The values at which the lines of a field with levels run.
 */
#ifndef nprLineLevels_h
#define nprLineLevels_h

#include "vtkNPRFiltersLinesModule.h"

#include <vector>

namespace npr
{
class LineSurface;

struct FieldRange
{
  double Minimum = 0.0;
  double Maximum = 0.0;
};

/// Over the points that have triangles, where the field is a number; 0 to 0 when it is nowhere.
VTKNPRFILTERSLINES_EXPORT FieldRange GetFieldRange(const LineSurface& surface, const float* field);

/// The middles of so many equal parts of the range: none touches its ends. None for an empty range.
VTKNPRFILTERSLINES_EXPORT std::vector<float> GetLevelsByCount(const FieldRange& range, int count);

/// How many levels GetLevelsBySpacing() gives; as a number that may be very large.
VTKNPRFILTERSLINES_EXPORT double CountLevelsBySpacing(
  const FieldRange& range, double spacing, double offset);

/// The values within the range that are multiples of the spacing (> 0) when an offset is added to
/// them. Those that touch the ends of the range, but for rounding, are left out: there the lines
/// would be points, or the borders of flat parts.
VTKNPRFILTERSLINES_EXPORT std::vector<float> GetLevelsBySpacing(
  const FieldRange& range, double spacing, double offset);
}

#endif
