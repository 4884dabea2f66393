// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprOpenMesh.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <sstream>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;

//------------------------------------------------------------------------------
/// Whether the triangles at a point (its incidence is built) are one fan, open or closed, all
/// oriented alike.
bool IsOneFan(const TriangleMesh& mesh, Index point)
{
  // Where each triangle, seen from the point, begins and ends.
  using Step = std::array<Index, 2>;
  std::vector<Step> steps;
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    const Triangle& corners = mesh.GetTriangle(*t);
    const int i = corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
    steps.push_back({ corners[(i + 1) % 3], corners[(i + 2) % 3] });
  }
  if (steps.empty())
  {
    return true;
  }
  std::sort(steps.begin(), steps.end());
  std::vector<Index> ends;
  for (const Step& step : steps)
  {
    ends.push_back(step[1]);
  }
  std::sort(ends.begin(), ends.end());
  const auto haveSameBegin = [](const Step& a, const Step& b) { return a[0] == b[0]; };
  if (std::adjacent_find(steps.begin(), steps.end(), haveSameBegin) != steps.end() ||
    std::adjacent_find(ends.begin(), ends.end()) != ends.end())
  {
    return false;
  }
  // An open fan begins where no triangle ends.
  Index at = steps.front()[0];
  for (const Step& step : steps)
  {
    if (!std::binary_search(ends.begin(), ends.end(), step[0]))
    {
      at = step[0];
      break;
    }
  }
  // Begins and ends are all different, so this runs along one open or closed chain.
  const Index first = at;
  std::size_t taken = 0;
  do
  {
    const auto next = std::lower_bound(steps.begin(), steps.end(), Step{ at, -1 });
    if (next == steps.end() || (*next)[0] != at)
    {
      break;
    }
    at = (*next)[1];
    ++taken;
  } while (at != first);
  return taken == steps.size();
}
}

//------------------------------------------------------------------------------
std::string FindHalfEdgeObstacle(vtkPolyData* surface)
{
  TriangleMesh mesh(surface);
  const vtkIdType otherCells = surface->GetNumberOfCells() - mesh.GetNumberOfTriangles();
  mesh.BuildIncidence();
  std::atomic<vtkIdType> badPoints{ 0 };
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType found = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        found += !IsOneFan(mesh, static_cast<Index>(i));
      }
      badPoints += found;
    });
  if (otherCells == 0 && badPoints == 0)
  {
    return {};
  }
  std::ostringstream text;
  text << "This needs an oriented manifold of triangles, but ";
  if (otherCells > 0)
  {
    text << otherCells << " of " << surface->GetNumberOfCells()
         << " cells are no triangles with three different, finite points";
  }
  if (badPoints > 0)
  {
    text << (otherCells > 0 ? ", and " : "") << "at " << badPoints << " of "
         << mesh.GetNumberOfPoints()
         << " points the triangles are not one fan (an edge has more than two, or neighbours are "
            "oriented against each other, or only the point joins them)";
  }
  text << ". Run vtkNPRSurfacePreparation first.";
  return text.str();
}

//------------------------------------------------------------------------------
std::vector<Triangle> GetAllTriangles(vtkPolyData* surface)
{
  return TriangleMesh(surface).GetTriangles();
}

//------------------------------------------------------------------------------
bool MakeHalfEdges(Index numberOfPoints, const std::vector<Triangle>& triangles, HalfEdgeMesh& mesh)
{
  mesh.reserve(numberOfPoints, 3 * triangles.size() / 2 + numberOfPoints / 8, triangles.size());
  for (Index i = 0; i < numberOfPoints; ++i)
  {
    mesh.add_vertex(OpenMesh::Vec3d(0.0, 0.0, 0.0));
  }
  for (const Triangle& t : triangles)
  {
    using Vertex = HalfEdgeMesh::VertexHandle;
    if (!mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])).is_valid())
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
UnitPlacement PlaceHalfEdges(vtkPolyData* surface, HalfEdgeMesh& mesh)
{
  std::vector<HalfEdgeMesh::VertexHandle> used;
  Eigen::Vector3d low;
  Eigen::Vector3d high;
  const auto getPoint = [surface](HalfEdgeMesh::VertexHandle vertex)
  {
    Eigen::Vector3d point;
    surface->GetPoint(vertex.idx(), point.data());
    return point;
  };
  for (const auto vertex : mesh.vertices())
  {
    if (!mesh.is_isolated(vertex))
    {
      const Eigen::Vector3d point = getPoint(vertex);
      low = used.empty() ? point : Eigen::Vector3d(low.cwiseMin(point));
      high = used.empty() ? point : Eigen::Vector3d(high.cwiseMax(point));
      used.push_back(vertex);
    }
  }
  UnitPlacement placement;
  if (used.empty())
  {
    return placement;
  }
  placement.Origin = 0.5 * low + 0.5 * high;
  const double size = (0.5 * high - 0.5 * low).maxCoeff();
  placement.Unit = size > 0.0 ? size : 1.0;
  for (const auto vertex : used)
  {
    const Eigen::Vector3d point = (getPoint(vertex) - placement.Origin) / placement.Unit;
    mesh.set_point(vertex, OpenMesh::Vec3d(point.x(), point.y(), point.z()));
  }
  return placement;
}
}
