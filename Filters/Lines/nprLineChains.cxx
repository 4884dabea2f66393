// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineChains.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <utility>

namespace npr
{
namespace
{
// End 2 * s + i is vertex i of segment s.
using End = std::int32_t;
constexpr End Free = -1;

std::vector<End> FindMates(const std::vector<LineSegment>& segments)
{
  std::vector<std::pair<std::int64_t, End>> ends(2 * segments.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(ends.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        ends[i] = { segments[i / 2].Keys[i % 2], static_cast<End>(i) };
      }
    });
  vtkSMPTools::Sort(ends.begin(), ends.end());
  std::vector<End> mates(ends.size(), Free);
  for (std::size_t i = 0; i < ends.size();)
  {
    std::size_t last = i + 1;
    while (last < ends.size() && ends[last].first == ends[i].first)
    {
      ++last;
    }
    if (last - i == 2)
    {
      mates[ends[i].second] = ends[i + 1].second;
      mates[ends[i + 1].second] = ends[i].second;
    }
    i = last;
  }
  return mates;
}

class Joiner
{
public:
  Joiner(const std::vector<LineSegment>& segments, const Eigen::Vector3d& origin)
    : Segments(segments), Origin(origin), Mates(FindMates(segments)),
      Visited(segments.size(), false)
  {
  }

  LineChains Run()
  {
    for (End end = 0; end < static_cast<End>(this->Mates.size()); ++end)
    {
      if (this->Mates[end] == Free && !this->Visited[end / 2])
      {
        this->Trace(end);
        this->Write(false);
      }
    }
    for (End end = 0; end < static_cast<End>(this->Mates.size()); end += 2)
    {
      if (!this->Visited[end / 2])
      {
        this->Trace(end);
        this->Write(true);
      }
    }
    return std::move(this->Chains);
  }

private:
  // Follows the chain whose first vertex is at `end`; Path gets the end that each segment is
  // entered by.
  void Trace(End end)
  {
    this->Path.clear();
    std::size_t forward = 0;
    while (end != Free && !this->Visited[end / 2])
    {
      this->Visited[end / 2] = true;
      this->Path.push_back(end);
      forward += end % 2 == 0;
      end = this->Mates[end ^ 1];
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

  const LineVertex& Get(End end) const { return this->Segments[end / 2].Vertices[end % 2]; }

  bool AtOnePlace(const LineVertex& a, const LineVertex& b) const
  {
    return this->Origin + a.Position == this->Origin + b.Position;
  }

  void Append(const LineVertex& vertex)
  {
    std::vector<LineVertex>& vertices = this->Chains.Vertices;
    if (vertices.size() > this->Chains.Offsets.back() && this->AtOnePlace(vertices.back(), vertex))
    {
      vertices.back().Normal += vertex.Normal;
    }
    else
    {
      vertices.push_back(vertex);
    }
  }

  void Write(bool closed)
  {
    std::vector<LineVertex>& vertices = this->Chains.Vertices;
    const std::size_t first = this->Chains.Offsets.back();
    for (End entry : this->Path)
    {
      this->Append(this->Get(entry));
      this->Append(this->Get(entry ^ 1));
    }
    if (closed && vertices.size() - first > 1 && this->AtOnePlace(vertices[first], vertices.back()))
    {
      vertices[first].Normal += vertices.back().Normal;
      vertices.pop_back();
    }
    const std::size_t size = vertices.size() - first;
    if (size < 2)
    {
      vertices.resize(first);
      return;
    }
    for (std::size_t i = first; i < vertices.size(); ++i)
    {
      vertices[i].Normal.normalize();
    }
    this->Chains.Offsets.push_back(vertices.size());
    // There and back between two places is one piece, not a loop.
    this->Chains.Closed.push_back(closed && size > 2);
  }

  const std::vector<LineSegment>& Segments;
  const Eigen::Vector3d Origin;
  const std::vector<End> Mates;
  std::vector<bool> Visited;
  std::vector<End> Path;
  LineChains Chains;
};
}

//------------------------------------------------------------------------------
LineChains JoinSegments(const std::vector<LineSegment>& segments, const Eigen::Vector3d& origin)
{
  return Joiner(segments, origin).Run();
}
}
