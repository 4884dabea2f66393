// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFieldAxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace npr
{
namespace
{
// Of three neighbours, two of them ten degrees off the line through the third.
constexpr double LeastDeterminant = 0.03;

Eigen::Vector3f ToEigen(const std::array<float, 3>& vector)
{
  return { vector[0], vector[1], vector[2] };
}
}

//------------------------------------------------------------------------------
float FieldAxes::MoveOff(float value, const std::array<float, 3>& axis, bool even)
{
  if (value != 0.0f)
  {
    return value;
  }
  constexpr float slightly = std::numeric_limits<float>::min();
  const auto component =
    std::find_if(axis.begin(), axis.end(), [](float number) { return number != 0.0f; });
  return even || component == axis.end() || *component > 0.0f ? slightly : -slightly;
}

//------------------------------------------------------------------------------
float FieldAxes::ComputeFall(Index point) const
{
  // The gradient that explains best how much the field rises to each neighbour, by its distance.
  const TriangleMesh& mesh = this->Surface.GetMesh();
  const AxisPoint& here = this->Points[point];
  const Eigen::Vector3f place = mesh.GetPoint(point);
  const Eigen::Vector3f axis = ToEigen(here.Axis);
  const Eigen::Vector3f across = ToEigen(here.Normal).cross(axis);
  // In double precision, so that the order of the neighbours does not show.
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double rx = 0.0;
  double ry = 0.0;
  const auto add = [&](Index neighbour)
  {
    const AxisPoint& there = this->Points[neighbour];
    const Relation relation = Compare(here, there);
    const Eigen::Vector3f edge = mesh.GetPoint(neighbour) - place;
    const float square = edge.squaredNorm();
    if (!relation.AreComparable || !(square > 0.0f))
    {
      return;
    }
    const double x = edge.dot(axis);
    const double y = edge.dot(across);
    const double weight = 1.0 / square;
    const double rise = weight * (Turn(there.Field, relation.Cosine) - here.Field);
    xx += weight * x * x;
    xy += weight * x * y;
    yy += weight * y * y;
    rx += rise * x;
    ry += rise * y;
  };
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    // The next corner of each triangle: around a point these are all neighbours, each once, but for
    // a last one at a seam.
    const TriangleMesh::Triangle& c = mesh.GetTriangle(*t);
    constexpr std::array<int, 5> ring = { 0, 1, 2, 0, 1 };
    const int corner = (c[1] == point ? 1 : 0) + (c[2] == point ? 2 : 0);
    const int last = ring[corner + 2];
    add(c[ring[corner + 1]]);
    if (this->Surface.GetTwin(3 * *t + last) == LineSurface::NoTwin)
    {
      add(c[last]);
    }
  }
  // Neighbours in all but one line say nothing.
  const double determinant = xx * yy - xy * xy;
  return determinant > LeastDeterminant ? static_cast<float>((ry * xy - rx * yy) / determinant)
                                        : 0.0f;
}
}
