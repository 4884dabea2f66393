// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPlaneBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace npr
{
namespace
{
constexpr double Margin = 1.0e-6;
}

//------------------------------------------------------------------------------
TrianglePlane::TrianglePlane(const TriangleMesh& mesh, TriangleMesh::Index triangle)
{
  const TriangleMesh::Triangle& c = mesh.GetTriangle(triangle);
  this->Corner = mesh.GetPoint(c[0]).cast<double>();
  this->Normal = (mesh.GetPoint(c[1]).cast<double>() - this->Corner)
                   .cross(mesh.GetPoint(c[2]).cast<double>() - this->Corner);
}

//------------------------------------------------------------------------------
PlaneBounds::PlaneBounds(const TriangleMesh& mesh, Index begin, Index end)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index t = begin; t < end; ++t)
  {
    sum += TrianglePlane(mesh, t).Corner;
  }
  const Eigen::Vector3f centre = (sum / double(end - begin)).cast<float>();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(infinity);
  Eigen::Vector3d high = -low;
  double least = infinity;
  double most = -infinity;
  for (Index t = begin; t < end; ++t)
  {
    const TrianglePlane plane(mesh, t);
    const Eigen::Vector3d normal = plane.Normal / plane.Normal.norm();
    const Eigen::Vector3d way = plane.Corner - centre.cast<double>();
    const double offset = normal.dot(way);
    const double margin = Margin * way.lpNorm<1>();
    if (!std::isfinite(offset))
    {
      // A triangle without a normal is on no side that is known.
      low.setConstant(-1.0);
      high.setConstant(1.0);
      least = -infinity;
      most = infinity;
      break;
    }
    low = low.cwiseMin(normal);
    high = high.cwiseMax(normal);
    least = std::min(least, offset - margin);
    most = std::max(most, offset + margin);
  }
  Eigen::Vector3f::Map(this->Centre.data()) = centre;
  Eigen::Vector3f::Map(this->Low.data()) = low.cast<float>();
  Eigen::Vector3f::Map(this->High.data()) = high.cast<float>();
  this->Offsets = { least, most };
}

//------------------------------------------------------------------------------
std::array<double, 2> PlaneBounds::GetRange(const LineView& view) const
{
  double low = 0.0;
  double high = 0.0;
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double way = double(view.Eye[i]) - double(view.Perspective) * this->Centre[i];
    const double a = way * this->Low[i];
    const double b = way * this->High[i];
    low += std::min(a, b);
    high += std::max(a, b);
    size += std::abs(way);
  }
  if (view.Perspective != 0.0f)
  {
    low -= this->Offsets[1];
    high -= this->Offsets[0];
  }
  return { low - Margin * size, high + Margin * size };
}
}
