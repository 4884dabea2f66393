// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfaceSmoothing.h"

#include "nprCreases.h"
#include "nprLengthScale.h"
#include "nprOpenMesh.h"
#include "nprProgress.h"
#include "nprRemeshedArrays.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <OpenMesh/Tools/Smoother/JacobiLaplaceSmootherT.hh>

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkNPRSurfaceSmoothing);

namespace
{
using Index = npr::TriangleMesh::Index;
using Vertex = npr::HalfEdgeMesh::VertexHandle;
using Smoother = OpenMesh::Smoother::JacobiLaplaceSmootherT<npr::HalfEdgeMesh>;

//------------------------------------------------------------------------------
void LockFeatures(const npr::TriangleMesh& triangles, double angle, npr::HalfEdgeMesh& mesh)
{
  const npr::EdgeFlags creases = npr::FindCreases(triangles, angle);
  for (Index t = 0; t < triangles.GetNumberOfTriangles(); ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      if (creases[t][e])
      {
        mesh.status(Vertex(triangles.GetTriangle(t)[e])).set_locked(true);
        mesh.status(Vertex(triangles.GetTriangle(t)[(e + 1) % 3])).set_locked(true);
      }
    }
  }
}

//------------------------------------------------------------------------------
/// The cotangents of a triangle without area are infinite. Whatever would take them stays.
void LockDegenerate(bool withNeighbours, npr::HalfEdgeMesh& mesh)
{
  for (const auto face : mesh.faces())
  {
    const auto h = mesh.halfedge_handle(face);
    const OpenMesh::Vec3d a = mesh.calc_edge_vector(h);
    const OpenMesh::Vec3d b = mesh.calc_edge_vector(mesh.next_halfedge_handle(h));
    const double longest = std::max({ a.sqrnorm(), b.sqrnorm(), (a + b).sqrnorm() });
    if (OpenMesh::cross(a, b).norm() > 1e-12 * longest)
    {
      continue;
    }
    for (const Vertex corner : mesh.fv_range(face))
    {
      mesh.status(corner).set_locked(true);
      if (withNeighbours)
      {
        for (const Vertex neighbour : mesh.vv_range(corner))
        {
          mesh.status(neighbour).set_locked(true);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Returns how many points could not be moved because that had no result.
vtkIdType MovePoints(const std::vector<OpenMesh::Vec3d>& old, const npr::HalfEdgeMesh& mesh,
  const npr::UnitPlacement& placement, vtkPoints* points)
{
  vtkIdType lost = 0;
  for (const auto vertex : mesh.vertices())
  {
    const OpenMesh::Vec3d& point = mesh.point(vertex);
    if (point == old[vertex.idx()])
    {
      continue;
    }
    if (!std::isfinite(point.sqrnorm()))
    {
      ++lost;
      continue;
    }
    const Eigen::Vector3d moved =
      placement.Origin + placement.Unit * Eigen::Vector3d(point[0], point[1], point[2]);
    points->SetPoint(vertex.idx(), moved.data());
  }
  points->Modified();
  return lost;
}
}

//------------------------------------------------------------------------------
vtkNPRSurfaceSmoothing::vtkNPRSurfaceSmoothing() = default;
vtkNPRSurfaceSmoothing::~vtkNPRSurfaceSmoothing() = default;

//------------------------------------------------------------------------------
int vtkNPRSurfaceSmoothing::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  if (this->NumberOfIterations == 0 || input->GetNumberOfCells() == 0)
  {
    return 1;
  }
  const std::string obstacle = npr::FindHalfEdgeObstacle(input);
  if (!obstacle.empty())
  {
    vtkErrorMacro(<< obstacle);
    return 0;
  }
  npr::TriangleMesh triangles(input);
  npr::HalfEdgeMesh mesh;
  if (!npr::MakeHalfEdges(triangles.GetNumberOfPoints(), triangles.GetTriangles(), mesh))
  {
    vtkErrorMacro("OpenMesh refuses a triangle. Run vtkNPRSurfacePreparation first.");
    return 0;
  }
  const npr::UnitPlacement placement = npr::PlaceHalfEdges(input, mesh);
  const std::vector<OpenMesh::Vec3d> old(mesh.points(), mesh.points() + mesh.n_vertices());

  mesh.request_vertex_status();
  if (this->FeatureAngle < 180.0)
  {
    triangles.BuildNeighbours();
    LockFeatures(triangles, this->FeatureAngle, mesh);
  }
  if (this->Component == NORMAL)
  {
    LockDegenerate(this->Continuity > 0, mesh);
  }
  Smoother smoother(mesh);
  constexpr Smoother::Component Components[] = { Smoother::Tangential, Smoother::Normal,
    Smoother::Tangential_and_Normal };
  smoother.initialize(
    Components[this->Component], this->Continuity == 0 ? Smoother::C0 : Smoother::C1);
  if (this->MaximumMove > 0.0)
  {
    smoother.set_absolute_local_error(
      this->MaximumMove * npr::GetLengthScale(input) / placement.Unit);
  }
  const int part = std::max(1, this->NumberOfIterations / 20);
  for (int done = 0; done < this->NumberOfIterations; done += part)
  {
    this->UpdateProgress(0.1 + 0.9 * done / this->NumberOfIterations);
    if (npr::IsAborted(this))
    {
      return 1;
    }
    smoother.smooth(static_cast<unsigned int>(std::min(part, this->NumberOfIterations - done)));
  }

  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType()); // a deep copy would keep its own
  points->DeepCopy(input->GetPoints());
  const vtkIdType lost = MovePoints(old, mesh, placement, points);
  if (lost > 0)
  {
    vtkWarningMacro(<< lost
                    << " points stay in place: between triangles as thin as theirs the "
                       "cotangents lead nowhere. Take fewer iterations, or another component.");
  }
  output->SetPoints(points);
  npr::DropShapeArrays(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRSurfaceSmoothing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Continuity: " << this->Continuity << "\n";
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MaximumMove: " << this->MaximumMove << "\n";
}
