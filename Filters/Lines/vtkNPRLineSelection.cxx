// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRLineSelection.h"

#include "nprArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkNPRLineSelection);

namespace
{
bool IsAtLeast(double minimum, vtkPoints* points, vtkIdType size, const vtkIdType* ids)
{
  double length = 0.0;
  double from[3], to[3];
  for (vtkIdType i = 0; i < size && length < minimum; ++i)
  {
    points->GetPoint(ids[i], to);
    length += i == 0 ? 0.0 : std::sqrt(vtkMath::Distance2BetweenPoints(from, to));
    std::copy(to, to + 3, from);
  }
  return length >= minimum;
}
}

//------------------------------------------------------------------------------
int vtkNPRLineSelection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->GetFieldData()->PassData(input->GetFieldData());

  vtkIdType wanted = this->LineIndex;
  vtkDataArray* types = nullptr;
  if ((this->LineIndex >= 0 || !this->LineType.empty()) && input->GetNumberOfLines() > 0)
  {
    types = input->GetCellData()->GetArray(npr::names::LineType);
    auto names = vtkStringArray::SafeDownCast(
      input->GetFieldData()->GetAbstractArray(npr::names::LineTypeNames));
    if (!types || !names)
    {
      vtkErrorMacro("the input has no cell array " << npr::names::LineType << " or no field data "
                                                   << npr::names::LineTypeNames
                                                   << "; vtkNPRFeatureLines makes them");
      return 0;
    }
    if (this->LineIndex < 0)
    {
      wanted = names->LookupValue(this->LineType);
    }
  }

  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  output->GetCellData()->CopyAllocate(input->GetCellData());
  vtkNew<vtkCellArray> lines;
  const vtkIdType firstLine = input->GetNumberOfVerts();
  auto iterator = vtk::TakeSmartPointer(input->GetLines()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    const vtkIdType cell = firstLine + iterator->GetCurrentCellId();
    vtkIdType size;
    const vtkIdType* ids;
    iterator->GetCurrentCell(size, ids);
    const bool isWanted = !types || static_cast<vtkIdType>(types->GetComponent(cell, 0)) == wanted;
    if (isWanted && IsAtLeast(this->MinimumLength, input->GetPoints(), size, ids))
    {
      output->GetCellData()->CopyData(input->GetCellData(), cell, lines->InsertNextCell(size, ids));
    }
  }
  output->SetLines(lines);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRLineSelection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LineType: " << this->LineType << "\n";
  os << indent << "LineIndex: " << this->LineIndex << "\n";
  os << indent << "MinimumLength: " << this->MinimumLength << "\n";
}
