// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfaceNormals.h"

#include <vtkSMPTools.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

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
Vector3d ComputeNormal(const TriangleMesh& mesh, NormalWeights weights, Index point)
{
  const Vector3d p = Corner(mesh, point);
  Vector3d sum = Vector3d::Zero();
  Vector3d largest = Vector3d::Zero();
  double magnitude = 0.0;
  for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
  {
    const TriangleMesh::Triangle& corners = mesh.GetTriangle(*t);
    const int here = corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
    const Vector3d a = Corner(mesh, corners[(here + 1) % 3]) - p;
    const Vector3d b = Corner(mesh, corners[(here + 2) % 3]) - p;
    const Vector3d area = a.cross(b);
    const double squaredArea = area.squaredNorm();
    if (!(squaredArea > 0.0))
    {
      continue;
    }
    double weight = 1.0;
    if (weights == NormalWeights::Max)
    {
      weight = 1.0 / (a.squaredNorm() * b.squaredNorm());
    }
    else if (weights == NormalWeights::Angle)
    {
      const double length = std::sqrt(squaredArea);
      weight = std::atan2(length, a.dot(b)) / length;
    }
    sum += weight * area;
    magnitude += weight * weight * squaredArea;
    if (squaredArea > largest.squaredNorm())
    {
      largest = area;
    }
  }
  // Where the triangles cancel each other the direction of the sum is rounding noise.
  if (sum.squaredNorm() > 1e-16 * magnitude)
  {
    return sum.normalized();
  }
  return largest.squaredNorm() > 0.0 ? largest.normalized() : Vector3d::UnitZ();
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
    std::vector<unsigned char> done(open.size(), 0);
    Tuples<3> fitted(open.size());
    vtkSMPTools::For(0, static_cast<vtkIdType>(open.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          Vector3d normal;
          done[i] = FitBorderNormal(mesh, settled, normals, round < rounds - 1, open[i], normal);
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
}
}

//------------------------------------------------------------------------------
Tuples<3> ComputeNormals(const TriangleMesh& mesh, NormalWeights weights)
{
  Tuples<3> normals(mesh.GetNumberOfPoints());
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        normals[i] = ComputeNormal(mesh, weights, static_cast<Index>(i)).cast<float>();
      }
    });
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
