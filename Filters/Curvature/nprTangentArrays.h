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

/// Which arrays are wanted of those that follow from the second fundamental form.
struct CurvatureArrays
{
  bool Tensor = true;
  bool PrincipalCurvatures = true;
  bool PrincipalDirections = true;
  bool MeanCurvature = true;
  bool GaussianCurvature = true;
  bool ShapeIndex = false;
  bool Curvedness = false;
};

/// Adds what is wanted. Tensors that are moved here become an array as they are.
/// @param derivatives over MakeTangentFrame(normal); where there are any, they are added as P, Q,
/// S, T in the principal frames
void AddCurvatureArrays(vtkPolyData* surface, Tuples<6> tensors, const Tuples<3>& normals,
  const CurvatureArrays& wanted = CurvatureArrays(), Tuples<4> derivatives = Tuples<4>());
}

#endif
