// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLengthScale.h
 * @brief The length that makes thresholds dimensionless, as it travels with a surface.
 *
 * It is a documented property of the data: the field data array LengthScale, which the preparation
 * writes and a user may set, so that an animation or a distributed run uses one for all its parts.
 */
#ifndef nprLengthScale_h
#define nprLengthScale_h

#include "nprVTKCompat.h"
#include "vtkNPRFiltersCoreModule.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
class TriangleMesh;

/// The surface's LengthScale from its field data if that has a positive one, else computed from its
/// triangles (see TriangleMesh::ComputeLengthScale). Zero for a surface without area.
VTKNPRFILTERSCORE_EXPORT double GetLengthScale(vtkPolyData* surface);

/// The same for a surface whose triangles are at hand.
VTKNPRFILTERSCORE_EXPORT double GetLengthScale(vtkPolyData* surface, const TriangleMesh& mesh);

/// Writes the field data array LengthScale.
VTKNPRFILTERSCORE_EXPORT void SetLengthScale(vtkPolyData* surface, double lengthScale);
}

#endif
