// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfacePreparation.h"

#include "nprArrayNames.h"
#include "nprLengthScale.h"
#include "nprSurfaceArrays.h"

#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <sstream>

vtkStandardNewMacro(vtkNPRSurfacePreparation);

//------------------------------------------------------------------------------
vtkNPRSurfacePreparation::vtkNPRSurfacePreparation() = default;
vtkNPRSurfacePreparation::~vtkNPRSurfacePreparation() = default;

//------------------------------------------------------------------------------
int vtkNPRSurfacePreparation::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);

  npr::SurfacePreparationOptions options;
  options.Weld = this->Weld;
  // The scale of the surface as it comes; to weld hardly changes it.
  options.WeldTolerance =
    this->WeldTolerance > 0.0 ? this->WeldTolerance * npr::GetLengthScale(input) : 0.0;
  options.Orient = this->Orient;
  options.SplitCreases = this->SplitCreases;
  options.CreaseAngle = this->CreaseAngle;
  const npr::PreparedSurface surface = npr::PrepareSurface(input, options);
  this->Counts = surface.Counts;
  this->UpdateProgress(0.8);

  npr::SetTriangles(output, surface.Triangles);
  npr::SelectPoints(input, surface.SourcePoints, output);
  npr::SelectTuples(input->GetCellData(), surface.SourceCells, output->GetCellData());

  vtkNew<vtkIdTypeArray> weldedPointIds;
  weldedPointIds->SetName(npr::names::WeldedPointIds);
  weldedPointIds->SetNumberOfTuples(static_cast<vtkIdType>(surface.WeldedPointIds.size()));
  std::copy(
    surface.WeldedPointIds.begin(), surface.WeldedPointIds.end(), weldedPointIds->GetPointer(0));
  output->GetPointData()->AddArray(weldedPointIds);

  output->GetFieldData()->PassData(input->GetFieldData());
  if (!output->GetFieldData()->HasArray(npr::names::LengthScale))
  {
    npr::SetLengthScale(output, surface.LengthScale);
  }
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkNPRSurfacePreparation::GetReport() const
{
  const std::pair<vtkIdType, const char*> parts[] = {
    { this->Counts.DroppedCells, "vertices and lines dropped" },
    { this->Counts.TriangulatedCells, "polygons and strips triangulated" },
    { this->Counts.NonFiniteTriangles, "triangles without finite points dropped" },
    { this->Counts.WeldedPoints, "points welded" },
    { this->Counts.UnusedPoints, "unused points dropped" },
    { this->Counts.DegenerateTriangles, "triangles without area dropped" },
    { this->Counts.FlippedNeedles, "needles mended" },
    { this->Counts.DuplicateTriangles, "duplicate triangles dropped" },
    { this->Counts.ReorientedTriangles, "triangles reoriented" },
    { this->Counts.NonManifoldEdges, "non-manifold edges" },
    { this->Counts.BoundaryEdges, "boundary edges" },
    { this->Counts.CreaseEdges, "crease edges" },
    { this->Counts.SplitPoints, "points made by splitting creases" },
  };
  std::ostringstream report;
  const char* separator = "";
  for (const auto& part : parts)
  {
    if (part.first > 0)
    {
      report << separator << part.first << " " << part.second;
      separator = ", ";
    }
  }
  return *separator ? report.str() : "nothing to do";
}

//------------------------------------------------------------------------------
void vtkNPRSurfacePreparation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Weld: " << this->Weld << "\n";
  os << indent << "WeldTolerance: " << this->WeldTolerance << "\n";
  os << indent << "Orient: " << this->Orient << "\n";
  os << indent << "SplitCreases: " << this->SplitCreases << "\n";
  os << indent << "CreaseAngle: " << this->CreaseAngle << "\n";
  os << indent << "Report: " << this->GetReport() << "\n";
}
