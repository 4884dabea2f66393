// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprRemeshedArrays.h
 * @brief What must happen to a surface's own arrays when its points or triangles become others.
 */
#ifndef nprRemeshedArrays_h
#define nprRemeshedArrays_h

#include "nprTriangleMesh.h"
#include "nprVTKCompat.h"
#include "vtkNPRFiltersSurfacesModule.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// Replaces the array WeldedPointIds where the surface has one.
VTKNPRFILTERSSURFACES_EXPORT void ReplaceWeldedPointIds(
  vtkPolyData* surface, const std::vector<TriangleMesh::Index>& ids);

/// Renumbers WeldedPointIds, where the surface has them, after some points were dropped or all
/// were put into another order, and the arrays with them.
VTKNPRFILTERSSURFACES_EXPORT void RenumberWeldedPointIds(vtkPolyData* surface);

/// Drops what was true only of the points where they were: normals, curvatures, and the rest of
/// nprArrayNames.h that describes the shape.
VTKNPRFILTERSSURFACES_EXPORT void DropShapeArrays(vtkPolyData* surface);

/// Drops what was true only of the triangles that met at the points: PointArea and
/// NeighbourhoodRadius.
VTKNPRFILTERSSURFACES_EXPORT void DropDensityArrays(vtkPolyData* surface);
}

#endif
