// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfaceRefinement.h"

#include "nprArrayNames.h"
#include "nprChordErrors.h"
#include "nprCurvature.h"
#include "nprGhostLevels.h"
#include "nprLengthScale.h"
#include "nprMidpointArrays.h"
#include "nprProgress.h"
#include "nprRemeshedArrays.h"
#include "nprSurfaceArrays.h"
#include "nprSurfaceNormals.h"
#include "nprSurfaceRefinement.h"
#include "nprTangentArrays.h"
#include "nprWeldedPoints.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkNPRSurfaceRefinement);

namespace
{
using Index = npr::TriangleMesh::Index;

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
/// The input's array of that many components, a tuple for each point, else null.
vtkDataArray* Find(
  vtkPointData* input, const npr::RefinedSurface& refined, const char* name, int components)
{
  vtkDataArray* array = input->GetArray(name);
  return array && array->GetNumberOfComponents() == components &&
      array->GetNumberOfTuples() == refined.GetNumberOfCoarsePoints()
    ? array
    : nullptr;
}

//------------------------------------------------------------------------------
/// The tensors in the tangent planes of all points, and of what follows from them those arrays that
/// the input has: none of it can be interpolated by its components, which refer to a frame of their
/// own at each point.
void SetCurvatureArrays(
  vtkPointData* input, const npr::RefinedSurface& refined, vtkPolyData* surface)
{
  vtkDataArray* const array = Find(input, refined, npr::names::CurvatureTensor, 6);
  if (!array || refined.Parents.empty())
  {
    return;
  }
  const npr::Tuples<6> coarse = npr::ReadTuples<6>(array);
  npr::CurvatureArrays wanted;
  wanted.PrincipalCurvatures = input->HasArray(npr::names::PrincipalCurvature1);
  wanted.PrincipalDirections = input->HasArray(npr::names::PrincipalDirection1);
  wanted.MeanCurvature = input->HasArray(npr::names::MeanCurvature);
  wanted.GaussianCurvature = input->HasArray(npr::names::GaussianCurvature);
  wanted.ShapeIndex = input->HasArray(npr::names::ShapeIndex);
  wanted.Curvedness = input->HasArray(npr::names::Curvedness);
  npr::Tuples<4> derivatives;
  if (vtkDataArray* coarseDerivatives = Find(input, refined, npr::names::CurvatureDerivatives, 4))
  {
    // A direction may point either way, and the derivatives say nothing without knowing which.
    vtkDataArray* const given = Find(input, refined, npr::names::PrincipalDirection1, 3);
    const npr::Tuples<3> e1 = given
      ? npr::ReadTuples<3>(given)
      : npr::ComputePrincipalFrames(
          coarse, { refined.Normals.begin(), refined.Normals.begin() + coarse.size() })
          .E1;
    derivatives = npr::ExtendDerivatives(npr::ReadTuples<4>(coarseDerivatives), e1, refined);
  }
  npr::AddCurvatureArrays(
    surface, npr::ExtendTensors(coarse, refined), refined.Normals, wanted, std::move(derivatives));
}

//------------------------------------------------------------------------------
/// A midpoint belongs to the piece that one of its ends belongs to: to that of the end that comes
/// first in space, which all pieces agree about.
void SetPointGhosts(const npr::RefinedSurface& refined, vtkPolyData* surface)
{
  vtkUnsignedCharArray* ghosts = surface->GetPointGhostArray();
  if (!ghosts)
  {
    return;
  }
  vtkIdType point = surface->GetNumberOfPoints() - static_cast<vtkIdType>(refined.Parents.size());
  for (const std::array<Index, 2>& ends : refined.Parents)
  {
    std::array<double, 3> a;
    std::array<double, 3> b;
    surface->GetPoint(ends[0], a.data());
    surface->GetPoint(ends[1], b.data());
    ghosts->SetValue(point++, ghosts->GetValue(a < b ? ends[0] : ends[1]));
  }
}

//------------------------------------------------------------------------------
void SetChordErrors(
  const npr::TriangleMesh& coarse, const npr::RefinedSurface& refined, vtkPolyData* surface)
{
  const std::vector<float> errors = npr::MeasureChordErrors(coarse,
    { refined.Normals.begin(), refined.Normals.begin() + refined.GetNumberOfCoarsePoints() });
  vtkNew<vtkFloatArray> array;
  array->SetName(npr::names::ChordError);
  array->SetNumberOfValues(static_cast<vtkIdType>(refined.SourceTriangles.size()));
  for (std::size_t t = 0; t < refined.SourceTriangles.size(); ++t)
  {
    array->SetValue(static_cast<vtkIdType>(t), errors[refined.SourceTriangles[t]]);
  }
  surface->GetCellData()->AddArray(array);
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
  SetCurvatureArrays(input, refined, surface);
  SetPointGhosts(refined, surface);
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
int vtkNPRSurfaceRefinement::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  npr::RequestGhostLevels(inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0),
    npr::GetRefinementReach(this->NumberOfLevels) + npr::NormalsReach);
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkNPRSurfaceRefinement::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  vtkInformation* outputInformation = outputs->GetInformationObject(0);
  if (!this->Compute(input, output, npr::IsPiece(outputInformation)))
  {
    output->ShallowCopy(input);
  }
  npr::DropExtraGhostLevels(output, outputInformation);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkNPRSurfaceRefinement::Compute(vtkPolyData* input, vtkPolyData* output, bool isPiece)
{
  const npr::Progress progress = npr::ReportTo(this);
  npr::TriangleMesh mesh(input);
  if (mesh.GetNumberOfTriangles() == 0 || !progress(0.1))
  {
    return false;
  }
  mesh.BuildIncidence();
  npr::SurfaceRefinementOptions options;
  options.NumberOfLevels = this->NumberOfLevels;
  const double lengthScale = npr::GetLengthScale(input, mesh);
  options.MaximumEdgeLength = this->MaximumEdgeLength * lengthScale;
  options.MaximumTurn = this->MaximumTurn;
  options.MaximumChordError = this->MaximumChordError * lengthScale;
  options.MaximumNumberOfTriangles = this->MaximumNumberOfTriangles;
  const npr::RefinedSurface refined =
    npr::RefineSurface(mesh, npr::GetUnitNormals(mesh, npr::FindNormals(input)),
      npr::GetWeldedPoints(input), options, npr::PartOf(progress, 0.1, 0.6));
  if (!progress(0.6))
  {
    return false;
  }

  SetPoints(input, mesh, refined, output);
  npr::SetTriangles(output, refined.Triangles);
  SetPointArrays(input->GetPointData(), refined, output);
  if (!progress(0.95))
  {
    return false;
  }
  std::vector<vtkIdType> cells(refined.SourceTriangles.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    cells[i] = mesh.GetCellId(refined.SourceTriangles[i]);
  }
  npr::SelectTuples(input->GetCellData(), cells, output->GetCellData());
  if (!input->GetCellData()->HasArray(npr::names::ChordError))
  {
    SetChordErrors(mesh, refined, output);
  }
  output->GetFieldData()->PassData(input->GetFieldData());
  if (!isPiece) // whose own is not the whole's
  {
    npr::SetLengthScale(output, lengthScale);
  }
  if (!refined.Parents.empty())
  {
    npr::DropDensityArrays(output);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkNPRSurfaceRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "MaximumTurn: " << this->MaximumTurn << "\n";
  os << indent << "MaximumChordError: " << this->MaximumChordError << "\n";
  os << indent << "MaximumNumberOfTriangles: " << this->MaximumNumberOfTriangles << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
}
