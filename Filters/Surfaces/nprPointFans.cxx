// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPointFans.h"

#include <vtkSMPTools.h>

#include <algorithm>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;

//------------------------------------------------------------------------------
/// Labels the triangles around a point by the fan they belong to, and returns how many there are.
int LabelFans(
  const TriangleMesh& mesh, const EdgeFlags& cuts, Index point, std::vector<int>& labels)
{
  const Index* const begin = mesh.IncidentBegin(point);
  const Index* const end = mesh.IncidentEnd(point);
  labels.assign(end - begin, -1);
  int count = 0;
  for (const Index* first = begin; first != end; ++first)
  {
    if (labels[first - begin] >= 0)
    {
      continue;
    }
    labels[first - begin] = count;
    // From the first triangle of the fan, go round both ways.
    for (int way = 0; way < 2; ++way)
    {
      Index triangle = *first;
      int edge = (FindCorner(mesh.GetTriangle(triangle), point) + 2 * way) % 3;
      for (;;)
      {
        const Index next = mesh.GetNeighbour(triangle, edge);
        if (next < 0 || (!cuts.empty() && cuts[triangle][edge]))
        {
          break;
        }
        int& label = labels[std::lower_bound(begin, end, next) - begin];
        if (label >= 0)
        {
          break;
        }
        label = count;
        // Out of the next triangle by its edge at the point that is not the one come in by.
        const Triangle& corners = mesh.GetTriangle(triangle);
        const Index other = corners[edge] == point ? corners[(edge + 1) % 3] : corners[edge];
        const Triangle& nextCorners = mesh.GetTriangle(next);
        const int here = FindCorner(nextCorners, point);
        edge = nextCorners[(here + 1) % 3] == other ? (here + 2) % 3 : here;
        triangle = next;
      }
    }
    ++count;
  }
  return count;
}

//------------------------------------------------------------------------------
bool HasCut(const TriangleMesh& mesh, const EdgeFlags& cuts, Index point)
{
  return std::any_of(mesh.IncidentBegin(point), mesh.IncidentEnd(point),
    [&](Index t)
    {
      const int corner = FindCorner(mesh.GetTriangle(t), point);
      return cuts[t][corner] || cuts[t][(corner + 2) % 3];
    });
}

//------------------------------------------------------------------------------
/// For each point, whether it has more than one fan.
std::vector<unsigned char> FindFannedPoints(
  const TriangleMesh& mesh, const EdgeFlags& cuts, bool onlyAtCuts)
{
  std::vector<unsigned char> fanned(mesh.GetNumberOfPoints(), 0);
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<int> labels;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index point = static_cast<Index>(i);
        fanned[i] =
          (!onlyAtCuts || HasCut(mesh, cuts, point)) && LabelFans(mesh, cuts, point, labels) > 1;
      }
    });
  return fanned;
}
}

//------------------------------------------------------------------------------
NonManifoldCounts CountNonManifold(const TriangleMesh& mesh)
{
  NonManifoldCounts counts;
  std::vector<unsigned char> bowTies = FindFannedPoints(mesh, {}, false);
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      if (mesh.GetNeighbour(t, e) != TriangleMesh::NonManifold)
      {
        continue;
      }
      // Counted by the first of its triangles.
      const Index from = mesh.GetTriangle(t)[e];
      const Index to = mesh.GetTriangle(t)[(e + 1) % 3];
      const Index first = *std::find_if(mesh.IncidentBegin(from), mesh.IncidentEnd(from),
        [&](Index other)
        {
          const Triangle& corners = mesh.GetTriangle(other);
          return std::find(corners.begin(), corners.end(), to) != corners.end();
        });
      counts.Edges += first == t;
      bowTies[from] = bowTies[to] = 0;
    }
  }
  counts.Points = std::count(bowTies.begin(), bowTies.end(), 1);
  return counts;
}

//------------------------------------------------------------------------------
EdgeFlags FindDisagreements(const TriangleMesh& mesh)
{
  EdgeFlags flags(mesh.GetNumberOfTriangles(), { { 0, 0, 0 } });
  vtkSMPTools::For(0, mesh.GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (Index t = static_cast<Index>(begin); t < end; ++t)
      {
        const Triangle& corners = mesh.GetTriangle(t);
        for (int e = 0; e < 3; ++e)
        {
          const Index neighbour = mesh.GetNeighbour(t, e);
          flags[t][e] = neighbour >= 0 &&
            !RunsOppositely(mesh.GetTriangle(neighbour), corners[e], corners[(e + 1) % 3]);
        }
      }
    });
  return flags;
}

//------------------------------------------------------------------------------
vtkIdType CountEdges(const EdgeFlags& flags)
{
  vtkIdType count = 0;
  for (const auto& edges : flags)
  {
    count += edges[0] + edges[1] + edges[2];
  }
  return count / 2;
}

//------------------------------------------------------------------------------
std::vector<Index> SplitPoints(const TriangleMesh& mesh, const EdgeFlags& cuts, bool onlyAtCuts,
  std::vector<Triangle>& triangles)
{
  const std::vector<unsigned char> fanned = FindFannedPoints(mesh, cuts, onlyAtCuts);
  std::vector<Index> originals;
  std::vector<int> labels;
  for (Index point = 0; point < mesh.GetNumberOfPoints(); ++point)
  {
    if (!fanned[point])
    {
      continue;
    }
    const int count = LabelFans(mesh, cuts, point, labels);
    const Index firstCopy = mesh.GetNumberOfPoints() + static_cast<Index>(originals.size());
    const Index* const incident = mesh.IncidentBegin(point);
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
      if (labels[i] > 0)
      {
        triangles[incident[i]][FindCorner(mesh.GetTriangle(incident[i]), point)] =
          firstCopy + labels[i] - 1;
      }
    }
    originals.insert(originals.end(), count - 1, point);
  }
  return originals;
}
}
