// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFaceAverages.h"

#include "nprFaceFits.h"
#include "nprSurfaceNormals.h"

#include <vtkSMPTools.h>

#include <array>
#include <cmath>
#include <utility>

namespace npr
{
namespace
{
using Index = FaceAverages::Index;
using Eigen::Vector4f;

//------------------------------------------------------------------------------
int FindCorner(const TriangleMesh::Triangle& corners, Index point)
{
  return corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
}

//------------------------------------------------------------------------------
template<typename Function>
void ForAll(std::size_t size, const Function& function)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(size),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        function(static_cast<Index>(i));
      }
    });
}
}

//------------------------------------------------------------------------------
FaceAverages::FaceAverages(const TriangleMesh& mesh, const Tuples<3>& normals)
  : Mesh(mesh), Normals(normals), Parts(3 * mesh.GetTriangles().size())
{
}

//------------------------------------------------------------------------------
void FaceAverages::FitForms()
{
  ForAll(this->Mesh.GetTriangles().size(),
    [this](Index t)
    {
      const FaceShape face(this->Mesh, this->Mesh.GetTriangle(t));
      Vector4f* const parts = &this->Parts[3 * static_cast<std::size_t>(t)];
      if (!face.IsUsable)
      {
        std::fill_n(parts, 3, Vector4f::Zero());
        return;
      }
      const std::array<Eigen::Vector3f, 3> normals = { this->Normals[face.Points[0]],
        this->Normals[face.Points[1]], this->Normals[face.Points[2]] };
      const QuadraticForm form = face.FitQuadratic(normals[0], normals[1], normals[2]);
      const std::array<float, 3> areas = face.GetCornerAreas();
      for (int i = 0; i < 3; ++i)
      {
        const QuadraticForm turned = CornerTurning(face, normals[i]).ToPoint(form);
        parts[face.Slots[i]] =
          areas[i] * Vector4f(1.0f, turned.Mean, turned.Rest.Re, turned.Rest.Im);
      }
    });
}

//------------------------------------------------------------------------------
void FaceAverages::FitDerivatives(const Tuples<4>& forms, const std::vector<unsigned char>& border)
{
  this->TouchesBorder.resize(this->Mesh.GetTriangles().size());
  ForAll(this->Mesh.GetTriangles().size(),
    [&](Index t)
    {
      const TriangleMesh::Triangle& corners = this->Mesh.GetTriangle(t);
      this->TouchesBorder[t] = border[corners[0]] || border[corners[1]] || border[corners[2]];
      const FaceShape face(this->Mesh, corners);
      Vector4f* const parts = &this->Parts[3 * static_cast<std::size_t>(t)];
      if (!face.IsUsable)
      {
        std::fill_n(parts, 3, Vector4f::Zero());
        return;
      }
      const std::array<CornerTurning, 3> turnings = { CornerTurning(
                                                        face, this->Normals[face.Points[0]]),
        CornerTurning(face, this->Normals[face.Points[1]]),
        CornerTurning(face, this->Normals[face.Points[2]]) };
      const CubicForm cubic =
        face.FitCubic({ turnings[0].ToFace(ReadQuadratic(forms[face.Points[0]])),
          turnings[1].ToFace(ReadQuadratic(forms[face.Points[1]])),
          turnings[2].ToFace(ReadQuadratic(forms[face.Points[2]])) });
      const std::array<float, 3> areas = face.GetCornerAreas();
      for (int i = 0; i < 3; ++i)
      {
        const CubicForm turned = turnings[i].ToPoint(cubic);
        parts[face.Slots[i]] = areas[i] *
          Vector4f(turned.Gradient.Re, turned.Gradient.Im, turned.Rest.Re, turned.Rest.Im);
      }
    });
}

//------------------------------------------------------------------------------
Vector4f FaceAverages::AddUp(Index point) const
{
  Vector4f sum = Vector4f::Zero();
  for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point); ++t)
  {
    const int here = FindCorner(this->Mesh.GetTriangle(*t), point);
    sum += this->Parts[3 * static_cast<std::size_t>(*t) + here];
  }
  return sum;
}

//------------------------------------------------------------------------------
Tuples<4> FaceAverages::AverageForms()
{
  this->FitForms();
  Tuples<4> forms(this->Mesh.GetNumberOfPoints());
  ForAll(forms.size(),
    [&](Index i)
    {
      const Vector4f sum = this->AddUp(i);
      const bool isKnown = sum[0] > 0.0f && sum.allFinite();
      forms[i] = isKnown ? Vector4f(sum / sum[0]) : Vector4f::Zero();
      forms[i][0] = isKnown ? sum[0] : 0.0f;
    });
  return forms;
}

//------------------------------------------------------------------------------
Tuples<4> FaceAverages::AverageDerivatives(const Tuples<4>& forms)
{
  const std::vector<unsigned char> border = ComputeBorderPoints(this->Mesh);
  this->FitDerivatives(forms, border);
  Tuples<4> values(forms.size());
  std::vector<unsigned char> known(forms.size());
  ForAll(forms.size(),
    [&](Index i)
    {
      const Index* const begin = this->Mesh.IncidentBegin(i);
      const Index* const end = this->Mesh.IncidentEnd(i);
      const bool isInner =
        std::none_of(begin, end, [&](Index t) { return this->TouchesBorder[t]; });
      known[i] = isInner ? forms[i][0] > 0.0f : !border[i] && this->Average(i, false, values[i]);
      if (!known[i])
      {
        values[i].setZero();
      }
      else if (isInner)
      {
        values[i] = this->AddUp(i) / forms[i][0];
      }
    });
  std::vector<Index> open;
  for (Index i = 0; i < this->Mesh.GetNumberOfPoints(); ++i)
  {
    if (!known[i])
    {
      open.push_back(i);
    }
  }
  this->FillBorder(std::move(open), known, values);
  return values;
}

//------------------------------------------------------------------------------
/// From inside outwards: two rounds reach the border from where all triangles are inner ones. What
/// is then still open (narrow strips) has but the one-sided estimate.
void FaceAverages::FillBorder(
  std::vector<Index> open, std::vector<unsigned char>& known, Tuples<4>& values) const
{
  for (int round = 0; round < 3 && !open.empty(); ++round)
  {
    Tuples<4> found(open.size());
    std::vector<unsigned char> done(open.size());
    ForAll(open.size(),
      [&](Index i)
      {
        done[i] = round < 2 ? this->Extend(open[i], values, known, found[i])
                            : this->Average(open[i], true, found[i]);
      });
    std::vector<Index> left;
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      if (done[i])
      {
        values[open[i]] = found[i];
        known[open[i]] = 1;
      }
      else
      {
        left.push_back(open[i]);
      }
    }
    open.swap(left);
  }
}

//------------------------------------------------------------------------------
/// The mean over the triangles, or only over those that do not touch a border. False without any.
bool FaceAverages::Average(Index point, bool touchingBorder, Vector4f& mean) const
{
  Vector4f sum = Vector4f::Zero();
  float area = 0.0f;
  for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point); ++t)
  {
    const TriangleMesh::Triangle& corners = this->Mesh.GetTriangle(*t);
    const FaceShape face(this->Mesh, corners);
    if (face.IsUsable && (touchingBorder || !this->TouchesBorder[*t]))
    {
      sum += this->Parts[3 * static_cast<std::size_t>(*t) + FindCorner(corners, point)];
      area += face.GetCornerAreas()[FindCorner(face.Points, point)];
    }
  }
  mean = sum / area;
  return area > 0.0f && mean.allFinite();
}

//------------------------------------------------------------------------------
/// The mean of the neighbours that have a value. False without any.
bool FaceAverages::Extend(Index point, const Tuples<4>& values,
  const std::vector<unsigned char>& known, Vector4f& mean) const
{
  const Eigen::Vector3d normal = this->Normals[point].cast<double>();
  const TangentFrame own = MakeTangentFrame(normal);
  Vector4f sum = Vector4f::Zero();
  int count = 0;
  for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point); ++t)
  {
    for (Index corner : this->Mesh.GetTriangle(*t))
    {
      const Eigen::Vector3d other = this->Normals[corner].cast<double>();
      const MinimalRotation rotation(other, normal);
      if (corner != point && known[corner] && rotation.IsValid())
      {
        const Eigen::Vector3d u = rotation(MakeTangent(other));
        const Complex once = { static_cast<float>(u.dot(own.U)), static_cast<float>(u.dot(own.V)) };
        const Complex gradient = once * Complex{ values[corner][0], values[corner][1] };
        const Complex rest = once * once * once * Complex{ values[corner][2], values[corner][3] };
        sum += Vector4f(gradient.Re, gradient.Im, rest.Re, rest.Im);
        ++count;
      }
    }
  }
  mean = sum / static_cast<float>(std::max(count, 1));
  return count > 0;
}
}
