// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSegmentMatching.h
 * @brief Whether two extractions found the same lines, whatever the order they give them in.
 */
#ifndef nprSegmentMatching_h
#define nprSegmentMatching_h

#include "nprLineTesting.h"

namespace nprtest
{
/// How many segments of either have no partner in the other, both of whose ends are within a
/// tolerance.
inline std::size_t CountUnmatched(
  const std::vector<Segment>& a, const std::vector<Segment>& b, double tolerance)
{
  const auto getMiddle = [](const Segment& segment) { return segment[0] + segment[3]; };
  std::vector<Segment> sorted = b;
  std::sort(sorted.begin(), sorted.end(),
    [&](const Segment& s, const Segment& t) { return getMiddle(s) < getMiddle(t); });
  const auto isClose = [tolerance](const double* p, const double* q)
  {
    return std::abs(p[0] - q[0]) <= tolerance && std::abs(p[1] - q[1]) <= tolerance &&
      std::abs(p[2] - q[2]) <= tolerance;
  };
  std::vector<bool> taken(sorted.size(), false);
  std::size_t matched = 0;
  for (const Segment& segment : a)
  {
    auto other =
      std::lower_bound(sorted.begin(), sorted.end(), getMiddle(segment) - 2.0 * tolerance,
        [&](const Segment& s, double value) { return getMiddle(s) < value; });
    for (; other != sorted.end() && getMiddle(*other) <= getMiddle(segment) + 2.0 * tolerance;
         ++other)
    {
      const double* const p = segment.data();
      const double* const q = other->data();
      const std::size_t index = other - sorted.begin();
      if (!taken[index] &&
        ((isClose(p, q) && isClose(p + 3, q + 3)) || (isClose(p, q + 3) && isClose(p + 3, q))))
      {
        taken[index] = true;
        ++matched;
        break;
      }
    }
  }
  return a.size() + b.size() - 2 * matched;
}

/// How many segments a chain has, and whether it is closed.
using Form = std::pair<std::size_t, bool>;
inline std::vector<Form> GetForms(const std::vector<Chain>& chains)
{
  std::vector<Form> forms;
  for (const Chain& chain : chains)
  {
    forms.emplace_back(chain.GetNumberOfSegments(), chain.Closed);
  }
  std::sort(forms.begin(), forms.end());
  return forms;
}
}

#endif
