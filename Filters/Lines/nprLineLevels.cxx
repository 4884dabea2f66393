// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineLevels.h"

#include "nprLineSurface.h"

#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace npr
{
namespace
{
constexpr double Rounding = 1.0e-6; // of values in single precision, as a part of their range

// The first and the last multiple of the spacing.
FieldRange GetMultiples(const FieldRange& range, double spacing, double offset)
{
  const double margin = Rounding * (range.Maximum - range.Minimum);
  return { std::ceil((range.Minimum + margin + offset) / spacing),
    std::floor((range.Maximum - margin + offset) / spacing) };
}
}

//------------------------------------------------------------------------------
FieldRange GetFieldRange(const LineSurface& surface, const float* field)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  using Range = std::array<float, 2>;
  vtkSMPThreadLocal<Range> ranges(Range{ infinity, -infinity });
  vtkSMPTools::For(0, surface.GetMesh().GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      Range& range = ranges.Local();
      for (LineSurface::Index t = static_cast<LineSurface::Index>(begin); t < end; ++t)
      {
        for (const LineSurface::Index point : surface.GetMesh().GetTriangle(t))
        {
          if (std::isfinite(field[point]))
          {
            range = { std::min(range[0], field[point]), std::max(range[1], field[point]) };
          }
        }
      }
    });
  float minimum = infinity;
  float maximum = -infinity;
  for (const Range& range : ranges)
  {
    minimum = std::min(minimum, range[0]);
    maximum = std::max(maximum, range[1]);
  }
  return minimum <= maximum ? FieldRange{ minimum, maximum } : FieldRange();
}

//------------------------------------------------------------------------------
std::vector<float> GetLevelsByCount(const FieldRange& range, int count)
{
  std::vector<float> levels;
  for (int i = 0; i < count && range.Minimum < range.Maximum; ++i)
  {
    levels.push_back(
      static_cast<float>(range.Minimum + (range.Maximum - range.Minimum) * ((i + 0.5) / count)));
  }
  return levels;
}

//------------------------------------------------------------------------------
double CountLevelsBySpacing(const FieldRange& range, double spacing, double offset)
{
  const FieldRange multiples = GetMultiples(range, spacing, offset);
  return range.Minimum < range.Maximum ? std::max(0.0, multiples.Maximum - multiples.Minimum + 1.0)
                                       : 0.0;
}

//------------------------------------------------------------------------------
std::vector<float> GetLevelsBySpacing(const FieldRange& range, double spacing, double offset)
{
  const double first = GetMultiples(range, spacing, offset).Minimum;
  const auto count = static_cast<std::size_t>(CountLevelsBySpacing(range, spacing, offset));
  std::vector<float> levels(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    levels[i] = static_cast<float>((first + i) * spacing - offset);
  }
  return levels;
}
}
