// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprOpenMesh.h
 * @brief Between a vtkPolyData of triangles and the half-edge mesh of OpenMesh.
 *
 * Vertex i is point i and face i is cell i, and they stay so as long as nobody collects OpenMesh's
 * garbage: that is how arrays find their way back.
 */
#ifndef nprOpenMesh_h
#define nprOpenMesh_h

#include "nprTriangleMesh.h"
#include "nprVTKCompat.h"

// OpenMesh grows its arrays by vectors that nobody has set yet, which GCC tells us inlined.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <Eigen/Core>

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
struct HalfEdgeTraits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

/// Why the surface has no half-edge mesh, and what to do; empty if it has one. It must consist of
/// triangles with three different, finite points, and be an oriented manifold.
std::string FindHalfEdgeObstacle(vtkPolyData* surface);

/// The triangles of a surface without obstacles.
std::vector<TriangleMesh::Triangle> GetAllTriangles(vtkPolyData* surface);

/// Fills the mesh with the triangles. All points are at zero. False if OpenMesh refuses one, which
/// does not happen without obstacles.
bool MakeHalfEdges(TriangleMesh::Index numberOfPoints,
  const std::vector<TriangleMesh::Triangle>& triangles, HalfEdgeMesh& mesh);

/// From the coordinates of a surface to those of its half-edge mesh, which lies within [-1, 1]
/// around 0: so no digits are lost far from the origin, and no products of small lengths vanish.
struct UnitPlacement
{
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero();
  double Unit = 1.0; ///< length
};

/// Puts the vertices of the mesh where the surface has its points. Those without a triangle stay at
/// 0.
UnitPlacement PlaceHalfEdges(vtkPolyData* surface, HalfEdgeMesh& mesh);
}

#endif
