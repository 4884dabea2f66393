// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineExtractor.h"

#include "nprCrossingMaker.h"
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
bool LineExtractor::IsCrossed(Index triangle, const FieldValues& values) const
{
  const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(triangle);
  const FieldValues::Side a = values.GetSide(c[0]);
  const FieldValues::Side b = values.GetSide(c[1]);
  const FieldValues::Side d = values.GetSide(c[2]);
  const FieldAxes* const axes = values.GetAxes();
  const float* const field = values.Get();
  const bool mayBe =
    axes ? values.MayBeAt(c[0]) || values.MayBeAt(c[1]) || values.MayBeAt(c[2]) : a != b || b != d;
  return mayBe && a != FieldValues::NotANumber && b != FieldValues::NotANumber &&
    d != FieldValues::NotANumber &&
    (!axes ||
      axes->IsCrossed(3 * triangle, field) + axes->IsCrossed(3 * triangle + 1, field) +
          axes->IsCrossed(3 * triangle + 2, field) ==
        2);
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
  const FieldValues::Side* const sides = values.GetSides();
  const TriangleMesh::Triangle* const triangles = this->Surface.GetMesh().GetTriangles().data();
  ForEach(this->Parts,
    [&](Index p)
    {
      std::vector<Index>& crossed = this->Parts[p].Crossed;
      crossed.clear();
      const auto look = [&](Index triangle)
      {
        const TriangleMesh::Triangle& c = triangles[triangle];
        const FieldValues::Side side = sides[c[0]];
        const FieldValues::Side second = sides[c[1]];
        const FieldValues::Side third = sides[c[2]];
        if (((second != side) | (third != side)) && side != FieldValues::NotANumber &&
          second != FieldValues::NotANumber && third != FieldValues::NotANumber)
        {
          crossed.push_back(triangle);
        }
      };
      for (const Index cluster : this->Parts[p].Clusters)
      {
        if (this->IsOnOneSide(cluster, values))
        {
          continue;
        }
        if (values.GetAxes())
        {
          // Sides mean nothing where the sign belongs to an axis.
          for (Index t = this->Clusters.GetFirstTriangle(cluster);
               t < this->Clusters.GetTriangleEnd(cluster); ++t)
          {
            if (this->IsCrossed(t, values))
            {
              crossed.push_back(t);
            }
          }
        }
        else if (this->HasCandidates)
        {
          const Index end = this->CandidateOffsets[cluster + 1];
          for (Index i = this->CandidateOffsets[cluster]; i < end; ++i)
          {
            look(this->Candidates[i]);
          }
        }
        else
        {
          const Index end = this->Clusters.GetTriangleEnd(cluster);
          for (Index t = this->Clusters.GetFirstTriangle(cluster); t < end; ++t)
          {
            look(t);
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
  if (this->Surface.HasGhosts())
  {
    for (Part& part : this->Parts)
    {
      part.Crossed.erase(std::remove_if(part.Crossed.begin(), part.Crossed.end(),
                           [this](Index triangle) { return this->Surface.IsGhost(triangle); }),
        part.Crossed.end());
    }
  }
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
    values.EvaluateTests();
  }
  const CrossingMaker maker(this->Surface, this->Levels, values);
  ForEach(this->Parts,
    [&](Index p)
    {
      Part& part = this->Parts[p];
      part.Crossings.clear();
      for (const Index triangle : part.Crossed)
      {
        if (!tested || maker.MayBeAccepted(triangle))
        {
          maker.Add(triangle, part.Crossings);
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
