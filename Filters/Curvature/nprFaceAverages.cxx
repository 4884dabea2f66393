// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFaceAverages.h"

#include "nprFaceBatch.h"
#include "nprFaceFits.h"
#include "nprForAll.h"
#include "nprSurfaceNormals.h"
#include "nprTangentFrame.h"

#include <vtkSMPTools.h>

#include <algorithm>
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

/// Calls `work(batch, begin, end)` for all triangles.
template<typename Work>
void ForBatches(const TriangleMesh& mesh, const Work& work)
{
  vtkSMPTools::For(0, mesh.GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      FaceBatch batch(mesh);
      for (vtkIdType t = begin; t < end; t += FaceBatch::Capacity)
      {
        work(batch, static_cast<Index>(t),
          static_cast<Index>(std::min<vtkIdType>(end, t + FaceBatch::Capacity)));
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
  const auto read = [this](Index point, FaceBatch::Row* values, int i)
  {
    const Eigen::Vector3f& normal = this->Normals[point];
    values[0][i] = normal.x();
    values[1][i] = normal.y();
    values[2][i] = normal.z();
  };
  ForBatches(this->Mesh,
    [&](FaceBatch& batch, Index begin, Index end)
    {
      batch.Fill(begin, end, read);
      batch.ForLanes(
        [&](const std::array<Vector3<Lanes>, 3>& points, int i)
        {
          const FaceShape<Lanes> face(points);
          const std::array<Vector3<Lanes>, 3> normals = { FaceBatch::LoadVector(
                                                            batch.GetValues(0), i),
            FaceBatch::LoadVector(batch.GetValues(1), i),
            FaceBatch::LoadVector(batch.GetValues(2), i) };
          const QuadraticForm<Lanes> form = face.FitQuadratic(normals);
          const std::array<Lanes, 3> areas = face.GetCornerAreas();
          for (int c = 0; c < 3; ++c)
          {
            const QuadraticForm<Lanes> own = CornerTurning<Lanes>(face, normals[c]).ToPoint(form);
            batch.SetPart(c, i,
              { areas[c], face.IfUsable(areas[c] * own.Mean), face.IfUsable(areas[c] * own.Rest.Re),
                face.IfUsable(areas[c] * own.Rest.Im) });
          }
        });
      batch.Write(this->Parts);
    });
}

//------------------------------------------------------------------------------
void FaceAverages::FitDerivatives(const Tuples<4>& forms, const std::vector<unsigned char>& border)
{
  this->TouchesBorder.resize(this->Mesh.GetTriangles().size());
  const auto read = [&](Index point, FaceBatch::Row* values, int i)
  {
    const Eigen::Vector3f& normal = this->Normals[point];
    const Vector4f& form = forms[point];
    values[0][i] = normal.x();
    values[1][i] = normal.y();
    values[2][i] = normal.z();
    values[3][i] = form[1];
    values[4][i] = form[2];
    values[5][i] = form[3];
  };
  ForBatches(this->Mesh,
    [&](FaceBatch& batch, Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const TriangleMesh::Triangle& corners = this->Mesh.GetTriangle(t);
        this->TouchesBorder[t] = border[corners[0]] || border[corners[1]] || border[corners[2]];
      }
      batch.Fill(begin, end, read);
      batch.ForLanes(
        [&](const std::array<Vector3<Lanes>, 3>& points, int i)
        {
          const FaceShape<Lanes> face(points);
          const auto turning = [&](int c)
          { return CornerTurning<Lanes>(face, FaceBatch::LoadVector(batch.GetValues(c), i)); };
          const std::array<CornerTurning<Lanes>, 3> turnings = { turning(0), turning(1),
            turning(2) };
          const auto form = [&](int c)
          {
            const Vector3<Lanes> own = FaceBatch::LoadVector(batch.GetValues(c) + 3, i);
            return turnings[c].ToFace(QuadraticForm<Lanes>{ own.X, { own.Y, own.Z } });
          };
          const CubicForm<Lanes> cubic = face.FitCubic({ form(0), form(1), form(2) });
          const std::array<Lanes, 3> areas = face.GetCornerAreas();
          for (int c = 0; c < 3; ++c)
          {
            const CubicForm<Lanes> own = turnings[c].ToPoint(cubic);
            batch.SetPart(c, i,
              { face.IfUsable(areas[c] * own.Gradient.Re),
                face.IfUsable(areas[c] * own.Gradient.Im), face.IfUsable(areas[c] * own.Rest.Re),
                face.IfUsable(areas[c] * own.Rest.Im) });
          }
        });
      batch.Write(this->Parts);
    });
}

//------------------------------------------------------------------------------
Vector4f FaceAverages::AddUp(Index point) const
{
  Vector4f sum = Vector4f::Zero();
  for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point); ++t)
  {
    // Without this most of the time would go by in waiting for memory: triangles at a point may lie
    // anywhere.
    const Index later = t[TriangleMesh::LookAhead];
    Prefetch(&this->Mesh.GetTriangles()[later]);
    Prefetch(&this->Parts[3 * static_cast<std::size_t>(later)]);
    Prefetch(&this->Parts[3 * static_cast<std::size_t>(later) + 2]);
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
    if (!touchingBorder && this->TouchesBorder[*t])
    {
      continue;
    }
    const int here = FindCorner(corners, point);
    const std::array<TriangleMesh::Vector, 3> positions = GetPositions(this->Mesh, corners);
    const std::array<int, 3> order = FindOrder(positions);
    std::array<Vector3<float>, 3> points;
    for (int c = 0; c < 3; ++c)
    {
      const TriangleMesh::Vector& position = positions[order[c]];
      points[c] = { position.x(), position.y(), position.z() };
    }
    const std::array<float, 3> areas = FaceShape<float>(points).GetCornerAreas();
    sum += this->Parts[3 * static_cast<std::size_t>(*t) + here];
    area += areas[std::find(order.begin(), order.end(), here) - order.begin()];
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
        const Complex<float> once = { static_cast<float>(u.dot(own.U)),
          static_cast<float>(u.dot(own.V)) };
        const Complex<float> gradient =
          once * Complex<float>{ values[corner][0], values[corner][1] };
        const Complex<float> rest =
          once * once * once * Complex<float>{ values[corner][2], values[corner][3] };
        sum += Vector4f(gradient.Re, gradient.Im, rest.Re, rest.Im);
        ++count;
      }
    }
  }
  mean = sum / static_cast<float>(std::max(count, 1));
  return count > 0;
}
}
