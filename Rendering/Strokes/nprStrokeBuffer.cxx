// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeBuffer.h"

#include "nprArrayNames.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
vtkDataArray* GetPointScalars(vtkPolyData* strokes, const char* name)
{
  vtkDataArray* array = strokes->GetPointData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() == strokes->GetNumberOfPoints();
  return fits ? array : nullptr;
}

float GetFactor(vtkDataArray* array, vtkIdType id)
{
  const double value = array ? array->GetComponent(id, 0) : 1.0;
  return std::isfinite(value) ? static_cast<float>(std::max(value, 0.0)) : 0.0f;
}
}

StrokeRecords MakeStrokeRecords(vtkPolyData* strokes)
{
  StrokeRecords result;
  vtkCellArray* lines = strokes->GetLines();
  vtkPoints* points = strokes->GetPoints();
  const vtkIdType numberOfLines = lines ? lines->GetNumberOfCells() : 0;
  if (numberOfLines == 0 || !points)
  {
    return result;
  }
  vtkBoundingBox box;
  double point[3];
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, point);
    if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
    {
      box.AddPoint(point);
    }
  }
  if (!box.IsValid())
  {
    return result;
  }
  box.GetCenter(result.Origin.data());

  vtkDataArray* widths = GetPointScalars(strokes, names::Width);
  vtkDataArray* strengths = GetPointScalars(strokes, names::Strength);
  result.Records.resize(lines->GetNumberOfConnectivityIds());
  std::vector<vtkIdType> first(numberOfLines + 1, 0);
  for (vtkIdType line = 0; line < numberOfLines; ++line)
  {
    first[line + 1] = first[line] + lines->GetCellSize(line);
  }
  vtkSMPTools::For(0, numberOfLines,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType line = begin; line < end; ++line)
      {
        lines->GetCellAtId(line, ids);
        StrokeRecord* record = result.Records.data() + first[line];
        const vtkIdType size = ids->GetNumberOfIds();
        for (vtkIdType i = 0; i < size; ++i)
        {
          const vtkIdType id = ids->GetId(i);
          double x[3];
          points->GetPoint(id, x);
          const bool finite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
          for (int c = 0; c < 3; ++c)
          {
            record[i].Position[c] = finite ? static_cast<float>(x[c] - result.Origin[c]) : 0.0f;
          }
          record[i].Width = GetFactor(widths, id);
          record[i].Strength = GetFactor(strengths, id);
          record[i].Unused[0] = record[i].Unused[1] = 0.0f;
          record[i].Connected = finite && i + 1 < size ? 1.0f : 0.0f;
          if (!finite && i > 0)
          {
            record[i - 1].Connected = 0.0f;
          }
        }
      }
    });
  if (widths)
  {
    result.MaximumWidth = 0;
    for (const StrokeRecord& record : result.Records)
    {
      result.MaximumWidth = std::max(result.MaximumWidth, record.Width);
    }
  }
  return result;
}
}
