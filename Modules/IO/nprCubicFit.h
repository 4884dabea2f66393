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

#include <optional>
#include <vector>

namespace npr
{
/// A tangent that is given, such as where a curve meets a straight piece; if not, it comes from the
/// points.
using GivenTangent = std::optional<PagePoint>;

/**
 * Appends curves from the first point to the last one, without a move to the first.
 *
 * They pass all points within the tolerance and have common tangents where they meet. There are at
 * least two points.
 */
void FitSection(const std::vector<PagePoint>& points, const GivenTangent& start,
  const GivenTangent& end, const FitSettings& settings, PagePath& path);
}

#endif
