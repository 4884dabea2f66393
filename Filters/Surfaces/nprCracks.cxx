// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCracks.h"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStaticPointLocator.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;
using Eigen::Vector3d;

// How far a point may be off an edge: coordinates in texts have six digits.
constexpr double ToleranceOfSize = 1e-5; // of the largest coordinate
constexpr double ToleranceOfEdge = 1e-2; // of the edge's length

struct BoundaryEdge
{
  Index Triangle;
  int Edge;
  std::vector<Index> Within; ///< Points on it, from its start.
};

class CrackFinder
{
public:
  explicit CrackFinder(const TriangleMesh& mesh) : Mesh(mesh)
  {
    std::map<Index, std::vector<Index>> ends;
    for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
    {
      for (int e = 0; e < 3; ++e)
      {
        if (mesh.GetNeighbour(t, e) == TriangleMesh::Boundary)
        {
          const Index from = mesh.GetTriangle(t)[e];
          const Index to = mesh.GetTriangle(t)[(e + 1) % 3];
          this->Edges.push_back({ t, e, {} });
          ends[from].push_back(to);
          ends[to].push_back(from);
        }
      }
    }
    vtkNew<vtkPoints> places;
    places->SetDataTypeToDouble();
    for (auto& [point, others] : ends)
    {
      places->InsertNextPoint(this->GetPoint(point).data());
      this->Points.push_back(point);
      this->Ends.push_back(std::move(others));
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(places);
    this->Locator->SetDataSet(data);
    if (!this->Points.empty())
    {
      this->Locator->BuildLocator();
    }
  }

  /// The boundary edges that have points within them.
  std::vector<BoundaryEdge> Find()
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Edges.size()),
      [this](vtkIdType begin, vtkIdType end)
      {
        vtkNew<vtkIdList> near;
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->FindWithin(this->Edges[i], near);
        }
      });
    std::vector<BoundaryEdge> found;
    std::copy_if(this->Edges.begin(), this->Edges.end(), std::back_inserter(found),
      [](const BoundaryEdge& edge) { return !edge.Within.empty(); });
    return found;
  }

private:
  Vector3d GetPoint(Index point) const { return this->Mesh.GetPoint(point).cast<double>(); }

  void FindWithin(BoundaryEdge& edge, vtkIdList* near) const
  {
    const Triangle& corners = this->Mesh.GetTriangle(edge.Triangle);
    const Vector3d start = this->GetPoint(corners[edge.Edge]);
    const Vector3d way = this->GetPoint(corners[(edge.Edge + 1) % 3]) - start;
    const double length = way.norm();
    const double tolerance =
      std::min(ToleranceOfSize * this->Mesh.GetUnit(), ToleranceOfEdge * length);
    const Vector3d direction = way / length;
    const auto isOnLine = [&](const Vector3d& place)
    { return direction.cross(place - start).norm() <= tolerance; };

    const Vector3d middle = start + 0.5 * way;
    this->Locator->FindPointsWithinRadius(0.5 * length, middle.data(), near);
    std::vector<std::pair<double, Index>> within;
    for (vtkIdType i = 0; i < near->GetNumberOfIds(); ++i)
    {
      const vtkIdType number = near->GetId(i);
      const Index point = this->Points[number];
      const Vector3d place = this->GetPoint(point);
      const double at = direction.dot(place - start);
      // One that only touches the edge, as a corner of something else, is no part of a crack.
      const std::vector<Index>& ends = this->Ends[number];
      if (std::find(corners.begin(), corners.end(), point) == corners.end() && at > tolerance &&
        at < length - tolerance && isOnLine(place) &&
        std::any_of(
          ends.begin(), ends.end(), [&](Index end) { return isOnLine(this->GetPoint(end)); }))
      {
        within.emplace_back(at, point);
      }
    }
    std::sort(within.begin(), within.end());
    double last = 0.0;
    for (const auto& [at, point] : within)
    {
      if (at > last + tolerance)
      {
        edge.Within.push_back(point);
        last = at;
      }
    }
  }

  const TriangleMesh& Mesh;
  std::vector<BoundaryEdge> Edges;
  std::vector<Index> Points;            ///< On the boundary.
  std::vector<std::vector<Index>> Ends; ///< Of each of these, where its boundary edges lead to.
  vtkNew<vtkStaticPointLocator> Locator;
};

/// Parts the triangle into a fan around the corner across the edge.
void Split(const BoundaryEdge& edge, PreparedSurface& surface)
{
  const Triangle corners = surface.Triangles[edge.Triangle];
  const Index apex = corners[(edge.Edge + 2) % 3];
  const vtkIdType cell = surface.SourceCells[edge.Triangle];
  surface.Triangles[edge.Triangle] = { corners[edge.Edge], edge.Within.front(), apex };
  for (std::size_t i = 0; i < edge.Within.size(); ++i)
  {
    const bool isLast = i + 1 == edge.Within.size();
    const Index to = isLast ? corners[(edge.Edge + 1) % 3] : edge.Within[i + 1];
    surface.Triangles.push_back({ edge.Within[i], to, apex });
    surface.SourceCells.push_back(cell);
  }
}
}

//------------------------------------------------------------------------------
void CloseCracks(TriangleMesh& mesh, PreparedSurface& surface)
{
  constexpr int rounds = 3; // in each, one edge of a triangle
  for (int round = 0; round < rounds; ++round)
  {
    Index last = -1;
    for (const BoundaryEdge& edge : CrackFinder(mesh).Find())
    {
      if (edge.Triangle != last)
      {
        Split(edge, surface);
        last = edge.Triangle;
        ++surface.Counts.CrackEdges;
      }
    }
    if (last < 0)
    {
      return;
    }
    mesh = TriangleMesh(mesh.GetPoints(), surface.Triangles, mesh.GetOrigin());
    mesh.BuildNeighbours();
  }
}
}
