// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineLevels.h"

#include "nprLanes.h"
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
  constexpr float greatest = std::numeric_limits<float>::max();
  struct Range
  {
    Lanes Minimum = Lanes{} + infinity;
    Lanes Maximum = Lanes{} - infinity;
    void Add(const Lanes& values)
    {
      const Lanes minimum = values < this->Minimum ? values : this->Minimum;
      const Lanes maximum = values > this->Maximum ? values : this->Maximum;
      this->Minimum = minimum >= -greatest ? minimum : this->Minimum;
      this->Maximum = maximum <= greatest ? maximum : this->Maximum;
    }
  };
  vtkSMPThreadLocal<Range> ranges;
  vtkSMPTools::For(0, surface.GetMesh().GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      Range range = ranges.Local();
      vtkIdType i = begin;
      for (; !surface.HasUnusedPoints() && i + NumberOfLanes <= end; i += NumberOfLanes)
      {
        range.Add(Load<Lanes>(field + i));
      }
      for (; i < end; ++i)
      {
        if (surface.IsUsed(static_cast<LineSurface::Index>(i)))
        {
          range.Add(Lanes{} + field[i]);
        }
      }
      ranges.Local() = range;
    });
  Range all;
  for (const Range& range : ranges)
  {
    all.Add(range.Minimum);
    all.Add(range.Maximum);
  }
  std::array<float, NumberOfLanes> minima;
  std::array<float, NumberOfLanes> maxima;
  Store(all.Minimum, minima.data());
  Store(all.Maximum, maxima.data());
  const float minimum = *std::min_element(minima.begin(), minima.end());
  const float maximum = *std::max_element(maxima.begin(), maxima.end());
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
