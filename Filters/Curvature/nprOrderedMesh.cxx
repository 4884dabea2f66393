// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprOrderedMesh.h"

#include "nprHilbertOrder.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;

//------------------------------------------------------------------------------
std::vector<vtkIdType> Order(const TriangleMesh& mesh)
{
  std::vector<Eigen::Vector3d> points(mesh.GetNumberOfPoints());
  std::transform(mesh.GetPoints().begin(), mesh.GetPoints().end(), points.begin(),
    [](const TriangleMesh::Vector& point) { return Eigen::Vector3d(point.cast<double>()); });
  return GetHilbertOrder(points);
}

//------------------------------------------------------------------------------
TriangleMesh Renumber(const TriangleMesh& mesh, const std::vector<vtkIdType>& order)
{
  std::vector<Index> numbers(order.size());
  std::vector<TriangleMesh::Vector> points(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    numbers[order[i]] = static_cast<Index>(i);
    points[i] = mesh.GetPoint(static_cast<Index>(order[i]));
  }
  // The triangles by their first point in the order.
  std::vector<Index> places(order.size() + 1, 0);
  const auto renumber = [&](const TriangleMesh::Triangle& corners) {
    return TriangleMesh::Triangle{ numbers[corners[0]], numbers[corners[1]], numbers[corners[2]] };
  };
  const auto first = [](const TriangleMesh::Triangle& corners) {
    return std::min({ corners[0], corners[1], corners[2] });
  };
  for (const TriangleMesh::Triangle& corners : mesh.GetTriangles())
  {
    ++places[first(renumber(corners)) + 1];
  }
  std::partial_sum(places.begin(), places.end(), places.begin());
  std::vector<TriangleMesh::Triangle> triangles(mesh.GetNumberOfTriangles());
  for (const TriangleMesh::Triangle& corners : mesh.GetTriangles())
  {
    const TriangleMesh::Triangle renumbered = renumber(corners);
    triangles[places[first(renumbered)]++] = renumbered;
  }
  return TriangleMesh(std::move(points), std::move(triangles), mesh.GetOrigin());
}
}

//------------------------------------------------------------------------------
OrderedMesh::OrderedMesh(const TriangleMesh& mesh, const Tuples<3>& normals)
  : Points(Order(mesh)), Mesh(Renumber(mesh, this->Points)), Normals(normals.size())
{
  this->Mesh.BuildIncidence();
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    this->Normals[i] = normals[this->Points[i]];
  }
}
}
