// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfaceDecimation.h"

#include "nprLengthScale.h"
#include "nprOpenMesh.h"
#include "nprPointStencils.h"
#include "nprProgress.h"
#include "nprRemeshedArrays.h"
#include "nprSurfaceArrays.h"
#include "nprSurfaceDecimation.h"
#include "nprWeldedPoints.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkNPRSurfaceDecimation);

namespace
{
using Index = npr::TriangleMesh::Index;
using Vertex = npr::HalfEdgeMesh::VertexHandle;

//------------------------------------------------------------------------------
void LockCopies(const std::vector<Index>& weldedPointIds, npr::HalfEdgeMesh& mesh)
{
  for (std::size_t i = 0; i < weldedPointIds.size(); ++i)
  {
    const Index first = weldedPointIds[i];
    if (first != static_cast<Index>(i))
    {
      mesh.status(Vertex(first)).set_locked(true);
      mesh.status(Vertex(static_cast<Index>(i))).set_locked(true);
    }
  }
}

//------------------------------------------------------------------------------
/// What the points that are left come from.
npr::PointStencils MakeStencils(const std::vector<npr::PointMerge>& merges,
  const std::vector<vtkIdType>& left, std::size_t numberOfPoints)
{
  // Backwards each merge tells what a point was before. Those that never merged stay themselves.
  std::vector<double> weights(numberOfPoints, 1.0);
  std::vector<Index> owners(numberOfPoints);
  std::iota(owners.begin(), owners.end(), 0);
  for (auto merge = merges.rbegin(); merge != merges.rend(); ++merge)
  {
    weights[merge->Gone] = weights[merge->Kept] * merge->Share;
    weights[merge->Kept] *= 1.0 - merge->Share;
    owners[merge->Gone] = owners[merge->Kept];
  }
  std::vector<std::vector<Index>> parts(numberOfPoints);
  for (std::size_t i = 0; i < numberOfPoints; ++i)
  {
    if (weights[i] > 0.0)
    {
      parts[owners[i]].push_back(static_cast<Index>(i));
    }
  }
  npr::PointStencils stencils;
  for (const vtkIdType point : left)
  {
    for (const Index part : parts[point])
    {
      stencils.Add(part, weights[part]);
    }
    stencils.Close();
  }
  return stencils;
}

//------------------------------------------------------------------------------
/// Those that have not moved stay exactly where they were.
vtkSmartPointer<vtkPoints> MakePoints(const npr::HalfEdgeMesh& mesh,
  const std::vector<OpenMesh::Vec3d>& old, const npr::UnitPlacement& placement,
  const std::vector<vtkIdType>& left, vtkPoints* input)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(input->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(left.size()));
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    Eigen::Vector3d point;
    input->GetPoint(left[i], point.data());
    const OpenMesh::Vec3d& p = mesh.point(Vertex(static_cast<Index>(left[i])));
    if (p != old[left[i]])
    {
      point = placement.Origin + placement.Unit * Eigen::Vector3d(p[0], p[1], p[2]);
    }
    points->SetPoint(static_cast<vtkIdType>(i), point.data());
  }
  return points;
}

//------------------------------------------------------------------------------
/// What is left, with its arrays.
void Extract(const npr::HalfEdgeMesh& mesh, const std::vector<OpenMesh::Vec3d>& old,
  const npr::UnitPlacement& placement, const std::vector<npr::PointMerge>& merges,
  vtkPolyData* input, vtkPolyData* output)
{
  std::vector<vtkIdType> left;
  std::vector<Index> numbers(mesh.n_vertices(), -1);
  for (const auto vertex : mesh.vertices()) // skips the deleted
  {
    if (!mesh.is_isolated(vertex))
    {
      numbers[vertex.idx()] = static_cast<Index>(left.size());
      left.push_back(vertex.idx());
    }
  }
  std::vector<vtkIdType> cells;
  std::vector<npr::TriangleMesh::Triangle> triangles;
  for (const auto face : mesh.faces())
  {
    npr::TriangleMesh::Triangle triangle;
    auto corner = triangle.begin();
    for (const auto vertex : mesh.fv_range(face))
    {
      *corner++ = numbers[vertex.idx()];
    }
    cells.push_back(face.idx());
    triangles.push_back(triangle);
  }
  output->SetPoints(MakePoints(mesh, old, placement, left, input->GetPoints()));
  npr::ApplyStencils(
    input->GetPointData(), MakeStencils(merges, left, mesh.n_vertices()), output->GetPointData());
  npr::SetTriangles(output, triangles);
  npr::SelectTuples(input->GetCellData(), cells, output->GetCellData());
}
}

//------------------------------------------------------------------------------
vtkNPRSurfaceDecimation::vtkNPRSurfaceDecimation() = default;
vtkNPRSurfaceDecimation::~vtkNPRSurfaceDecimation() = default;

//------------------------------------------------------------------------------
int vtkNPRSurfaceDecimation::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (input->GetNumberOfCells() == 0)
  {
    output->ShallowCopy(input);
    return 1;
  }
  const std::string obstacle = npr::FindHalfEdgeObstacle(input);
  if (!obstacle.empty())
  {
    vtkErrorMacro(<< obstacle);
    return 0;
  }
  npr::HalfEdgeMesh mesh;
  if (!npr::MakeHalfEdges(
        static_cast<Index>(input->GetNumberOfPoints()), npr::GetAllTriangles(input), mesh))
  {
    vtkErrorMacro("OpenMesh refuses a triangle. Run vtkNPRSurfacePreparation first.");
    return 0;
  }
  const npr::UnitPlacement placement = npr::PlaceHalfEdges(input, mesh);
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  LockCopies(npr::GetWeldedPoints(input), mesh);

  npr::SurfaceDecimationOptions options;
  options.NumberOfTriangles = static_cast<std::size_t>(this->TargetNumberOfTriangles >= 0
      ? this->TargetNumberOfTriangles
      : std::llround((1.0 - this->TargetReduction) * input->GetNumberOfCells()));
  options.MaximumError = this->MaximumError * npr::GetLengthScale(input) / placement.Unit;
  options.MinimumAngle = this->MinimumAngle;
  const std::vector<OpenMesh::Vec3d> old(mesh.points(), mesh.points() + mesh.n_vertices());
  const std::vector<npr::PointMerge> merges =
    npr::DecimateSurface(mesh, options, npr::ReportTo(this, 0.2, 0.95));
  if (npr::IsAborted(this))
  {
    output->ShallowCopy(input);
    return 1;
  }
  Extract(mesh, old, placement, merges, input, output);
  output->GetFieldData()->PassData(input->GetFieldData());
  npr::RenumberWeldedPointIds(output);
  if (!merges.empty())
  {
    npr::DropShapeArrays(output);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRSurfaceDecimation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TargetReduction: " << this->TargetReduction << "\n";
  os << indent << "TargetNumberOfTriangles: " << this->TargetNumberOfTriangles << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "MinimumAngle: " << this->MinimumAngle << "\n";
}
