// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprHilbertOrder.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

namespace npr
{
namespace
{
constexpr int BitsPerAxis = 21; // three of them in 63 bits

/// How far along the curve a cell of a grid of 2^21 cells a side lies.
std::uint64_t GetHilbertNumber(std::array<std::uint32_t, 3> cell)
{
  // From the largest cubes to the smallest, undo the reflections and rotations by which the curve
  // within a cube differs from the whole one.
  for (std::uint32_t bit = 1u << (BitsPerAxis - 1); bit > 1; bit >>= 1)
  {
    const std::uint32_t lower = bit - 1;
    for (std::uint32_t& axis : cell)
    {
      if (axis & bit)
      {
        cell[0] ^= lower;
      }
      else
      {
        const std::uint32_t difference = (cell[0] ^ axis) & lower;
        cell[0] ^= difference;
        axis ^= difference;
      }
    }
  }
  // What is left is a Gray code.
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t parity = 0;
  for (std::uint32_t bit = 1u << (BitsPerAxis - 1); bit > 1; bit >>= 1)
  {
    if (cell[2] & bit)
    {
      parity ^= bit - 1;
    }
  }
  std::uint64_t number = 0;
  for (int bit = BitsPerAxis - 1; bit >= 0; --bit)
  {
    for (const std::uint32_t axis : cell)
    {
      number = number << 1 | (((axis ^ parity) >> bit) & 1u);
    }
  }
  return number;
}
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> GetHilbertOrder(const std::vector<Eigen::Vector3d>& points)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(Infinity);
  Eigen::Vector3d high = Eigen::Vector3d::Constant(-Infinity);
  for (const Eigen::Vector3d& point : points)
  {
    if (point.allFinite())
    {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }
  const double size = (high - low).maxCoeff();
  constexpr double Cells = (1u << BitsPerAxis) - 1;
  const double scale = size > 0.0 ? Cells / size : 0.0;

  using Entry = std::pair<std::uint64_t, vtkIdType>;
  std::vector<Entry> entries(points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(points.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        entries[i] = { std::numeric_limits<std::uint64_t>::max(), i };
        if (points[i].allFinite())
        {
          const Eigen::Vector3d cell = scale * (points[i] - low);
          entries[i].first = GetHilbertNumber({ static_cast<std::uint32_t>(cell.x()),
            static_cast<std::uint32_t>(cell.y()), static_cast<std::uint32_t>(cell.z()) });
        }
      }
    });
  vtkSMPTools::Sort(entries.begin(), entries.end());
  std::vector<vtkIdType> order(entries.size());
  std::transform(
    entries.begin(), entries.end(), order.begin(), [](const Entry& entry) { return entry.second; });
  return order;
}
}
