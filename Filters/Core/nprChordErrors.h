// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprChordErrors.h
 * @brief How far triangles are from the smooth surface that their normals describe.
 */
#ifndef nprChordErrors_h
#define nprChordErrors_h

#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"
#include "vtkNPRFiltersCoreModule.h"

#include <vector>

namespace npr
{
/**
 * For each triangle the farthest that the middle of one of its edges is from the curve that leaves
 * the edge's ends at right angles to their normals, by the edge rule of A. Vlachos et al., "Curved
 * PN Triangles", I3D 2001, scaled so that it is exact for circles: for small angles an eighth of
 * the edge's length times the angle between the normals. 0 of edges whose normals differ by more
 * than 60 degrees, as no curve does.
 *
 * @param normals unit normals of the points; what is no number makes no error
 */
VTKNPRFILTERSCORE_EXPORT std::vector<float> MeasureChordErrors(
  const TriangleMesh& mesh, const Tuples<3>& normals);
}

#endif
