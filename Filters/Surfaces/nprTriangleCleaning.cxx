// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprTriangleCleaning.h"

#include <vtkSMPTools.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;
using Eigen::Vector3d;

//------------------------------------------------------------------------------
/// Keeps the triangles (with their cells) for which keep(index) holds; returns how many it dropped.
template<typename Predicate>
vtkIdType KeepTriangles(
  std::vector<Triangle>& triangles, std::vector<vtkIdType>& cells, const Predicate& keep)
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (keep(t))
    {
      triangles[kept] = triangles[t];
      cells[kept++] = cells[t];
    }
  }
  const vtkIdType dropped = static_cast<vtkIdType>(triangles.size() - kept);
  triangles.resize(kept);
  cells.resize(kept);
  return dropped;
}

//------------------------------------------------------------------------------
/// The middle corner of a triangle whose corners lie on one line (to the precision of single
/// coordinates), or -1 for a triangle with an area.
int FindMiddleCorner(const TriangleMesh& mesh, const Triangle& corners)
{
  double longest = -1.0;
  int middle = -1;
  for (int i = 0; i < 3; ++i)
  {
    const double length =
      (mesh.GetPoint(corners[(i + 1) % 3]) - mesh.GetPoint(corners[(i + 2) % 3]))
        .cast<double>()
        .squaredNorm();
    if (length > longest)
    {
      longest = length;
      middle = i;
    }
  }
  const Vector3d a = (mesh.GetPoint(corners[1]) - mesh.GetPoint(corners[0])).cast<double>();
  const Vector3d b = (mesh.GetPoint(corners[2]) - mesh.GetPoint(corners[0])).cast<double>();
  return a.cross(b).norm() > 1e-7 * longest ? -1 : middle;
}
}

//------------------------------------------------------------------------------
vtkIdType DropCollapsedTriangles(PreparedSurface& surface)
{
  return KeepTriangles(surface.Triangles, surface.SourceCells,
    [&](std::size_t t)
    {
      const Triangle& c = surface.Triangles[t];
      return c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
    });
}

//------------------------------------------------------------------------------
void MendNeedles(TriangleMesh& mesh, PreparedSurface& surface)
{
  constexpr int rounds = 8; // needles upon needles
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<signed char> middles(mesh.GetNumberOfTriangles());
    vtkSMPTools::For(0, mesh.GetNumberOfTriangles(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType t = begin; t < end; ++t)
        {
          middles[t] = static_cast<signed char>(
            FindMiddleCorner(mesh, mesh.GetTriangle(static_cast<Index>(t))));
        }
      });
    if (std::all_of(middles.begin(), middles.end(), [](signed char m) { return m < 0; }))
    {
      return;
    }
    std::vector<Triangle>& triangles = surface.Triangles;
    std::vector<unsigned char> touched(triangles.size(), 0);
    vtkIdType flipped = 0;
    mesh.BuildNeighbours();
    for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
    {
      if (middles[t] < 0)
      {
        continue;
      }
      const Index other = mesh.GetNeighbour(t, (middles[t] + 1) % 3);
      if (other < 0 || middles[other] >= 0 || touched[t] || touched[other])
      {
        continue;
      }
      const Index middle = triangles[t][middles[t]];
      int apex = 0;
      while (std::find(triangles[t].begin(), triangles[t].end(), triangles[other][apex]) !=
        triangles[t].end())
      {
        if (++apex == 3)
        {
          break;
        }
      }
      if (apex == 3)
      {
        continue;
      }
      const Index from = triangles[other][(apex + 1) % 3];
      const Index to = triangles[other][(apex + 2) % 3];
      triangles[t] = { middle, to, triangles[other][apex] };
      triangles[other] = { from, middle, triangles[other][apex] };
      surface.SourceCells[t] = surface.SourceCells[other];
      touched[t] = touched[other] = 1;
      ++flipped;
    }
    const bool last = flipped == 0 || round == rounds - 1;
    if (last)
    {
      surface.Counts.DegenerateTriangles += KeepTriangles(triangles, surface.SourceCells,
        [&](std::size_t t) { return FindMiddleCorner(mesh, triangles[t]) < 0; });
    }
    surface.Counts.FlippedNeedles += flipped;
    mesh = TriangleMesh(mesh.GetPoints(), triangles, mesh.GetOrigin());
    if (last)
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
void DropDuplicates(TriangleMesh& mesh, PreparedSurface& surface)
{
  mesh.BuildIncidence();
  std::vector<unsigned char> isDuplicate(mesh.GetNumberOfTriangles(), 0);
  vtkSMPTools::For(0, mesh.GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        Triangle corners = mesh.GetTriangle(static_cast<Index>(t));
        for (int i = 1; i < 3; ++i)
        {
          if (mesh.GetNumberOfIncident(corners[i]) < mesh.GetNumberOfIncident(corners[0]))
          {
            std::swap(corners[i], corners[0]);
          }
        }
        for (const Index* o = mesh.IncidentBegin(corners[0]); *o < t; ++o)
        {
          const Triangle& other = mesh.GetTriangle(*o);
          const auto has = [&](Index p) { return other[0] == p || other[1] == p || other[2] == p; };
          if (has(corners[1]) && has(corners[2]))
          {
            isDuplicate[t] = 1;
            break;
          }
        }
      }
    });
  surface.Counts.DuplicateTriangles = KeepTriangles(
    surface.Triangles, surface.SourceCells, [&](std::size_t t) { return !isDuplicate[t]; });
  if (surface.Counts.DuplicateTriangles > 0)
  {
    mesh = TriangleMesh(mesh.GetPoints(), surface.Triangles, mesh.GetOrigin());
  }
}

//------------------------------------------------------------------------------
void DropUnusedPoints(TriangleMesh& mesh, PreparedSurface& surface)
{
  std::vector<Index> numbers(surface.SourcePoints.size(), -1);
  for (const Triangle& triangle : surface.Triangles)
  {
    for (Index corner : triangle)
    {
      numbers[corner] = 0;
    }
  }
  if (std::find(numbers.begin(), numbers.end(), -1) == numbers.end())
  {
    return;
  }
  std::size_t kept = 0;
  std::vector<TriangleMesh::Vector> points;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (numbers[i] == 0)
    {
      points.push_back(mesh.GetPoint(static_cast<Index>(i)));
      surface.SourcePoints[kept] = surface.SourcePoints[i];
      numbers[i] = static_cast<Index>(kept++);
    }
  }
  surface.SourcePoints.resize(kept);
  for (Triangle& triangle : surface.Triangles)
  {
    for (Index& corner : triangle)
    {
      corner = numbers[corner];
    }
  }
  mesh = TriangleMesh(std::move(points), surface.Triangles, mesh.GetOrigin());
}
}
