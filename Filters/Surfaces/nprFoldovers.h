// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprFoldovers.h
 * @brief Mends triangles that are folded over their neighbours.
 *
 * Where programs for CAD part a face with slivers in it, as along a fillet, an edge that runs the
 * wrong way folds a triangle over: it faces backwards, between neighbours that all face forwards.
 * Its points are right, and the other diagonal of the two triangles at the edge parts their
 * quadrilateral without a fold.
 */
#ifndef nprFoldovers_h
#define nprFoldovers_h

#include "nprSurfacePreparation.h"

namespace npr
{
/**
 * Flips edges of folds: those where two triangles meet at more than 135 degrees, and one of them
 * meets another one so, too. After a flip there are fewer such edges than before, none that was
 * none before, and the sharpest angle from the two triangles to those around them is less; both
 * have an area, their new edge is that of no other triangle, and their borders are as before. So
 * the rims of flat bodies stay: what a flip there would lay right on one side, it folds on the
 * other.
 *
 * The flip that leaves the least angles comes first, then the next best, whatever the order of the
 * triangles. Both new triangles have the cell of the one that the other was folded over: this is
 * what they cover. Needs the mesh's neighbours and triangles that agree, and builds the neighbours
 * again where it changes something. Counted: the flips, and the triangles that still are folded
 * over all their neighbours (of two at least).
 */
void MendFoldovers(TriangleMesh& mesh, PreparedSurface& surface);
}

#endif
