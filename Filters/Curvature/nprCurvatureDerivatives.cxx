// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCurvatureDerivatives.h"

#include "nprCurvature.h"
#include "nprSurfaceNormals.h"

#include <vtkSMPTools.h>

#include <array>
#include <cmath>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// The cubic form of one triangle in its frame, and the areas that it lends its corners.
struct FaceCubic
{
  Eigen::Vector4f Components = Eigen::Vector4f::Zero();
  Eigen::Vector3f CornerAreas = Eigen::Vector3f::Zero();
};

//------------------------------------------------------------------------------
FaceCubic FitCubic(const TriangleMesh& mesh, const Tuples<6>& tensors, const Tuples<3>& normals,
  const TriangleMesh::Triangle& corners)
{
  FaceCubic cubic;
  const FaceFrame face(mesh, corners);
  if (!face.IsUsable)
  {
    return cubic;
  }
  std::array<Vector3d, 3> forms;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3d normal = normals[corners[i]].cast<double>();
    const MinimalRotation rotation(face.GetNormalTowards(normal), normal);
    forms[i] = ToFrame(tensors[corners[i]].cast<double>(), rotation(face.Frame));
  }
  // The normal equations of C (u, v) = (duu, duv, dvv) over the edges are tridiagonal.
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
  Vector4d right = Vector4d::Zero();
  for (int i = 0; i < 3; ++i)
  {
    const double u = face.Edges[i].dot(face.Frame.U);
    const double v = face.Edges[i].dot(face.Frame.V);
    const Vector3d change = forms[(i + 2) % 3] - forms[(i + 1) % 3];
    uu += u * u;
    uv += u * v;
    vv += v * v;
    right += Vector4d(u * change[0], v * change[0] + 2.0 * u * change[1],
      2.0 * v * change[1] + u * change[2], v * change[2]);
  }
  Vector4d diagonal(uu, 2.0 * uu + vv, uu + 2.0 * vv, vv);
  const Vector3d off(uv, 2.0 * uv, uv);
  for (int i = 1; i < 4; ++i)
  {
    const double factor = off[i - 1] / diagonal[i - 1];
    diagonal[i] -= factor * off[i - 1];
    right[i] -= factor * right[i - 1];
  }
  Vector4d solution;
  solution[3] = right[3] / diagonal[3];
  for (int i = 2; i >= 0; --i)
  {
    solution[i] = (right[i] - off[i] * solution[i + 1]) / diagonal[i];
  }
  const Eigen::Vector4f components = solution.cast<float>();
  if (components.allFinite())
  {
    cubic.Components = components;
    cubic.CornerAreas = face.GetCornerAreas().cast<float>();
  }
  return cubic;
}

//------------------------------------------------------------------------------
/// Averages the triangles' forms at the points, and carries values on to points that have none.
class Averager
{
public:
  Averager(const TriangleMesh& mesh, const std::vector<FaceCubic>& cubics, const Tuples<3>& normals,
    const Tuples<3>& e1, const std::vector<unsigned char>& border)
    : Mesh(mesh), Cubics(cubics), Normals(normals), E1(e1), Border(border)
  {
  }

  TangentFrame GetFrame(Index point) const
  {
    const Vector3d a = this->E1[point].cast<double>();
    return { a, this->Normals[point].cast<double>().cross(a) };
  }

  /// The mean over the triangles, or only over those that do not touch a border. False without any.
  bool Average(Index point, bool touchingBorder, Eigen::Vector4f& mean) const
  {
    const Vector3d normal = this->Normals[point].cast<double>();
    const TangentFrame own = this->GetFrame(point);
    Vector4d sum = Vector4d::Zero();
    double area = 0.0;
    for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point); ++t)
    {
      const TriangleMesh::Triangle& corners = this->Mesh.GetTriangle(*t);
      const int here = corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
      const double weight = this->Cubics[*t].CornerAreas[here];
      if (!(weight > 0.0) ||
        (!touchingBorder &&
          (this->Border[corners[0]] || this->Border[corners[1]] || this->Border[corners[2]])))
      {
        continue;
      }
      const FaceFrame face(this->Mesh, corners);
      const MinimalRotation rotation(face.GetNormalTowards(normal), normal);
      sum +=
        weight * ChangeFrame(this->Cubics[*t].Components.cast<double>(), rotation(face.Frame), own);
      area += weight;
    }
    if (!(area > 0.0))
    {
      return false;
    }
    mean = (sum / area).cast<float>();
    return true;
  }

  /// The mean of the neighbours that have a value. False without any.
  bool Extend(Index point, const Tuples<4>& values, const std::vector<unsigned char>& known,
    Eigen::Vector4f& mean) const
  {
    const Vector3d normal = this->Normals[point].cast<double>();
    const TangentFrame own = this->GetFrame(point);
    Vector4d sum = Vector4d::Zero();
    int count = 0;
    for (const Index* t = this->Mesh.IncidentBegin(point); t != this->Mesh.IncidentEnd(point); ++t)
    {
      for (Index corner : this->Mesh.GetTriangle(*t))
      {
        const MinimalRotation rotation(this->Normals[corner].cast<double>(), normal);
        if (corner != point && known[corner] && rotation.IsValid())
        {
          sum += ChangeFrame(values[corner].cast<double>(), rotation(this->GetFrame(corner)), own);
          ++count;
        }
      }
    }
    if (count == 0)
    {
      return false;
    }
    mean = (sum / count).cast<float>();
    return true;
  }

private:
  const TriangleMesh& Mesh;
  const std::vector<FaceCubic>& Cubics;
  const Tuples<3>& Normals;
  const Tuples<3>& E1;
  const std::vector<unsigned char>& Border;
};
}

//------------------------------------------------------------------------------
Vector4d ChangeFrame(const Vector4d& cubic, const TangentFrame& from, const TangentFrame& to)
{
  const double u1 = to.U.dot(from.U);
  const double v1 = to.U.dot(from.V);
  const double u2 = to.V.dot(from.U);
  const double v2 = to.V.dot(from.V);
  // C(a, a, .) and so on, as pairs over (u, v).
  const double aau = cubic[0] * u1 * u1 + 2.0 * cubic[1] * u1 * v1 + cubic[2] * v1 * v1;
  const double aav = cubic[1] * u1 * u1 + 2.0 * cubic[2] * u1 * v1 + cubic[3] * v1 * v1;
  const double bbu = cubic[0] * u2 * u2 + 2.0 * cubic[1] * u2 * v2 + cubic[2] * v2 * v2;
  const double bbv = cubic[1] * u2 * u2 + 2.0 * cubic[2] * u2 * v2 + cubic[3] * v2 * v2;
  return { aau * u1 + aav * v1, aau * u2 + aav * v2, bbu * u1 + bbv * v1, bbu * u2 + bbv * v2 };
}

//------------------------------------------------------------------------------
Tuples<4> ComputeCurvatureDerivatives(
  const TriangleMesh& mesh, const Tuples<6>& tensors, const Tuples<3>& normals, const Tuples<3>& e1)
{
  std::vector<FaceCubic> cubics(mesh.GetNumberOfTriangles());
  vtkSMPTools::For(0, mesh.GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        cubics[t] = FitCubic(mesh, tensors, normals, mesh.GetTriangle(static_cast<Index>(t)));
      }
    });

  const std::vector<unsigned char> border = ComputeBorderPoints(mesh);
  const Averager averager(mesh, cubics, normals, e1, border);
  Tuples<4> values(mesh.GetNumberOfPoints(), Eigen::Vector4f::Zero());
  std::vector<unsigned char> known(mesh.GetNumberOfPoints(), 0);
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        known[i] = !border[i] && averager.Average(static_cast<Index>(i), false, values[i]);
      }
    });

  // From inside outwards: two rounds reach the border from where all triangles are inner ones. What
  // is then still open (narrow strips) has but the one-sided estimate.
  std::vector<Index> open;
  for (Index i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    if (!known[i])
    {
      open.push_back(i);
    }
  }
  for (int round = 0; round < 3 && !open.empty(); ++round)
  {
    Tuples<4> found(open.size(), Eigen::Vector4f::Zero());
    std::vector<unsigned char> done(open.size(), 0);
    vtkSMPTools::For(0, static_cast<vtkIdType>(open.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          done[i] = round < 2 ? averager.Extend(open[i], values, known, found[i])
                              : averager.Average(open[i], true, found[i]);
        }
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
  return values;
}
}
