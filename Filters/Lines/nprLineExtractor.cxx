// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineExtractor.h"

#include "nprArrayNames.h"
#include "nprEdgePieces.h"
#include "nprLanes.h"
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

// Not 0 where a line runs through a triangle. Where lines are is as good as random, so that
// branches would be slow.
unsigned int FindCrossedBySides(const TriangleMesh& mesh, Index triangle, const FieldValues& values)
{
  constexpr unsigned int any = 7;
  const TriangleMesh::Triangle& c = mesh.GetTriangle(triangle);
  const FieldValues::Side* const sides = values.GetSides();
  const FieldValues::Side first = sides[c[0]];
  const FieldValues::Side second = sides[c[1]];
  const FieldValues::Side third = sides[c[2]];
  const bool areNumbers = (first != FieldValues::NotANumber) & (second != FieldValues::NotANumber) &
    (third != FieldValues::NotANumber);
  return (((second != first) | (third != first)) & areNumbers) * any;
}

// As FieldAxes::FindCrossed(), where a line runs through a triangle and so crosses two of its
// edges, else 0.
std::array<unsigned int, NumberOfLanes> FindCrossedByAxes(
  const std::array<Index, NumberOfLanes>& triangles, const FieldAxes& axes)
{
  constexpr unsigned int twoEdges = 1u << 3 | 1u << 5 | 1u << 6;
  std::array<unsigned int, NumberOfLanes> crossed = axes.FindCrossed(triangles);
  for (unsigned int& edges : crossed)
  {
    edges *= twoEdges >> edges & 1u;
  }
  return crossed;
}
}

//------------------------------------------------------------------------------
LineExtractor::LineExtractor(
  const LineSurface& surface, const LineClusters& clusters, const vtkNPRLineDefinition& definition)
  : Surface(surface), Clusters(clusters), Definition(definition), Levels({ 0.0f }),
    Edges(std::make_unique<EdgePieces>(surface, definition))
{
  if (!definition.HasField())
  {
    return;
  }
  this->Levels = definition.GetLevels(surface);
  std::sort(this->Levels.begin(), this->Levels.end());
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
  if (this->Levels.size() != 1 || this->Levels[0] != 0.0f || this->Definition.GetAxes() ||
    this->Definition.HasViewAxes())
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
  segments.Pieces.clear();
  if (!this->Definition.HasField())
  {
    segments.Crossings.clear();
  }
  else
  {
    values.Start(this->Definition, view, this->Levels, this->GetDoubts(options));
    this->AddCrossings(view, options, values, segments);
    if (this->Definition.FollowsJumps())
    {
      AddJumpPieces(this->Surface, values, segments.Pieces);
    }
  }
  this->Edges->Add(view, segments.Pieces);
  if (this->Definition.HasField())
  {
    RemoveDoubles(this->Surface, segments);
  }
}

//------------------------------------------------------------------------------
const float* LineExtractor::GetDoubts(const LineOptions& options) const
{
  return !options.KeepsDoubtful && this->Definition.NeedsDerivatives() &&
      this->Surface.HasArray(names::DerivativeDoubt)
    ? this->Definition.GetDoubts(this->Surface)
    : nullptr;
}

//------------------------------------------------------------------------------
void LineExtractor::AddCrossings(
  const LineView& view, const LineOptions& options, FieldValues& values, LineSegments& segments)
{
  if (this->Definition.FollowsJumps())
  {
    this->RequireSeams(values);
  }
  const CrossingMaker maker(this->Surface, this->Levels, values);
  const bool isTested = values.HasTest();
  const auto makeCrossings = [&](Part& part)
  {
    part.Crossings.clear();
    if (isTested)
    {
      maker.AddAccepted(part.Crossed, part.Crossings);
    }
    else
    {
      maker.Add(part.Crossed, part.Crossings);
    }
    if (options.UseSlopes && this->HasSlopes)
    {
      maker.UseSlopes(this->Definition, view, part.Crossings);
    }
    if (isTested)
    {
      maker.SetTests(part.Crossings);
    }
  };
  // While what was found is in the cache.
  const auto goOn = [&](Part& part)
  {
    this->DropGhosts(part.Crossed);
    if (isTested)
    {
      this->RequireTests(part.Crossed, values);
    }
    else
    {
      makeCrossings(part);
    }
  };
  if (options.Strategy == LineStrategy::Random && this->Definition.IsViewDependent())
  {
    values.Evaluate();
    this->FindCrossedAtRandom(options.SeedShare, values);
    ForEach(this->Parts, [&](Index p) { goOn(this->Parts[p]); });
  }
  else
  {
    this->FindClusters(view, options.Strategy, values);
    values.Evaluate();
    ForEach(this->Parts,
      [&](Index p)
      {
        this->FindCrossed(values, this->Parts[p]);
        goOn(this->Parts[p]);
      });
  }
  if (isTested)
  {
    values.EvaluateTests();
    ForEach(this->Parts, [&](Index p) { makeCrossings(this->Parts[p]); });
  }
  std::vector<std::size_t> offsets(this->Parts.size() + 1, 0);
  for (std::size_t p = 0; p < this->Parts.size(); ++p)
  {
    offsets[p + 1] = offsets[p] + this->Parts[p].Crossings.size();
  }
  // What was there is overwritten: to clear it first would write all of it twice.
  segments.Crossings.resize(offsets.back());
  ForEach(this->Parts,
    [&](Index p)
    {
      const std::vector<LineCrossing>& crossings = this->Parts[p].Crossings;
      std::copy(crossings.begin(), crossings.end(), segments.Crossings.begin() + offsets[p]);
    });
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
      if (isBounded)
      {
        this->Clusters.FindFacing(view, range, p * GroupsOfPart, last, clusters);
      }
      else
      {
        const Index end =
          std::min(last * LineClusters::ClustersOfGroup, this->Clusters.GetNumberOfClusters());
        clusters.resize(end - p * GroupsOfPart * LineClusters::ClustersOfGroup);
        std::iota(
          clusters.begin(), clusters.end(), p * GroupsOfPart * LineClusters::ClustersOfGroup);
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
// Whether all points of a cluster are known to be on one side of the line.
bool LineExtractor::IsOnOneSide(Index cluster, const FieldValues& values) const
{
  const Index* const begin = this->Clusters.BlocksBegin(cluster);
  const FieldValues::Side side = values.GetSideOfBlock(*begin);
  return side != FieldValues::Mixed &&
    std::all_of(begin + 1, this->Clusters.BlocksEnd(cluster),
      [&](Index block) { return values.GetSideOfBlock(block) == side; });
}

//------------------------------------------------------------------------------
void LineExtractor::FindCrossed(const FieldValues& values, Part& part) const
{
  const TriangleMesh& mesh = this->Surface.GetMesh();
  part.Crossed.clear();
  // Those of some clusters, before they go to the others.
  std::array<CrossedTriangle, 16 * LineClusters::TrianglesOfCluster> found;
  std::size_t size = 0;
  const auto keep = [&]()
  {
    part.Crossed.insert(part.Crossed.end(), found.begin(), found.begin() + size);
    size = 0;
  };
  // `at` gives the number of a triangle, for 0 <= i < count.
  const auto lookBySides = [&](Index count, const auto& at)
  {
    for (Index i = 0; i < count; ++i)
    {
      const Index triangle = at(i);
      const unsigned int edges = FindCrossedBySides(mesh, triangle, values);
      found[size] = { triangle, edges };
      size += edges != 0;
    }
  };
  const Index lastTriangle = mesh.GetNumberOfTriangles() - 1;
  const auto lookByAxes = [&](Index first, Index count)
  {
    constexpr Index ahead = 8;
    for (Index i = 0; i < count; i += NumberOfLanes)
    {
      std::array<Index, NumberOfLanes> triangles;
      for (int lane = 0; lane < NumberOfLanes; ++lane)
      {
        triangles[lane] = first + std::min(i + lane, count - 1);
        values.GetAxes()->PrefetchTriangle(std::min(triangles[lane] + ahead, lastTriangle));
      }
      const auto edges = FindCrossedByAxes(triangles, *values.GetAxes());
      for (int lane = 0; lane < std::min<Index>(NumberOfLanes, count - i); ++lane)
      {
        found[size] = { triangles[lane], edges[lane] };
        size += edges[lane] != 0;
      }
    }
  };
  for (std::size_t c = 0; c < part.Clusters.size(); ++c)
  {
    constexpr std::size_t ahead = 2;
    const Index later = part.Clusters[std::min(c + ahead, part.Clusters.size() - 1)];
    const Index firstLater = this->Clusters.GetFirstTriangle(later);
    PrefetchSpan(&mesh.GetTriangle(firstLater), this->Clusters.GetTriangleEnd(later) - firstLater);
    const Index cluster = part.Clusters[c];
    if (this->IsOnOneSide(cluster, values))
    {
      continue;
    }
    if (size + LineClusters::TrianglesOfCluster > found.size())
    {
      keep();
    }
    const Index first = this->Clusters.GetFirstTriangle(cluster);
    const Index count = this->Clusters.GetTriangleEnd(cluster) - first;
    if (values.GetAxes())
    {
      lookByAxes(first, count);
    }
    else if (this->HasCandidates)
    {
      const Index* const candidates = this->Candidates.data() + this->CandidateOffsets[cluster];
      lookBySides(this->CandidateOffsets[cluster + 1] - this->CandidateOffsets[cluster],
        [candidates](Index i) { return candidates[i]; });
    }
    else
    {
      lookBySides(count, [first](Index i) { return first + i; });
    }
  }
  keep();
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
  const auto findCrossed = [&](Index triangle)
  {
    if (!values.GetAxes())
    {
      return FindCrossedBySides(mesh, triangle, values);
    }
    std::array<Index, NumberOfLanes> triangles;
    triangles.fill(triangle);
    return FindCrossedByAxes(triangles, *values.GetAxes())[0];
  };
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
    answer.IsCrossed = findCrossed(triangle) != 0;
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
    this->Parts[triangle / trianglesOfPart].Crossed.push_back({ triangle, findCrossed(triangle) });
  }
}

//------------------------------------------------------------------------------
void LineExtractor::DropGhosts(std::vector<CrossedTriangle>& crossed) const
{
  if (this->Surface.HasGhosts())
  {
    crossed.erase(std::remove_if(crossed.begin(), crossed.end(),
                    [this](const CrossedTriangle& triangle)
                    { return this->Surface.IsGhost(triangle.Triangle); }),
      crossed.end());
  }
}

//------------------------------------------------------------------------------
void LineExtractor::RequireTests(
  const std::vector<CrossedTriangle>& crossed, FieldValues& values) const
{
  for (const CrossedTriangle& triangle : crossed)
  {
    for (const Index corner : this->Surface.GetMesh().GetTriangle(triangle.Triangle))
    {
      values.RequireTest(corner);
    }
  }
}
}
