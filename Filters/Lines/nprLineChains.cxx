// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineChains.h"

#include "nprArrayNames.h"
#include "nprLanes.h"

#include <vtkSMPTools.h>

#include <algorithm>

#include <Eigen/Geometry>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;

float Smooth(float x)
{
  x = std::min(std::max(x, 0.0f), 1.0f);
  return x * x * (3.0f - 2.0f * x);
}

// Vertices of segments, at their ends.
class Vertices
{
public:
  Vertices(const LineSurface& surface, const LineSegments& segments)
    : Surface(surface), Segments(segments)
  {
    if (surface.HasArray(names::Normals))
    {
      for (int i = 0; i < 3; ++i)
      {
        this->Normals[i] = surface.GetComponent(names::Normals, i);
      }
    }
  }

  struct Vertex
  {
    Eigen::Vector3d Position;
    Eigen::Vector3f Normal;
    float Strength;
    LineNode Node;
    Index Triangle;
  };

  Vertex Get(LinePaths::End end) const
  {
    const std::size_t segment = end / 2;
    const std::size_t crossings = this->Segments.Crossings.size();
    return segment < crossings
      ? this->GetOfCrossing(this->Segments.Crossings[segment], end % 2)
      : this->GetOfPiece(this->Segments.Pieces[segment - crossings], end % 2);
  }

  /// Starts to load what Get() will read, in two steps.
  void PrefetchTriangle(LinePaths::End end) const
  {
    const std::size_t segment = end / 2;
    if (segment < this->Segments.Crossings.size())
    {
      Prefetch(&this->Surface.GetMesh().GetTriangle(this->Segments.Crossings[segment].Triangle));
    }
  }
  void PrefetchPoints(LinePaths::End end) const
  {
    const std::size_t segment = end / 2;
    if (segment < this->Segments.Crossings.size())
    {
      const LineNode node = this->Segments.Crossings[segment].GetNode(this->Surface, end % 2);
      for (const Index point : { node.From, node.To })
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          Prefetch(this->Surface.GetCoordinate(axis) + point);
          if (this->Normals[axis])
          {
            Prefetch(this->Normals[axis] + point);
          }
        }
      }
    }
  }

private:
  Eigen::Vector3f GetNormal(Index point) const
  {
    return { this->Normals[0][point], this->Normals[1][point], this->Normals[2][point] };
  }

  // From the spans that fields are evaluated over: the cache is likely to have them still.
  Eigen::Vector3f GetPoint(Index point) const
  {
    return { this->Surface.GetCoordinate(0)[point], this->Surface.GetCoordinate(1)[point],
      this->Surface.GetCoordinate(2)[point] };
  }

  Eigen::Vector3d GetPosition(const LineNode& node) const
  {
    const Eigen::Vector3d from = this->GetPoint(node.From).cast<double>();
    const Eigen::Vector3d to = this->GetPoint(node.To).cast<double>();
    return from + double(node.T) * (to - from);
  }

  Vertex GetOfNode(const LineCrossing& crossing, int end) const
  {
    Vertex vertex;
    vertex.Node = crossing.GetNode(this->Surface, end);
    vertex.Position = this->GetPosition(vertex.Node);
    vertex.Normal.setZero();
    if (this->Normals[0])
    {
      const Eigen::Vector3f normal = this->GetNormal(vertex.Node.From);
      vertex.Normal =
        (normal + vertex.Node.T * (this->GetNormal(vertex.Node.To) - normal)).normalized();
    }
    vertex.Strength = Smooth(crossing.Test[end]);
    vertex.Triangle = crossing.Triangle;
    return vertex;
  }

  Vertex GetOfCrossing(const LineCrossing& crossing, int end) const
  {
    Vertex vertex = this->GetOfNode(crossing, end);
    if (crossing.IsCut(end))
    {
      // The line ends in this triangle, where the test turns.
      const Vertex inside = this->GetOfNode(crossing, 1 - end);
      const double s = crossing.Test[end] / (double(crossing.Test[end]) - crossing.Test[1 - end]);
      vertex.Position += s * (inside.Position - vertex.Position);
      vertex.Normal += static_cast<float>(s) * (inside.Normal - vertex.Normal);
      vertex.Normal.normalize();
      vertex.Strength = 0.0f;
    }
    return vertex;
  }

  // The normal is the mean of those of the triangles on the edge.
  Vertex GetOfPiece(const LinePiece& piece, int end) const
  {
    Vertex vertex;
    vertex.Node = piece.Nodes[end];
    vertex.Position = this->GetPosition(vertex.Node);
    vertex.Normal.setZero();
    for (const Index* side = piece.Sides; side != piece.SidesEnd; ++side)
    {
      if (this->Normals[0])
      {
        const auto [low, high] = this->Surface.GetLowAndHigh(*side);
        const Eigen::Vector3f normal = this->GetNormal(low);
        vertex.Normal += normal + piece.FromLow[end] * (this->GetNormal(high) - normal);
      }
      else
      {
        vertex.Normal += this->Surface.GetMesh().GetAreaNormal(*side / 3).normalized();
      }
    }
    vertex.Normal.normalize();
    vertex.Strength = piece.Strength;
    vertex.Triangle = *piece.Sides / 3;
    return vertex;
  }

  const LineSurface& Surface;
  const LineSegments& Segments;
  std::array<const float*, 3> Normals = { nullptr, nullptr, nullptr };
};
}

//------------------------------------------------------------------------------
void LineChains::Make(const LineSurface& surface, const LineSegments& segments,
  const LinePaths& paths, bool findSources)
{
  this->Begins.assign(paths.Offsets.begin(), std::prev(paths.Offsets.end()));
  this->Ends.assign(std::next(paths.Offsets.begin()), paths.Offsets.end());
  this->Closed = paths.Closed;
  this->Levels.assign(this->Begins.size(), 0);
  for (std::size_t chain = 0; chain < this->Begins.size(); ++chain)
  {
    const std::size_t segment = paths.Ends[this->Begins[chain]] / 2;
    if (segment < segments.Crossings.size())
    {
      this->Levels[chain] = segments.Crossings[segment].Level;
    }
  }
  this->SetVertices(surface, segments, paths, findSources);
  this->MergePlaces(surface.GetMesh().GetOrigin());
}

//------------------------------------------------------------------------------
void LineChains::SetVertices(const LineSurface& surface, const LineSegments& segments,
  const LinePaths& paths, bool findSources)
{
  const std::size_t size = paths.Ends.size();
  this->Positions.resize(size);
  this->Normals.resize(size);
  this->Strengths.resize(size);
  this->Triangles.resize(size);
  this->SourceCells.resize(findSources ? size : 0);
  this->SourceEdges.resize(findSources ? size : 0);
  const Vertices vertices(surface, segments);
  vtkSMPTools::For(0, static_cast<vtkIdType>(size),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        constexpr vtkIdType ahead = 4;
        vertices.PrefetchTriangle(paths.Ends[std::min(i + 2 * ahead, end - 1)]);
        vertices.PrefetchPoints(paths.Ends[std::min(i + ahead, end - 1)]);
        const Vertices::Vertex vertex = vertices.Get(paths.Ends[i]);
        this->Positions[i] = vertex.Position;
        this->Normals[i] = vertex.Normal;
        this->Strengths[i] = vertex.Strength;
        this->Triangles[i] = vertex.Triangle;
        if (findSources)
        {
          this->SourceCells[i] = surface.GetCellId(vertex.Triangle);
          this->SourceEdges[i] = { surface.GetPointId(vertex.Node.From),
            surface.GetPointId(vertex.Node.To) };
        }
      }
    });
}

//------------------------------------------------------------------------------
// Places are compared as they will be written, with the origin added.
void LineChains::MergePlaces(const Eigen::Vector3d& origin)
{
  const auto isAtOnePlace = [&](std::size_t a, std::size_t b)
  { return origin + this->Positions[a] == origin + this->Positions[b]; };
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Begins.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType chain = first; chain < last; ++chain)
      {
        const std::size_t begin = this->Begins[chain];
        std::size_t kept = begin;
        for (std::size_t i = begin + 1; i < this->Ends[chain]; ++i)
        {
          if (isAtOnePlace(kept, i))
          {
            this->Normals[kept] += this->Normals[i];
            continue;
          }
          if (++kept != i)
          {
            this->Positions[kept] = this->Positions[i];
            this->Normals[kept] = this->Normals[i];
            this->Strengths[kept] = this->Strengths[i];
            this->Triangles[kept] = this->Triangles[i];
            if (!this->SourceCells.empty())
            {
              this->SourceCells[kept] = this->SourceCells[i];
              this->SourceEdges[kept] = this->SourceEdges[i];
            }
          }
        }
        if (this->Closed[chain] && kept > begin && isAtOnePlace(begin, kept))
        {
          this->Normals[begin] += this->Normals[kept];
          --kept;
        }
        if (kept + 1 != this->Ends[chain])
        {
          for (std::size_t i = begin; i <= kept; ++i)
          {
            this->Normals[i].normalize();
          }
        }
        const std::size_t size = kept + 1 - begin;
        this->Ends[chain] = size < 2 ? begin : kept + 1;
        // There and back between two places is one piece, not a loop.
        this->Closed[chain] = this->Closed[chain] && size > 2;
      }
    });
}
}
