// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprTriangleCleaning.h
 * @brief Drops or mends the triangles that are none, and what only they used.
 */
#ifndef nprTriangleCleaning_h
#define nprTriangleCleaning_h

#include "nprSurfacePreparation.h"

namespace npr
{
/// Drops triangles that use a point twice. Returns how many.
vtkIdType DropCollapsedTriangles(PreparedSurface& surface);

/// Needles close the gaps of T-junctions. To drop one would open the surface, so its long edge is
/// flipped: the triangle across that edge is parted at the needle's middle corner instead. What can
/// not be mended so is dropped. Both are counted.
void MendNeedles(TriangleMesh& mesh, PreparedSurface& surface);

/// Of triangles with the same three points keeps one, that faces as most of them do, and of folds
/// (small flaps whose two sides coincide) none. Both are counted.
void DropDuplicates(TriangleMesh& mesh, PreparedSurface& surface);

/// Drops points that no triangle uses any more.
void DropUnusedPoints(TriangleMesh& mesh, PreparedSurface& surface);
}

#endif
