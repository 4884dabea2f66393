// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfaceSource.h"

#include <vtkCompositeDataGeometryFilter.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>

namespace npr
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkAlgorithm> MakeSurfaceSource(vtkMapper* mapper)
{
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  vtkSmartPointer<vtkAlgorithm> source;
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    source = vtkSmartPointer<vtkCompositeDataGeometryFilter>::New();
  }
  else if (vtkDataSet::SafeDownCast(data) && !vtkPolyData::SafeDownCast(data))
  {
    source = vtkSmartPointer<vtkDataSetSurfaceFilter>::New();
  }
  if (source)
  {
    source->SetInputConnection(mapper->GetInputConnection(0, 0));
  }
  return source;
}
}
