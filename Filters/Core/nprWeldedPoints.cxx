// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprWeldedPoints.h"

#include "nprArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <numeric>
#include <unordered_map>

namespace npr
{
//------------------------------------------------------------------------------
std::vector<TriangleMesh::Index> GetWeldedPoints(vtkPolyData* surface)
{
  using Index = TriangleMesh::Index;
  const vtkIdType size = surface->GetNumberOfPoints();
  std::vector<Index> points(size);
  std::iota(points.begin(), points.end(), 0);
  vtkDataArray* array = surface->GetPointData()->GetArray(names::WeldedPointIds);
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != size)
  {
    return points;
  }
  std::unordered_map<double, Index> firsts;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double id = array->GetComponent(i, 0);
    // The surface that was prepared, as it is: a copy's id is that of the first.
    const bool isPoint = id >= 0.0 && id < static_cast<double>(size);
    points[i] = isPoint && array->GetComponent(static_cast<vtkIdType>(id), 0) == id
      ? static_cast<Index>(id)
      : firsts.emplace(id, static_cast<Index>(i)).first->second;
  }
  return points;
}
}
