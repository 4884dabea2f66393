// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprWeldedPoints.h
 * @brief Which points of a surface are copies of each other, where creases were split.
 */
#ifndef nprWeldedPoints_h
#define nprWeldedPoints_h

#include "nprTriangleMesh.h"
#include "nprVTKCompat.h"
#include "vtkNPRFiltersCoreModule.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * For each point one that stands for all its copies: points are copies of each other if the array
 * WeldedPointIds says the same of them. The ids are those of the surface that was prepared, of
 * which this may be a part: so they are not taken for points of this one. Without such an array, or
 * with one of the wrong size, each point stands for itself.
 */
VTKNPRFILTERSCORE_EXPORT std::vector<TriangleMesh::Index> GetWeldedPoints(vtkPolyData* surface);
}

#endif
