// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLineTesting.h
 * @brief Surfaces whose normals and curvatures are known exactly, and measures of lines.
 */
#ifndef nprLineTesting_h
#define nprLineTesting_h

#include "nprArrayNames.h"
#include "vtkNPRFeatureLines.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
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
#include <iostream>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

namespace nprtest
{
using Vector = Eigen::Vector3d;
constexpr double Pi = 3.14159265358979323846;

/// Counts what went wrong; a test returns Result().
class Checks
{
public:
  bool operator()(bool good, const char* what, double value = 0.0)
  {
    if (!good)
    {
      std::cerr << "FAILED: " << what << " (" << value << ")\n";
      ++this->Failed;
    }
    return good;
  }
  int Result() const { return this->Failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  int Failed = 0;
};

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

/// A chain of the output.
struct Chain
{
  std::vector<Vector> Points; // a closed one does not repeat its first point
  std::vector<Vector> Normals;
  std::vector<double> Strength;
  bool Closed = false;
  int Type = 0;

  std::size_t GetNumberOfSegments() const { return this->Points.size() - (this->Closed ? 0 : 1); }
  const Vector& Next(std::size_t i) const { return this->Points[(i + 1) % this->Points.size()]; }
};

inline std::vector<Chain> GetChains(vtkPolyData* lines)
{
  std::vector<Chain> chains;
  vtkDataArray* strength = lines->GetPointData()->GetArray(npr::names::Strength);
  vtkDataArray* normals = lines->GetPointData()->GetArray(npr::names::Normals);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfLines(); ++cell)
  {
    lines->GetLines()->GetCellAtId(cell, ids);
    Chain chain;
    chain.Type =
      static_cast<int>(lines->GetCellData()->GetArray(npr::names::LineType)->GetTuple1(cell));
    chain.Closed = ids->GetId(0) == ids->GetId(ids->GetNumberOfIds() - 1);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds() - (chain.Closed ? 1 : 0); ++i)
    {
      Vector p;
      lines->GetPoint(ids->GetId(i), p.data());
      chain.Points.push_back(p);
      normals->GetTuple(ids->GetId(i), p.data());
      chain.Normals.push_back(p);
      chain.Strength.push_back(strength->GetTuple1(ids->GetId(i)));
    }
    chains.push_back(chain);
  }
  return chains;
}

/// All pieces, each with its lesser end first, in ascending order.
using Segment = std::array<double, 6>;
inline std::vector<Segment> GetSegments(const std::vector<Chain>& chains)
{
  std::vector<Segment> segments;
  for (const Chain& chain : chains)
  {
    for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
    {
      std::array<double, 3> a = { chain.Points[i][0], chain.Points[i][1], chain.Points[i][2] };
      std::array<double, 3> b = { chain.Next(i)[0], chain.Next(i)[1], chain.Next(i)[2] };
      if (b < a)
      {
        std::swap(a, b);
      }
      segments.push_back({ a[0], a[1], a[2], b[0], b[1], b[2] });
    }
  }
  std::sort(segments.begin(), segments.end());
  return segments;
}

/// What holds for all lines: no piece without length, none twice, strengths in range, unit normals.
inline void CheckSound(const std::vector<Chain>& chains, Checks& check)
{
  int types = 0;
  for (const Chain& chain : chains)
  {
    types = std::max(types, chain.Type + 1);
    check(chain.Points.size() >= 2, "a chain has two points or more");
    for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
    {
      check(chain.Points[i] != chain.Next(i), "every piece has a length");
    }
    for (std::size_t i = 0; i < chain.Points.size(); ++i)
    {
      check(chain.Strength[i] >= 0.0 && chain.Strength[i] <= 1.0, "strength is in [0, 1]");
      check(std::abs(chain.Normals[i].norm() - 1.0) < 1.0e-5, "normals are unit vectors",
        chain.Normals[i].norm());
    }
  }
  for (int type = 0; type < types; ++type)
  {
    std::vector<Chain> ofType;
    std::copy_if(chains.begin(), chains.end(), std::back_inserter(ofType),
      [type](const Chain& chain) { return chain.Type == type; });
    const auto segments = GetSegments(ofType);
    check(std::adjacent_find(segments.begin(), segments.end()) == segments.end(),
      "no piece comes twice");
  }
}

inline double GetLength(const Chain& chain)
{
  double length = 0.0;
  for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
  {
    length += (chain.Next(i) - chain.Points[i]).norm();
  }
  return length;
}

/// How far a point is from lines.
inline double GetDistance(const std::vector<Chain>& chains, const Vector& p)
{
  double least = std::numeric_limits<double>::max();
  for (const Chain& chain : chains)
  {
    for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
    {
      const Vector along = chain.Next(i) - chain.Points[i];
      const double t =
        std::min(1.0, std::max(0.0, (p - chain.Points[i]).dot(along) / along.squaredNorm()));
      least = std::min(least, (p - chain.Points[i] - t * along).norm());
    }
  }
  return least;
}

inline vtkSmartPointer<vtkCamera> MakeCamera(const Vector& position, bool parallel = false)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(position[0], position[1], position[2]);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.1, 0.9, 0.3);
  camera->SetParallelProjection(parallel);
  return camera;
}

/// Extracts lines by their names.
inline std::vector<Chain> Extract(
  vtkPolyData* surface, const std::vector<const char*>& names, vtkCamera* camera)
{
  vtkNew<vtkNPRFeatureLines> lines;
  for (const char* name : names)
  {
    lines->AddDefinition(name);
  }
  lines->SetCamera(camera);
  lines->SetInputData(surface);
  lines->Update();
  return GetChains(lines->GetOutput());
}

/// The text of the errors of one update.
inline std::string GetErrors(vtkNPRFeatureLines* lines)
{
  std::string errors;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&errors);
  observer->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
    { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
  const unsigned long tag = lines->AddObserver(vtkCommand::ErrorEvent, observer);
  // The executive adds that the filter failed.
  const unsigned long executiveTag =
    lines->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  lines->Update();
  lines->RemoveObserver(tag);
  lines->GetExecutive()->RemoveObserver(executiveTag);
  return errors;
}

/// Whether a text has a part.
inline bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}

#endif
