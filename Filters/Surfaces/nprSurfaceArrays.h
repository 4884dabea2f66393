// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSurfaceArrays.h
 * @brief Builds a vtkPolyData of triangles from flat arrays and from parts of another.
 */
#ifndef nprSurfaceArrays_h
#define nprSurfaceArrays_h

#include "nprTriangleMesh.h"
#include "nprVTKCompat.h"
#include "vtkNPRFiltersSurfacesModule.h"

#include <vtkType.h>

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSetAttributes;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// Makes the triangles the surface's only cells.
VTKNPRFILTERSSURFACES_EXPORT void SetTriangles(
  vtkPolyData* surface, const std::vector<TriangleMesh::Triangle>& triangles);

/// Makes `output` have those tuples of `input`, in that order, with what is active.
VTKNPRFILTERSSURFACES_EXPORT void SelectTuples(
  vtkDataSetAttributes* input, const std::vector<vtkIdType>& ids, vtkDataSetAttributes* output);

/// Makes `output` have those points of `input`, in that order, with their arrays.
VTKNPRFILTERSSURFACES_EXPORT void SelectPoints(
  vtkPolyData* input, const std::vector<vtkIdType>& ids, vtkPolyData* output);
}

#endif
