// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineExtractor.h"

#include "nprEdgePieces.h"
#include "nprHermite.h"
#include "vtkNPRLineDefinition.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace npr
{
namespace
{
using Index = LineExtractor::Index;
constexpr Index GroupsOfPart = 4;

// Calls work(i) for all elements, in parallel.
template<typename Elements, typename Work>
void ForEach(Elements& elements, const Work& work)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(elements.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        work(static_cast<Index>(i));
      }
    });
}
}

//------------------------------------------------------------------------------
LineExtractor::LineExtractor(
  const LineSurface& surface, const LineClusters& clusters, const vtkNPRLineDefinition& definition)
  : Surface(surface), Clusters(clusters), Definition(definition), Levels({ 0.0f })
{
  if (!definition.HasField())
  {
    return;
  }
  this->Levels = definition.GetLevels(surface);
  std::sort(this->Levels.begin(), this->Levels.end());
  if (definition.GetAxes() || definition.HasViewAxes())
  {
    this->Axes = std::make_unique<FieldAxes>(surface);
  }
  if (definition.GetAxes())
  {
    std::array<const float*, 3> axes;
    for (int i = 0; i < 3; ++i)
    {
      axes[i] = surface.GetComponent(definition.GetAxes(), i);
    }
    this->Axes->SetVectors(axes);
    this->Axes->Compare();
  }
  const auto slopeArrays = definition.GetSlopeArrays();
  this->HasSlopes = !slopeArrays.empty() &&
    std::all_of(slopeArrays.begin(), slopeArrays.end(),
      [&surface](const auto& array) { return surface.HasArray(array.Name); });
  this->Parts.resize((clusters.GetNumberOfGroups() + GroupsOfPart - 1) / GroupsOfPart);
  this->FindCandidates();
}

//------------------------------------------------------------------------------
LineExtractor::~LineExtractor() = default;

//------------------------------------------------------------------------------
void LineExtractor::FindCandidates()
{
  if (this->Levels.size() != 1 || this->Levels[0] != 0.0f)
  {
    return;
  }
  const TriangleMesh& mesh = this->Surface.GetMesh();
  std::vector<signed char> signs(mesh.GetNumberOfPoints());
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    { this->Definition.BoundField(this->Surface, begin, end, signs.data()); });
  this->HasCandidates =
    std::any_of(signs.begin(), signs.end(), [](signed char sign) { return sign != 0; });
  if (!this->HasCandidates)
  {
    return;
  }
  this->CandidateOffsets.assign(1, 0);
  for (Index cluster = 0; cluster < this->Clusters.GetNumberOfClusters(); ++cluster)
  {
    for (Index t = this->Clusters.GetFirstTriangle(cluster);
         t < this->Clusters.GetTriangleEnd(cluster); ++t)
    {
      const TriangleMesh::Triangle& c = mesh.GetTriangle(t);
      const signed char sign = signs[c[0]];
      if (sign == 0 || signs[c[1]] != sign || signs[c[2]] != sign)
      {
        this->Candidates.push_back(t);
      }
    }
    this->CandidateOffsets.push_back(static_cast<Index>(this->Candidates.size()));
  }
}

//------------------------------------------------------------------------------
void LineExtractor::Extract(
  const LineView& view, const LineOptions& options, FieldValues& values, LineSegments& segments)
{
  segments.Crossings.clear();
  segments.Pieces.clear();
  if (this->Definition.HasField())
  {
    values.Start(this->Definition, view, this->Levels, this->Axes.get());
    if (this->Definition.FollowsJumps())
    {
      this->RequireSeams(values);
    }
    if (options.Strategy == LineStrategy::Random && this->Definition.IsViewDependent())
    {
      values.Evaluate();
      this->FindCrossedAtRandom(options.SeedShare, values);
    }
    else
    {
      this->FindClusters(view, options.Strategy, values);
      values.Evaluate();
      this->FindCrossed(values);
    }
    this->MakeCrossings(view, options.UseSlopes, values, segments);
    if (this->Definition.FollowsJumps())
    {
      AddJumpPieces(this->Surface, values, segments.Pieces);
    }
  }
  AddEdgePieces(this->Surface, this->Definition, view, segments.Pieces);
  RemoveDoubles(this->Surface, segments);
}

//------------------------------------------------------------------------------
void LineExtractor::RequireSeams(FieldValues& values) const
{
  for (const Index halfEdge : this->Surface.GetSeams().HalfEdges)
  {
    values.Require(this->Surface.GetStart(halfEdge) / LineClusters::PointsOfBlock);
    values.Require(this->Surface.GetEnd(halfEdge) / LineClusters::PointsOfBlock);
  }
}

//------------------------------------------------------------------------------
void LineExtractor::FindClusters(const LineView& view, LineStrategy strategy, FieldValues& values)
{
  const bool isBounded =
    strategy == LineStrategy::Hierarchical && this->Definition.IsViewDependent();
  const std::array<float, 2> range = this->Definition.GetFacingRange();
  ForEach(this->Parts,
    [&](Index p)
    {
      std::vector<Index>& clusters = this->Parts[p].Clusters;
      clusters.clear();
      const Index last = std::min((p + 1) * GroupsOfPart, this->Clusters.GetNumberOfGroups());
      for (Index group = p * GroupsOfPart; group < last; ++group)
      {
        if (isBounded)
        {
          this->Clusters.FindFacing(view, range, group, clusters);
          continue;
        }
        const Index first = group * LineClusters::ClustersOfGroup;
        const Index end =
          std::min(first + LineClusters::ClustersOfGroup, this->Clusters.GetNumberOfClusters());
        for (Index cluster = first; cluster < end; ++cluster)
        {
          clusters.push_back(cluster);
        }
      }
      if (this->HasCandidates)
      {
        clusters.erase(
          std::remove_if(clusters.begin(), clusters.end(),
            [this](Index cluster)
            { return this->CandidateOffsets[cluster] == this->CandidateOffsets[cluster + 1]; }),
          clusters.end());
      }
      for (const Index cluster : clusters)
      {
        for (const Index* block = this->Clusters.BlocksBegin(cluster);
             block != this->Clusters.BlocksEnd(cluster); ++block)
        {
          values.Require(*block);
        }
      }
    });
}

//------------------------------------------------------------------------------
bool LineExtractor::IsCrossed(Index triangle, const FieldValues& values) const
{
  const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(triangle);
  const FieldValues::Side a = values.GetSide(c[0]);
  const FieldValues::Side b = values.GetSide(c[1]);
  const FieldValues::Side d = values.GetSide(c[2]);
  if (!this->Axes)
  {
    return (a != b || b != d) && a != FieldValues::NotANumber && b != FieldValues::NotANumber &&
      d != FieldValues::NotANumber;
  }
  const float* const field = values.Get();
  return a != FieldValues::NotANumber && b != FieldValues::NotANumber &&
    d != FieldValues::NotANumber &&
    this->Axes->IsCrossed(3 * triangle, field) + this->Axes->IsCrossed(3 * triangle + 1, field) +
      this->Axes->IsCrossed(3 * triangle + 2, field) ==
    2;
}

//------------------------------------------------------------------------------
void LineExtractor::FindCrossed(FieldValues& values)
{
  ForEach(this->Parts,
    [&](Index p)
    {
      Part& part = this->Parts[p];
      part.Crossed.clear();
      for (const Index cluster : part.Clusters)
      {
        if (this->HasCandidates)
        {
          for (Index i = this->CandidateOffsets[cluster]; i < this->CandidateOffsets[cluster + 1];
               ++i)
          {
            if (this->IsCrossed(this->Candidates[i], values))
            {
              part.Crossed.push_back(this->Candidates[i]);
            }
          }
          continue;
        }
        const Index end = this->Clusters.GetTriangleEnd(cluster);
        for (Index t = this->Clusters.GetFirstTriangle(cluster); t < end; ++t)
        {
          if (this->IsCrossed(t, values))
          {
            part.Crossed.push_back(t);
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
void LineExtractor::FindCrossedAtRandom(double share, FieldValues& values)
{
  if (!this->Seeds)
  {
    std::vector<Index> all(
      this->HasCandidates ? 0 : this->Surface.GetMesh().GetNumberOfTriangles());
    std::iota(all.begin(), all.end(), 0);
    this->Seeds =
      std::make_unique<RandomSeeds>(this->Surface, this->HasCandidates ? this->Candidates : all);
  }
  const TriangleMesh& mesh = this->Surface.GetMesh();
  const auto ask = [&](Index triangle)
  {
    RandomSeeds::Answer answer;
    for (int i = 0; i < 3; ++i)
    {
      const Index point = mesh.GetTriangle(triangle)[i];
      values.EvaluateNow(point / LineClusters::PointsOfBlock);
      // Of many levels the one in the middle will do: it goes downhill to get anywhere.
      answer.Distances[i] = std::abs(values[point] - this->Levels[this->Levels.size() / 2]);
    }
    answer.IsCrossed = this->IsCrossed(triangle, values);
    return answer;
  };
  const std::size_t count =
    static_cast<std::size_t>(std::ceil(share * mesh.GetNumberOfTriangles()));
  for (Part& part : this->Parts)
  {
    part.Crossed.clear();
  }
  constexpr Index trianglesOfPart =
    GroupsOfPart * LineClusters::ClustersOfGroup * LineClusters::TrianglesOfCluster;
  for (const Index triangle : this->Seeds->Find(count, ask))
  {
    this->Parts[triangle / trianglesOfPart].Crossed.push_back(triangle);
  }
}

//------------------------------------------------------------------------------
void LineExtractor::MakeCrossings(
  const LineView& view, bool useSlopes, FieldValues& values, LineSegments& segments)
{
  const bool tested = this->Definition.HasTest();
  if (tested)
  {
    ForEach(this->Parts,
      [&](Index p)
      {
        for (const Index triangle : this->Parts[p].Crossed)
        {
          for (const Index corner : this->Surface.GetMesh().GetTriangle(triangle))
          {
            values.RequireTest(corner);
          }
        }
      });
    if (this->Definition.IsMaximum())
    {
      // The fall to it is measured in the triangles around, wherever their points may be.
      values.RequireAll();
      values.Evaluate();
    }
    values.EvaluateTests();
  }
  ForEach(this->Parts,
    [&](Index p)
    {
      Part& part = this->Parts[p];
      part.Crossings.clear();
      for (const Index triangle : part.Crossed)
      {
        this->AddCrossings(triangle, values, part.Crossings);
      }
      if (useSlopes && this->HasSlopes)
      {
        this->UseSlopes(view, values, part.Crossings);
      }
      if (tested)
      {
        this->SetTests(values, part.Crossings);
      }
    });
  std::vector<std::size_t> offsets(this->Parts.size() + 1, 0);
  for (std::size_t p = 0; p < this->Parts.size(); ++p)
  {
    offsets[p + 1] = offsets[p] + this->Parts[p].Crossings.size();
  }
  segments.Crossings.resize(offsets.back());
  ForEach(this->Parts,
    [&](Index p)
    {
      const std::vector<LineCrossing>& crossings = this->Parts[p].Crossings;
      std::copy(crossings.begin(), crossings.end(), segments.Crossings.begin() + offsets[p]);
    });
}

//------------------------------------------------------------------------------
void LineExtractor::AddCrossings(
  Index triangle, const FieldValues& values, std::vector<LineCrossing>& crossings) const
{
  if (this->Axes)
  {
    this->AddCrossing(triangle, 0, values, crossings);
    return;
  }
  const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(triangle);
  const auto [low, high] =
    std::minmax({ values.GetSide(c[0]), values.GetSide(c[1]), values.GetSide(c[2]) });
  for (std::size_t level = low; level < high; ++level)
  {
    this->AddCrossing(triangle, level, values, crossings);
  }
}

//------------------------------------------------------------------------------
void LineExtractor::AddCrossing(Index triangle, std::size_t level, const FieldValues& values,
  std::vector<LineCrossing>& crossings) const
{
  const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(triangle);
  const double value = this->Levels[level];
  const auto isAbove = [&](Index point) { return values.GetSide(point) > level; };
  const auto rank = [&](Index point)
  { return std::make_pair(std::abs(values[point]), this->Surface.GetWelded(point)); };
  LineCrossing crossing;
  crossing.Triangle = triangle;
  crossing.Level = static_cast<std::uint16_t>(level);
  crossing.Test = { 1.0f, 1.0f };
  std::array<Index, 2> vertices = { -1, -1 };
  int found = 0;
  for (int e = 0; e < 3; ++e)
  {
    const Index start = c[e];
    const Index stop = c[e == 2 ? 0 : e + 1];
    if (this->Axes ? !this->Axes->IsCrossed(3 * triangle + e, values.Get())
                   : isAbove(start) == isAbove(stop))
    {
      continue;
    }
    // Walking the triangle's border, the line starts where the field turns negative; where that
    // means nothing, with the first crossing.
    const int n = this->Axes ? found++ : isAbove(start) ? 0 : 1;
    // Always from one end, so that both triangles find the same bits, and an exact zero its vertex:
    // from the end above, or where the field has axes and so no end above, from the one that is
    // nearer to 0.
    const bool isReversed = this->Axes ? rank(stop) < rank(start) : isAbove(stop);
    const double from = std::abs(double(values[isReversed ? stop : start]) - value);
    const double sum = from + std::abs(double(values[isReversed ? start : stop]) - value);
    // Both ends are 0 only where axes turn against their order in space.
    crossing.T[n] = sum > 0.0 ? static_cast<float>(from / sum) : 0.5f;
    crossing.Places[n] = static_cast<std::uint8_t>(e + (isReversed ? LineCrossing::Reversed : 0));
    if (crossing.T[n] == 0.0f)
    {
      vertices[n] = this->Surface.GetWelded(isReversed ? stop : start);
    }
  }
  // From a vertex to itself is no line.
  if (vertices[0] < 0 || vertices[0] != vertices[1])
  {
    crossings.push_back(crossing);
  }
}

//------------------------------------------------------------------------------
void LineExtractor::UseSlopes(
  const LineView& view, const FieldValues& values, std::vector<LineCrossing>& crossings) const
{
  std::vector<Index> from;
  std::vector<Index> to;
  for (const LineCrossing& crossing : crossings)
  {
    for (int n = 0; n < 2; ++n)
    {
      const LineNode node = crossing.GetNode(this->Surface, n);
      from.push_back(node.From);
      to.push_back(node.To);
    }
  }
  std::vector<float> atFrom(from.size());
  std::vector<float> atTo(from.size());
  this->Definition.EvaluateSlopes(this->Surface, view, from.data(), to.data(),
    static_cast<vtkIdType>(from.size()), atFrom.data(), atTo.data());
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    LineCrossing& crossing = crossings[i / 2];
    float& t = crossing.T[i % 2];
    // Along seams, jumps are where the values say.
    const bool isInside =
      this->Surface.GetTwin(crossing.GetHalfEdge(static_cast<int>(i % 2))) != LineSurface::NoTwin;
    if (t != 0.0f && isInside)
    {
      const double level = this->Levels[crossing.Level];
      t = static_cast<float>(
        FindHermiteRoot(values[from[i]] - level, values[to[i]] - level, atFrom[i], atTo[i], t));
    }
  }
}

//------------------------------------------------------------------------------
// Drops crossings of which the test accepts nothing.
void LineExtractor::SetTests(const FieldValues& values, std::vector<LineCrossing>& crossings) const
{
  std::size_t kept = 0;
  for (LineCrossing& crossing : crossings)
  {
    for (int n = 0; n < 2; ++n)
    {
      const LineNode node = crossing.GetNode(this->Surface, n);
      const float from = values.GetTest(node.From);
      crossing.Test[n] = from + node.T * (values.GetTest(node.To) - from);
    }
    // Also false where the test is not a number.
    if (std::max(crossing.Test[0], crossing.Test[1]) > 0.0f && std::isfinite(crossing.Test[0]) &&
      std::isfinite(crossing.Test[1]))
    {
      crossings[kept++] = crossing;
    }
  }
  crossings.resize(kept);
}
}
