// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprMidpointArrays.h
 * @brief Point arrays of a refined surface, from those of the coarse one.
 */
#ifndef nprMidpointArrays_h
#define nprMidpointArrays_h

#include "nprSurfaceRefinement.h"
#include "nprTupleArrays.h"
#include "nprVTKCompat.h"

#include <vtkSmartPointer.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// The array with a tuple for each midpoint after the old ones: halfway between its parents' for
/// real numbers and bytes, the first parent's for others.
vtkSmartPointer<vtkAbstractArray> ExtendArray(
  vtkAbstractArray* array, const RefinedSurface& refined);

/// The same for tensors of tangent planes, turned into those of the midpoints.
Tuples<6> ExtendTensors(const Tuples<6>& tensors, const RefinedSurface& refined);

/// The same for derivatives of tensors, P, Q, S, T: given over the frames of the old points that
/// begin with the unit vectors \p e1, returned over MakeTangentFrame(normal).
Tuples<4> ExtendDerivatives(
  const Tuples<4>& derivatives, const Tuples<3>& e1, const RefinedSurface& refined);
}

#endif
