// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfaceArrays.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>

namespace npr
{
namespace
{
//------------------------------------------------------------------------------
bool IsWhole(const std::vector<vtkIdType>& ids, vtkIdType size)
{
  if (static_cast<vtkIdType>(ids.size()) != size)
  {
    return false;
  }
  vtkIdType expected = 0;
  return std::all_of(ids.begin(), ids.end(), [&](vtkIdType id) { return id == expected++; });
}
}

//------------------------------------------------------------------------------
void SetTriangles(vtkPolyData* surface, const std::vector<TriangleMesh::Triangle>& triangles)
{
  const vtkIdType size = static_cast<vtkIdType>(triangles.size());
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  offsets->SetNumberOfValues(size + 1);
  connectivity->SetNumberOfValues(3 * size);
  vtkIdType* const offset = offsets->GetPointer(0);
  vtkIdType* const corner = connectivity->GetPointer(0);
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType t = begin; t < end; ++t)
      {
        offset[t] = 3 * t;
        std::copy_n(triangles[t].data(), 3, corner + 3 * t);
      }
    });
  offset[size] = 3 * size;
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  surface->SetPolys(cells);
}

//------------------------------------------------------------------------------
void SelectTuples(
  vtkDataSetAttributes* input, const std::vector<vtkIdType>& ids, vtkDataSetAttributes* output)
{
  if (input->GetNumberOfArrays() == 0)
  {
    return;
  }
  if (IsWhole(ids, input->GetNumberOfTuples()))
  {
    output->PassData(input);
    return;
  }
  const vtkIdType size = static_cast<vtkIdType>(ids.size());
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  from->SetNumberOfIds(size);
  to->SetNumberOfIds(size);
  std::copy(ids.begin(), ids.end(), from->GetPointer(0));
  for (vtkIdType i = 0; i < size; ++i)
  {
    to->SetId(i, i);
  }
  output->CopyAllOn();
  output->CopyAllocate(input, size);
  output->CopyData(input, from, to);
}

//------------------------------------------------------------------------------
void SelectPoints(vtkPolyData* input, const std::vector<vtkIdType>& ids, vtkPolyData* output)
{
  if (IsWhole(ids, input->GetNumberOfPoints()))
  {
    output->SetPoints(input->GetPoints());
    output->GetPointData()->PassData(input->GetPointData());
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(ids.size()));
  vtkSMPTools::For(0, static_cast<vtkIdType>(ids.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      double point[3];
      for (vtkIdType i = begin; i < end; ++i)
      {
        input->GetPoints()->GetPoint(ids[i], point);
        points->SetPoint(i, point);
      }
    });
  output->SetPoints(points);
  SelectTuples(input->GetPointData(), ids, output->GetPointData());
}
}
