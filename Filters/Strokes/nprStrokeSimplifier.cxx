// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeSimplifier.h"

#include <Eigen/Core>

#include <algorithm>
#include <utility>

namespace npr
{
namespace
{
using Place = Eigen::Map<const Eigen::Vector3d>;

double GetSquaredDistance(const Place& place, const Place& from, const Place& to)
{
  const Eigen::Vector3d along = to - from;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((place - from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (place - from - t * along).squaredNorm();
}
}

//------------------------------------------------------------------------------
void SimplifyStroke(std::vector<StrokeSample>& samples, std::size_t start,
  const std::vector<std::size_t>& kept, bool closed, double distance)
{
  if (samples.size() < start + 3)
  {
    return;
  }
  const std::size_t last = samples.size() - 1;
  const auto getPlace = [&](std::size_t i) { return Place(samples[i].Position.data()); };
  /// The farthest from the segment between two samples, and its squared distance.
  const auto findFarthest = [&](std::size_t from, std::size_t to)
  {
    std::pair<std::size_t, double> farthest(from, -1.0);
    for (std::size_t i = from + 1; i < to; ++i)
    {
      const double squared = GetSquaredDistance(getPlace(i), getPlace(from), getPlace(to));
      if (squared > farthest.second)
      {
        farthest = { i, squared };
      }
    }
    return farthest;
  };
  std::vector<char> stays(samples.size() - start, 0);
  std::vector<std::pair<std::size_t, std::size_t>> parts;
  const auto split = [&](std::size_t from, std::size_t at, std::size_t to)
  {
    stays[at - start] = 1;
    parts.emplace_back(at, to);
    parts.emplace_back(from, at);
  };
  stays.front() = stays.back() = 1;
  std::size_t from = start;
  for (const std::size_t corner : kept)
  {
    if (corner > from && corner < last)
    {
      stays[corner - start] = 1;
      parts.emplace_back(from, corner);
      from = corner;
    }
  }
  if (closed && from == start)
  {
    split(start, findFarthest(start, last).first, last);
  }
  else
  {
    parts.emplace_back(from, last);
  }
  while (!parts.empty())
  {
    const auto [first, end] = parts.back();
    parts.pop_back();
    const auto [farthest, squared] = findFarthest(first, end);
    if (squared > distance * distance)
    {
      split(first, farthest, end);
    }
  }
  std::size_t place = start;
  for (std::size_t i = start; i <= last; ++i)
  {
    if (stays[i - start])
    {
      samples[place++] = samples[i];
    }
  }
  samples.resize(place);
}
}
