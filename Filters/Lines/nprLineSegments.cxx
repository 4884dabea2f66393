// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineSegments.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;

// Takes out the elements whose place in `drop`, from `offset` on, is marked.
template<typename T>
void Erase(std::vector<T>& elements, const std::vector<char>& drop, std::size_t offset)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    if (!drop[offset + i])
    {
      elements[kept++] = elements[i];
    }
  }
  elements.resize(kept);
}
}

//------------------------------------------------------------------------------
void RemoveDoubles(const LineSurface& surface, LineSegments& segments)
{
  struct Edge
  {
    std::array<Index, 2> Points;
    std::size_t Segment;
    bool operator<(const Edge& other) const
    {
      return this->Points != other.Points ? this->Points < other.Points
                                          : this->Segment < other.Segment;
    }
  };
  std::vector<Edge> edges;
  const auto add = [&](Index a, Index b, std::size_t segment)
  {
    const Index from = surface.GetWelded(a);
    const Index to = surface.GetWelded(b);
    edges.push_back({ { std::min(from, to), std::max(from, to) }, segment });
  };
  const std::size_t crossings = segments.Crossings.size();
  for (std::size_t i = 0; i < crossings; ++i)
  {
    const LineCrossing& crossing = segments.Crossings[i];
    if (crossing.T[0] == 0.0f && crossing.T[1] == 0.0f && !crossing.IsCut(0) && !crossing.IsCut(1))
    {
      add(crossing.GetNode(surface, 0).From, crossing.GetNode(surface, 1).From, i);
    }
  }
  for (std::size_t i = 0; i < segments.Pieces.size(); ++i)
  {
    const LinePiece& piece = segments.Pieces[i];
    if (piece.Nodes[0].IsVertex() && piece.Nodes[1].IsVertex())
    {
      add(piece.Nodes[0].From, piece.Nodes[1].From, crossings + i);
    }
  }
  if (edges.size() < 2)
  {
    return;
  }
  std::sort(edges.begin(), edges.end());
  std::vector<char> drop(segments.GetSize(), 0);
  for (std::size_t i = 1; i < edges.size(); ++i)
  {
    drop[edges[i].Segment] = edges[i].Points == edges[i - 1].Points;
  }
  Erase(segments.Crossings, drop, 0);
  Erase(segments.Pieces, drop, crossings);
}

//------------------------------------------------------------------------------
void DropShortRows(const LineSurface& surface, double least, std::vector<LinePiece>& pieces)
{
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
  const auto getPoint = [&surface](const LinePiece& piece, int end)
  { return surface.GetWelded(piece.Nodes[end].From); };

  for (const LinePiece& piece : pieces)
  {
    parents[findRoot(getPoint(piece, 0))] = findRoot(getPoint(piece, 1));
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
  for (const LinePiece& piece : pieces)
  {
    ++lengths[findRoot(getPoint(piece, 0))];
  }
  for (Index point = 0; point < numberOfPoints; ++point)
  {
    if (atBorder[point])
    {
      ++lengths[findRoot(point)];
    }
  }
  pieces.erase(
    std::remove_if(pieces.begin(), pieces.end(),
      [&](const LinePiece& piece) { return lengths[findRoot(getPoint(piece, 0))] < least; }),
    pieces.end());
}
}
