// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineExtractor.h"

#include "nprEdgePieces.h"
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

// Not 0 where a line runs through a triangle.
unsigned int FindCrossedBySides(const TriangleMesh& mesh, Index triangle, const FieldValues& values)
{
  constexpr unsigned int any = 7;
  const TriangleMesh::Triangle& c = mesh.GetTriangle(triangle);
  const FieldValues::Side* const sides = values.GetSides();
  const FieldValues::Side first = sides[c[0]];
  const FieldValues::Side second = sides[c[1]];
  const FieldValues::Side third = sides[c[2]];
  return ((second != first) | (third != first)) && first != FieldValues::NotANumber &&
      second != FieldValues::NotANumber && third != FieldValues::NotANumber
    ? any
    : 0;
}

// As FieldAxes::FindCrossed(), where a line runs through a triangle, else 0. Sides say only where
// values are numbers: the sign belongs to an axis.
unsigned int FindCrossedByAxes(const TriangleMesh& mesh, Index triangle, const FieldValues& values)
{
  const unsigned int edges = values.GetAxes()->FindCrossed(triangle);
  if (edges != 3 && edges != 5 && edges != 6)
  {
    return 0;
  }
  const TriangleMesh::Triangle& c = mesh.GetTriangle(triangle);
  return std::all_of(c.begin(), c.end(),
           [&](Index point) { return values.GetSide(point) != FieldValues::NotANumber; })
    ? edges
    : 0;
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
  segments.Crossings.clear();
  segments.Pieces.clear();
  if (this->Definition.HasField())
  {
    values.Start(this->Definition, view, this->Levels);
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
  this->Edges->Add(view, segments.Pieces);
  if (this->Definition.HasField())
  {
    RemoveDoubles(this->Surface, segments);
  }
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
void LineExtractor::FindCrossed(FieldValues& values)
{
  const TriangleMesh& mesh = this->Surface.GetMesh();
  ForEach(this->Parts,
    [&](Index p)
    {
      std::vector<CrossedTriangle>& crossed = this->Parts[p].Crossed;
      crossed.clear();
      const auto look = [&](Index triangle, unsigned int edges)
      {
        if (edges != 0)
        {
          crossed.push_back({ triangle, edges });
        }
      };
      for (const Index cluster : this->Parts[p].Clusters)
      {
        if (this->IsOnOneSide(cluster, values))
        {
          continue;
        }
        const Index first = this->Clusters.GetFirstTriangle(cluster);
        const Index end = this->Clusters.GetTriangleEnd(cluster);
        if (values.GetAxes())
        {
          for (Index t = first; t < end; ++t)
          {
            look(t, FindCrossedByAxes(mesh, t, values));
          }
        }
        else if (this->HasCandidates)
        {
          for (Index i = this->CandidateOffsets[cluster]; i < this->CandidateOffsets[cluster + 1];
               ++i)
          {
            look(this->Candidates[i], FindCrossedBySides(mesh, this->Candidates[i], values));
          }
        }
        else
        {
          for (Index t = first; t < end; ++t)
          {
            look(t, FindCrossedBySides(mesh, t, values));
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
  const auto findCrossed = [&](Index triangle)
  {
    return values.GetAxes() ? FindCrossedByAxes(mesh, triangle, values)
                            : FindCrossedBySides(mesh, triangle, values);
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
void LineExtractor::MakeCrossings(
  const LineView& view, bool useSlopes, FieldValues& values, LineSegments& segments)
{
  if (this->Surface.HasGhosts())
  {
    for (Part& part : this->Parts)
    {
      part.Crossed.erase(std::remove_if(part.Crossed.begin(), part.Crossed.end(),
                           [this](const CrossedTriangle& crossed)
                           { return this->Surface.IsGhost(crossed.Triangle); }),
        part.Crossed.end());
    }
  }
  const bool tested = this->Definition.HasTest();
  if (tested)
  {
    ForEach(this->Parts,
      [&](Index p)
      {
        for (const CrossedTriangle& crossed : this->Parts[p].Crossed)
        {
          for (const Index corner : this->Surface.GetMesh().GetTriangle(crossed.Triangle))
          {
            values.RequireTest(corner);
          }
        }
      });
    values.EvaluateTests();
  }
  const CrossingMaker maker(this->Surface, this->Levels, values);
  ForEach(this->Parts,
    [&](Index p)
    {
      Part& part = this->Parts[p];
      part.Crossings.clear();
      for (const CrossedTriangle& crossed : part.Crossed)
      {
        if (!tested || maker.MayBeAccepted(crossed.Triangle))
        {
          maker.Add(crossed, part.Crossings);
        }
      }
      if (useSlopes && this->HasSlopes)
      {
        maker.UseSlopes(this->Definition, view, part.Crossings);
      }
      if (tested)
      {
        maker.SetTests(part.Crossings);
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
}
