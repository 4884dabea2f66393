// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCreases.h"

#include "nprEdgeSides.h"
#include "nprLooseEdges.h"

#include <vtkMath.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;
using Vector = TriangleMesh::Vector;

/// What flags of edges say until the loose ones are out.
enum : unsigned char
{
  Smooth = 0,
  Sharp = 1,
  Soft = 2
};

/// Sharp edges that hang together, fewer of which are taken for noise. Six are a tetrahedron's.
constexpr int ShortestChain = 6;
/// The share of the length scale that is too small to be seen: what is narrower beside an edge does
/// not tell whether it stands out.
constexpr double LeastDetail = 0.01;
/// What a point on a border counts: from border to border even one edge is a crease.
constexpr int BorderEnd = 3;

//------------------------------------------------------------------------------
/// What the sides of edges are on.
struct MeshSides
{
  Eigen::Vector3d GetPoint(Index halfEdge) const
  {
    return this->Mesh.GetPoint(this->Mesh.GetTriangle(halfEdge / 3)[halfEdge % 3]).cast<double>();
  }
  Index GetOther(Index halfEdge) const
  {
    const Index neighbour = this->Mesh.GetNeighbour(halfEdge / 3, halfEdge % 3);
    if (neighbour < 0)
    {
      return neighbour;
    }
    const auto [from, to] = this->GetEnds(halfEdge);
    for (Index other = 3 * neighbour; other < 3 * neighbour + 2; ++other)
    {
      const auto [otherFrom, otherTo] = this->GetEnds(other);
      if ((otherFrom == to && otherTo == from) || (otherFrom == from && otherTo == to))
      {
        return other;
      }
    }
    return 3 * neighbour + 2;
  }
  bool AreOpposite(Index halfEdge, Index other) const
  {
    return this->GetEnds(halfEdge)[0] != this->GetEnds(other)[0];
  }
  std::array<Index, 2> GetEnds(Index halfEdge) const
  {
    const Triangle& corners = this->Mesh.GetTriangle(halfEdge / 3);
    return { corners[halfEdge % 3], corners[(halfEdge + 1) % 3] };
  }

  const TriangleMesh& Mesh;
};

//------------------------------------------------------------------------------
/// The mean normal of a triangle and those of its neighbours that bend less than the angle, but for
/// the one across an edge.
Vector GetSideNormal(const TriangleMesh& mesh, const std::vector<Vector>& normals, float cosine,
  Index triangle, Index except)
{
  // Twice the area as the weight: a scan's triangles are all alike, a thin sliver should not count.
  Eigen::Vector3d sum = mesh.GetAreaNormal(triangle).cast<double>();
  for (int e = 0; e < 3; ++e)
  {
    const Index neighbour = mesh.GetNeighbour(triangle, e);
    if (neighbour >= 0 && neighbour != except &&
      normals[triangle].dot(normals[neighbour]) >= cosine)
    {
      sum += mesh.GetAreaNormal(neighbour).cast<double>();
    }
  }
  return sum.normalized().cast<float>();
}

//------------------------------------------------------------------------------
/// Union-find with path halving; the smallest point of a set is its root.
Index FindRoot(std::vector<Index>& parents, Index point)
{
  while (parents[point] != point)
  {
    parents[point] = parents[parents[point]];
    point = parents[point];
  }
  return point;
}

//------------------------------------------------------------------------------
/// Takes back soft creases that lead nowhere.
void DropLooseEnds(const TriangleMesh& mesh, EdgeFlags& creases)
{
  std::vector<NetworkEdge> edges;
  std::vector<std::array<Index, 2>> places;
  std::vector<Index> held(mesh.GetNumberOfPoints(), 0);
  bool isAnySoft = false;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const Triangle& corners = mesh.GetTriangle(t);
    for (int e = 0; e < 3; ++e)
    {
      const Index neighbour = mesh.GetNeighbour(t, e);
      if (neighbour < 0)
      {
        held[corners[e]] = held[corners[(e + 1) % 3]] = 1;
      }
      else if (creases[t][e] != Smooth && neighbour > t)
      {
        isAnySoft = isAnySoft || creases[t][e] == Soft;
        edges.push_back({ { corners[e], corners[(e + 1) % 3] }, creases[t][e] == Soft });
        places.push_back({ t, e });
      }
    }
  }
  if (!isAnySoft)
  {
    return;
  }
  const std::vector<char> loose = FindLooseEdges(edges, std::move(held));
  const MeshSides sides{ mesh };
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const auto [t, e] = places[i];
    const Index other = sides.GetOther(3 * t + e);
    creases[t][e] = creases[other / 3][other % 3] = loose[i] ? Smooth : Sharp;
  }
}

//------------------------------------------------------------------------------
/// Takes back creases that are too short.
void DropShortChains(const TriangleMesh& mesh, EdgeFlags& creases)
{
  std::vector<Index> parents(mesh.GetNumberOfPoints());
  std::vector<unsigned char> border(mesh.GetNumberOfPoints(), 0);
  for (Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    parents[i] = i;
  }
  bool any = false;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const Triangle& corners = mesh.GetTriangle(t);
    for (int e = 0; e < 3; ++e)
    {
      if (mesh.GetNeighbour(t, e) < 0)
      {
        border[corners[e]] = border[corners[(e + 1) % 3]] = 1;
      }
      else if (creases[t][e])
      {
        any = true;
        const Index a = FindRoot(parents, corners[e]);
        const Index b = FindRoot(parents, corners[(e + 1) % 3]);
        parents[std::max(a, b)] = std::min(a, b);
      }
    }
  }
  if (!any)
  {
    return;
  }
  // Every crease is met from both of its triangles, and so counts twice.
  std::vector<int> lengths(mesh.GetNumberOfPoints(), 0);
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      if (creases[t][e])
      {
        ++lengths[FindRoot(parents, mesh.GetTriangle(t)[e])];
      }
    }
  }
  for (Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    if (border[i])
    {
      lengths[FindRoot(parents, i)] += 2 * BorderEnd;
    }
  }
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      const Triangle& corners = mesh.GetTriangle(t);
      if (creases[t][e] && lengths[FindRoot(parents, corners[e])] < 2 * ShortestChain &&
        RunsOppositely(mesh.GetTriangle(mesh.GetNeighbour(t, e)), corners[e], corners[(e + 1) % 3]))
      {
        creases[t][e] = 0;
      }
    }
  }
}

}

//------------------------------------------------------------------------------
EdgeFlags FindCreases(const TriangleMesh& mesh, double angle)
{
  const double sharp = vtkMath::RadiansFromDegrees(angle);
  const double soft = SoftCreaseShare * sharp;
  const auto sharpCosine = static_cast<float>(std::cos(sharp));
  const auto softCosine = static_cast<float>(std::cos(soft));
  const double lengthScale = mesh.ComputeLengthScale();
  const double leastDetail = LeastDetail * lengthScale;
  const MeshSides sides{ mesh };
  const Index numberOfTriangles = mesh.GetNumberOfTriangles();
  std::vector<Vector> normals(numberOfTriangles);
  vtkSMPTools::For(0, numberOfTriangles,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        normals[t] =
          mesh.GetAreaNormal(static_cast<Index>(t)).cast<double>().normalized().cast<float>();
      }
    });
  EdgeFlags creases(numberOfTriangles, { { 0, 0, 0 } });
  vtkSMPTools::For(0, numberOfTriangles,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index t = static_cast<Index>(i);
        const Triangle& corners = mesh.GetTriangle(t);
        for (int e = 0; e < 3; ++e)
        {
          const Index neighbour = mesh.GetNeighbour(t, e);
          if (neighbour < 0)
          {
            continue;
          }
          if (!RunsOppositely(mesh.GetTriangle(neighbour), corners[e], corners[(e + 1) % 3]))
          {
            creases[t][e] = Sharp;
            continue;
          }
          // Without area there is no normal, and no angle.
          const float cosine = normals[t].dot(normals[neighbour]);
          if (angle >= 180.0 || !(cosine < softCosine) || normals[t].isZero() ||
            normals[neighbour].isZero())
          {
            continue;
          }
          const auto isSharp = [&](float least)
          {
            return cosine < least &&
              GetSideNormal(mesh, normals, least, t, neighbour)
                .dot(GetSideNormal(mesh, normals, least, neighbour, t)) < least;
          };
          const double bend = std::acos(std::clamp(cosine, -1.0f, 1.0f));
          // In the same order from both triangles, so that both have the same to the last bit.
          const auto [first, second] = std::minmax({ 3 * t + e, sides.GetOther(3 * t + e) });
          if (isSharp(sharpCosine))
          {
            creases[t][e] = bend < GetRoundAngle(sharp) &&
                IsOfRound(
                  bend, GetBendsBeside(sides, first, second, bend, leastDetail), lengthScale)
              ? Smooth
              : Sharp;
          }
          else if (isSharp(softCosine))
          {
            creases[t][e] = StandsOut(bend, GetBendsBeside(sides, first, second, bend, leastDetail))
              ? Soft
              : Smooth;
          }
        }
      }
    });
  DropLooseEnds(mesh, creases);
  DropShortChains(mesh, creases);
  return creases;
}
}
