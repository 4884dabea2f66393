// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeCurves.h"

#include "vtkNPRSplineStrokes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace npr
{
namespace
{
const char* const ColorsName = "vtkNPRStrokeMapper colors";
const char* const LinesName = "vtkNPRStrokeMapper lines";

vtkDataSetAttributes* GetData(vtkPolyData* strokes, bool ofCells)
{
  vtkDataSetAttributes* cells = strokes->GetCellData();
  return ofCells ? cells : strokes->GetPointData();
}
}

//------------------------------------------------------------------------------
StrokeRecords SampleStrokeCurves(vtkPolyData* strokes, vtkUnsignedCharArray* colors, bool ofCells,
  const StrokeTolerance& tolerance, const CurveSettings& settings)
{
  // What belongs to points and lines goes with them.
  vtkNew<vtkPolyData> input;
  input->ShallowCopy(strokes);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(LinesName);
  numbers->SetNumberOfValues(input->GetNumberOfCells());
  const vtkIdType firstLine = input->GetNumberOfVerts();
  for (vtkIdType i = 0; i < numbers->GetNumberOfValues(); ++i)
  {
    numbers->SetValue(i, i - firstLine);
  }
  input->GetCellData()->AddArray(numbers);
  if (colors)
  {
    vtkNew<vtkUnsignedCharArray> copy;
    copy->ShallowCopy(colors);
    copy->SetName(ColorsName);
    GetData(input, ofCells)->AddArray(copy);
  }
  vtkNew<vtkNPRSplineStrokes> splines;
  splines->SetInputData(input);
  splines->SetSplineType(static_cast<int>(settings.Kind));
  splines->SetTension(SplineTension);
  splines->SetCornerAngle(settings.CornerAngle);
  splines->SetMaximumChordError(settings.ChordError * tolerance.Length);
  splines->Update();
  vtkPolyData* const sampled = splines->GetOutput();
  StrokeRecords records = MakeStrokeRecords(sampled,
    vtkUnsignedCharArray::SafeDownCast(GetData(sampled, ofCells)->GetArray(ColorsName)), ofCells,
    tolerance);
  vtkDataArray* const lines = sampled->GetCellData()->GetArray(LinesName);
  for (std::size_t i = 0; i + 1 < records.Begins.size(); ++i)
  {
    records.Lines.push_back(
      static_cast<std::ptrdiff_t>(lines->GetComponent(static_cast<vtkIdType>(i), 0)));
  }
  return records;
}

//------------------------------------------------------------------------------
double FindOvershoot(vtkPolyData* strokes, SplineKind kind)
{
  if (kind != SplineKind::CatmullRom)
  {
    return 0.0; // within the hull
  }
  double longest = 0.0;
  vtkCellArray* const lines = strokes->GetLines();
  vtkNew<vtkIdList> ids;
  Vector3 places[2];
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    lines->GetCellAtId(line, ids);
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      strokes->GetPoint(ids->GetId(i - 1), places[0].data());
      strokes->GetPoint(ids->GetId(i), places[1].data());
      const double length = std::hypot(
        places[1][0] - places[0][0], places[1][1] - places[0][1], places[1][2] - places[0][2]);
      longest = length > longest && std::isfinite(length) ? length : longest;
    }
  }
  // The negative weights of a span's four points sum up to -t (1 - t) times the tension.
  return 0.25 * SplineTension * 3.0 * longest;
}
}
