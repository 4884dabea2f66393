// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Selecting lines by kind and by length, with their arrays.
#include "vtkNPRLineSelection.h"

#include "nprArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <cstdlib>
#include <iostream>
#include <vector>

namespace
{
/// Four lines along X: kinds 0 1 1 0, lengths 1 2 3 4, with the cell array Number 10 11 12 13.
void MakeLines(vtkPolyData* lines)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> types;
  types->SetName(npr::names::LineType);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (int i = 0; i < 4; ++i)
  {
    cells->InsertNextCell(3);
    for (int j = 0; j < 3; ++j)
    {
      cells->InsertCellPoint(points->InsertNextPoint(0.5 * j * (i + 1), i, 0.0));
    }
    types->InsertNextValue(i == 1 || i == 2);
    numbers->InsertNextValue(10 + i);
  }
  vtkNew<vtkStringArray> names;
  names->SetName(npr::names::LineTypeNames);
  names->InsertNextValue("contours");
  names->InsertNextValue("creases");
  lines->SetPoints(points);
  lines->SetLines(cells);
  lines->GetCellData()->AddArray(types);
  lines->GetCellData()->AddArray(numbers);
  lines->GetFieldData()->AddArray(names);
}

bool CheckSelection(vtkPolyData* lines, const char* type, double minimum, std::vector<int> expected)
{
  vtkNew<vtkNPRLineSelection> selection;
  selection->SetInputData(lines);
  selection->SetLineType(type);
  selection->SetMinimumLength(minimum);
  selection->Update();
  vtkPolyData* output = selection->GetOutput();
  vtkDataArray* numbers = output->GetCellData()->GetArray("Number");
  std::vector<int> got;
  for (vtkIdType i = 0; i < output->GetNumberOfLines(); ++i)
  {
    got.push_back(static_cast<int>(numbers->GetComponent(i, 0)));
    const bool inPlace =
      output->GetCell(i)->GetPoints()->GetPoint(0)[1] == numbers->GetComponent(i, 0) - 10;
    if (!inPlace)
    {
      std::cerr << "FAILED: line " << i << " has the points of another\n";
      return false;
    }
  }
  if (got != expected)
  {
    std::cerr << "FAILED: type '" << type << "', minimum " << minimum << ": " << got.size()
              << " lines\n";
    return false;
  }
  return true;
}
}

int TestLineSelection(int, char*[])
{
  vtkNew<vtkPolyData> lines;
  MakeLines(lines);
  bool good = CheckSelection(lines, "", 0.0, { 10, 11, 12, 13 });
  good = CheckSelection(lines, "contours", 0.0, { 10, 13 }) && good;
  good = CheckSelection(lines, "creases", 2.5, { 12 }) && good;
  good = CheckSelection(lines, "creases", 3.0, { 12 }) && good;
  good = CheckSelection(lines, "hair", 0.0, {}) && good;
  good = CheckSelection(lines, "", 100.0, {}) && good;

  vtkNew<vtkPolyData> empty;
  good = CheckSelection(empty, "contours", 0.0, {}) && good;

  vtkNew<vtkNPRLineSelection> byIndex;
  byIndex->SetInputData(lines);
  byIndex->SetLineIndex(0);
  byIndex->Update();
  good = byIndex->GetOutput()->GetNumberOfLines() == 2 && good;

  vtkObject::GlobalWarningDisplayOff();
  lines->GetFieldData()->Initialize();
  return CheckSelection(lines, "contours", 0.0, {}) && good ? EXIT_SUCCESS : EXIT_FAILURE;
}
