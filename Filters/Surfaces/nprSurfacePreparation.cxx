// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfacePreparation.h"

#include "nprCreases.h"
#include "nprPointWelding.h"
#include "nprPolygonTriangles.h"

#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;
using Eigen::Vector3d;

//------------------------------------------------------------------------------
std::vector<Vector3d> ReadPoints(vtkPolyData* input)
{
  std::vector<Vector3d> points(input->GetNumberOfPoints());
  vtkSMPTools::For(0, input->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        input->GetPoints()->GetPoint(i, points[i].data());
      }
    });
  return points;
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

//------------------------------------------------------------------------------
/// Needles close the gaps of T-junctions. To drop one would open the surface, so its long edge is
/// flipped: the triangle across that edge is parted at the needle's middle corner instead. What can
/// not be mended so is dropped.
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
/// Drops triangles with the same three points as an earlier one.
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
/// Renumbers the points that triangles use, in the order of the input, and makes a mesh of them.
TriangleMesh MakeMesh(const std::vector<Vector3d>& points, PreparedSurface& surface)
{
  std::vector<Index> numbers(points.size(), 0);
  for (const Triangle& triangle : surface.Triangles)
  {
    for (Index corner : triangle)
    {
      numbers[corner] = 1;
    }
  }
  surface.SourcePoints.clear();
  Vector3d low = Vector3d::Zero();
  Vector3d high = Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (numbers[i])
    {
      low = surface.SourcePoints.empty() ? points[i] : Vector3d(low.cwiseMin(points[i]));
      high = surface.SourcePoints.empty() ? points[i] : Vector3d(high.cwiseMax(points[i]));
      numbers[i] = static_cast<Index>(surface.SourcePoints.size());
      surface.SourcePoints.push_back(static_cast<vtkIdType>(i));
    }
  }
  for (Triangle& triangle : surface.Triangles)
  {
    for (Index& corner : triangle)
    {
      corner = numbers[corner];
    }
  }
  const Vector3d origin = 0.5 * low + 0.5 * high;
  std::vector<TriangleMesh::Vector> relative(surface.SourcePoints.size());
  for (std::size_t i = 0; i < relative.size(); ++i)
  {
    relative[i] = (points[surface.SourcePoints[i]] - origin).cast<float>();
  }
  return TriangleMesh(std::move(relative), surface.Triangles, origin);
}

//------------------------------------------------------------------------------
/// Drops points that no triangle uses any more.
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

//------------------------------------------------------------------------------
void CountEdges(const TriangleMesh& mesh, SurfacePreparationCounts& counts)
{
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      const Index neighbour = mesh.GetNeighbour(t, e);
      counts.BoundaryEdges += neighbour == TriangleMesh::Boundary;
      if (neighbour == TriangleMesh::NonManifold)
      {
        // Counted by the first of its triangles.
        const Triangle& corners = mesh.GetTriangle(t);
        const Index to = corners[(e + 1) % 3];
        const Index* first = mesh.IncidentBegin(corners[e]);
        const auto has = [&](Index other)
        {
          const Triangle& o = mesh.GetTriangle(other);
          return o[0] == to || o[1] == to || o[2] == to;
        };
        while (!has(*first))
        {
          ++first;
        }
        counts.NonManifoldEdges += *first == t;
      }
    }
  }
}
}

//------------------------------------------------------------------------------
vtkIdType OrientTriangles(TriangleMesh& mesh)
{
  const Index numberOfTriangles = mesh.GetNumberOfTriangles();
  std::vector<unsigned char> seen(numberOfTriangles, 0);
  std::vector<unsigned char> turned(numberOfTriangles, 0);
  std::vector<Index> component;
  vtkIdType count = 0;
  for (Index seed = 0; seed < numberOfTriangles; ++seed)
  {
    if (seen[seed])
    {
      continue;
    }
    component.assign(1, seed);
    seen[seed] = 1;
    bool isClosed = true;
    std::size_t numberOfTurned = 0;
    double volume = 0.0;
    const Vector3d apex = mesh.GetPoint(mesh.GetTriangle(seed)[0]).cast<double>();
    for (std::size_t i = 0; i < component.size(); ++i)
    {
      const Index t = component[i];
      const Triangle corners = mesh.GetTriangle(t);
      numberOfTurned += turned[t];
      volume +=
        (mesh.GetPoint(corners[0]).cast<double>() - apex).dot(mesh.GetAreaNormal(t).cast<double>());
      for (int e = 0; e < 3; ++e)
      {
        const Index next = mesh.GetNeighbour(t, e);
        if (next < 0)
        {
          isClosed = false;
        }
        else if (!seen[next])
        {
          seen[next] = 1;
          component.push_back(next);
          const Triangle& other = mesh.GetTriangle(next);
          for (int o = 0; o < 3; ++o)
          {
            if (other[o] == corners[e] && other[(o + 1) % 3] == corners[(e + 1) % 3])
            {
              turned[next] = 1;
              mesh.Flip(next);
              break;
            }
          }
        }
      }
    }
    const bool turnAll =
      isClosed && volume != 0.0 ? volume < 0.0 : 2 * numberOfTurned > component.size();
    if (turnAll)
    {
      for (Index t : component)
      {
        mesh.Flip(t);
      }
      numberOfTurned = component.size() - numberOfTurned;
    }
    count += static_cast<vtkIdType>(numberOfTurned);
  }
  return count;
}

//------------------------------------------------------------------------------
PreparedSurface PrepareSurface(vtkPolyData* input, const SurfacePreparationOptions& options)
{
  PreparedSurface surface;
  SurfacePreparationCounts& counts = surface.Counts;
  const std::vector<Vector3d> points = ReadPoints(input);
  PolygonTriangles polygons = GetPolygonTriangles(input, points);
  surface.Triangles = std::move(polygons.Triangles);
  surface.SourceCells = std::move(polygons.Cells);
  counts.DroppedCells = input->GetNumberOfVerts() + input->GetNumberOfLines();
  counts.TriangulatedCells = polygons.NumberOfTriangulatedCells;
  counts.NonFiniteTriangles = polygons.NumberOfBadTriangles;

  if (options.Weld)
  {
    const std::vector<Index> firsts = FindCoincidentPoints(points, options.WeldTolerance);
    for (std::size_t i = 0; i < firsts.size(); ++i)
    {
      counts.WeldedPoints += firsts[i] != static_cast<Index>(i);
    }
    for (Triangle& triangle : surface.Triangles)
    {
      triangle = { firsts[triangle[0]], firsts[triangle[1]], firsts[triangle[2]] };
    }
  }
  counts.DegenerateTriangles = KeepTriangles(surface.Triangles, surface.SourceCells,
    [&](std::size_t t)
    {
      const Triangle& c = surface.Triangles[t];
      return c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
    });

  TriangleMesh mesh = MakeMesh(points, surface);
  MendNeedles(mesh, surface);
  DropDuplicates(mesh, surface);
  DropUnusedPoints(mesh, surface);
  mesh.BuildNeighbours();
  CountEdges(mesh, counts);
  surface.LengthScale = mesh.ComputeLengthScale();
  if (options.Orient)
  {
    counts.ReorientedTriangles = OrientTriangles(mesh);
  }
  surface.Triangles = mesh.GetTriangles();
  const Index numberOfWelded = static_cast<Index>(surface.SourcePoints.size());
  counts.UnusedPoints =
    static_cast<vtkIdType>(points.size()) - counts.WeldedPoints - numberOfWelded;
  surface.WeldedPointIds.resize(numberOfWelded);
  for (Index i = 0; i < numberOfWelded; ++i)
  {
    surface.WeldedPointIds[i] = i;
  }

  if (options.SplitCreases)
  {
    const EdgeFlags creases = FindCreases(mesh, options.CreaseAngle);
    for (const auto& flags : creases)
    {
      counts.CreaseEdges += flags[0] + flags[1] + flags[2];
    }
    counts.CreaseEdges /= 2;
    const std::vector<Index> originals = SplitPoints(mesh, creases, surface.Triangles);
    for (Index original : originals)
    {
      surface.SourcePoints.push_back(surface.SourcePoints[original]);
      surface.WeldedPointIds.push_back(original);
    }
    counts.SplitPoints = static_cast<vtkIdType>(originals.size());
  }
  return surface;
}
}
