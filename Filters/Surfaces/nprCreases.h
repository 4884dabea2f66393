// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCreases.h
 * @brief Finds the creases of a triangle mesh.
 */
#ifndef nprCreases_h
#define nprCreases_h

#include "nprPointFans.h"
#include "vtkNPRFiltersSurfacesModule.h"

namespace npr
{
/**
 * The edges whose triangles meet at more than an angle (needs the neighbours); at more than half of
 * it where they stand out from the edges beside them (see nprEdgeSides.h) and lead from one crease
 * or border to another, or close; and at more than 1.3 times of it, or 50 degrees, where they are
 * between facets of a round face, bent alike on both sides.
 *
 * Noise must not shatter a scan. So the angle must also lie between the means over the nearest
 * triangles of either side, and of edges that hang together fewer than six (a border they end at
 * counts for three) are left out. An edge whose triangles are oriented against each other always is
 * a crease.
 *
 * @param angle degrees, 0 (flat) to 180
 */
VTKNPRFILTERSSURFACES_EXPORT EdgeFlags FindCreases(const TriangleMesh& mesh, double angle);
}

#endif
