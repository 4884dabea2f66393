// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFieldAxes.h"

#include "nprArrayNames.h"
#include <Eigen/Geometry>

namespace npr
{
//------------------------------------------------------------------------------
FieldAxes::FieldAxes(const LineSurface& surface, const std::array<const float*, 3>& axes)
  : Surface(surface), Axes(axes)
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
  const TriangleMesh& mesh = this->Surface.GetMesh();
  double sum = 0.0;
  double area = 0.0;
  const Eigen::Vector3d axis = this->GetAxis(point);
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    const TriangleMesh::Triangle& c = mesh.GetTriangle(*t);
    const int here = c[0] == point ? 0 : c[1] == point ? 1 : 2;
    const Index b = c[(here + 1) % 3];
    const Index d = c[(here + 2) % 3];
    const int turnB = this->GetTurn(point, b);
    const int turnD = this->GetTurn(point, d);
    const Eigen::Vector3d toB = (mesh.GetPoint(b) - mesh.GetPoint(point)).cast<double>();
    const Eigen::Vector3d toD = (mesh.GetPoint(d) - mesh.GetPoint(point)).cast<double>();
    const Eigen::Vector3d normal = toB.cross(toD);
    const double size = normal.norm();
    if (turnB == 0 || turnD == 0 || !(size > 0.0))
    {
      continue;
    }
    // The gradient of the linear field in the triangle, times twice its area.
    const double riseB = double(field[b]) * turnB - field[point];
    const double riseD = double(field[d]) * turnD - field[point];
    const Eigen::Vector3d gradient = (riseB * toD - riseD * toB).cross(normal) / size;
    sum -= gradient.dot(axis);
    area += size;
  }
  return area > 0.0 ? static_cast<float>(sum / area) : 0.0f;
}
}
