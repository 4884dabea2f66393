// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRDirectionStrokes.h"

#include "nprArrayNames.h"
#include "nprDirectionTracer.h"
#include "nprLengthScale.h"
#include "nprProgress.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

vtkStandardNewMacro(vtkNPRDirectionStrokes);

namespace
{
constexpr double TaperShare = 0.3; // of a stroke's length, at either end
}

//------------------------------------------------------------------------------
vtkNPRDirectionStrokes::vtkNPRDirectionStrokes()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, npr::names::PrincipalDirection1);
}

//------------------------------------------------------------------------------
vtkNPRDirectionStrokes::~vtkNPRDirectionStrokes()
{
  this->SetStrengthArray(nullptr);
}

//------------------------------------------------------------------------------
int vtkNPRDirectionStrokes::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (input->GetNumberOfPolys() == 0)
  {
    return 1;
  }
  vtkDataArray* const directions = this->GetInputArrayToProcess(0, inputs);
  if (!directions || directions->GetNumberOfComponents() != 3 ||
    directions->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    vtkErrorMacro("The surface has no point array of directions with 3 components; run "
                  "vtkNPRCurvatureTensor first, or name one by SetInputArrayToProcess().");
    return 0;
  }
  std::vector<float> strengths;
  if (this->StrengthArray)
  {
    vtkDataArray* const array = input->GetPointData()->GetArray(this->StrengthArray);
    if (!array || array->GetNumberOfComponents() != 1 ||
      array->GetNumberOfTuples() != input->GetNumberOfPoints())
    {
      vtkErrorMacro("The surface has no point array '"
        << this->StrengthArray << "' of single values; name one that it has as StrengthArray.");
      return 0;
    }
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      strengths.push_back(static_cast<float>(array->GetTuple1(i)));
    }
  }

  npr::TriangleMesh mesh(input);
  mesh.BuildNeighbours();
  const double spacing = this->Spacing * npr::GetLengthScale(input, mesh);
  if (!(spacing > 0.0))
  {
    return 1;
  }
  const npr::Tuples<3> axes = npr::ReadTuples<3>(directions);
  npr::DirectionTracer tracer(mesh, axes, strengths, spacing, this->Length * spacing);
  const auto curves = tracer.Trace(npr::ReportTo(this));
  if (npr::IsAborted(this))
  {
    return 1;
  }

  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkFloatArray> strength;
  strength->SetName(npr::names::Strength);
  vtkNew<vtkFloatArray> normals;
  normals->SetName(npr::names::Normals);
  normals->SetNumberOfComponents(3);
  for (const npr::TracedCurve& curve : curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.size()));
    const double taper = TaperShare * (curve.size() - 1);
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      const Eigen::Vector3d p = curve[i].Position + mesh.GetOrigin();
      lines->InsertCellPoint(points->InsertNextPoint(p.data()));
      normals->InsertNextTuple(curve[i].Normal.data());
      const auto fromEnd = static_cast<double>(std::min(i, curve.size() - 1 - i));
      strength->InsertNextValue(
        static_cast<float>(curve[i].Strength * (fromEnd < taper ? fromEnd / taper : 1.0)));
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(strength);
  output->GetPointData()->SetNormals(normals);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRDirectionStrokes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "StrengthArray: " << (this->StrengthArray ? this->StrengthArray : "(none)")
     << "\n";
}
