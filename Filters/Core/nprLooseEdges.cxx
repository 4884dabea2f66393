// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLooseEdges.h"

#include <algorithm>
#include <utility>

namespace npr
{
//------------------------------------------------------------------------------
std::vector<char> FindLooseEdges(
  const std::vector<NetworkEdge>& edges, std::vector<TriangleMesh::Index> held)
{
  using Index = TriangleMesh::Index;
  std::vector<char> loose(edges.size(), 0);
  std::vector<std::pair<Index, std::size_t>> softAtPoints;
  std::vector<std::size_t> open;
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    for (const Index point : edges[edge].Points)
    {
      ++held[point];
      if (edges[edge].IsSoft)
      {
        softAtPoints.emplace_back(point, edge);
      }
    }
    if (edges[edge].IsSoft)
    {
      open.push_back(edge);
    }
  }
  std::sort(softAtPoints.begin(), softAtPoints.end());
  while (!open.empty())
  {
    const std::size_t edge = open.back();
    open.pop_back();
    const auto& points = edges[edge].Points;
    if (loose[edge] || (held[points[0]] > 1 && held[points[1]] > 1))
    {
      continue;
    }
    loose[edge] = 1;
    for (const Index point : points)
    {
      --held[point];
      for (auto next = std::lower_bound(
             softAtPoints.begin(), softAtPoints.end(), std::pair<Index, std::size_t>(point, 0));
           next != softAtPoints.end() && next->first == point; ++next)
      {
        open.push_back(next->second);
      }
    }
  }
  return loose;
}
}
