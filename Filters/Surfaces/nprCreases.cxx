// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCreases.h"

#include <vtkMath.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;
using Vector = TriangleMesh::Vector;

/// Sharp edges that hang together, fewer of which are taken for noise. Six are a tetrahedron's.
constexpr int ShortestChain = 6;
/// What a point on a border counts: from border to border even one edge is a crease.
constexpr int BorderEnd = 3;

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
  const float cosine = static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(angle)));
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
            creases[t][e] = 1;
            continue;
          }
          // Without area there is no normal, and no angle.
          creases[t][e] = angle < 180.0 && normals[t].dot(normals[neighbour]) < cosine &&
            !normals[t].isZero() && !normals[neighbour].isZero() &&
            GetSideNormal(mesh, normals, cosine, t, neighbour)
                .dot(GetSideNormal(mesh, normals, cosine, neighbour, t)) < cosine;
        }
      }
    });
  DropShortChains(mesh, creases);
  return creases;
}
}
