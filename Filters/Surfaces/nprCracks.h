// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCracks.h
 * @brief Closes the cracks between faces that were meshed one by one.
 *
 * Programs for CAD mesh each face for itself. Where they part a common edge differently, an edge of
 * one face has points of the other within it (T-junctions): nothing is open there, but no edge has
 * two triangles, and all that goes by edges takes the two faces for two sheets.
 */
#ifndef nprCracks_h
#define nprCracks_h

#include "nprSurfacePreparation.h"

namespace npr
{
/// Splits the triangles at boundary edges on which points of other boundary edges along them lie,
/// at these points. Needs the mesh's neighbours, and builds them again where it changes something.
/// Counted.
void CloseCracks(TriangleMesh& mesh, PreparedSurface& surface);
}

#endif
