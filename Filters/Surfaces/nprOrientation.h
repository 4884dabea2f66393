// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprOrientation.h
 * @brief Turns triangles until they agree.
 */
#ifndef nprOrientation_h
#define nprOrientation_h

#include "nprTriangleMesh.h"
#include "vtkNPRFiltersSurfacesModule.h"

namespace npr
{
/// Turns triangles over until neighbours agree and closed components have their normals outside;
/// open ones keep the side of most of their triangles (needs the neighbours).
VTKNPRFILTERSSURFACES_EXPORT void OrientTriangles(TriangleMesh& mesh);
}

#endif
