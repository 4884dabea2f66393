// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprTriangleArea.h
 * @brief Which triangles have an area, the same for all who ask.
 */
#ifndef nprTriangleArea_h
#define nprTriangleArea_h

#include "nprVTKCompat.h"
#include "vtkNPRFiltersCoreModule.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// Whether a triangle's corners do not lie on one line, to the precision of single coordinates.
/// False if a number is NaN.
inline bool CountsAsArea(double twiceArea, double longestEdgeSquared)
{
  return twiceArea > 1e-7 * longestEdgeSquared;
}

/// Whether any of the surface's polygons and strips has an area.
VTKNPRFILTERSCORE_EXPORT bool HasArea(vtkPolyData* surface);
}

#endif
