// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprVisibleSides.h
 * @brief Which sides of a surface can be seen from outside.
 */
#ifndef nprVisibleSides_h
#define nprVisibleSides_h

#include "vtkNPRRenderingIllustrationModule.h"

class vtkCamera;
class vtkPolyData;

namespace npr
{
/// Whether rays from outside meet the front of a triangle first: some ten thousand, along each axis
/// from both ends. A closed surface with its normals outside passes, also where its parts overlap;
/// one with holes, or turned inside out by crossing itself, does not. False without triangles.
VTKNPRRENDERINGILLUSTRATION_EXPORT bool ShowsOnlyFronts(vtkPolyData* surface);

/// Whether the camera is in front of bounds, with its near plane.
bool IsInFrontOf(vtkCamera* camera, const double bounds[6]);
}

#endif
