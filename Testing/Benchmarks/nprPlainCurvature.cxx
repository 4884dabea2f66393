// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPlainCurvature.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace nprbench
{
namespace
{
using Vector = PlainMesh::Vector;

/// UU, UV, VV of a symmetric form, and UUU, UUV, UVV, VVV of a cubic one.
using Form = std::array<float, 3>;
using Cubic = std::array<float, 4>;

struct Frame
{
  Vector U;
  Vector V;
};

struct Corners
{
  std::array<Vector, 3> Edges; // opposite the corners
  Frame Axes;

  Corners(const PlainMesh& mesh, const PlainMesh::Triangle& t)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Edges[i] = mesh.Points[t[(i + 2) % 3]] - mesh.Points[t[(i + 1) % 3]];
    }
    this->Axes.U = this->Edges[0].normalized();
    const Vector normal = this->Edges[0].cross(this->Edges[1]);
    this->Axes.V = normal.cross(this->Axes.U).normalized();
  }
};

//------------------------------------------------------------------------------
/// The frame turned into the plane that has this normal, about the line where the planes meet.
Frame Turn(const Frame& frame, const Vector& normal)
{
  const Vector old = frame.U.cross(frame.V);
  const float cosine = old.dot(normal);
  if (cosine <= -1.0f)
  {
    return { -frame.U, -frame.V };
  }
  const Vector across = normal - cosine * old;
  const Vector change = (old + normal) / (1.0f + cosine);
  return { frame.U - change * frame.U.dot(across), frame.V - change * frame.V.dot(across) };
}

//------------------------------------------------------------------------------
Form ChangeFrame(const Form& f, const Frame& from, const Frame& to)
{
  const Frame turned = Turn(to, from.U.cross(from.V));
  const float u1 = turned.U.dot(from.U);
  const float v1 = turned.U.dot(from.V);
  const float u2 = turned.V.dot(from.U);
  const float v2 = turned.V.dot(from.V);
  return { f[0] * u1 * u1 + f[1] * 2.0f * u1 * v1 + f[2] * v1 * v1,
    f[0] * u1 * u2 + f[1] * (u1 * v2 + u2 * v1) + f[2] * v1 * v2,
    f[0] * u2 * u2 + f[1] * 2.0f * u2 * v2 + f[2] * v2 * v2 };
}

//------------------------------------------------------------------------------
Cubic ChangeFrame(const Cubic& c, const Frame& from, const Frame& to)
{
  const Frame turned = Turn(to, from.U.cross(from.V));
  const float u1 = turned.U.dot(from.U);
  const float v1 = turned.U.dot(from.V);
  const float u2 = turned.V.dot(from.U);
  const float v2 = turned.V.dot(from.V);
  const float uu1 = u1 * u1;
  const float uu2 = u2 * u2;
  const float vv1 = v1 * v1;
  const float vv2 = v2 * v2;
  const float uv1 = u1 * v1;
  const float uv2 = u2 * v2;
  return { c[0] * uu1 * u1 + 3.0f * (c[1] * uu1 * v1 + c[2] * u1 * vv1) + c[3] * vv1 * v1,
    c[0] * uu1 * u2 + c[1] * (uu1 * v2 + 2.0f * u2 * uv1) + c[2] * (u2 * vv1 + 2.0f * uv1 * v2) +
      c[3] * vv1 * v2,
    c[0] * u1 * uu2 + c[1] * (uu2 * v1 + 2.0f * u1 * uv2) + c[2] * (u1 * vv2 + 2.0f * uv2 * v1) +
      c[3] * v1 * vv2,
    c[0] * uu2 * u2 + 3.0f * (c[1] * uu2 * v2 + c[2] * u2 * vv2) + c[3] * vv2 * v2 };
}

//------------------------------------------------------------------------------
/// Solves a symmetric positive system by Cholesky's decomposition L D L'; false if it is singular.
template<int Size>
bool Solve(float a[Size][Size], std::array<float, Size>& x)
{
  for (int i = 0; i < Size; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      float sum = a[i][j];
      for (int k = 0; k < j; ++k)
      {
        sum -= a[i][k] * a[k][k] * a[j][k];
      }
      a[i][j] = sum / a[j][j];
      a[i][i] -= a[i][j] * a[i][j] * a[j][j];
    }
    if (!(a[i][i] > 0.0f))
    {
      return false;
    }
    for (int j = 0; j < i; ++j)
    {
      x[i] -= a[i][j] * x[j];
    }
  }
  for (int i = Size - 1; i >= 0; --i)
  {
    x[i] /= a[i][i];
    for (int j = i + 1; j < Size; ++j)
    {
      x[i] -= a[j][i] * x[j];
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
void PlainMesh::ComputeNormals()
{
  this->Normals.assign(this->Points.size(), Vector::Zero());
  for (const Triangle& t : this->Triangles)
  {
    const Vector a = this->Points[t[0]] - this->Points[t[1]];
    const Vector b = this->Points[t[1]] - this->Points[t[2]];
    const Vector c = this->Points[t[2]] - this->Points[t[0]];
    const float aa = a.squaredNorm();
    const float bb = b.squaredNorm();
    const float cc = c.squaredNorm();
    if (aa > 0.0f && bb > 0.0f && cc > 0.0f)
    {
      const Vector normal = a.cross(b);
      this->Normals[t[0]] += normal / (aa * cc);
      this->Normals[t[1]] += normal / (bb * aa);
      this->Normals[t[2]] += normal / (cc * bb);
    }
  }
  for (Vector& normal : this->Normals)
  {
    normal.normalize();
  }
}

//------------------------------------------------------------------------------
void PlainMesh::ComputeAdjacency()
{
  std::vector<int> counts(this->Points.size(), 0);
  for (const Triangle& t : this->Triangles)
  {
    for (int corner : t)
    {
      ++counts[corner];
    }
  }
  this->AdjacentTriangles.resize(this->Points.size());
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    this->AdjacentTriangles[i].reserve(counts[i]);
  }
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int corner : this->Triangles[t])
    {
      this->AdjacentTriangles[corner].push_back(static_cast<int>(t));
    }
  }
  this->Neighbours.assign(this->Triangles.size(), { -1, -1, -1 });
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int from = this->Triangles[t][(i + 1) % 3];
      const int to = this->Triangles[t][(i + 2) % 3];
      for (int other : this->AdjacentTriangles[from])
      {
        // Across the edge it runs the other way.
        const Triangle& o = this->Triangles[other];
        if ((o[0] == to && o[1] == from) || (o[1] == to && o[2] == from) ||
          (o[2] == to && o[0] == from))
        {
          this->Neighbours[t][i] = other;
          break;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void PlainMesh::ComputeAreas()
{
  this->PointAreas.assign(this->Points.size(), 0.0f);
  this->CornerAreas.assign(this->Triangles.size(), {});
  for (std::size_t f = 0; f < this->Triangles.size(); ++f)
  {
    const Triangle& t = this->Triangles[f];
    const Vector e[3] = { this->Points[t[2]] - this->Points[t[1]],
      this->Points[t[0]] - this->Points[t[2]], this->Points[t[1]] - this->Points[t[0]] };
    const float area = 0.5f * e[0].cross(e[1]).norm();
    const float dots[3] = { -e[1].dot(e[2]), -e[2].dot(e[0]), -e[0].dot(e[1]) };
    std::array<float, 3>& areas = this->CornerAreas[f];
    if (dots[0] <= 0.0f || dots[1] <= 0.0f || dots[2] <= 0.0f)
    {
      for (int i = 0; i < 3; ++i)
      {
        areas[i] = (dots[i] <= 0.0f ? 0.5f : 0.25f) * area;
      }
    }
    else
    {
      float shares[3];
      for (int i = 0; i < 3; ++i)
      {
        shares[i] = e[i].squaredNorm() * dots[i] / (16.0f * area);
      }
      areas = { shares[1] + shares[2], shares[2] + shares[0], shares[0] + shares[1] };
    }
    for (int i = 0; i < 3; ++i)
    {
      this->PointAreas[t[i]] += areas[i];
    }
  }
}

//------------------------------------------------------------------------------
void PlainMesh::ComputeCurvature()
{
  const std::size_t size = this->Points.size();
  this->E1.resize(size);
  this->E2.resize(size);
  this->K1.assign(size, 0.0f);
  this->K2.assign(size, 0.0f);
  std::vector<float> mixed(size, 0.0f);
  for (const Triangle& t : this->Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->E1[t[i]] = this->Points[t[(i + 1) % 3]] - this->Points[t[i]];
    }
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    this->E1[i] = this->E1[i].cross(this->Normals[i]).normalized();
    this->E2[i] = this->Normals[i].cross(this->E1[i]);
  }

  for (std::size_t f = 0; f < this->Triangles.size(); ++f)
  {
    const Triangle& t = this->Triangles[f];
    const Corners corners(*this, t);
    // II over (u, v): three unknowns, two equations for each edge.
    float matrix[3][3] = {};
    Form form{};
    for (int i = 0; i < 3; ++i)
    {
      const float u = corners.Edges[i].dot(corners.Axes.U);
      const float v = corners.Edges[i].dot(corners.Axes.V);
      const Vector change = this->Normals[t[(i + 2) % 3]] - this->Normals[t[(i + 1) % 3]];
      const float du = change.dot(corners.Axes.U);
      const float dv = change.dot(corners.Axes.V);
      matrix[0][0] += u * u;
      matrix[1][0] += u * v;
      matrix[2][2] += v * v;
      form[0] += u * du;
      form[1] += v * du + u * dv;
      form[2] += v * dv;
    }
    matrix[1][1] = matrix[0][0] + matrix[2][2];
    matrix[2][1] = matrix[1][0];
    if (!Solve<3>(matrix, form))
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      const int point = t[i];
      const Form own = ChangeFrame(form, corners.Axes, { this->E1[point], this->E2[point] });
      const float weight = this->CornerAreas[f][i] / this->PointAreas[point];
      this->K1[point] += weight * own[0];
      mixed[point] += weight * own[1];
      this->K2[point] += weight * own[2];
    }
  }

  for (std::size_t i = 0; i < size; ++i)
  {
    // Jacobi's rotation makes the form diagonal.
    float c = 1.0f;
    float s = 0.0f;
    float tangent = 0.0f;
    if (mixed[i] != 0.0f)
    {
      const float half = 0.5f * (this->K2[i] - this->K1[i]) / mixed[i];
      tangent = std::copysign(1.0f / (std::abs(half) + std::sqrt(1.0f + half * half)), half);
      c = 1.0f / std::sqrt(1.0f + tangent * tangent);
      s = tangent * c;
    }
    this->K1[i] -= tangent * mixed[i];
    this->K2[i] += tangent * mixed[i];
    Vector first = c * this->E1[i] - s * this->E2[i];
    if (std::abs(this->K1[i]) < std::abs(this->K2[i]))
    {
      std::swap(this->K1[i], this->K2[i]);
      first = s * this->E1[i] + c * this->E2[i];
    }
    this->E1[i] = first;
    this->E2[i] = this->Normals[i].cross(first);
  }
}

//------------------------------------------------------------------------------
void PlainMesh::ComputeDerivatives()
{
  this->Derivatives.assign(this->Points.size(), {});
  for (std::size_t f = 0; f < this->Triangles.size(); ++f)
  {
    const Triangle& t = this->Triangles[f];
    const Corners corners(*this, t);
    Form forms[3];
    for (int i = 0; i < 3; ++i)
    {
      forms[i] = ChangeFrame(Form{ this->K1[t[i]], 0.0f, this->K2[t[i]] },
        { this->E1[t[i]], this->E2[t[i]] }, corners.Axes);
    }
    // C over (u, v): four unknowns, four equations (of which two are equal) for each edge.
    float matrix[4][4] = {};
    Cubic cubic{};
    for (int i = 0; i < 3; ++i)
    {
      const float u = corners.Edges[i].dot(corners.Axes.U);
      const float v = corners.Edges[i].dot(corners.Axes.V);
      const Form& last = forms[(i + 2) % 3];
      const Form& first = forms[(i + 1) % 3];
      const float change[3] = { last[0] - first[0], last[1] - first[1], last[2] - first[2] };
      matrix[0][0] += u * u;
      matrix[1][0] += u * v;
      matrix[3][3] += v * v;
      cubic[0] += u * change[0];
      cubic[1] += v * change[0] + 2.0f * u * change[1];
      cubic[2] += 2.0f * v * change[1] + u * change[2];
      cubic[3] += v * change[2];
    }
    matrix[1][1] = 2.0f * matrix[0][0] + matrix[3][3];
    matrix[2][2] = matrix[0][0] + 2.0f * matrix[3][3];
    matrix[2][1] = 2.0f * matrix[1][0];
    matrix[3][2] = matrix[1][0];
    if (!Solve<4>(matrix, cubic))
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      const int point = t[i];
      const Cubic own = ChangeFrame(cubic, corners.Axes, { this->E1[point], this->E2[point] });
      const float weight = this->CornerAreas[f][i] / this->PointAreas[point];
      for (int k = 0; k < 4; ++k)
      {
        this->Derivatives[point][k] += weight * own[k];
      }
    }
  }
}

//------------------------------------------------------------------------------
void PlainMesh::Clear()
{
  PlainMesh bare;
  bare.Points.swap(this->Points);
  bare.Triangles.swap(this->Triangles);
  *this = std::move(bare);
}
}
