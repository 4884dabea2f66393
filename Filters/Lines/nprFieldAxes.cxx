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
float FieldAxes::MakeField(float value, const std::array<float, 3>& axis, bool even)
{
  if (value != 0.0f)
  {
    return std::isinf(value) ? std::numeric_limits<float>::quiet_NaN() : value;
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
  const Eigen::Vector3f place = mesh.GetPoint(point);
  const AxisPoint& at = this->Points[point];
  const Eigen::Vector3f side = ToEigen(at.Normal).cross(ToEigen(at.Axis));
  const Lanes zero = {};
  const AxisPoints here = { { zero + at.Axis[0], zero + at.Axis[1], zero + at.Axis[2] },
    zero + at.Field, { zero + at.Normal[0], zero + at.Normal[1], zero + at.Normal[2] },
    zero + at.Bound };
  const Vector3<Lanes> across = { zero + side[0], zero + side[1], zero + side[2] };
  // Summed in double precision, so that the order of the neighbours does not show.
  LaneSum xx;
  LaneSum xy;
  LaneSum yy;
  LaneSum rx;
  LaneSum ry;
  const auto addRow = [&](const std::array<Index, NumberOfLanes>& neighbours)
  {
    const auto getEdge = [&](int c)
    { return MakeLanes([&](int i) { return mesh.GetPoint(neighbours[i])[c] - place[c]; }); };
    const Vector3<Lanes> edge = { getEdge(0), getEdge(1), getEdge(2) };
    const AxisPoints there = this->Load(neighbours);
    const Relation relation = Compare(here, there);
    const Lanes square = Dot(edge, edge);
    const Lanes counts = square > zero ? relation.AreComparable : zero;
    const Lanes weight = counts > zero ? Lanes(1.0f / square) : zero;
    const Lanes x = Dot(edge, here.Axis);
    const Lanes y = Dot(edge, across);
    const Lanes rise = SignOf(relation.Cosine) * there.Field - here.Field;
    const Lanes weighted = counts > zero ? Lanes(weight * rise) : zero;
    const Lanes wx = weight * x;
    xx.Add(wx * x);
    xy.Add(wx * y);
    yy.Add(weight * y * y);
    rx.Add(weighted * x);
    ry.Add(weighted * y);
  };
  const Index* const end = this->Surface.NeighboursEnd(point);
  for (const Index* row = this->Surface.NeighboursBegin(point); row < end; row += NumberOfLanes)
  {
    std::array<Index, NumberOfLanes> neighbours;
    for (int i = 0; i < NumberOfLanes; ++i)
    {
      // The point itself adds nothing, for it is at no distance.
      neighbours[i] = row + i < end ? row[i] : point;
    }
    addRow(neighbours);
  }
  // Neighbours in all but one line say nothing.
  const double sxx = xx.Get();
  const double sxy = xy.Get();
  const double syy = yy.Get();
  const double determinant = sxx * syy - sxy * sxy;
  return determinant > LeastDeterminant
    ? static_cast<float>((ry.Get() * sxy - rx.Get() * syy) / determinant)
    : 0.0f;
}
}
