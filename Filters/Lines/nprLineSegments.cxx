// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineSegments.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace npr
{
//------------------------------------------------------------------------------
void RemoveDoubles(std::vector<LineSegment>& segments, std::int64_t firstVertexKey)
{
  std::vector<char> drop(segments.size(), 0);
  std::vector<std::pair<std::array<std::int64_t, 2>, std::size_t>> edges;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    auto keys = segments[i].Keys;
    if (keys[0] >= firstVertexKey && keys[1] >= firstVertexKey)
    {
      std::sort(keys.begin(), keys.end());
      edges.emplace_back(keys, i);
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 1; i < edges.size(); ++i)
  {
    drop[edges[i].second] |= edges[i].first == edges[i - 1].first;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (!drop[i])
    {
      segments[kept++] = segments[i];
    }
  }
  segments.resize(kept);
}

//------------------------------------------------------------------------------
void DropShortRows(std::vector<LineSegment>& segments, const LineSurface& surface,
  std::int64_t firstVertexKey, double least)
{
  using Index = TriangleMesh::Index;
  const Index numberOfPoints = surface.GetMesh().GetNumberOfPoints();
  std::vector<Index> parents(numberOfPoints);
  std::iota(parents.begin(), parents.end(), 0);
  const auto findRoot = [&parents](Index point)
  {
    while (parents[point] != point)
    {
      parents[point] = parents[parents[point]];
      point = parents[point];
    }
    return point;
  };
  const auto getPoint = [firstVertexKey](const LineSegment& segment, int end)
  { return static_cast<Index>(segment.Keys[end] - firstVertexKey); };

  for (const LineSegment& segment : segments)
  {
    parents[findRoot(getPoint(segment, 0))] = findRoot(getPoint(segment, 1));
  }
  std::vector<char> atBorder(numberOfPoints, 0);
  const EdgeList& seams = surface.GetSeams();
  for (Index edge = 0; edge < seams.GetNumberOfEdges(); ++edge)
  {
    if (seams.End(edge) - seams.Begin(edge) == 1)
    {
      const Index halfEdge = *seams.Begin(edge);
      atBorder[surface.GetWelded(surface.GetStart(halfEdge))] = 1;
      atBorder[surface.GetWelded(surface.GetEnd(halfEdge))] = 1;
    }
  }
  std::vector<Index> lengths(numberOfPoints, 0);
  for (const LineSegment& segment : segments)
  {
    ++lengths[findRoot(getPoint(segment, 0))];
  }
  for (Index point = 0; point < numberOfPoints; ++point)
  {
    if (atBorder[point])
    {
      ++lengths[findRoot(point)];
    }
  }
  segments.erase(
    std::remove_if(segments.begin(), segments.end(),
      [&](const LineSegment& segment) { return lengths[findRoot(getPoint(segment, 0))] < least; }),
    segments.end());
}
}
