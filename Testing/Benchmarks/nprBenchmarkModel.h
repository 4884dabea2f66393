// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprBenchmarkModel.h
 * @brief The surface that benchmarks measure on.
 */
#ifndef nprBenchmarkModel_h
#define nprBenchmarkModel_h

#include "vtkNPRModelImporter.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace nprbench
{
/// A file's surface, prepared but not split along creases: the geometry alone, in single precision,
/// whatever the file has. Null, with the importer's error, where there is none.
inline vtkSmartPointer<vtkPolyData> ReadModel(const char* name)
{
  vtkNew<vtkNPRModelImporter> importer;
  importer->SetFileName(name);
  vtkNew<vtkPolyData> model;
  if (!importer->GetSurface(model))
  {
    return nullptr;
  }
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(model);
  preparation->SetSplitCreases(false);
  preparation->Update();
  vtkNew<vtkPoints> points; // which are floats, and stay so
  points->DeepCopy(preparation->GetOutput()->GetPoints());
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(preparation->GetOutput()->GetPolys());
  return surface;
}
}

#endif
