// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineJoiner.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <utility>

namespace npr
{
//------------------------------------------------------------------------------
LineJoiner::LineJoiner(const LineSurface& surface)
  : Surface(surface), CrossingOfTriangle(surface.GetMesh().GetNumberOfTriangles(), 0)
{
}

//------------------------------------------------------------------------------
void LineJoiner::Join(const LineSegments& segments, LinePaths& paths)
{
  paths.Ends.clear();
  paths.Offsets.assign(1, 0);
  paths.Closed.clear();
  this->FindMates(segments);
  this->Visited.assign(segments.GetSize(), 0);
  const End size = static_cast<End>(this->Mates.size());
  for (End end = 0; end < size; ++end)
  {
    if (this->Mates[end] == Free && !this->Visited[end / 2])
    {
      this->Trace(end);
      this->Write(false, paths);
    }
  }
  for (End end = 0; end < size; end += 2)
  {
    if (!this->Visited[end / 2])
    {
      this->Trace(end);
      this->Write(true, paths);
    }
  }
}

//------------------------------------------------------------------------------
void LineJoiner::FindMates(const LineSegments& segments)
{
  const std::vector<LineCrossing>& crossings = segments.Crossings;
  vtkSMPTools::For(0, static_cast<vtkIdType>(crossings.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (i == 0 || crossings[i - 1].Triangle != crossings[i].Triangle)
        {
          this->CrossingOfTriangle[crossings[i].Triangle] = static_cast<Index>(i);
        }
      }
    });
  this->Mates.resize(2 * segments.GetSize());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Mates.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->Mates[i] = this->FindMate(segments, static_cast<End>(i));
      }
    });
  this->FindMatesByKeys(segments);
}

//------------------------------------------------------------------------------
LineJoiner::End LineJoiner::FindMate(const LineSegments& segments, End end) const
{
  const Index size = static_cast<Index>(segments.Crossings.size());
  const Index segment = end / 2;
  if (segment >= size)
  {
    return Keyed;
  }
  const LineCrossing& crossing = segments.Crossings[segment];
  if (crossing.IsCut(end % 2))
  {
    return Free;
  }
  if (crossing.T[end % 2] == 0.0f)
  {
    return Keyed;
  }
  const Index twin = this->Surface.GetTwin(crossing.GetHalfEdge(end % 2));
  if (twin == LineSurface::NoTwin)
  {
    return segments.Pieces.empty() ? Free : Keyed;
  }
  for (Index other = this->CrossingOfTriangle[twin / 3];
       other < size && segments.Crossings[other].Triangle == twin / 3; ++other)
  {
    const LineCrossing& next = segments.Crossings[other];
    if (next.Level != crossing.Level)
    {
      continue;
    }
    for (int n = 0; n < 2; ++n)
    {
      if (next.GetHalfEdge(n) == twin && next.T[n] != 0.0f && !next.IsCut(n))
      {
        return 2 * other + n;
      }
    }
  }
  return Free;
}

//------------------------------------------------------------------------------
std::int64_t LineJoiner::GetKeyOf(const LineSegments& segments, End end) const
{
  const std::size_t segment = end / 2;
  if (segment < segments.Crossings.size())
  {
    const LineCrossing& crossing = segments.Crossings[segment];
    const LineNode node = crossing.GetNode(this->Surface, end % 2);
    return GetKey(
      this->Surface, node, node.IsVertex() ? LinePiece::NoHalfEdge : crossing.GetHalfEdge(end % 2));
  }
  const LinePiece& piece = segments.Pieces[segment - segments.Crossings.size()];
  return GetKey(this->Surface, piece.Nodes[end % 2], piece.HalfEdges[end % 2]);
}

//------------------------------------------------------------------------------
// At a vertex, where exactly two ends meet the sum of both less one is the other.
void LineJoiner::FindMatesByKeys(const LineSegments& segments)
{
  std::vector<std::pair<std::int64_t, End>> atVertices;
  std::vector<std::pair<std::int64_t, End>> onSeams;
  const std::int64_t firstVertex = this->Surface.GetNumberOfHalfEdges();
  for (End end = 0; end < static_cast<End>(this->Mates.size()); ++end)
  {
    if (this->Mates[end] == Keyed)
    {
      this->Mates[end] = Free;
      const std::int64_t key = this->GetKeyOf(segments, end);
      (key < firstVertex ? onSeams : atVertices).emplace_back(key, end);
    }
  }
  if (!atVertices.empty() && this->Counts.empty())
  {
    this->Counts.assign(this->Surface.GetMesh().GetNumberOfPoints(), 0);
    this->Sums.assign(this->Counts.size(), 0);
  }
  for (const auto& [key, end] : atVertices)
  {
    unsigned char& count = this->Counts[key - firstVertex];
    count = static_cast<unsigned char>(std::min(count + 1, 3));
    this->Sums[key - firstVertex] ^= end;
  }
  for (const auto& [key, end] : atVertices)
  {
    if (this->Counts[key - firstVertex] == 2)
    {
      this->Mates[end] = JoinByKey(this->Sums[key - firstVertex] ^ end);
    }
  }
  for (const auto& [key, end] : atVertices)
  {
    this->Counts[key - firstVertex] = 0;
    this->Sums[key - firstVertex] = 0;
  }
  std::sort(onSeams.begin(), onSeams.end());
  for (std::size_t i = 0; i < onSeams.size();)
  {
    std::size_t last = i + 1;
    while (last < onSeams.size() && onSeams[last].first == onSeams[i].first)
    {
      ++last;
    }
    if (last - i == 2)
    {
      this->Mates[onSeams[i].second] = JoinByKey(onSeams[i + 1].second);
      this->Mates[onSeams[i + 1].second] = JoinByKey(onSeams[i].second);
    }
    i = last;
  }
}

//------------------------------------------------------------------------------
void LineJoiner::Trace(End end)
{
  this->Path.clear();
  std::size_t forward = 0;
  while (end != Free && !this->Visited[end / 2])
  {
    this->Visited[end / 2] = 1;
    this->Path.push_back(end);
    forward += end % 2 == 0;
    end = this->GetMate(end ^ 1);
  }
  if (2 * forward < this->Path.size())
  {
    std::reverse(this->Path.begin(), this->Path.end());
    for (End& entry : this->Path)
    {
      entry ^= 1;
    }
  }
}

//------------------------------------------------------------------------------
void LineJoiner::Write(bool closed, LinePaths& paths) const
{
  paths.Ends.push_back(this->Path.front());
  for (std::size_t i = 0; i < this->Path.size(); ++i)
  {
    const End leaving = this->Path[i] ^ 1;
    const bool isLast = i + 1 == this->Path.size();
    const bool isJoinedInside = this->Mates[leaving] >= 0;
    // At an edge between twins both have the same node.
    if (!(isLast && closed && isJoinedInside))
    {
      paths.Ends.push_back(leaving);
    }
    if (!isLast && !isJoinedInside)
    {
      paths.Ends.push_back(this->Path[i + 1]);
    }
  }
  paths.Offsets.push_back(paths.Ends.size());
  paths.Closed.push_back(closed ? 1 : 0);
}
}
