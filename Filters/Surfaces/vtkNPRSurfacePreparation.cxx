// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSurfacePreparation.h"

#include "nprArrayNames.h"
#include "nprLengthScale.h"
#include "nprProgress.h"
#include "nprSurfaceArrays.h"

#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <iterator>
#include <sstream>

vtkStandardNewMacro(vtkNPRSurfacePreparation);

namespace
{
using Counts = npr::SurfacePreparationCounts;

struct Count
{
  vtkIdType Counts::*Value;
  const char* Name; // of the array's component
  const char* Text; // in the report, after the number
};

// In the order in which things are done.
const Count AllCounts[] = {
  { &Counts::DroppedCells, "DroppedCells", "vertices and lines dropped" },
  { &Counts::TriangulatedCells, "TriangulatedCells", "polygons and strips triangulated" },
  { &Counts::NonFiniteTriangles, "NonFiniteTriangles", "triangles without finite points dropped" },
  { &Counts::WeldedPoints, "WeldedPoints", "points welded" },
  { &Counts::UnusedPoints, "UnusedPoints", "unused points dropped" },
  { &Counts::DegenerateTriangles, "DegenerateTriangles", "triangles without area dropped" },
  { &Counts::FlippedNeedles, "FlippedNeedles", "needles mended" },
  { &Counts::DuplicateTriangles, "DuplicateTriangles", "duplicate triangles dropped" },
  { &Counts::FoldTriangles, "FoldTriangles", "triangles of folds dropped" },
  { &Counts::CrackEdges, "CrackEdges", "edges split at T-junctions" },
  { &Counts::NonManifoldEdges, "NonManifoldEdges", "non-manifold edges" },
  { &Counts::NonManifoldPoints, "NonManifoldPoints", "non-manifold points off these" },
  { &Counts::ReorientedTriangles, "ReorientedTriangles", "triangles reoriented" },
  { &Counts::NonOrientableEdges, "NonOrientableEdges", "edges that can not be oriented" },
  { &Counts::NonManifoldSplitPoints, "NonManifoldSplitPoints",
    "points made by splitting into manifolds" },
  { &Counts::BoundaryEdges, "BoundaryEdges", "boundary edges" },
  { &Counts::MendedFoldovers, "MendedFoldovers", "folded-over triangles mended" },
  { &Counts::LeftFoldovers, "LeftFoldovers", "folded-over triangles left" },
  { &Counts::FilledHoles, "FilledHoles", "holes filled" },
  { &Counts::FillingTriangles, "FillingTriangles", "triangles added to fill them" },
  { &Counts::OpenHoles, "OpenHoles", "holes left open" },
  { &Counts::CreaseEdges, "CreaseEdges", "crease edges" },
  { &Counts::SplitPoints, "SplitPoints", "points made by splitting creases" },
};

//------------------------------------------------------------------------------
vtkSmartPointer<vtkIdTypeArray> MakeCountsArray(const Counts& counts)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(npr::names::PreparationCounts);
  array->SetNumberOfComponents(static_cast<int>(std::size(AllCounts)));
  array->SetNumberOfTuples(1);
  int component = 0;
  for (const Count& count : AllCounts)
  {
    array->SetComponentName(component, count.Name);
    array->SetTypedComponent(0, component++, counts.*count.Value);
  }
  return array;
}
}

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
  options.WeldTolerance = this->WeldTolerance;
  options.Orient = this->Orient;
  options.SplitNonManifold = this->SplitNonManifold;
  options.FillHoles = this->FillHoles;
  options.SplitCreases = this->SplitCreases;
  options.CreaseAngle = this->CreaseAngle;
  const npr::PreparedSurface surface =
    npr::PrepareSurface(input, options, npr::ReportTo(this, 0.0, 0.9));
  this->Counts = surface.Counts;
  if (npr::IsAborted(this))
  {
    return 1;
  }

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
  output->GetFieldData()->AddArray(MakeCountsArray(this->Counts));
  if (!output->GetFieldData()->HasArray(npr::names::LengthScale))
  {
    npr::SetLengthScale(output, surface.LengthScale);
  }
  vtkVLogF(vtkLogger::VERBOSITY_1, "%s: %s", vtkLogIdentifier(this), this->GetReport().c_str());
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkNPRSurfacePreparation::GetReport() const
{
  std::ostringstream report;
  const char* separator = "";
  for (const Count& count : AllCounts)
  {
    if (this->Counts.*count.Value > 0)
    {
      report << separator << this->Counts.*count.Value << " " << count.Text;
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
  os << indent << "SplitNonManifold: " << this->SplitNonManifold << "\n";
  os << indent << "FillHoles: " << this->FillHoles << "\n";
  os << indent << "SplitCreases: " << this->SplitCreases << "\n";
  os << indent << "CreaseAngle: " << this->CreaseAngle << "\n";
  os << indent << "Report: " << this->GetReport() << "\n";
}
