// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprRemeshedArrays.h"

#include "nprArrayNames.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <string>
#include <unordered_map>

namespace npr
{
using Index = TriangleMesh::Index;

//------------------------------------------------------------------------------
void ReplaceWeldedPointIds(vtkPolyData* surface, const std::vector<Index>& ids)
{
  if (!surface->GetPointData()->HasArray(names::WeldedPointIds))
  {
    return;
  }
  vtkNew<vtkIdTypeArray> array;
  array->SetName(names::WeldedPointIds);
  array->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), ids[i]);
  }
  surface->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
void RenumberWeldedPointIds(vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(names::WeldedPointIds);
  if (!array)
  {
    return;
  }
  // Copies still have a number in common, though it is that of nobody now: the first of them gives
  // them its own.
  std::unordered_map<vtkIdType, Index> firsts;
  std::vector<Index> ids(surface->GetNumberOfPoints());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const auto old = static_cast<vtkIdType>(array->GetComponent(static_cast<vtkIdType>(i), 0));
    ids[i] = firsts.emplace(old, static_cast<Index>(i)).first->second;
  }
  ReplaceWeldedPointIds(surface, ids);
}

//------------------------------------------------------------------------------
void DropShapeArrays(vtkPolyData* surface)
{
  vtkPointData* points = surface->GetPointData();
  for (vtkDataSetAttributes* attributes : { static_cast<vtkDataSetAttributes*>(points),
         static_cast<vtkDataSetAttributes*>(surface->GetCellData()) })
  {
    if (vtkDataArray* normals = attributes->GetNormals())
    {
      const std::string name = normals->GetName() ? normals->GetName() : "";
      attributes->SetNormals(nullptr);
      attributes->RemoveArray(name.c_str());
    }
  }
  for (const char* name : { names::Normals, names::CurvatureTensor, names::PrincipalCurvature1,
         names::PrincipalCurvature2, names::PrincipalDirection1, names::PrincipalDirection2,
         names::MeanCurvature, names::GaussianCurvature, names::CurvatureDerivatives,
         names::DerivativeDoubt, names::ShapeIndex, names::Curvedness, names::BorderPoints,
         names::UnknownCurvature })
  {
    points->RemoveArray(name);
  }
  for (int scale = 1;; ++scale)
  {
    const std::string name = names::ScaleNormalsPrefix + std::to_string(scale);
    if (!points->HasArray(name.c_str()))
    {
      break;
    }
    points->RemoveArray(name.c_str());
  }
  DropDensityArrays(surface);
}

//------------------------------------------------------------------------------
void DropDensityArrays(vtkPolyData* surface)
{
  surface->GetPointData()->RemoveArray(names::PointArea);
  surface->GetFieldData()->RemoveArray(names::NeighbourhoodRadius);
}
}
