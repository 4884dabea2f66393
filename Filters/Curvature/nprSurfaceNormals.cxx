// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfaceNormals.h"

#include "nprLanes.h"

#include <vtkSMPTools.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Vector3d;

//------------------------------------------------------------------------------
Vector3d Corner(const TriangleMesh& mesh, Index point)
{
  return mesh.GetPoint(point).cast<double>();
}

//------------------------------------------------------------------------------
/// The normal by this weighting. False where the triangles cancel each other or have no area, and
/// in single precision also where that does not suffice for their sizes.
template<typename Real, NormalWeights Weights>
bool AddUpNormals(
  const TriangleMesh& mesh, Index point, Real perUnit, Eigen::Matrix<Real, 3, 1>& normal)
{
  using Vector = Eigen::Matrix<Real, 3, 1>;
  const Vector p = mesh.GetPoint(point).template cast<Real>();
  Vector sum = Vector::Zero();
  Real magnitude = 0;
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    Prefetch(&mesh.GetTriangles()[t[TriangleMesh::LookAhead]]);
    const TriangleMesh::Triangle& corners = mesh.GetTriangle(*t);
    const int here = corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
    const Index next = corners[here == 2 ? 0 : here + 1];
    const Index last = corners[here == 0 ? 2 : here - 1];
    const Vector a = (mesh.GetPoint(next).template cast<Real>() - p) * perUnit;
    const Vector b = (mesh.GetPoint(last).template cast<Real>() - p) * perUnit;
    const Vector area = a.cross(b);
    const Real squaredArea = area.squaredNorm();
    if (!(squaredArea > Real(0)))
    {
      continue;
    }
    Real weight = 1;
    if (Weights == NormalWeights::Max)
    {
      weight = Real(1) / (a.squaredNorm() * b.squaredNorm());
    }
    else if (Weights == NormalWeights::Angle)
    {
      const Real length = std::sqrt(squaredArea);
      weight = std::atan2(length, a.dot(b)) / length;
    }
    sum += weight * area;
    magnitude += weight * weight * squaredArea;
  }
  // Where the triangles cancel each other the direction of the sum is rounding noise.
  const Real square = sum.squaredNorm();
  const Real noise = std::numeric_limits<Real>::epsilon();
  normal = sum / std::sqrt(square);
  return square > Real(1e3) * noise * noise * magnitude && std::isfinite(square) &&
    std::isfinite(magnitude);
}

//------------------------------------------------------------------------------
/// The direction of the largest triangle, or else the z axis.
Vector3d GetLargestNormal(const TriangleMesh& mesh, Index point)
{
  Vector3d largest = Vector3d::Zero();
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    const TriangleMesh::Triangle& corners = mesh.GetTriangle(*t);
    const Vector3d p = Corner(mesh, corners[0]);
    const Vector3d area = (Corner(mesh, corners[1]) - p).cross(Corner(mesh, corners[2]) - p);
    if (area.squaredNorm() > largest.squaredNorm())
    {
      largest = area;
    }
  }
  return largest.squaredNorm() > 0.0 ? largest.normalized() : Vector3d::UnitZ();
}

//------------------------------------------------------------------------------
template<NormalWeights Weights>
void AddUpNormals(const TriangleMesh& mesh, Tuples<3>& normals)
{
  const float perUnit = 1.0f / mesh.GetUnit();
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index point = static_cast<Index>(i);
        if (!AddUpNormals<float, Weights>(mesh, point, perUnit, normals[i]))
        {
          Vector3d normal;
          if (!AddUpNormals<double, Weights>(mesh, point, perUnit, normal))
          {
            normal = GetLargestNormal(mesh, point);
          }
          normals[i] = normal.cast<float>();
        }
      }
    });
}

//------------------------------------------------------------------------------
/// Turns the normal of a border point so that it fits those of the neighbours that are settled.
/// False if it has no such neighbour, or (if `fully`) none that determine it in both directions.
bool FitBorderNormal(const TriangleMesh& mesh, const std::vector<unsigned char>& settled,
  const Tuples<3>& normals, bool fully, Index point, Vector3d& fitted)
{
  // Least squares for the change d of the normal, over edges e: (n + d).e = -(other normal).e
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  const Vector3d p = Corner(mesh, point);
  const Vector3d n = normals[point].cast<double>();
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    for (Index corner : mesh.GetTriangle(*t))
    {
      Vector3d edge = Corner(mesh, corner) - p;
      if (corner == point || !settled[corner] || !(edge.squaredNorm() > 0.0))
      {
        continue;
      }
      edge.normalize();
      const double mismatch = edge.dot(n + normals[corner].cast<double>());
      edge = (edge - edge.dot(n) * n).eval();
      matrix += edge * edge.transpose();
      right -= mismatch * edge;
    }
  }
  const double trace = matrix.trace();
  if (!(trace > 0.0))
  {
    return false;
  }
  // The product of the two eigenvalues in the tangent plane; equal ones give a quarter.
  const double product = 0.5 * (trace * trace - matrix.squaredNorm());
  if (fully && product < 0.03 * trace * trace)
  {
    return false;
  }
  // The small diagonal leaves alone what the edges do not determine.
  matrix.diagonal().array() += (fully ? 1e-6 : 1e-2) * trace;
  const Vector3d change = matrix.inverse() * right;
  // A turn by more than 45 degrees is not a correction but a misfit (noise, a fold).
  fitted = change.squaredNorm() < 1.0 ? (n + change).normalized() : n;
  return true;
}

//------------------------------------------------------------------------------
/// The angle that the triangles around a point fill.
double GetFanAngle(const TriangleMesh& mesh, Index point)
{
  double angle = 0.0;
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    const TriangleMesh::Triangle& corners = mesh.GetTriangle(*t);
    const int here = corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
    const Vector3d a = Corner(mesh, corners[(here + 1) % 3]) - Corner(mesh, point);
    const Vector3d b = Corner(mesh, corners[(here + 2) % 3]) - Corner(mesh, point);
    angle += std::atan2(a.cross(b).norm(), a.dot(b));
  }
  return angle;
}

//------------------------------------------------------------------------------
/// The most that an edge from a point to settled ones bulges, were its normal this: eight times as
/// far as the curve is from the chord.
double GetLargestBulge(const TriangleMesh& mesh, const std::vector<unsigned char>& settled,
  const Tuples<3>& normals, Index point, const Vector3d& normal)
{
  double largest = 0.0;
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    for (Index corner : mesh.GetTriangle(*t))
    {
      if (corner != point && settled[corner])
      {
        const Vector3d edge = Corner(mesh, corner) - Corner(mesh, point);
        largest = std::max(largest, std::abs(edge.dot(normals[corner].cast<double>() - normal)));
      }
    }
  }
  return largest;
}

//------------------------------------------------------------------------------
/// Whether edges from a point would bulge about as much as those from its settled neighbours do:
/// not so at the far end of a plane that goes over into a fillet, whose edges are sampled far more
/// coarsely than an arc would be.
bool IsSampledAlike(const TriangleMesh& mesh, const std::vector<unsigned char>& settled,
  const Tuples<3>& normals, Index point, const Vector3d& normal)
{
  constexpr double LargestRatio = 4.0;
  double known = 0.0;
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    for (Index corner : mesh.GetTriangle(*t))
    {
      if (corner != point && settled[corner])
      {
        known = std::max(
          known, GetLargestBulge(mesh, settled, normals, corner, normals[corner].cast<double>()));
      }
    }
  }
  return GetLargestBulge(mesh, settled, normals, point, normal) <= LargestRatio * known;
}

//------------------------------------------------------------------------------
/// Whether the sides of a border make an angle there.
bool IsCorner(const TriangleMesh& mesh, Index point)
{
  constexpr double LargestAngle = 2.356; // 135 degrees
  return GetFanAngle(mesh, point) < LargestAngle;
}

//------------------------------------------------------------------------------
/// Settles those of the open points that accept a normal fit, all by the same state. They are open
/// no longer.
template<typename Fit>
void FitRound(
  std::vector<unsigned char>& settled, Tuples<3>& normals, std::vector<Index>& open, const Fit& fit)
{
  std::vector<unsigned char> done(open.size(), 0);
  Tuples<3> fitted(open.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(open.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Vector3d normal;
        done[i] = fit(open[i], normal);
        if (done[i])
        {
          fitted[i] = normal.cast<float>();
        }
      }
    });
  std::vector<Index> left;
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    if (done[i])
    {
      settled[open[i]] = 1;
      normals[open[i]] = fitted[i];
    }
    else
    {
      left.push_back(open[i]);
    }
  }
  open.swap(left);
}

//------------------------------------------------------------------------------
void FitBorderNormals(const TriangleMesh& mesh, Tuples<3>& normals)
{
  const std::vector<unsigned char> border = ComputeBorderPoints(mesh);
  std::vector<Index> open;
  std::vector<unsigned char> settled(border.size());
  for (std::size_t i = 0; i < border.size(); ++i)
  {
    settled[i] = !border[i];
    if (border[i])
    {
      open.push_back(static_cast<Index>(i));
    }
  }
  // First those that have inner neighbours in several directions; then those, such as corners, that
  // have settled neighbours along the border; last those that have anything to go by.
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round)
  {
    FitRound(settled, normals, open,
      [&](Index point, Vector3d& normal)
      { return FitBorderNormal(mesh, settled, normals, round < rounds - 1, point, normal); });
  }
  // What is left has no inner points, such as the side of a cylinder in one row: there the points
  // along the border know how the surface turns along it, and its corners follow them.
  FitRound(settled, normals, open,
    [&](Index point, Vector3d& normal)
    {
      normal = normals[point].cast<double>();
      return !IsCorner(mesh, point);
    });
  for (int round = 0; round < 2; ++round)
  {
    FitRound(settled, normals, open,
      [&](Index point, Vector3d& normal)
      {
        return FitBorderNormal(mesh, settled, normals, true, point, normal) &&
          IsSampledAlike(mesh, settled, normals, point, normal);
      });
  }
}
}

//------------------------------------------------------------------------------
Tuples<3> ComputeNormals(const TriangleMesh& mesh, NormalWeights weights)
{
  Tuples<3> normals(mesh.GetNumberOfPoints());
  switch (weights)
  {
    case NormalWeights::Max:
      AddUpNormals<NormalWeights::Max>(mesh, normals);
      break;
    case NormalWeights::Area:
      AddUpNormals<NormalWeights::Area>(mesh, normals);
      break;
    case NormalWeights::Angle:
      AddUpNormals<NormalWeights::Angle>(mesh, normals);
      break;
  }
  FitBorderNormals(mesh, normals);
  return normals;
}

//------------------------------------------------------------------------------
Tuples<3> GetUnitNormals(const TriangleMesh& mesh, vtkDataArray* given)
{
  if (!given || given->GetNumberOfComponents() != 3 ||
    given->GetNumberOfTuples() != mesh.GetNumberOfPoints())
  {
    return ComputeNormals(mesh, NormalWeights::Max);
  }
  Tuples<3> normals = ReadTuples<3>(given);
  Tuples<3> computed;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const float squared = normals[i].squaredNorm();
    if (std::isfinite(squared) && squared > 1e-12f)
    {
      normals[i] /= std::sqrt(squared);
      continue;
    }
    if (computed.empty())
    {
      computed = ComputeNormals(mesh, NormalWeights::Max);
    }
    normals[i] = computed[i];
  }
  return normals;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> ComputeBorderPoints(const TriangleMesh& mesh)
{
  if (!mesh.GetBorder().empty())
  {
    return mesh.GetBorder();
  }
  std::vector<unsigned char> border(mesh.GetNumberOfPoints());
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        border[i] = mesh.IsBorderPoint(static_cast<Index>(i));
      }
    });
  return border;
}
}
