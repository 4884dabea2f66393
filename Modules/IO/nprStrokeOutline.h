// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprStrokeOutline.h
 * @brief Strokes whose width changes, as outlines to be filled.
 */
#ifndef nprStrokeOutline_h
#define nprStrokeOutline_h

#include "nprCurveFit.h"
#include "nprPagePath.h"

namespace npr
{
/// Makes widths smaller where they would change by more than `slope` along the way: a pen neither
/// starts nor ends like a step.
void LimitWidthChange(PageChain& chain, double slope);

/**
 * Appends the outline of a chain with widths: one part for each smooth section, all with the same
 * sense, to be filled by the nonzero rule.
 *
 * At corners, and where the chain bends more tightly than it is wide, sections end in half circles,
 * which join them. The ends of the chain are half circles, too, if `roundCaps`, or else straight.
 * A closed chain without corners is a ring.
 */
void AddOutline(
  const PageChain& chain, const FitSettings& settings, bool roundCaps, PagePath& path);
}

#endif
