// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprHidingSurfaces.h"

#include "nprArrayNames.h"
#include "nprChordErrors.h"
#include "nprTupleArrays.h"
#include "nprWeldedPoints.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPThreadLocal.h>
#include <vtkSMPTools.h>
#include <vtkTriangleFilter.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;

/// A surface of triangles, and how exact they are.
struct ReadSurface
{
  TriangleMesh Mesh;
  std::vector<float> ChordErrors;
};

std::vector<float> GetChordErrors(const TriangleMesh& mesh, vtkPolyData* surface)
{
  vtkDataArray* const known = surface->GetCellData()->GetArray(names::ChordError);
  if (known && known->GetNumberOfComponents() == 1)
  {
    std::vector<float> errors(mesh.GetNumberOfTriangles());
    for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
    {
      const auto error = static_cast<float>(known->GetComponent(mesh.GetCellId(t), 0));
      errors[t] = std::isfinite(error) ? std::max(error, 0.0f) : 0.0f;
    }
    return errors;
  }
  vtkDataArray* const normals = surface->GetPointData()->GetArray(names::Normals);
  return normals && normals->GetNumberOfComponents() == 3
    ? MeasureChordErrors(mesh, ReadTuples<3>(normals))
    : std::vector<float>(mesh.GetNumberOfTriangles(), 0.0f);
}

/// The triangles of a surface that may have other polygons and strips.
ReadSurface ReadTriangles(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> triangulate;
  const bool isTriangulated =
    surface->GetNumberOfStrips() == 0 && surface->GetPolys()->IsHomogeneous() == 3;
  if (!isTriangulated)
  {
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(surface);
    triangulate->PassVertsOff();
    triangulate->PassLinesOff();
    triangulate->SetInputData(copy);
    triangulate->Update();
    surface = triangulate->GetOutput();
  }
  TriangleMesh mesh(surface);
  std::vector<float> errors = GetChordErrors(mesh, surface);
  if (!surface->GetPointData()->HasArray(names::WeldedPointIds))
  {
    return { std::move(mesh), std::move(errors) };
  }
  const std::vector<TriangleMesh::Index> welded = GetWeldedPoints(surface);
  std::vector<TriangleMesh::Triangle> triangles = mesh.GetTriangles();
  for (TriangleMesh::Triangle& triangle : triangles)
  {
    for (TriangleMesh::Index& corner : triangle)
    {
      corner = welded[corner];
    }
  }
  return { TriangleMesh(mesh.GetPoints(), std::move(triangles), mesh.GetOrigin()),
    std::move(errors) };
}
}

//------------------------------------------------------------------------------
HidingSurfaces::HidingSurfaces(const std::vector<Surface>& surfaces)
{
  Eigen::AlignedBox3d box;
  std::size_t numberOfPoints = 1;
  for (const Surface& surface : surfaces)
  {
    double bounds[6];
    surface.Data->GetBounds(bounds);
    numberOfPoints += surface.Data->GetNumberOfPoints();
    for (int corner = 0; corner < 8 && surface.Data->GetNumberOfPoints() > 0; ++corner)
    {
      const Eigen::Vector4d point(
        bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2 & 1)], 1.0);
      const Eigen::Vector3d place = (surface.ToWorld * point).head<3>();
      if (place.allFinite())
      {
        box.extend(place);
      }
    }
  }
  if (!box.isEmpty())
  {
    this->Centre = box.center();
  }
  this->Points.reserve(numberOfPoints);
  for (const Surface& surface : surfaces)
  {
    if (surface.Data->GetNumberOfPoints() > 0)
    {
      auto [mesh, errors] = ReadTriangles(surface.Data);
      mesh.BuildNeighbours();
      this->Append(mesh, surface.ToWorld);
      const auto scale =
        static_cast<float>(surface.ToWorld.topLeftCorner<3, 3>().colwise().norm().maxCoeff());
      std::transform(errors.begin(), errors.end(), std::back_inserter(this->ChordErrors),
        [scale](float error) { return scale * error; });
    }
  }
  this->Points.emplace_back(Eigen::Vector3f::Zero());

  this->Measure();
  this->FindBodies();
  if (!this->IsEmpty())
  {
    this->Tracer = std::make_unique<RayTracer>(this->Points, this->Triangles);
  }
}

//------------------------------------------------------------------------------
void HidingSurfaces::Measure()
{
  struct Local
  {
    float SquaredRadius = 0.0f;
    float SquaredEdge = 0.0f;
    float ChordError = 0.0f;
    bool IsOriented = true;
  };
  vtkSMPThreadLocal<Local> locals;
  vtkSMPTools::For(0, this->GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      Local& local = locals.Local();
      for (auto t = static_cast<Index>(begin); t < end; ++t)
      {
        local.ChordError = std::max(local.ChordError, this->ChordErrors[t]);
        for (int e = 0; e < 3; ++e)
        {
          const Eigen::Vector3f& from = this->Points[this->Triangles[t][e]];
          const Eigen::Vector3f& to = this->Points[this->Triangles[t][(e + 1) % 3]];
          local.SquaredRadius = std::max(local.SquaredRadius, from.squaredNorm());
          local.SquaredEdge = std::max(local.SquaredEdge, (to - from).squaredNorm());
          if (this->GetNeighbour(t, e) > t && !this->CompareOrientation(t, e))
          {
            local.IsOriented = false;
          }
        }
      }
    });
  Local all;
  for (const Local& local : locals)
  {
    all.SquaredRadius = std::max(all.SquaredRadius, local.SquaredRadius);
    all.SquaredEdge = std::max(all.SquaredEdge, local.SquaredEdge);
    all.ChordError = std::max(all.ChordError, local.ChordError);
    all.IsOriented = all.IsOriented && local.IsOriented;
  }
  constexpr double manyRoundings = 1e-5;
  this->Radius = std::sqrt(all.SquaredRadius);
  this->Tolerance = manyRoundings * this->Radius;
  this->LongestEdge = std::sqrt(all.SquaredEdge);
  this->LargestChordError = all.ChordError;
  this->IsOriented = all.IsOriented;
}

//------------------------------------------------------------------------------
void HidingSurfaces::FindBodies()
{
  this->Bodies.resize(this->Triangles.size());
  std::iota(this->Bodies.begin(), this->Bodies.end(), 0);
  const auto findFirst = [this](Index triangle)
  {
    while (this->Bodies[triangle] != triangle)
    {
      this->Bodies[triangle] = this->Bodies[this->Bodies[triangle]];
      triangle = this->Bodies[triangle];
    }
    return triangle;
  };
  for (Index t = 0; t < this->GetNumberOfTriangles(); ++t)
  {
    for (const Index neighbour : this->Neighbours[t])
    {
      if (neighbour > t)
      {
        const Index one = findFirst(t);
        const Index other = findFirst(neighbour);
        this->Bodies[std::max(one, other)] = std::min(one, other);
      }
    }
  }
  // None comes after what it refers to.
  for (Index& body : this->Bodies)
  {
    body = this->Bodies[body];
  }
}

//------------------------------------------------------------------------------
void HidingSurfaces::Append(const TriangleMesh& mesh, const Eigen::Matrix4d& toWorld)
{
  const Eigen::Matrix3d linear = toWorld.topLeftCorner<3, 3>();
  const Eigen::Vector3d offset =
    linear * mesh.GetOrigin() + toWorld.topRightCorner<3, 1>() - this->Centre;
  const auto firstPoint = static_cast<Index>(this->Points.size());
  const auto firstTriangle = static_cast<Index>(this->Triangles.size());
  this->Points.resize(this->Points.size() + mesh.GetNumberOfPoints());
  vtkSMPTools::For(0, mesh.GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<Index>(begin); i < end; ++i)
      {
        this->Points[firstPoint + i] =
          (linear * mesh.GetPoint(i).cast<double>() + offset).cast<float>();
      }
    });
  this->Triangles.resize(this->Triangles.size() + mesh.GetNumberOfTriangles());
  this->Neighbours.resize(this->Triangles.size());
  vtkSMPTools::For(0, mesh.GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto t = static_cast<Index>(begin); t < end; ++t)
      {
        for (int e = 0; e < 3; ++e)
        {
          const Index neighbour = mesh.GetNeighbour(t, e);
          this->Triangles[firstTriangle + t][e] = firstPoint + mesh.GetTriangle(t)[e];
          this->Neighbours[firstTriangle + t][e] =
            neighbour < 0 ? neighbour : firstTriangle + neighbour;
        }
      }
    });
}

//------------------------------------------------------------------------------
bool HidingSurfaces::CompareOrientation(Index triangle, int edge) const
{
  // Of two triangles with the same side in front, one runs along their edge from its start to its
  // end and the other back.
  const Index from = this->Triangles[triangle][edge];
  const Index to = this->Triangles[triangle][(edge + 1) % 3];
  const TriangleMesh::Triangle& other = this->Triangles[this->Neighbours[triangle][edge]];
  for (int e = 0; e < 3; ++e)
  {
    if (other[e] == to && other[(e + 1) % 3] == from)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
Eigen::Vector3d HidingSurfaces::GetAreaNormal(Index triangle) const
{
  const Eigen::Vector3d a = this->GetCorner(triangle, 0);
  return (this->GetCorner(triangle, 1) - a).cross(this->GetCorner(triangle, 2) - a);
}
}
