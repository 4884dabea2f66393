// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprManifoldChecks.h
 * @brief What a surface is, by brute force: with maps and sets, and nothing of what is tested.
 */
#ifndef nprManifoldChecks_h
#define nprManifoldChecks_h

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace nprtest
{
using Corners = std::array<vtkIdType, 3>;

inline std::vector<Corners> GetTriangles(vtkPolyData* surface)
{
  std::vector<Corners> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < surface->GetNumberOfPolys(); ++c)
  {
    surface->GetPolys()->GetCellAtId(c, ids);
    triangles.push_back({ ids->GetId(0), ids->GetId(1), ids->GetId(2) });
  }
  return triangles;
}

inline vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<std::array<double, 3>>& points, const std::vector<Corners>& triangles)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  for (const auto& point : points)
  {
    positions->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const Corners& corners : triangles)
  {
    cells->InsertNextCell(3, corners.data());
  }
  mesh->SetPoints(positions);
  mesh->SetPolys(cells);
  return mesh;
}

struct Shape
{
  vtkIdType NonManifoldEdges = 0; ///< more than two triangles
  vtkIdType ManyFans = 0;         ///< points with more than one fan
  vtkIdType Unused = 0;           ///< points without triangles
  vtkIdType BoundaryEdges = 0;    ///< one triangle
  vtkIdType Disagreements = 0;    ///< edges that two triangles run through the same way
  vtkIdType EulerCharacteristic = 0;

  bool IsManifold() const { return this->NonManifoldEdges + this->ManyFans + this->Unused == 0; }
};

inline Shape GetShape(vtkPolyData* surface)
{
  const std::vector<Corners> triangles = GetTriangles(surface);
  std::map<std::pair<vtkIdType, vtkIdType>, std::vector<std::size_t>> edges;
  std::map<std::pair<vtkIdType, vtkIdType>, int> directed;
  std::map<vtkIdType, std::set<std::size_t>> fans;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      const vtkIdType from = triangles[t][e];
      const vtkIdType to = triangles[t][(e + 1) % 3];
      edges[std::minmax(from, to)].push_back(t);
      ++directed[{ from, to }];
      fans[from].insert(t);
    }
  }
  Shape shape;
  for (const auto& [edge, users] : edges)
  {
    shape.NonManifoldEdges += users.size() > 2;
    shape.BoundaryEdges += users.size() == 1;
    shape.Disagreements +=
      users.size() == 2 && directed[edge] != directed[{ edge.second, edge.first }];
  }
  for (const auto& [point, around] : fans)
  {
    // What can be reached from the first, over edges at the point that have two triangles.
    std::set<std::size_t> rest(std::next(around.begin()), around.end());
    std::vector<std::size_t> front(1, *around.begin());
    while (!front.empty())
    {
      const Corners corners = triangles[front.back()];
      front.pop_back();
      for (vtkIdType other : corners)
      {
        if (other == point)
        {
          continue;
        }
        const auto& users = edges[std::minmax(point, other)];
        for (std::size_t next : users)
        {
          if (users.size() == 2 && rest.erase(next) > 0)
          {
            front.push_back(next);
          }
        }
      }
    }
    shape.ManyFans += !rest.empty();
  }
  shape.Unused = surface->GetNumberOfPoints() - static_cast<vtkIdType>(fans.size());
  shape.EulerCharacteristic = static_cast<vtkIdType>(fans.size()) -
    static_cast<vtkIdType>(edges.size()) + static_cast<vtkIdType>(triangles.size());
  return shape;
}
}

#endif
