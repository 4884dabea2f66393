// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineExtractor.h"

#include "nprArrayNames.h"
#include "vtkNPRLineDefinition.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace npr
{
namespace
{
// Large enough that a virtual call a block costs nothing, small enough to balance the threads.
constexpr vtkIdType BlockSize = 8192;

// Calls work(block, begin, end) for the blocks of [0, size), in parallel.
template<typename Work>
void ForBlocks(vtkIdType size, const Work& work)
{
  const vtkIdType blocks = (size + BlockSize - 1) / BlockSize;
  vtkSMPTools::For(0, blocks, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType block = first; block < last; ++block)
      {
        work(block, block * BlockSize, std::min(size, (block + 1) * BlockSize));
      }
    });
}

template<typename T>
void AppendBlocks(const std::vector<std::vector<T>>& blocks, std::vector<T>& result)
{
  std::size_t size = result.size();
  for (const std::vector<T>& block : blocks)
  {
    size += block.size();
  }
  result.reserve(size);
  for (const std::vector<T>& block : blocks)
  {
    result.insert(result.end(), block.begin(), block.end());
  }
}

vtkIdType GetNumberOfBlocks(vtkIdType size)
{
  return (size + BlockSize - 1) / BlockSize;
}

float Smooth(float x)
{
  x = std::min(std::max(x, 0.0f), 1.0f);
  return x * x * (3.0f - 2.0f * x);
}
}

// A point on an edge: From + T (To - From), as far as Position says.
struct LineExtractor::Node
{
  std::int64_t Key;
  Index From;
  Index To;
  double T;
};

//------------------------------------------------------------------------------
LineExtractor::LineExtractor(const LineSurface& surface, const vtkNPRLineDefinition& definition)
  : Surface(surface), Definition(definition), FirstVertexKey(surface.GetNumberOfHalfEdges()),
    FirstCutKey(FirstVertexKey + surface.GetMesh().GetNumberOfPoints())
{
  if (surface.HasArray(names::Normals))
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Normals[i] = surface.GetComponent(names::Normals, i);
    }
  }
  if (!definition.HasField())
  {
    return;
  }
  if (definition.GetAxes())
  {
    std::array<const float*, 3> axes;
    for (int i = 0; i < 3; ++i)
    {
      axes[i] = surface.GetComponent(definition.GetAxes(), i);
    }
    this->Axes = std::make_unique<FieldAxes>(surface, axes);
  }
  const TriangleMesh& mesh = surface.GetMesh();
  std::vector<signed char> signs(mesh.GetNumberOfPoints());
  ForBlocks(mesh.GetNumberOfPoints(),
    [&](vtkIdType, vtkIdType begin, vtkIdType end)
    { definition.BoundField(surface, begin, end, signs.data()); });
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const TriangleMesh::Triangle& c = mesh.GetTriangle(t);
    const signed char sign = signs[c[0]];
    if (sign == 0 || signs[c[1]] != sign || signs[c[2]] != sign)
    {
      this->Candidates.push_back(t);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<float> LineExtractor::EvaluateField(const LineView& view, float level) const
{
  const Index numberOfPoints = this->Surface.GetMesh().GetNumberOfPoints();
  std::vector<float> field(numberOfPoints);
  ForBlocks(numberOfPoints,
    [&](vtkIdType, vtkIdType begin, vtkIdType end)
    {
      this->Definition.EvaluateField(this->Surface, view, begin, end, field.data());
      for (vtkIdType i = begin; i < end; ++i)
      {
        field[i] -= level;
      }
    });
  return field;
}

//------------------------------------------------------------------------------
void LineExtractor::SetViewAxes(const LineView& view)
{
  const Index numberOfPoints = this->Surface.GetMesh().GetNumberOfPoints();
  std::array<float*, 3> axes;
  for (int i = 0; i < 3; ++i)
  {
    this->ViewAxes[i].resize(numberOfPoints);
    axes[i] = this->ViewAxes[i].data();
  }
  ForBlocks(numberOfPoints,
    [&](vtkIdType, vtkIdType begin, vtkIdType end)
    { this->Definition.EvaluateAxes(this->Surface, view, begin, end, axes); });
  this->Axes = std::make_unique<FieldAxes>(
    this->Surface, std::array<const float*, 3>{ axes[0], axes[1], axes[2] });
}

//------------------------------------------------------------------------------
std::vector<LineSegment> LineExtractor::Extract(const LineView& view, float level)
{
  std::vector<LineSegment> segments;
  if (this->Definition.HasField())
  {
    if (this->Definition.HasViewAxes())
    {
      this->SetViewAxes(view);
    }
    const std::vector<float> field = this->EvaluateField(view, level);
    this->ExtractField(view, field.data(), segments);
    if (this->Definition.FollowsJumps())
    {
      this->ExtractJumps(field.data(), segments);
    }
  }
  const vtkNPRLineDefinition::EdgeKind edges = this->Definition.GetEdges();
  std::vector<LineSegment> edgeSegments;
  if (edges != vtkNPRLineDefinition::NoEdges)
  {
    this->ExtractEdges(view, this->Surface.GetSeams(), edgeSegments);
  }
  if (edges == vtkNPRLineDefinition::AllEdges)
  {
    this->ExtractEdges(view, this->Surface.GetInnerEdges(), edgeSegments);
  }
  if (this->Definition.GetLeastRow() > 1.0)
  {
    DropShortRows(
      edgeSegments, this->Surface, this->FirstVertexKey, this->Definition.GetLeastRow());
  }
  segments.insert(segments.end(), edgeSegments.begin(), edgeSegments.end());
  RemoveDoubles(segments, this->FirstVertexKey);
  return segments;
}

//------------------------------------------------------------------------------
bool LineExtractor::IsCrossed(Index halfEdge, const float* field) const
{
  return this->Axes ? this->Axes->IsCrossed(halfEdge, field)
                    : (field[this->Surface.GetStart(halfEdge)] >= 0.0f) !=
      (field[this->Surface.GetEnd(halfEdge)] >= 0.0f);
}

//------------------------------------------------------------------------------
// Of a half-edge that is crossed.
LineExtractor::Node LineExtractor::CrossEdge(Index halfEdge, const float* field) const
{
  Node node;
  node.From = this->Surface.GetStart(halfEdge);
  node.To = this->Surface.GetEnd(halfEdge);
  // Always from one end, so that both triangles find the same bits, and an exact zero its vertex:
  // from the positive end, or where the field has axes and so no positive end, from the one that is
  // nearer to 0.
  const auto rank = [&](Index point)
  { return std::make_pair(std::abs(field[point]), this->Surface.GetWelded(point)); };
  if (this->Axes ? rank(node.To) < rank(node.From) : field[node.From] < 0.0f)
  {
    std::swap(node.From, node.To);
  }
  const double from = std::abs(double(field[node.From]));
  const double sum = from + std::abs(double(field[node.To]));
  // Both ends are 0 only where axes turn against their order in space.
  node.T = sum > 0.0 ? from / sum : 0.5;
  if (node.T == 0.0)
  {
    node.Key = this->FirstVertexKey + this->Surface.GetWelded(node.From);
  }
  else
  {
    const Index twin = this->Surface.GetTwin(halfEdge);
    node.Key = twin == LineSurface::NoTwin ? halfEdge : std::min(halfEdge, twin);
  }
  return node;
}

//------------------------------------------------------------------------------
std::array<LineExtractor::Index, 2> LineExtractor::GetLowAndHigh(Index halfEdge) const
{
  const Index start = this->Surface.GetStart(halfEdge);
  const Index end = this->Surface.GetEnd(halfEdge);
  return this->Surface.GetWelded(start) < this->Surface.GetWelded(end)
    ? std::array<Index, 2>{ start, end }
    : std::array<Index, 2>{ end, start };
}

//------------------------------------------------------------------------------
LineExtractor::Node LineExtractor::AtVertex(Index point) const
{
  return { this->FirstVertexKey + this->Surface.GetWelded(point), point, point, 0.0 };
}

//------------------------------------------------------------------------------
Eigen::Vector3f LineExtractor::GetNormal(Index point) const
{
  return { this->Normals[0][point], this->Normals[1][point], this->Normals[2][point] };
}

//------------------------------------------------------------------------------
LineVertex LineExtractor::GetVertex(const Node& node) const
{
  const TriangleMesh& mesh = this->Surface.GetMesh();
  const Eigen::Vector3d from = mesh.GetPoint(node.From).cast<double>();
  const Eigen::Vector3d to = mesh.GetPoint(node.To).cast<double>();
  LineVertex vertex;
  vertex.Position = from + node.T * (to - from);
  vertex.Strength = 1.0f;
  vertex.Normal.setZero();
  if (this->Normals[0])
  {
    const Eigen::Vector3f normal = this->GetNormal(node.From);
    vertex.Normal =
      (normal + static_cast<float>(node.T) * (this->GetNormal(node.To) - normal)).normalized();
  }
  return vertex;
}

//------------------------------------------------------------------------------
void LineExtractor::ExtractField(
  const LineView& view, const float* field, std::vector<LineSegment>& segments) const
{
  const TriangleMesh& mesh = this->Surface.GetMesh();
  const vtkIdType size = static_cast<vtkIdType>(this->Candidates.size());
  const bool tested = this->Definition.HasTest();
  std::vector<float> fall;
  if (this->Axes && this->Definition.IsMaximum())
  {
    fall = this->Axes->ComputeFall(field);
  }
  std::vector<std::vector<LineSegment>> blocks(GetNumberOfBlocks(size));
  ForBlocks(size,
    [&](vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> crossed;
      std::vector<Index> corners;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index t = this->Candidates[i];
        const TriangleMesh::Triangle& c = mesh.GetTriangle(t);
        const int crossings = this->IsCrossed(3 * t, field) + this->IsCrossed(3 * t + 1, field) +
          this->IsCrossed(3 * t + 2, field);
        if (crossings == 2 && std::isfinite(field[c[0]]) && std::isfinite(field[c[1]]) &&
          std::isfinite(field[c[2]]))
        {
          crossed.push_back(t);
          corners.insert(corners.end(), c.begin(), c.end());
        }
      }
      std::vector<float> test;
      if (tested)
      {
        test.resize(corners.size());
        this->Definition.EvaluateTest(this->Surface, view, corners.data(),
          static_cast<vtkIdType>(corners.size()), fall.empty() ? nullptr : fall.data(),
          test.data());
      }

      blocks[block].reserve(crossed.size());
      for (std::size_t i = 0; i < crossed.size(); ++i)
      {
        const TriangleMesh::Triangle& c = mesh.GetTriangle(crossed[i]);
        // Walking the triangle's border, the line starts where the field turns negative; where that
        // means nothing, with the first crossing.
        std::array<Node, 2> nodes = {};
        std::array<float, 2> accepted = { 1.0f, 1.0f };
        int found = 0;
        for (int e = 0; e < 3; ++e)
        {
          if (!this->IsCrossed(3 * crossed[i] + e, field))
          {
            continue;
          }
          const int n = this->Axes ? found++ : field[c[e]] >= 0.0f ? 0 : 1;
          nodes[n] = this->CrossEdge(3 * crossed[i] + e, field);
          if (tested)
          {
            const int next = (e + 1) % 3;
            const bool forward = nodes[n].From == c[e];
            const float s = static_cast<float>(nodes[n].T);
            const std::size_t from = 3 * i + (forward ? e : next);
            const std::size_t to = 3 * i + (forward ? next : e);
            accepted[n] = test[from] + s * (test[to] - test[from]);
          }
        }
        // Also false where the test is not a number.
        const bool keep = std::max(accepted[0], accepted[1]) > 0.0f && std::isfinite(accepted[0]) &&
          std::isfinite(accepted[1]);
        if (nodes[0].Key == nodes[1].Key || !keep)
        {
          continue;
        }
        LineSegment segment = { { nodes[0].Key, nodes[1].Key },
          { this->GetVertex(nodes[0]), this->GetVertex(nodes[1]) } };
        for (int n = 0; n < 2; ++n)
        {
          segment.Vertices[n].Strength = Smooth(accepted[n]);
        }
        for (int n = 0; n < 2; ++n)
        {
          if (accepted[n] < 0.0f)
          {
            // The line ends in this triangle, where the test turns.
            const LineVertex& outside = segment.Vertices[n];
            const LineVertex& inside = segment.Vertices[1 - n];
            const double s = accepted[n] / (double(accepted[n]) - accepted[1 - n]);
            LineVertex cut;
            cut.Position = outside.Position + s * (inside.Position - outside.Position);
            cut.Normal = (outside.Normal + static_cast<float>(s) * (inside.Normal - outside.Normal))
                           .normalized();
            cut.Strength = 0.0f;
            segment.Vertices[n] = cut;
            segment.Keys[n] = this->FirstCutKey + crossed[i];
          }
        }
        blocks[block].push_back(segment);
      }
    });
  AppendBlocks(blocks, segments);
}

//------------------------------------------------------------------------------
// A piece of an edge; its normals are the mean of those of the triangles on it. `fromLow` and
// `toLow` say where it lies between the edge's low and high welded point.
LineSegment LineExtractor::GetEdgeSegment(const Node& from, const Node& to, const Index* sides,
  const Index* end, double fromLow, double toLow, float strength) const
{
  LineSegment segment = { { from.Key, to.Key }, { this->GetVertex(from), this->GetVertex(to) } };
  for (int n = 0; n < 2; ++n)
  {
    const float t = static_cast<float>(n == 0 ? fromLow : toLow);
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const Index* side = sides; side != end; ++side)
    {
      if (this->Normals[0])
      {
        const auto [low, high] = this->GetLowAndHigh(*side);
        const Eigen::Vector3f normal = this->GetNormal(low);
        sum += normal + t * (this->GetNormal(high) - normal);
      }
      else
      {
        sum += this->Surface.GetMesh().GetAreaNormal(*side / 3).normalized();
      }
    }
    segment.Vertices[n].Normal = sum.normalized();
    segment.Vertices[n].Strength = strength;
  }
  return segment;
}

//------------------------------------------------------------------------------
LineSegment LineExtractor::GetWholeEdge(const Index* sides, const Index* end, float strength) const
{
  // In the direction of its first triangle, which is then on the left.
  const Index start = this->Surface.GetStart(*sides);
  const Index stop = this->Surface.GetEnd(*sides);
  const double fromLow = start == this->GetLowAndHigh(*sides)[0] ? 0.0 : 1.0;
  return this->GetEdgeSegment(
    this->AtVertex(start), this->AtVertex(stop), sides, end, fromLow, 1.0 - fromLow, strength);
}

//------------------------------------------------------------------------------
void LineExtractor::ExtractJumps(const float* field, std::vector<LineSegment>& segments) const
{
  // Where points are split, each side has a field of its own along the edge. The line runs where
  // their signs differ: so it goes on exactly where the lines in the triangles on both sides end.
  struct Side
  {
    bool Forward;                 // the triangle runs from the low point to the high one
    std::array<bool, 2> Positive; // at low, at high
    std::size_t Change;           // the first interval after the change of sign
    bool IsPositive(std::size_t interval) const { return this->Positive[interval >= this->Change]; }
  };
  struct Place
  {
    double T; // from low to high
    Node At;
    std::size_t Owner; // the side whose sign changes here
  };
  const EdgeList& seams = this->Surface.GetSeams();
  std::vector<Side> sides;
  std::vector<Place> places;
  for (Index edge = 0; edge < seams.GetNumberOfEdges(); ++edge)
  {
    const Index* begin = seams.Begin(edge);
    const Index* end = seams.End(edge);
    if (end - begin == 1)
    {
      // Nothing is on the other side of a border, so the line runs along all of it.
      segments.push_back(this->GetWholeEdge(begin, end, 1.0f));
      continue;
    }
    sides.clear();
    places.clear();
    for (const Index* h = begin; h != end; ++h)
    {
      const auto [low, high] = this->GetLowAndHigh(*h);
      if (!std::isfinite(field[low]) || !std::isfinite(field[high]))
      {
        continue;
      }
      const bool forward = low == this->Surface.GetStart(*h);
      sides.push_back({ forward, { field[low] >= 0.0f, field[high] >= 0.0f }, 0 });
      if (sides.back().Positive[0] != sides.back().Positive[1])
      {
        const Node node = this->CrossEdge(*h, field);
        places.push_back({ node.From == low ? node.T : 1.0 - node.T, node, sides.size() - 1 });
      }
    }
    std::stable_sort(
      places.begin(), places.end(), [](const Place& a, const Place& b) { return a.T < b.T; });
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      sides[places[i].Owner].Change = i + 1;
    }
    const auto [low, high] = this->GetLowAndHigh(*begin);
    places.insert(places.begin(), { 0.0, this->AtVertex(low), 0 });
    places.push_back({ 1.0, this->AtVertex(high), 0 });
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
    {
      const auto front = std::find_if(
        sides.begin(), sides.end(), [i](const Side& side) { return side.IsPositive(i); });
      const bool mixed = front != sides.end() &&
        !std::all_of(
          sides.begin(), sides.end(), [i](const Side& side) { return side.IsPositive(i); });
      if (mixed && places[i].At.Key != places[i + 1].At.Key)
      {
        const Place& from = places[front->Forward ? i : i + 1];
        const Place& to = places[front->Forward ? i + 1 : i];
        segments.push_back(this->GetEdgeSegment(from.At, to.At, begin, end, from.T, to.T, 1.0f));
      }
    }
  }
}

//------------------------------------------------------------------------------
void LineExtractor::ExtractEdges(
  const LineView& view, const EdgeList& edges, std::vector<LineSegment>& segments) const
{
  const vtkIdType size = edges.GetNumberOfEdges();
  std::vector<std::vector<LineSegment>> blocks(GetNumberOfBlocks(size));
  ForBlocks(size,
    [&](vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      std::vector<float> strength(end - begin, 0.0f);
      this->Definition.EvaluateEdges(this->Surface, view, edges, begin, end, strength.data());
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (!(strength[i - begin] > 0.0f))
        {
          continue;
        }
        const Index edge = static_cast<Index>(i);
        blocks[block].push_back(
          this->GetWholeEdge(edges.Begin(edge), edges.End(edge), strength[i - begin]));
      }
    });
  AppendBlocks(blocks, segments);
}
}
