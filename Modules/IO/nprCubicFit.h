// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCubicFit.h
 * @brief Cubic curves that follow a smooth section of a chain, by least squares.
 */
#ifndef nprCubicFit_h
#define nprCubicFit_h

#include "nprCurveFit.h"
#include "nprPagePath.h"

#include <vector>

namespace npr
{
/**
 * Appends curves from the first point to the last one, without a move to the first.
 *
 * They pass all points within the tolerance and have common tangents where they meet. There are at
 * least two points. An end that is free has its tangent from the points of the section alone,
 * another one has that given.
 */
void FitSection(const std::vector<PagePoint>& points, const std::vector<PagePoint>& tangents,
  bool startsFree, bool endsFree, const FitSettings& settings, PagePath& path);
}

#endif
