// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprIrregularMeshes.h
 * @brief Meshes whose points and cells can be told apart, for what must not depend on how they are
 * dealt with.
 */
#ifndef nprIrregularMeshes_h
#define nprIrregularMeshes_h

#include "nprAnalyticSurfaces.h"

#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkPointData.h>

namespace nprtest
{
inline constexpr const char* PointNumbers = "PointNumbers";
inline constexpr const char* CellNumbers = "CellNumbers";

inline void AddNumbers(vtkDataSetAttributes* attributes, const char* name, vtkIdType size)
{
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(name);
  for (vtkIdType i = 0; i < size; ++i)
  {
    numbers->InsertNextValue(i);
  }
  attributes->AddArray(numbers);
}

/// The surface with its points moved at random by up to `noise` in each coordinate, and with point
/// and cell numbers.
inline vtkSmartPointer<vtkPolyData> MakeIrregular(const AnalyticSurface& surface, double noise)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  for (vtkIdType i = 0; i < surface.Mesh->GetNumberOfPoints(); ++i)
  {
    Vector3d point = surface.Truths[i].Point;
    for (double& coordinate : point)
    {
      random->Next();
      coordinate += random->GetRangeValue(-noise, noise);
    }
    surface.Mesh->GetPoints()->SetPoint(i, point.data());
  }
  AddNumbers(surface.Mesh->GetPointData(), PointNumbers, surface.Mesh->GetNumberOfPoints());
  AddNumbers(surface.Mesh->GetCellData(), CellNumbers, surface.Mesh->GetNumberOfCells());
  return surface.Mesh;
}
}

#endif
