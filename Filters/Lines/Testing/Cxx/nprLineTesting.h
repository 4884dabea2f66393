// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLineTesting.h
 * @brief Surfaces whose normals and curvatures are known exactly.
 */
#ifndef nprLineTesting_h
#define nprLineTesting_h

#include "nprArrayNames.h"
#include "nprChainTesting.h"
#include "nprChecks.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

namespace nprtest
{
inline vtkSmartPointer<vtkFloatArray> AddArray(
  vtkPolyData* surface, const char* name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  surface->GetPointData()->AddArray(array);
  return array;
}

inline void AddWeldedIds(vtkPolyData* surface, const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(npr::names::WeldedPointIds);
  for (vtkIdType id : ids)
  {
    array->InsertNextValue(id);
  }
  surface->GetPointData()->AddArray(array);
}

/// A grid of points, closed in both directions where wanted, outward for du x dv.
inline vtkSmartPointer<vtkPolyData> MakeGrid(int nu, int nv, bool closedU, bool closedV)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(nu) * nv);
  vtkNew<vtkCellArray> triangles;
  for (int i = 0; i < (closedU ? nu : nu - 1); ++i)
  {
    for (int j = 0; j < (closedV ? nv : nv - 1); ++j)
    {
      const vtkIdType a = i * nv + j;
      const vtkIdType b = ((i + 1) % nu) * nv + j;
      const vtkIdType c = ((i + 1) % nu) * nv + (j + 1) % nv;
      const vtkIdType d = i * nv + (j + 1) % nv;
      triangles->InsertNextCell({ a, b, c });
      triangles->InsertNextCell({ a, c, d });
    }
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

/// The torus ((R + r cos v) cos u, (R + r cos v) sin u, r sin v), R > 2 r.
struct Torus
{
  double R = 1.0;
  double r = 0.4;

  Vector Point(double u, double v) const
  {
    const double d = this->R + this->r * std::cos(v);
    return { d * std::cos(u), d * std::sin(u), this->r * std::sin(v) };
  }
  Vector Normal(double u, double v) const
  {
    return { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) };
  }
  Vector AlongU(double u) const { return { -std::sin(u), std::cos(u), 0.0 }; }
  Vector AlongV(double u, double v) const
  {
    return { -std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v) };
  }
  double CurvatureU(double v) const { return std::cos(v) / (this->R + this->r * std::cos(v)); }

  /// With exact normals, curvatures and derivatives. The first direction runs along v.
  vtkSmartPointer<vtkPolyData> Make(int nu, int nv) const
  {
    auto surface = MakeGrid(nu, nv, true, true);
    auto normals = AddArray(surface, npr::names::Normals, 3);
    auto tensors = AddArray(surface, npr::names::CurvatureTensor, 6);
    auto k1 = AddArray(surface, npr::names::PrincipalCurvature1, 1);
    auto k2 = AddArray(surface, npr::names::PrincipalCurvature2, 1);
    auto e1 = AddArray(surface, npr::names::PrincipalDirection1, 3);
    auto e2 = AddArray(surface, npr::names::PrincipalDirection2, 3);
    auto derivatives = AddArray(surface, npr::names::CurvatureDerivatives, 4);
    for (int i = 0; i < nu; ++i)
    {
      for (int j = 0; j < nv; ++j)
      {
        const vtkIdType id = static_cast<vtkIdType>(i) * nv + j;
        const double u = 2.0 * Pi * i / nu;
        const double v = 2.0 * Pi * j / nv;
        surface->GetPoints()->SetPoint(id, this->Point(u, v).data());
        normals->SetTuple(id, this->Normal(u, v).data());
        const Vector first = this->AlongV(u, v);
        const Vector second = -this->AlongU(u);
        const double c1 = 1.0 / this->r;
        const double c2 = this->CurvatureU(v);
        const Eigen::Matrix3d tensor =
          c1 * first * first.transpose() + c2 * second * second.transpose();
        tensors->SetTuple6(
          id, tensor(0, 0), tensor(1, 1), tensor(2, 2), tensor(0, 1), tensor(1, 2), tensor(0, 2));
        k1->SetTuple1(id, c1);
        k2->SetTuple1(id, c2);
        e1->SetTuple(id, first.data());
        e2->SetTuple(id, second.data());
        const double d = this->R + this->r * std::cos(v);
        derivatives->SetTuple4(id, 0.0, 0.0, -this->R * std::sin(v) / (this->r * d * d), 0.0);
      }
    }
    return surface;
  }
};

/// A sphere around a centre: n rings of 2 n points and two poles.
inline vtkSmartPointer<vtkPolyData> MakeSphere(
  int n, double radius, const Vector& centre = Vector::Zero())
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  std::vector<Vector> normals;
  const int m = 2 * n;
  for (int i = 1; i <= n; ++i)
  {
    const double latitude = Pi * (i / (n + 1.0) - 0.5);
    for (int j = 0; j < m; ++j)
    {
      const double longitude = 2.0 * Pi * j / m;
      normals.emplace_back(std::cos(latitude) * std::cos(longitude),
        std::cos(latitude) * std::sin(longitude), std::sin(latitude));
    }
  }
  normals.emplace_back(0.0, 0.0, -1.0);
  normals.emplace_back(0.0, 0.0, 1.0);
  const vtkIdType south = static_cast<vtkIdType>(n) * m;
  for (int j = 0; j < m; ++j)
  {
    const vtkIdType next = (j + 1) % m;
    triangles->InsertNextCell({ south, next, static_cast<vtkIdType>(j) });
    triangles->InsertNextCell({ south + 1, (n - 1) * m + j, (n - 1) * m + next });
    for (vtkIdType i = 0; i + 1 < n; ++i)
    {
      triangles->InsertNextCell({ i * m + j, i * m + next, (i + 1) * m + next });
      triangles->InsertNextCell({ i * m + j, (i + 1) * m + next, (i + 1) * m + j });
    }
  }
  for (const Vector& normal : normals)
  {
    points->InsertNextPoint(Vector(centre + radius * normal).data());
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  auto array = AddArray(surface, npr::names::Normals, 3);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), normals[i].data());
  }
  return surface;
}

/// The cube [-1, 1]^3: each face with points of its own that are welded by WeldedPointIds, or all
/// with the same eight points and the normals towards the corners.
inline vtkSmartPointer<vtkPolyData> MakeCube(bool split)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  std::vector<Vector> normals;
  std::vector<vtkIdType> welded;
  std::array<vtkIdType, 8> firstCopy;
  firstCopy.fill(-1);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = -1; side <= 1; side += 2)
    {
      std::array<vtkIdType, 4> corners;
      for (int c = 0; c < 4; ++c)
      {
        Vector p;
        p[axis] = side;
        p[(axis + 1) % 3] = (c == 1 || c == 2 ? 1 : -1) * side;
        p[(axis + 2) % 3] = c >= 2 ? 1 : -1;
        const int corner = (p[0] > 0) + 2 * (p[1] > 0) + 4 * (p[2] > 0);
        if (split || firstCopy[corner] < 0)
        {
          corners[c] = points->InsertNextPoint(p.data());
          normals.push_back(split ? Vector(side * Vector::Unit(axis)) : Vector(p.normalized()));
          firstCopy[corner] = firstCopy[corner] < 0 ? corners[c] : firstCopy[corner];
          welded.push_back(firstCopy[corner]);
        }
        else
        {
          corners[c] = firstCopy[corner];
        }
      }
      triangles->InsertNextCell({ corners[0], corners[1], corners[2] });
      triangles->InsertNextCell({ corners[0], corners[2], corners[3] });
    }
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  auto array = AddArray(surface, npr::names::Normals, 3);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), normals[i].data());
  }
  if (split)
  {
    AddWeldedIds(surface, welded);
  }
  return surface;
}
}

#endif
