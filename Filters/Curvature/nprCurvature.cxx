// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCurvature.h"

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

/// The form of one triangle: UU, UV, VV in its frame, and the areas that it lends its corners.
struct FaceForm
{
  Eigen::Vector3f Components = Eigen::Vector3f::Zero();
  Eigen::Vector3f CornerAreas = Eigen::Vector3f::Zero();
};

//------------------------------------------------------------------------------
FaceForm FitForm(
  const TriangleMesh& mesh, const Tuples<3>& normals, const TriangleMesh::Triangle& corners)
{
  FaceForm form;
  const FaceFrame face(mesh, corners);
  if (!face.IsUsable)
  {
    return form;
  }
  // The normal equations of II (u, v) = (du, dv) over the three edges.
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
  Vector3d right = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
  {
    const double u = face.Edges[i].dot(face.Frame.U);
    const double v = face.Edges[i].dot(face.Frame.V);
    const Vector3d turn =
      (normals[corners[(i + 2) % 3]] - normals[corners[(i + 1) % 3]]).cast<double>();
    const double du = turn.dot(face.Frame.U);
    const double dv = turn.dot(face.Frame.V);
    uu += u * u;
    uv += u * v;
    vv += v * v;
    right += Vector3d(u * du, v * du + u * dv, v * dv);
  }
  const double sum = uu + vv;
  const double determinant = sum * (uu * vv - uv * uv);
  const Vector3d solution((sum * vv - uv * uv) * right[0] - uv * vv * right[1] + uv * uv * right[2],
    -uv * vv * right[0] + uu * vv * right[1] - uu * uv * right[2],
    uv * uv * right[0] - uu * uv * right[1] + (sum * uu - uv * uv) * right[2]);
  const Eigen::Vector3f components = (solution / determinant).cast<float>();
  if (components.allFinite())
  {
    form.Components = components;
    form.CornerAreas = face.GetCornerAreas().cast<float>();
  }
  return form;
}
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
  // dots[i] has the sign of the cosine of the angle at corner i.
  const Vector3d dots(-this->Edges[1].dot(this->Edges[2]), -this->Edges[2].dot(this->Edges[0]),
    -this->Edges[0].dot(this->Edges[1]));
  for (int i = 0; i < 3; ++i)
  {
    if (dots[i] < 0.0)
    {
      Vector3d areas = Vector3d::Constant(0.25 * this->Area);
      areas[i] = 0.5 * this->Area;
      return areas;
    }
  }
  const double scale = 0.0625 / this->Area; // 1/8 of cotangent = dot / (2 area)
  const Vector3d shares(dots[0] * this->Edges[0].squaredNorm() * scale,
    dots[1] * this->Edges[1].squaredNorm() * scale, dots[2] * this->Edges[2].squaredNorm() * scale);
  return { shares[1] + shares[2], shares[2] + shares[0], shares[0] + shares[1] };
}

//------------------------------------------------------------------------------
PrincipalFrame Diagonalise(const SymmetricTensor& tensor, const Vector3d& normal)
{
  const TangentFrame frame = MakeTangentFrame(normal);
  const Vector3d form = ToFrame(tensor, frame);
  // Half of the difference of the eigenvalues, and twice the angle of the direction of the larger.
  const double mean = 0.5 * (form[0] + form[2]);
  const double half = 0.5 * (form[0] - form[2]);
  const double radius = std::hypot(half, form[1]);
  const double angle = 0.5 * std::atan2(form[1], half);
  const Vector3d direction = std::cos(angle) * frame.U + std::sin(angle) * frame.V;
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
Tuples<6> ComputeCurvatureTensors(
  const TriangleMesh& mesh, const Tuples<3>& normals, std::vector<unsigned char>& unknown)
{
  std::vector<FaceForm> forms(mesh.GetNumberOfTriangles());
  vtkSMPTools::For(0, mesh.GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        forms[t] = FitForm(mesh, normals, mesh.GetTriangle(static_cast<Index>(t)));
      }
    });

  Tuples<6> tensors(mesh.GetNumberOfPoints());
  unknown.assign(mesh.GetNumberOfPoints(), 1);
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index point = static_cast<Index>(i);
        const Vector3d normal = normals[i].cast<double>();
        SymmetricTensor sum = SymmetricTensor::Zero();
        double area = 0.0;
        for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
        {
          const TriangleMesh::Triangle& corners = mesh.GetTriangle(*t);
          const int here = corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
          const double weight = forms[*t].CornerAreas[here];
          if (!(weight > 0.0))
          {
            continue;
          }
          const FaceFrame face(mesh, corners);
          const MinimalRotation rotation(face.GetNormalTowards(normal), normal);
          sum += weight * FromFrame(forms[*t].Components.cast<double>(), rotation(face.Frame));
          area += weight;
        }
        if (area > 0.0)
        {
          sum /= area;
          unknown[i] = 0;
        }
        tensors[i] = sum.cast<float>();
      }
    });
  return tensors;
}

//------------------------------------------------------------------------------
std::vector<float> ComputePointAreas(const TriangleMesh& mesh)
{
  std::vector<float> areas(mesh.GetNumberOfPoints());
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Index point = static_cast<Index>(i);
        double sum = 0.0;
        for (const Index* t = mesh.IncidentBegin(point); t != mesh.IncidentEnd(point); ++t)
        {
          const TriangleMesh::Triangle& corners = mesh.GetTriangle(*t);
          const FaceFrame face(mesh, corners);
          if (face.Area > 0.0)
          {
            sum += face.GetCornerAreas()[corners[0] == point ? 0 : (corners[1] == point ? 1 : 2)];
          }
        }
        areas[i] = static_cast<float>(sum);
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
