// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFieldAxes.h"

#include "nprArrayNames.h"
#include "nprTangentFrame.h"

#include <vtkSMPTools.h>

#include <cmath>

namespace npr
{
namespace
{
constexpr double LeastCosine =
  0.70710678; // of axes that are closer to parallel than to right angles
}

//------------------------------------------------------------------------------
FieldAxes::FieldAxes(const LineSurface& surface) : Surface(surface)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Normals[i] = surface.GetComponent(names::Normals, i);
  }
}

//------------------------------------------------------------------------------
void FieldAxes::Compare()
{
  this->Turns.resize(this->Surface.GetNumberOfHalfEdges());
  vtkSMPTools::For(0, this->Surface.GetNumberOfHalfEdges(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (Index h = static_cast<Index>(begin); h < end; ++h)
      {
        const Index start = this->Surface.GetStart(h);
        const Index stop = this->Surface.GetEnd(h);
        // In one order, so that both half-edges of an edge round alike.
        this->Turns[h] =
          static_cast<signed char>(this->Compare(std::min(start, stop), std::max(start, stop)));
      }
    });
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
int FieldAxes::Compare(Index a, Index b) const
{
  const auto getNormal = [this](Index point) -> Eigen::Vector3d {
    return { this->Normals[0][point], this->Normals[1][point], this->Normals[2][point] };
  };
  const MinimalRotation rotation(getNormal(a), getNormal(b));
  const double cosine = rotation.IsValid() ? rotation(this->GetAxis(a)).dot(this->GetAxis(b)) : 0.0;
  return cosine > LeastCosine ? 1 : cosine < -LeastCosine ? -1 : 0;
}

//------------------------------------------------------------------------------
int FieldAxes::CompareQuickly(Index halfEdge) const
{
  const Index a = this->Surface.GetStart(halfEdge);
  const Index b = this->Surface.GetEnd(halfEdge);
  const double cosine = this->GetAxis(a).dot(this->GetAxis(b));
  return cosine > LeastCosine ? 1 : cosine < -LeastCosine ? -1 : 0;
}

//------------------------------------------------------------------------------
void FieldAxes::ComputeFall(
  const float* field, const std::vector<Index>& points, std::vector<float>& fall) const
{
  const TriangleMesh& mesh = this->Surface.GetMesh();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Index point = points[i];
    double sum = 0.0;
    double area = 0.0;
    const Eigen::Vector3d axis = this->GetAxis(point);
    for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
    {
      const TriangleMesh::Triangle& c = mesh.GetTriangle(*t);
      const int here = c[0] == point ? 0 : c[1] == point ? 1 : 2;
      const Index b = c[(here + 1) % 3];
      const Index d = c[(here + 2) % 3];
      const int turnB = this->GetTurn(3 * *t + here);
      const int turnD = this->GetTurn(3 * *t + (here + 2) % 3);
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
    fall[i] = area > 0.0 ? static_cast<float>(sum / area) : 0.0f;
  }
}
}
