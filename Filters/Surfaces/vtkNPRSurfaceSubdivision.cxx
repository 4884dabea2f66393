// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfaceSubdivision.h"

#include "nprOpenMesh.h"
#include "nprPointStencils.h"
#include "nprProgress.h"
#include "nprRemeshedArrays.h"
#include "nprSurfaceArrays.h"
#include "nprSurfaceSubdivision.h"
#include "nprWeldedPoints.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkNPRSurfaceSubdivision);

namespace
{
using Index = npr::TriangleMesh::Index;

/// Rounding differs with the order of the sums; copies of a point must not come apart.
vtkSmartPointer<vtkPoints> MakePoints(vtkPoints* input, const npr::SubdivisionStep& step)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  const auto coordinates = npr::ApplyStencils(input->GetData(), step.Stencils);
  points->SetData(vtkDataArray::SafeDownCast(coordinates));
  for (std::size_t i = 0; i < step.WeldedPointIds.size(); ++i)
  {
    const Index first = step.WeldedPointIds[i];
    if (first != static_cast<Index>(i))
    {
      double point[3];
      points->GetPoint(first, point);
      points->SetPoint(static_cast<vtkIdType>(i), point);
    }
  }
  return points;
}

/// Numbers of the edges, and so of midpoints, have the type Index.
bool IsTooLarge(vtkIdType numberOfTriangles, int numberOfSubdivisions)
{
  return numberOfTriangles * std::pow(4.0, numberOfSubdivisions) >
    std::numeric_limits<Index>::max() / 3;
}
}

//------------------------------------------------------------------------------
vtkNPRSurfaceSubdivision::vtkNPRSurfaceSubdivision() = default;
vtkNPRSurfaceSubdivision::~vtkNPRSurfaceSubdivision() = default;

//------------------------------------------------------------------------------
int vtkNPRSurfaceSubdivision::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (this->NumberOfSubdivisions == 0 || input->GetNumberOfCells() == 0)
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
  if (IsTooLarge(input->GetNumberOfCells(), this->NumberOfSubdivisions))
  {
    vtkErrorMacro("To part " << input->GetNumberOfCells() << " triangles "
                             << this->NumberOfSubdivisions
                             << " times makes more than there are numbers for: take fewer "
                                "subdivisions.");
    return 0;
  }
  const auto scheme =
    this->Scheme == LOOP ? npr::SubdivisionScheme::Loop : npr::SubdivisionScheme::Butterfly;
  std::vector<npr::TriangleMesh::Triangle> triangles = npr::GetAllTriangles(input);
  vtkSmartPointer<vtkPolyData> surface = input;
  // The last step does three quarters of the work.
  double share = std::pow(0.25, this->NumberOfSubdivisions);
  for (int level = 0; level < this->NumberOfSubdivisions; ++level, share *= 4.0)
  {
    this->UpdateProgress(share);
    if (npr::IsAborted(this))
    {
      output->ShallowCopy(input);
      return 1;
    }
    npr::HalfEdgeMesh mesh;
    if (!npr::MakeHalfEdges(static_cast<Index>(surface->GetNumberOfPoints()), triangles, mesh))
    {
      vtkErrorMacro("OpenMesh refuses a triangle. Run vtkNPRSurfacePreparation first.");
      return 0;
    }
    npr::SubdivisionStep step = npr::SubdivideSurface(mesh, npr::GetWeldedPoints(surface), scheme);
    auto next = vtkSmartPointer<vtkPolyData>::New();
    next->SetPoints(MakePoints(surface->GetPoints(), step));
    npr::ApplyStencils(surface->GetPointData(), step.Stencils, next->GetPointData());
    npr::ReplaceWeldedPointIds(next, step.WeldedPointIds);
    triangles.swap(step.Triangles);
    surface = next;
  }
  output->SetPoints(surface->GetPoints());
  output->GetPointData()->PassData(surface->GetPointData());
  npr::SetTriangles(output, triangles);
  const vtkIdType parts = vtkIdType(1) << (2 * this->NumberOfSubdivisions);
  std::vector<vtkIdType> sources(triangles.size());
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    sources[i] = static_cast<vtkIdType>(i) / parts;
  }
  npr::SelectTuples(input->GetCellData(), sources, output->GetCellData());
  output->GetFieldData()->PassData(input->GetFieldData());
  npr::DropShapeArrays(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRSurfaceSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << (this->Scheme == LOOP ? "loop" : "butterfly") << "\n";
  os << indent << "NumberOfSubdivisions: " << this->NumberOfSubdivisions << "\n";
}
