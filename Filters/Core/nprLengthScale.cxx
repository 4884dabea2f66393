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
//------------------------------------------------------------------------------
double GetLengthScale(vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetFieldData()->GetArray(names::LengthScale);
  if (array && array->GetNumberOfTuples() > 0)
  {
    const double lengthScale = array->GetComponent(0, 0);
    if (lengthScale > 0.0 && std::isfinite(lengthScale))
    {
      return lengthScale;
    }
  }
  return TriangleMesh(surface).ComputeLengthScale();
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
