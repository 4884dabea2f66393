// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLengthScale.h"

#include "nprArrayNames.h"
#include "nprTriangleMesh.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cmath>

namespace npr
{
namespace
{
// 0 where there is none.
double GetStoredLengthScale(vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetFieldData()->GetArray(names::LengthScale);
  const double lengthScale =
    array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0.0;
  return lengthScale > 0.0 && std::isfinite(lengthScale) ? lengthScale : 0.0;
}
}

//------------------------------------------------------------------------------
double GetLengthScale(vtkPolyData* surface)
{
  const double stored = GetStoredLengthScale(surface);
  return stored > 0.0 ? stored : TriangleMesh(surface).ComputeLengthScale();
}

//------------------------------------------------------------------------------
double GetLengthScale(vtkPolyData* surface, const TriangleMesh& mesh)
{
  const double stored = GetStoredLengthScale(surface);
  return stored > 0.0 ? stored : mesh.ComputeLengthScale();
}

//------------------------------------------------------------------------------
void SetLengthScale(vtkPolyData* surface, double lengthScale)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(names::LengthScale);
  array->InsertNextValue(lengthScale);
  surface->GetFieldData()->AddArray(array);
}
}
