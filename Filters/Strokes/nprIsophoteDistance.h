// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprIsophoteDistance.h
 * @brief How far from a contour a surface is dark.
 *
 * T. Goodwin, I. Vollick, A. Hertzmann, "Isophote distance: a shading approach to artistic stroke
 * thickness", NPAR 2007: strokes stand for the dark parts of a shaded surface beside them.
 */
#ifndef nprIsophoteDistance_h
#define nprIsophoteDistance_h

#include "vtkNPRFiltersStrokesModule.h"

namespace npr
{
/**
 * How far from a contour, as it is seen, the surface is darker than a level: where n.l, the cosine
 * between normal and light, comes up to it. Across the contour the surface is taken for a circle
 * with the radial curvature there. The distance is 0 where the contour is no darker than the level,
 * and the circle's radius where the level is not reached on this side; a surface that is not convex
 * towards the eye has no end of its shade, and counts as one that curves as little as can be.
 *
 * @param radialCurvature at the contour, 1/length
 * @param normalCosine n.l at the contour
 * @param eyeCosine v.l, for the direction v to the eye
 * @param level in [-1, 1]
 * @param most what the distance is at most, in the unit of length
 */
VTKNPRFILTERSSTROKES_EXPORT double GetIsophoteDistance(
  double radialCurvature, double normalCosine, double eyeCosine, double level, double most);
}

#endif
