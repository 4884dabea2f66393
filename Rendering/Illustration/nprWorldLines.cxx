// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprWorldLines.h"

#include "nprArrayNames.h"
#include "nprLengthScale.h"
#include "nprPageScale.h"

#include <vtkAlgorithmOutput.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>

namespace npr
{
vtkStandardNewMacro(WorldLines);

namespace
{
vtkSmartPointer<vtkPolyData> MoveToWorld(vtkPolyData* lines, vtkMatrix4x4* matrix)
{
  if (matrix->IsIdentity())
  {
    return lines;
  }
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  vtkNew<vtkTransformPolyDataFilter> toWorld;
  toWorld->SetTransform(transform);
  toWorld->SetInputData(lines);
  toWorld->Update();
  return toWorld->GetOutput();
}

void SetNumber(vtkPolyData* lines, int number)
{
  vtkNew<vtkIntArray> types;
  types->SetName(names::LineType);
  types->SetNumberOfValues(lines->GetNumberOfCells());
  types->FillValue(number);
  lines->GetCellData()->AddArray(types);
}
}

//------------------------------------------------------------------------------
WorldLines::WorldLines()
{
  this->SetNumberOfInputPorts(1);
}

//------------------------------------------------------------------------------
int WorldLines::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(INPUT_IS_REPEATABLE(), 1);
  information->Set(INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, information);
}

//------------------------------------------------------------------------------
bool WorldLines::HasSources(const std::vector<Source>& sources)
{
  bool same = sources.size() == this->Origins.size();
  for (std::size_t i = 0; same && i < sources.size(); ++i)
  {
    same = this->GetInputConnection(0, static_cast<int>(i)) == sources[i].Lines &&
      this->Origins[i].Matrix == sources[i].Matrix && this->Origins[i].Number == sources[i].Number;
  }
  return same;
}

//------------------------------------------------------------------------------
void WorldLines::SetSources(const std::vector<Source>& sources)
{
  if (this->HasSources(sources))
  {
    return;
  }
  this->RemoveAllInputConnections(0);
  this->Origins.clear();
  for (const Source& source : sources)
  {
    this->AddInputConnection(source.Lines);
    this->Origins.push_back({ source.Matrix, source.Number });
  }
  this->Modified();
}

//------------------------------------------------------------------------------
vtkMTimeType WorldLines::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const Origin& origin : this->Origins)
  {
    time = std::max(time, origin.Matrix->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
int WorldLines::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  vtkNew<vtkAppendPolyData> append;
  int mostNumbers = 0;
  double lengthScale = 0.0;
  for (std::size_t i = 0; i < this->Origins.size(); ++i)
  {
    const Origin& origin = this->Origins[i];
    vtkPolyData* const input = vtkPolyData::GetData(inputVector[0], static_cast<int>(i));
    mostNumbers = std::max(mostNumbers, origin.Number + 1);
    if (input && input->GetNumberOfLines() > 0)
    {
      vtkNew<vtkPolyData> lines;
      lines->ShallowCopy(input);
      SetNumber(lines, origin.Number);
      append->AddInputData(MoveToWorld(lines, origin.Matrix));
      lengthScale = std::max(lengthScale, GetLengthScale(input) * ComputeScale(origin.Matrix));
    }
  }
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
    output->ShallowCopy(append->GetOutput());
  }
  // Who selects lines by their numbers asks for names, too.
  vtkNew<vtkStringArray> labels;
  labels->SetName(names::LineTypeNames);
  labels->SetNumberOfValues(mostNumbers);
  output->GetFieldData()->AddArray(labels);
  SetLengthScale(output, lengthScale);
  return 1;
}
}
