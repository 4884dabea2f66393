// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPointWelding.h"

#include <vtkSMPTools.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Vector3d;
using Cell = std::array<std::int64_t, 3>;

//------------------------------------------------------------------------------
std::uint64_t Hash(const Cell& cell)
{
  std::uint64_t hash = 0;
  for (std::int64_t part : cell)
  {
    // The finaliser of a 64-bit mixing hash: each bit of the input reaches each of the result.
    hash ^= static_cast<std::uint64_t>(part) + 0x9e3779b97f4a7c15u + (hash << 6) + (hash >> 2);
    hash ^= hash >> 33;
    hash *= 0xff51afd7ed558ccdu;
    hash ^= hash >> 33;
  }
  return hash;
}

//------------------------------------------------------------------------------
/// The cell of a grid whose spacing is the tolerance; without one, the coordinates' own bits.
Cell GetCell(const Vector3d& point, double tolerance)
{
  Cell cell;
  for (int i = 0; i < 3; ++i)
  {
    if (tolerance > 0.0)
    {
      // Beyond the range of the integers all points share a cell: slow, but right.
      cell[i] = static_cast<std::int64_t>(
        std::fmax(-4e18, std::fmin(4e18, std::floor(point[i] / tolerance))));
    }
    else
    {
      const double value = point[i] + 0.0; // -0 becomes +0
      std::memcpy(&cell[i], &value, sizeof(value));
    }
  }
  return cell;
}
}

//------------------------------------------------------------------------------
std::vector<Index> FindCoincidentPoints(const std::vector<Vector3d>& points, double tolerance)
{
  const Index size = static_cast<Index>(points.size());
  std::vector<std::uint64_t> hashes(points.size());
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        hashes[i] = points[i].allFinite() ? Hash(GetCell(points[i], tolerance)) : 0;
      }
    });

  // Chains of the kept points with the same hash (mod the size of the table), latest first.
  std::size_t tableSize = 16;
  while (tableSize < 2 * points.size())
  {
    tableSize *= 2;
  }
  std::vector<Index> heads(tableSize, -1);
  std::vector<Index> nexts(points.size(), -1);
  std::vector<Index> firsts(points.size());
  const double limit = tolerance * tolerance;
  const auto search = [&](std::uint64_t hash, const Vector3d& point, Index best)
  {
    for (Index i = heads[hash & (tableSize - 1)]; i >= 0; i = nexts[i])
    {
      if ((best < 0 || i < best) && (points[i] - point).squaredNorm() <= limit)
      {
        best = i;
      }
    }
    return best;
  };
  for (Index i = 0; i < size; ++i)
  {
    firsts[i] = i;
    if (!points[i].allFinite())
    {
      continue;
    }
    Index found = -1;
    if (tolerance > 0.0)
    {
      const Cell centre = GetCell(points[i], tolerance);
      for (int n = 0; n < 27; ++n)
      {
        const Cell cell{ centre[0] + n % 3 - 1, centre[1] + n / 3 % 3 - 1, centre[2] + n / 9 - 1 };
        found = search(Hash(cell), points[i], found);
      }
    }
    else
    {
      found = search(hashes[i], points[i], -1);
    }
    if (found >= 0)
    {
      firsts[i] = found;
      continue;
    }
    Index& head = heads[hashes[i] & (tableSize - 1)];
    nexts[i] = head;
    head = i;
  }
  return firsts;
}
}
