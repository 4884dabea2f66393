// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What is collected around a point is what a plain search through all triangles finds.
#include "nprIrregularMeshes.h"
#include "nprNeighbourhood.h"
#include "nprSurfaceNormals.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace nprtest;

namespace
{
using npr::Neighbourhood;
using npr::TriangleMesh;
using Index = TriangleMesh::Index;

std::vector<std::set<Index>> FindNeighbours(const TriangleMesh& mesh)
{
  std::vector<std::set<Index>> neighbours(mesh.GetNumberOfPoints());
  for (const TriangleMesh::Triangle& corners : mesh.GetTriangles())
  {
    for (int i = 0; i < 3; ++i)
    {
      neighbours[corners[i]].insert(corners[(i + 1) % 3]);
      neighbours[corners[i]].insert(corners[(i + 2) % 3]);
    }
  }
  return neighbours;
}

/// A disc: a hub, and two rings.
TriangleMesh MakeFan(int spokes)
{
  std::vector<TriangleMesh::Vector> points = { TriangleMesh::Vector(0.0f, 0.0f, 0.3f) };
  std::vector<TriangleMesh::Triangle> triangles;
  for (int i = 0; i < spokes; ++i)
  {
    const auto angle = static_cast<float>(2.0 * vtkMath::Pi() * i / spokes);
    points.emplace_back(std::cos(angle), std::sin(angle), 0.2f);
    points.emplace_back(2.0f * std::cos(angle), 2.0f * std::sin(angle), 0.0f);
    const Index inner = 1 + 2 * i;
    const Index nextInner = 1 + 2 * ((i + 1) % spokes);
    triangles.push_back({ 0, inner, nextInner });
    triangles.push_back({ inner, inner + 1, nextInner });
    triangles.push_back({ nextInner, inner + 1, nextInner + 1 });
  }
  return TriangleMesh(points, triangles);
}

//------------------------------------------------------------------------------
void TestMesh(TriangleMesh mesh, const std::string& name, Checks& check)
{
  mesh.BuildIncidence();
  const auto neighbours = FindNeighbours(mesh);
  const npr::PointGraph graph(mesh);
  const npr::Tuples<3> normals = npr::ComputeNormals(mesh, npr::NormalWeights::Max);
  const std::vector<npr::OrientedPoint> points = npr::MakeOrientedPoints(mesh, normals);
  const std::vector<float> edges = npr::ComputeMeanEdges(mesh, graph);
  Neighbourhood around(graph, points);
  std::size_t largest = 0;
  for (Index centre = 0; centre < mesh.GetNumberOfPoints(); ++centre)
  {
    const std::vector<Index> listed(graph.Begin(centre), graph.End(centre));
    check(listed == std::vector<Index>(neighbours[centre].begin(), neighbours[centre].end()),
      name + ": neighbours, ascending", centre);
    for (const auto& [edgeRadius, rings] :
      { std::pair<double, int>(1.6, 8), { 3.3, 10 }, { 3.3, 2 }, { 3.3, 1 } })
    {
      const double radius = edgeRadius * edges[centre];
      const auto isNear = [&](Index point)
      {
        return (mesh.GetPoint(point) - mesh.GetPoint(centre)).norm() < radius &&
          normals[point].dot(normals[centre]) > 0.0f;
      };
      std::set<Index> expected = { centre };
      std::set<Index> front = expected;
      for (int ring = 0; ring < rings; ++ring)
      {
        std::set<Index> next;
        for (const Index point : front)
        {
          for (const Index other : neighbours[point])
          {
            if (isNear(other) && expected.insert(other).second)
            {
              next.insert(other);
            }
          }
        }
        front = next;
      }
      around.Collect(centre, radius, rings);
      std::set<Index> found;
      for (const Neighbourhood::Member& member : around.GetMembers())
      {
        found.insert(member.Point);
        const TriangleMesh::Vector offset = mesh.GetPoint(member.Point) - mesh.GetPoint(centre);
        check(member.Offset.head<3>() == offset && member.Offset[3] == 0.0f &&
            std::abs(member.SquaredDistance - offset.squaredNorm() / (radius * radius)) < 1e-5 &&
            std::abs(member.Turn - normals[member.Point].dot(normals[centre])) < 1e-5,
          name + ": what is said of a member", centre);
      }
      check(found.size() == around.GetMembers().size(), name + ": each point once", centre);
      check(found == expected, name + ": the same points", centre);
      check(around.GetMembers().front().Point == centre, name + ": the centre first", centre);
      largest = std::max(largest, found.size());
    }
  }
  check(largest > 12, name + ": neighbourhoods of some size", largest);
}
}

int TestNeighbourhood(int, char*[])
{
  Checks check;
  TestMesh(TriangleMesh(MakeIrregular(MakeTorus(1.0, 0.4, 40, 16), 0.02)), "torus", check);
  TestMesh(TriangleMesh(MakeIrregular(MakeWaves(14), 0.01)), "with border", check);
  // Just as many neighbours as a row takes, one more, and many more.
  for (const int spokes : { 8, 9, 25 })
  {
    TestMesh(MakeFan(spokes), "fan of " + std::to_string(spokes), check);
  }
  return check.GetResult();
}
