// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPlainMesh.h
 * @brief Surfaces as the plain implementations take them.
 */
#ifndef nprPlainMesh_h
#define nprPlainMesh_h

#include "nprArrayNames.h"
#include "nprPlainCurvature.h"
#include "nprTriangleMesh.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <type_traits>

namespace nprbench
{
/// Points and triangles. The points are relative to `origin`.
inline PlainMesh MakePlainMesh(vtkPolyData* surface, Eigen::Vector3d* origin = nullptr)
{
  const npr::TriangleMesh mesh(surface);
  PlainMesh plain;
  plain.Points.assign(mesh.GetPoints().begin(), mesh.GetPoints().end());
  plain.Triangles.assign(mesh.GetTriangles().begin(), mesh.GetTriangles().end());
  if (origin)
  {
    *origin = mesh.GetOrigin();
  }
  return plain;
}

/// Gives it the normals, the curvature and its derivatives that are in the surface's arrays.
inline void CopyCurvature(vtkPolyData* surface, PlainMesh& plain)
{
  const auto copy = [surface](const char* name, auto& values)
  {
    vtkDataArray* const array = surface->GetPointData()->GetArray(name);
    const vtkIdType size = surface->GetNumberOfPoints();
    values.resize(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if constexpr (std::is_same_v<std::decay_t<decltype(values[i])>, float>)
      {
        values[i] = static_cast<float>(array->GetComponent(i, 0));
      }
      else
      {
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        {
          values[i][c] = static_cast<float>(array->GetComponent(i, c));
        }
      }
    }
  };
  copy(npr::names::Normals, plain.Normals);
  copy(npr::names::PrincipalCurvature1, plain.K1);
  copy(npr::names::PrincipalCurvature2, plain.K2);
  copy(npr::names::PrincipalDirection1, plain.E1);
  copy(npr::names::PrincipalDirection2, plain.E2);
  copy(npr::names::CurvatureDerivatives, plain.Derivatives);
}
}

#endif
