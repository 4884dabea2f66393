// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfaceDecimation.h"

#include "nprLengthScale.h"
#include "nprOpenMesh.h"
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
#include <vtkPolyData.h>

#include <cmath>

vtkStandardNewMacro(vtkNPRSurfaceDecimation);

namespace
{
using Index = npr::TriangleMesh::Index;

//------------------------------------------------------------------------------
void LockCopies(const std::vector<Index>& weldedPointIds, npr::HalfEdgeMesh& mesh)
{
  for (std::size_t i = 0; i < weldedPointIds.size(); ++i)
  {
    const Index first = weldedPointIds[i];
    if (first != static_cast<Index>(i))
    {
      mesh.status(npr::HalfEdgeMesh::VertexHandle(first)).set_locked(true);
      mesh.status(npr::HalfEdgeMesh::VertexHandle(static_cast<Index>(i))).set_locked(true);
    }
  }
}

//------------------------------------------------------------------------------
/// What is left, with its arrays.
void Extract(const npr::HalfEdgeMesh& mesh, vtkPolyData* input, vtkPolyData* output)
{
  std::vector<vtkIdType> points;
  std::vector<Index> numbers(mesh.n_vertices(), -1);
  for (const auto vertex : mesh.vertices()) // skips the deleted
  {
    if (!mesh.is_isolated(vertex))
    {
      numbers[vertex.idx()] = static_cast<Index>(points.size());
      points.push_back(vertex.idx());
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
  npr::SelectPoints(input, points, output);
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
  npr::DecimateSurface(mesh, options, npr::ReportTo(this, 0.2, 0.95));
  if (npr::IsAborted(this))
  {
    output->ShallowCopy(input);
    return 1;
  }
  Extract(mesh, input, output);
  output->GetFieldData()->PassData(input->GetFieldData());
  npr::RenumberWeldedPointIds(output);
  npr::DropDensityArrays(output);
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
