// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprTriangleArea.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace npr
{
namespace
{
using Eigen::Vector3d;

Vector3d GetPoint(vtkPolyData* surface, vtkIdType point)
{
  Vector3d place;
  surface->GetPoint(point, place.data());
  return place;
}

bool HasArea(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  const double longest =
    std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
  return CountsAsArea((b - a).cross(c - a).norm(), longest);
}

/// Of the triangles of each cell: fans around the first point, or strips.
bool HasArea(vtkPolyData* surface, vtkCellArray* cells, bool areStrips)
{
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, points);
    for (vtkIdType i = 2; i < points->GetNumberOfIds(); ++i)
    {
      if (HasArea(GetPoint(surface, points->GetId(areStrips ? i - 2 : 0)),
            GetPoint(surface, points->GetId(i - 1)), GetPoint(surface, points->GetId(i))))
      {
        return true;
      }
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
bool HasArea(vtkPolyData* surface)
{
  return HasArea(surface, surface->GetPolys(), false) ||
    HasArea(surface, surface->GetStrips(), true);
}
}
