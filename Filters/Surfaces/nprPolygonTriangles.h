// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPolygonTriangles.h
 * @brief The triangles of all polygons and strips of a vtkPolyData.
 */
#ifndef nprPolygonTriangles_h
#define nprPolygonTriangles_h

#include "nprTriangleMesh.h"
#include "nprVTKCompat.h"

#include <Eigen/Core>

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
struct PolygonTriangles
{
  std::vector<TriangleMesh::Triangle> Triangles; // of the input's points
  std::vector<vtkIdType> Cells;                  // for each triangle, the cell it comes from
  vtkIdType NumberOfTriangulatedCells = 0;
  vtkIdType NumberOfBadTriangles = 0; // left out for a missing or not finite point
};

/// @param points those of the input, in double precision
PolygonTriangles GetPolygonTriangles(
  vtkPolyData* input, const std::vector<Eigen::Vector3d>& points);
}

#endif
