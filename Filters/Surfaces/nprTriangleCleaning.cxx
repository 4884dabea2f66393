// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprTriangleCleaning.h"

#include "nprTriangleArea.h"

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
bool HasPoint(const Triangle& corners, Index point)
{
  return std::find(corners.begin(), corners.end(), point) != corners.end();
}

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
/// The middle corner of a triangle whose corners lie on one line, or -1 for a triangle with an
/// area.
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
  return CountsAsArea(a.cross(b).norm(), longest) ? -1 : middle;
}

//------------------------------------------------------------------------------
/// For each triangle the first that has the same points, which mostly is itself (needs the
/// incidence).
std::vector<Index> FindFirsts(const TriangleMesh& mesh)
{
  std::vector<Index> firsts(mesh.GetNumberOfTriangles());
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
        const Index* first = mesh.IncidentBegin(corners[0]);
        while (*first < t &&
          !(HasPoint(mesh.GetTriangle(*first), corners[1]) &&
            HasPoint(mesh.GetTriangle(*first), corners[2])))
        {
          ++first;
        }
        firsts[t] = *first;
      }
    });
  return firsts;
}

//------------------------------------------------------------------------------
/// Whether two triangles with the same points run around them the same way.
bool FaceAlike(const Triangle& a, const Triangle& b)
{
  const auto place = std::find(a.begin(), a.end(), b[0]) - a.begin();
  return a[(place + 1) % 3] == b[1];
}

//------------------------------------------------------------------------------
/**
 * Which first triangles belong to folds: flaps without thickness, as decimation leaves them on
 * scans. On each of their triangles as many face one way as the other (their balance is 0), and
 * where they end, other triangles go on, two by two; without them nothing is open. One side of a
 * fold would be a fin on three-sided edges, and these be torn. A sheet that somebody made two-sided
 * is none: it is not fixed to anything, or more than a speck of the surface.
 */
std::vector<unsigned char> FindFolds(
  const TriangleMesh& mesh, const std::vector<Index>& firsts, const std::vector<int>& balances)
{
  constexpr double speck = 1e-3; // of the surface's area
  std::vector<unsigned char> isFold(firsts.size(), 0);
  double area = 0.0; // twice that, as the other is
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    area += firsts[t] == t ? mesh.GetAreaNormal(t).cast<double>().norm() : 0.0;
  }
  std::vector<unsigned char> isSeen(firsts.size(), 0);
  for (Index seed = 0; seed < mesh.GetNumberOfTriangles(); ++seed)
  {
    if (firsts[seed] != seed || balances[seed] != 0 || isSeen[seed])
    {
      continue;
    }
    std::vector<Index> component{ seed };
    isSeen[seed] = 1;
    double componentArea = 0.0;
    bool isFixed = false;
    bool isEven = true;
    for (std::size_t i = 0; i < component.size(); ++i)
    {
      componentArea += mesh.GetAreaNormal(component[i]).cast<double>().norm();
      const Triangle& corners = mesh.GetTriangle(component[i]);
      for (int e = 0; e < 3; ++e)
      {
        const Index to = corners[(e + 1) % 3];
        int others = 0;
        for (const Index* t = mesh.IncidentBegin(corners[e]); t != mesh.IncidentEnd(corners[e]);
             ++t)
        {
          if (firsts[*t] != *t || !HasPoint(mesh.GetTriangle(*t), to))
          {
            continue;
          }
          if (balances[*t] != 0)
          {
            ++others;
          }
          else if (!isSeen[*t])
          {
            isSeen[*t] = 1;
            component.push_back(*t);
          }
        }
        isFixed = isFixed || others > 0;
        isEven = isEven && others % 2 == 0;
      }
    }
    if (isFixed && isEven && componentArea < speck * area)
    {
      for (const Index t : component)
      {
        isFold[t] = 1;
      }
    }
  }
  return isFold;
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
      while (HasPoint(triangles[t], triangles[other][apex]))
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
  const std::vector<Index> firsts = FindFirsts(mesh);
  const Index size = mesh.GetNumberOfTriangles();
  std::vector<Index> duplicates;
  for (Index t = 0; t < size; ++t)
  {
    if (firsts[t] != t)
    {
      duplicates.push_back(t);
    }
  }
  if (duplicates.empty())
  {
    return;
  }
  // Of each first one, how many face as it does, less those that face the other way.
  std::vector<int> balances(size, 1);
  for (const Index t : duplicates)
  {
    balances[firsts[t]] += FaceAlike(mesh.GetTriangle(firsts[t]), mesh.GetTriangle(t)) ? 1 : -1;
  }
  const std::vector<unsigned char> isFold = FindFolds(mesh, firsts, balances);
  std::vector<unsigned char> isKept(size, 0);
  for (Index t = 0; t < size; ++t)
  {
    isKept[t] = firsts[t] == t && balances[t] >= 0 && !isFold[t];
    surface.Counts.FoldTriangles += isFold[firsts[t]];
  }
  for (const Index t : duplicates)
  {
    // The first of those that face as most do.
    if (balances[firsts[t]] < 0 && !FaceAlike(mesh.GetTriangle(firsts[t]), mesh.GetTriangle(t)))
    {
      isKept[t] = 1;
      balances[firsts[t]] = 0;
    }
  }
  surface.Counts.DuplicateTriangles = KeepTriangles(surface.Triangles, surface.SourceCells,
                                        [&](std::size_t t) { return isKept[t] != 0; }) -
    surface.Counts.FoldTriangles;
  mesh = TriangleMesh(mesh.GetPoints(), surface.Triangles, mesh.GetOrigin());
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
