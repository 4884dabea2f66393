// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFieldAxes.h"

#include "nprArrayNames.h"
#include <cmath>

#include <Eigen/Geometry>

namespace npr
{
namespace
{
// Of three neighbours, two of them ten degrees off the line through the third.
constexpr double LeastDeterminant = 0.03;
}

//------------------------------------------------------------------------------
FieldAxes::FieldAxes(const LineSurface& surface, const std::array<const float*, 3>& axes, bool even)
  : Surface(surface), Even(even), Axes(axes)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Normals[i] = surface.GetComponent(names::Normals, i);
  }
}

//------------------------------------------------------------------------------
bool FieldAxes::IsForward(Index point) const
{
  for (const float* component : this->Axes)
  {
    if (component[point] != 0.0f)
    {
      return component[point] > 0.0f;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
int FieldAxes::GetTurn(Index a, Index b, float cosine) const
{
  float normals = 0.0f;
  float fromA = 0.0f;
  float fromB = 0.0f;
  for (int i = 0; i < 3; ++i)
  {
    normals += this->Normals[i][a] * this->Normals[i][b];
    fromA += this->Axes[i][a] * this->Normals[i][b];
    fromB += this->Axes[i][b] * this->Normals[i][a];
  }
  if (normals < 0.0f)
  {
    return 0;
  }
  // The cosine after the shortest turn from one tangent plane to the other, in closed form. Both
  // ways round alike, for nothing here depends on the order of the points.
  const float turned = cosine - fromA * fromB / (1.0f + normals);
  return turned > LeastCosine ? 1 : turned < -LeastCosine ? -1 : 0;
}

//------------------------------------------------------------------------------
float FieldAxes::ComputeFall(Index point, const float* field) const
{
  // The gradient that explains best how much the field rises to each neighbour, by its distance.
  const TriangleMesh& mesh = this->Surface.GetMesh();
  const Eigen::Vector3f axis = this->GetAxis(point);
  const Eigen::Vector3f across = this->GetNormal(point).cross(axis);
  // In double precision, so that the order of the neighbours does not show.
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double rx = 0.0;
  double ry = 0.0;
  const auto add = [&](Index neighbour)
  {
    const int turn = this->GetTurn(point, neighbour);
    const Eigen::Vector3f edge = mesh.GetPoint(neighbour) - mesh.GetPoint(point);
    const float square = edge.squaredNorm();
    if (turn == 0 || !(square > 0.0f))
    {
      return;
    }
    const float perLength = 1.0f / std::sqrt(square);
    const double x = edge.dot(axis) * perLength;
    const double y = edge.dot(across) * perLength;
    const double rise = (field[neighbour] * turn - field[point]) * perLength;
    xx += x * x;
    xy += x * y;
    yy += y * y;
    rx += rise * x;
    ry += rise * y;
  };
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    // The next corner of each triangle: around a point these are all neighbours, each once, but for
    // a last one at a seam.
    const TriangleMesh::Triangle& c = mesh.GetTriangle(*t);
    const int here = c[0] == point ? 0 : c[1] == point ? 1 : 2;
    const int last = here == 0 ? 2 : here - 1;
    add(c[here == 2 ? 0 : here + 1]);
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
