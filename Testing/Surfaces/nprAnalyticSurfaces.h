// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprAnalyticSurfaces.h
 * @brief Meshes of surfaces whose normals, curvatures and derivatives are known by formula.
 */
#ifndef nprAnalyticSurfaces_h
#define nprAnalyticSurfaces_h

#include "nprChecks.h"
#include "nprSurfaceTruths.h"
#include "nprTangentFrame.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <vector>

namespace nprtest
{
using Parametrisation = std::function<Truth(double u, double v)>;

struct AnalyticSurface
{
  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<Truth> Truths;
};

/// A surface over a rectangle of parameters, u x v pointing outward. Where it closes in a
/// direction, the end of the range is its beginning.
struct ParametricSurface
{
  Parametrisation At;
  std::array<double, 4> Range; // u0, u1, v0, v1
  bool ClosesInU = false;
  bool ClosesInV = false;
};

/// How far parameters stray from those of the grid: evenly up to Amount of a cell, either way. What
/// lies on a border moves along it only.
struct Jitter
{
  double Amount = 0.0;
  unsigned int Seed = 1;
};

/// A grid of nu x nv cells, each parted by the same diagonal. The points are in double precision.
inline AnalyticSurface MakeSurface(
  const ParametricSurface& surface, int nu, int nv, const Jitter& jitter = Jitter())
{
  AnalyticSurface result;
  result.Mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  const int rows = nu + (surface.ClosesInU ? 0 : 1);
  const int columns = nv + (surface.ClosesInV ? 0 : 1);
  const auto& range = surface.Range;
  std::mt19937 random(jitter.Seed);
  const auto stray = [&](int i, int count, bool closes)
  {
    const double offset = jitter.Amount * (random() / 2147483648.0 - 1.0);
    return closes || (i > 0 && i < count) ? i + offset : i;
  };
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      const double u = stray(i, nu, surface.ClosesInU) / nu;
      const double v = stray(j, nv, surface.ClosesInV) / nv;
      result.Truths.push_back(
        surface.At(range[0] + (range[1] - range[0]) * u, range[2] + (range[3] - range[2]) * v));
      points->InsertNextPoint(result.Truths.back().Point.data());
    }
  }
  for (int i = 0; i < nu; ++i)
  {
    for (int j = 0; j < nv; ++j)
    {
      const int i1 = (i + 1) % rows;
      const int j1 = (j + 1) % columns;
      const vtkIdType a = i * columns + j;
      const vtkIdType b = i1 * columns + j;
      const vtkIdType c = i1 * columns + j1;
      const vtkIdType d = i * columns + j1;
      const vtkIdType lower[3] = { a, b, c };
      const vtkIdType upper[3] = { a, c, d };
      cells->InsertNextCell(3, lower);
      cells->InsertNextCell(3, upper);
    }
  }
  result.Mesh->SetPoints(points);
  result.Mesh->SetPolys(cells);
  return result;
}

/// Around z; u around the axis, v around the tube. On the meridian circle the curvature is 1 / r,
/// across it cos v / (R + r cos v); only the latter changes, and only along the meridian.
inline ParametricSurface Torus(double R, double r)
{
  const auto at = [=](double u, double v)
  {
    Truth truth;
    const double rho = R + r * std::cos(v);
    truth.Point = { rho * std::cos(u), rho * std::sin(u), r * std::sin(v) };
    truth.Normal = { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) };
    truth.Frame.U = { -std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v) };
    truth.Frame.V = truth.Normal.cross(truth.Frame.U);
    truth.Form = { 1.0 / r, 0.0, std::cos(v) / rho };
    truth.Cubic = { 0.0, 0.0, -R * std::sin(v) / (r * rho * rho), 0.0 };
    return truth;
  };
  return { at, { 0.0, 2.0 * Pi, 0.0, 2.0 * Pi }, true, true };
}

inline AnalyticSurface MakeTorus(double R, double r, int nu, int nv)
{
  return MakeSurface(Torus(R, r), nu, nv);
}

/// An open cylinder around z: 1 / r around, 0 along, and nothing changes.
inline ParametricSurface Cylinder(double r, double height)
{
  const auto at = [=](double u, double z)
  {
    Truth truth;
    truth.Normal = { std::cos(u), std::sin(u), 0.0 };
    truth.Point = r * truth.Normal + Vector3d(0.0, 0.0, z);
    truth.Frame.U = { -std::sin(u), std::cos(u), 0.0 };
    truth.Frame.V = Vector3d::UnitZ();
    truth.Form = { 1.0 / r, 0.0, 0.0 };
    truth.Cubic = Vector4d::Zero();
    return truth;
  };
  return { at, { 0.0, 2.0 * Pi, 0.0, height }, true, false };
}

inline AnalyticSurface MakeCylinder(double r, double height, int nu, int nv)
{
  return MakeSurface(Cylinder(r, height), nu, nv);
}

/// A frustum of a cone around z, its apex at the origin on top; u around, v from the farther to the
/// nearer distance from the apex. Around it the curvature is 1 / (s tan angle) at the distance s,
/// and grows towards the apex; along it 0.
inline ParametricSurface Cone(double angle, double farther, double nearer)
{
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const auto at = [=](double u, double v)
  {
    Truth truth;
    const double s = farther - v;
    truth.Point = { s * sine * std::cos(u), s * sine * std::sin(u), -s * cosine };
    truth.Normal = { cosine * std::cos(u), cosine * std::sin(u), sine };
    truth.Frame.U = { -std::sin(u), std::cos(u), 0.0 };
    truth.Frame.V = truth.Normal.cross(truth.Frame.U);
    truth.Form = { cosine / (s * sine), 0.0, 0.0 };
    truth.Cubic = { 0.0, cosine / (s * s * sine), 0.0, 0.0 };
    return truth;
  };
  return { at, { 0.0, 2.0 * Pi, 0.0, farther - nearer }, true, false };
}

/// A patch of a sphere between two latitudes: all curvatures are 1 / r.
inline ParametricSurface SpherePatch(double r)
{
  const auto at = [=](double u, double v)
  {
    Truth truth;
    truth.Normal = { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) };
    truth.Point = r * truth.Normal;
    truth.Frame = npr::MakeTangentFrame(truth.Normal);
    truth.Form = { 1.0 / r, 0.0, 1.0 / r };
    truth.Cubic = Vector4d::Zero();
    return truth;
  };
  return { at, { 0.0, 2.0, -0.7, 0.8 } };
}

inline AnalyticSurface MakeSpherePatch(double r, int nu, int nv)
{
  return MakeSurface(SpherePatch(r), nu, nv);
}

/// A patch of an ellipsoid, away from its poles.
inline ParametricSurface EllipsoidPatch(const Vector3d& axes)
{
  const auto at = [=](double u, double v)
  {
    return MakeEllipsoidTruth(
      axes, { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) });
  };
  return { at, { 0.0, 2.0, -0.7, 0.8 } };
}

/// The saddle z = x y.
inline ParametricSurface Saddle()
{
  const auto at = [](double x, double y) {
    return MakeHeightTruth(x, y, { x * y, { y, x }, { 0, 1, 0 }, { 0, 0, 0, 0 } });
  };
  return { at, { -0.8, 0.8, -0.8, 0.8 } };
}

inline AnalyticSurface MakeSaddle(int n)
{
  return MakeSurface(Saddle(), n, n);
}

/// z = x^3 - 3 x y^2: a saddle for three, flat and umbilic at its middle.
inline ParametricSurface MonkeySaddle()
{
  const auto at = [](double x, double y)
  {
    return MakeHeightTruth(x, y,
      { x * x * x - 3 * x * y * y, { 3 * (x * x - y * y), -6 * x * y }, { 6 * x, -6 * y, -6 * x },
        { 6, 0, -6, 0 } });
  };
  return { at, { -0.5, 0.5, -0.5, 0.5 } };
}

inline ParametricSurface Waves()
{
  return { MakeWavesTruth, { -1.0, 1.0, -1.0, 1.2 } };
}

inline AnalyticSurface MakeWaves(int n)
{
  return MakeSurface(Waves(), n, n);
}

/// A sphere of about equal triangles: an octahedron whose triangles are parted into four, level
/// times, the midpoints put on the sphere. A point set of its own for each triangle if not welded.
inline vtkSmartPointer<vtkPolyData> MakeOctasphere(double r, int level)
{
  using Triangle = std::array<Vector3d, 3>;
  std::vector<Triangle> triangles;
  for (int octant = 0; octant < 8; ++octant)
  {
    const Vector3d a((octant & 1) ? -1.0 : 1.0, 0.0, 0.0);
    const Vector3d b(0.0, (octant & 2) ? -1.0 : 1.0, 0.0);
    const Vector3d c(0.0, 0.0, (octant & 4) ? -1.0 : 1.0);
    const bool outward = a.cross(b).dot(c) > 0.0;
    triangles.push_back(outward ? Triangle{ a, b, c } : Triangle{ a, c, b });
  }
  for (int l = 0; l < level; ++l)
  {
    std::vector<Triangle> finer;
    for (const Triangle& t : triangles)
    {
      const Vector3d m0 = (t[0] + t[1]).normalized();
      const Vector3d m1 = (t[1] + t[2]).normalized();
      const Vector3d m2 = (t[2] + t[0]).normalized();
      finer.insert(
        finer.end(), { { t[0], m0, m2 }, { m0, t[1], m1 }, { m2, m1, t[2] }, { m0, m1, m2 } });
    }
    triangles.swap(finer);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : triangles)
  {
    cells->InsertNextCell(3);
    for (const Vector3d& corner : t)
    {
      const Vector3d p = r * corner;
      cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

/// A closed cylinder around z with its caps as fans.
inline vtkSmartPointer<vtkPolyData> MakeCan(double r, double height, int sides)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  points->SetDataTypeToDouble();
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * Pi * i / sides;
    points->InsertNextPoint(r * std::cos(angle), r * std::sin(angle), 0.0);
    points->InsertNextPoint(r * std::cos(angle), r * std::sin(angle), height);
  }
  const vtkIdType bottom = points->InsertNextPoint(0.0, 0.0, 0.0);
  const vtkIdType top = points->InsertNextPoint(0.0, 0.0, height);
  for (int i = 0; i < sides; ++i)
  {
    const vtkIdType a = 2 * i;
    const vtkIdType b = 2 * ((i + 1) % sides);
    const vtkIdType triangles[4][3] = { { a, b, b + 1 }, { a, b + 1, a + 1 }, { b, a, bottom },
      { a + 1, b + 1, top } };
    for (const auto& triangle : triangles)
    {
      cells->InsertNextCell(3, triangle);
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

/// Two triangles for each face of a cube, and 8 points.
inline vtkSmartPointer<vtkPolyData> MakeCube()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1, (i >> 1) & 1, i >> 2);
  }
  const vtkIdType quads[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& q : quads)
  {
    const vtkIdType triangles[2][3] = { { q[0], q[1], q[2] }, { q[0], q[2], q[3] } };
    for (const auto& triangle : triangles)
    {
      cells->InsertNextCell(3, triangle);
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}
}

#endif
