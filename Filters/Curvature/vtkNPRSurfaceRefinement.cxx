// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfaceRefinement.h"

#include "nprArrayNames.h"
#include "nprLengthScale.h"
#include "nprMidpointArrays.h"
#include "nprSurfaceArrays.h"
#include "nprSurfaceNormals.h"
#include "nprSurfaceRefinement.h"
#include "nprTangentArrays.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkNPRSurfaceRefinement);

namespace
{
using Index = npr::TriangleMesh::Index;

//------------------------------------------------------------------------------
/// The first copy of each point, as the preparation has written it, else each point itself.
std::vector<Index> GetWeldedPointIds(vtkPolyData* surface)
{
  const vtkIdType size = surface->GetNumberOfPoints();
  vtkDataArray* array = surface->GetPointData()->GetArray(npr::names::WeldedPointIds);
  std::vector<Index> ids(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    const vtkIdType id = array ? static_cast<vtkIdType>(array->GetComponent(i, 0)) : i;
    ids[i] = static_cast<Index>(id >= 0 && id < size ? id : i);
  }
  return ids;
}

//------------------------------------------------------------------------------
void SetPoints(vtkPolyData* input, const npr::TriangleMesh& mesh,
  const npr::RefinedSurface& refined, vtkPolyData* output)
{
  const vtkIdType oldSize = input->GetNumberOfPoints();
  const vtkIdType newSize = static_cast<vtkIdType>(refined.Points.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(newSize);
  points->GetData()->InsertTuples(0, oldSize, 0, input->GetPoints()->GetData());
  for (vtkIdType i = oldSize; i < newSize; ++i)
  {
    const Eigen::Vector3d point = mesh.GetOrigin() + refined.Points[i].cast<double>();
    points->SetPoint(i, point.data());
  }
  output->SetPoints(points);
}

//------------------------------------------------------------------------------
void SetPointArrays(vtkPointData* input, const npr::RefinedSurface& refined, vtkPolyData* surface)
{
  vtkPointData* output = surface->GetPointData();
  for (int i = 0; i < input->GetNumberOfArrays(); ++i)
  {
    const int index = output->AddArray(npr::ExtendArray(input->GetAbstractArray(i), refined));
    const int attribute = input->IsArrayAnAttribute(i);
    if (attribute >= 0)
    {
      output->SetActiveAttribute(index, attribute);
    }
  }
  output->SetNormals(npr::MakeArray<3>(npr::names::Normals, refined.Normals));
  vtkDataArray* tensors = input->GetArray(npr::names::CurvatureTensor);
  if (tensors && tensors->GetNumberOfComponents() == 6)
  {
    npr::AddCurvatureArrays(
      surface, npr::ExtendTensors(npr::ReadTuples<6>(tensors), refined), refined.Normals);
  }
  if (vtkDataArray* border = output->GetArray(npr::names::BorderPoints))
  {
    for (std::size_t i = 0; i < refined.BorderPoints.size(); ++i)
    {
      border->SetComponent(static_cast<vtkIdType>(i), 0, refined.BorderPoints[i]);
    }
  }
  if (vtkDataArray* welded = output->GetArray(npr::names::WeldedPointIds))
  {
    for (std::size_t i = 0; i < refined.WeldedPointIds.size(); ++i)
    {
      welded->SetComponent(static_cast<vtkIdType>(i), 0, refined.WeldedPointIds[i]);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkNPRSurfaceRefinement::vtkNPRSurfaceRefinement() = default;
vtkNPRSurfaceRefinement::~vtkNPRSurfaceRefinement() = default;

//------------------------------------------------------------------------------
int vtkNPRSurfaceRefinement::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  npr::TriangleMesh mesh(input);
  if (mesh.GetNumberOfTriangles() == 0)
  {
    output->ShallowCopy(input);
    return 1;
  }
  mesh.BuildIncidence();
  npr::SurfaceRefinementOptions options;
  options.NumberOfLevels = this->NumberOfLevels;
  const double lengthScale = npr::GetLengthScale(input);
  options.MaximumEdgeLength = this->MaximumEdgeLength * lengthScale;
  options.MaximumNumberOfTriangles = this->MaximumNumberOfTriangles;
  const npr::RefinedSurface refined = npr::RefineSurface(
    mesh, npr::GetUnitNormals(mesh, npr::FindNormals(input)), GetWeldedPointIds(input), options);
  this->UpdateProgress(0.6);

  SetPoints(input, mesh, refined, output);
  npr::SetTriangles(output, refined.Triangles);
  SetPointArrays(input->GetPointData(), refined, output);
  std::vector<vtkIdType> cells(refined.SourceTriangles.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    cells[i] = mesh.GetCellId(refined.SourceTriangles[i]);
  }
  npr::SelectTuples(input->GetCellData(), cells, output->GetCellData());
  output->GetFieldData()->PassData(input->GetFieldData());
  npr::SetLengthScale(output, lengthScale);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRSurfaceRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "MaximumNumberOfTriangles: " << this->MaximumNumberOfTriangles << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
}
