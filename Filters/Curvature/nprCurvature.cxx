// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCurvature.h"

#include "nprCornerAreas.h"

#include <vtkSMPTools.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Vector3d;
}

//------------------------------------------------------------------------------
FaceFrame::FaceFrame(const TriangleMesh& mesh, const TriangleMesh::Triangle& corners)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Edges[i] = mesh.GetPoint(corners[(i + 2) % 3]).cast<double>() -
      mesh.GetPoint(corners[(i + 1) % 3]).cast<double>();
  }
  this->Normal = this->Edges[0].cross(this->Edges[1]);
  const double length = this->Normal.norm();
  this->Area = 0.5 * length;
  const double longest = std::max(
    { this->Edges[0].squaredNorm(), this->Edges[1].squaredNorm(), this->Edges[2].squaredNorm() });
  // A height below 1e-6 of the longest edge is within the rounding of single precision points.
  this->IsUsable = length > 1e-6 * longest;
  if (this->IsUsable)
  {
    this->Normal /= length;
    this->Frame.U = this->Edges[0].normalized();
    this->Frame.V = this->Normal.cross(this->Frame.U);
  }
}

//------------------------------------------------------------------------------
Vector3d FaceFrame::GetCornerAreas() const
{
  const auto& e = this->Edges;
  const std::array<double, 3> areas =
    ComputeCornerAreas<double>({ -e[1].dot(e[2]), -e[2].dot(e[0]), -e[0].dot(e[1]) },
      { e[0].squaredNorm(), e[1].squaredNorm(), e[2].squaredNorm() }, 2.0 * this->Area);
  return { areas[0], areas[1], areas[2] };
}

//------------------------------------------------------------------------------
PrincipalFrame Diagonalise(const SymmetricTensor& tensor, const Vector3d& normal)
{
  const TangentFrame frame = MakeTangentFrame(normal);
  const Vector3d form = ToFrame(tensor, frame);
  // Half of the difference of the eigenvalues, and the direction of the larger: at half the angle
  // of (half, form[1]), by the half-angle formulas, of which one divides by what is not small.
  const double mean = 0.5 * (form[0] + form[2]);
  const double half = 0.5 * (form[0] - form[2]);
  const double radius = std::sqrt(half * half + form[1] * form[1]);
  const double longer = std::sqrt(0.5 * (radius + std::abs(half)));
  const double shorter = longer > 0.0 ? 0.5 * std::abs(form[1]) / longer : 0.0;
  const double scale = longer > 0.0 ? 1.0 / std::sqrt(radius) : 1.0;
  const double u = longer > 0.0 ? (half >= 0.0 ? longer : shorter) : 1.0;
  const double v = std::copysign(half >= 0.0 ? shorter : longer, form[1]);
  const Vector3d direction = scale * (u * frame.U + v * frame.V);
  PrincipalFrame principal;
  principal.K1 = mean + radius;
  principal.K2 = mean - radius;
  principal.E1 = direction;
  if (std::abs(principal.K1) < std::abs(principal.K2))
  {
    std::swap(principal.K1, principal.K2);
    principal.E1 = normal.cross(direction);
  }
  principal.E2 = normal.cross(principal.E1);
  return principal;
}

//------------------------------------------------------------------------------
std::vector<float> ComputePointAreas(const TriangleMesh& mesh)
{
  Tuples<3> shares(mesh.GetTriangles().size());
  const float perUnit = 1.0f / mesh.GetUnit();
  vtkSMPTools::For(0, mesh.GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        const TriangleMesh::Triangle& corners = mesh.GetTriangle(static_cast<Index>(t));
        const Eigen::Vector3f a = (mesh.GetPoint(corners[1]) - mesh.GetPoint(corners[0])) * perUnit;
        const Eigen::Vector3f b = (mesh.GetPoint(corners[2]) - mesh.GetPoint(corners[0])) * perUnit;
        const float aa = a.squaredNorm();
        const float bb = b.squaredNorm();
        const float ab = a.dot(b);
        const float doubleArea = a.cross(b).norm();
        shares[t].setZero();
        if (doubleArea > 0.0f)
        {
          const auto areas = ComputeCornerAreas<float>(
            { ab, aa - ab, bb - ab }, { (b - a).squaredNorm(), bb, aa }, doubleArea);
          shares[t] = { areas[0], areas[1], areas[2] };
        }
      }
    });
  std::vector<float> areas(mesh.GetNumberOfPoints());
  const float squareUnit = mesh.GetUnit() * mesh.GetUnit();
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index point = static_cast<Index>(i);
        float sum = 0.0f;
        for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
        {
          const TriangleMesh::Triangle& corners = mesh.GetTriangle(*t);
          sum += shares[*t][corners[0] == point ? 0 : (corners[1] == point ? 1 : 2)];
        }
        areas[i] = sum * squareUnit;
      }
    });
  return areas;
}

//------------------------------------------------------------------------------
PrincipalFrames ComputePrincipalFrames(const Tuples<6>& tensors, const Tuples<3>& normals)
{
  const std::size_t size = tensors.size();
  PrincipalFrames frames{ std::vector<float>(size), std::vector<float>(size), Tuples<3>(size),
    Tuples<3>(size) };
  vtkSMPTools::For(0, static_cast<vtkIdType>(size),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const PrincipalFrame frame =
          Diagonalise(tensors[i].cast<double>(), normals[i].cast<double>());
        frames.K1[i] = static_cast<float>(frame.K1);
        frames.K2[i] = static_cast<float>(frame.K2);
        frames.E1[i] = frame.E1.cast<float>();
        frames.E2[i] = frame.E2.cast<float>();
      }
    });
  return frames;
}
}
