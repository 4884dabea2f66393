// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprMidpointTurns.h"

#include "nprForAll.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Vector3d;

// Triangles may always turn by so much, 3 degrees: flat ones do, by rounding.
constexpr double LeastTurn = 0.9986;

/// A triangle's corners, followed by the midpoints of its edges.
struct PartedTriangle
{
  std::array<Vector3d, 6> Points;
  std::array<Vector3d, 6> Normals; // of any length

  /// The cosine of the angle from a part to the mean of the normals at its corners; 1 without area.
  double GetTurn(const std::array<int, 3>& part) const
  {
    const Vector3d& p = this->Points[part[0]];
    const Vector3d area = (this->Points[part[1]] - p).cross(this->Points[part[2]] - p);
    const Vector3d normal =
      this->Normals[part[0]] + this->Normals[part[1]] + this->Normals[part[2]];
    const double length = area.norm() * normal.norm();
    return length > 0.0 ? area.dot(normal) / length : 1.0;
  }

  /// The cosine of the angle from the whole to the farthest of the normals at its corners.
  double GetSpread() const
  {
    const Vector3d area =
      (this->Points[1] - this->Points[0]).cross(this->Points[2] - this->Points[0]);
    const double least = std::min(
      { area.dot(this->Normals[0]), area.dot(this->Normals[1]), area.dot(this->Normals[2]) });
    const double length = area.norm();
    return length > 0.0 ? least / length : -1.0;
  }
};

/// Of the edges of a triangle that turns too much the one with the longest move; else -1.
Index FindLongestOfTurned(const TriangleMesh& mesh, const Tuples<3>& normals,
  const std::vector<Index>& firstCopies, const std::vector<Vector3d>& moves, Index triangle)
{
  const TriangleMesh::Triangle& corners = mesh.GetTriangle(triangle);
  std::array<Index, 3> edges;
  Index longest = -1;
  double length = 0.0;
  for (int e = 0; e < 3; ++e)
  {
    edges[e] = firstCopies[mesh.FindEdge(corners[e], corners[(e + 1) % 3])];
    const double squared = moves[edges[e]].squaredNorm();
    if (squared > length)
    {
      length = squared;
      longest = edges[e];
    }
  }
  if (longest < 0)
  {
    return -1;
  }
  PartedTriangle parted;
  for (int i = 0; i < 3; ++i)
  {
    parted.Points[i] = mesh.GetPoint(corners[i]).cast<double>();
    parted.Normals[i] = normals[corners[i]].cast<double>();
  }
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    parted.Points[3 + i] = 0.5 * (parted.Points[i] + parted.Points[next]) + moves[edges[i]];
    parted.Normals[3 + i] = (parted.Normals[i] + parted.Normals[next]).normalized();
  }
  const double allowed = std::min(LeastTurn, parted.GetSpread());
  constexpr std::array<std::array<int, 3>, 4> parts = { { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 },
    { 3, 4, 5 } } };
  const bool turned = std::any_of(parts.begin(), parts.end(),
    [&](const std::array<int, 3>& part) { return parted.GetTurn(part) < allowed; });
  return turned ? longest : -1;
}
}

//------------------------------------------------------------------------------
void LimitTurns(const TriangleMesh& mesh, const Tuples<3>& normals,
  const std::vector<Index>& firstCopies, std::vector<Vector3d>& moves)
{
  std::vector<Index> longest(mesh.GetNumberOfTriangles());
  std::vector<unsigned char> isChanged(moves.size());
  ForAll(moves.size(), [&](Index edge) { isChanged[edge] = moves[edge].squaredNorm() > 0.0; });
  std::vector<unsigned char> isNear(mesh.GetNumberOfPoints());
  for (int round = 0; round < MidpointTurnsRounds; ++round)
  {
    // Most triangles of a fine mesh have no edge that moves.
    std::fill(isNear.begin(), isNear.end(), 0);
    for (std::size_t edge = 0; edge < moves.size(); ++edge)
    {
      if (isChanged[firstCopies[edge]])
      {
        isNear[mesh.GetEdge(static_cast<Index>(edge))[0]] = 1;
      }
    }
    ForAll(longest.size(),
      [&](Index t)
      {
        const TriangleMesh::Triangle& corners = mesh.GetTriangle(t);
        longest[t] = isNear[corners[0]] || isNear[corners[1]] || isNear[corners[2]]
          ? FindLongestOfTurned(mesh, normals, firstCopies, moves, t)
          : -1;
      });
    std::fill(isChanged.begin(), isChanged.end(), 0);
    for (Index edge : longest)
    {
      if (edge >= 0)
      {
        isChanged[edge] = 1;
      }
    }
    ForAll(moves.size(),
      [&](Index edge)
      {
        if (isChanged[edge])
        {
          moves[edge] *= 0.5;
        }
      });
  }
}
}
