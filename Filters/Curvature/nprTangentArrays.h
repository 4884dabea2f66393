// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprTangentArrays.h
 * @brief The arrays of normals and curvatures on a vtkPolyData.
 */
#ifndef nprTangentArrays_h
#define nprTangentArrays_h

#include "nprTupleArrays.h"
#include "nprVTKCompat.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// The surface's active normals, else its array "Normals", else null.
vtkDataArray* FindNormals(vtkPolyData* surface);

/// Adds the tensor and all that follows from it: the principal curvatures and directions, the mean
/// and the Gaussian curvature.
void AddCurvatureArrays(vtkPolyData* surface, const Tuples<6>& tensors, const Tuples<3>& normals);
}

#endif
