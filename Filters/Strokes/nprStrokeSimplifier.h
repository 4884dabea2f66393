// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeSimplifier_h
#define nprStrokeSimplifier_h

#include "nprStrokeSamples.h"

#include <cstddef>
#include <vector>

namespace npr
{
/**
 * Leaves out samples of a stroke, those from \p start on, as long as each is within a distance of
 * the segment that then passes it (D. Douglas, T. Peucker: Algorithms for the reduction of the
 * number of points required to represent a digitized line or its caricature, 1973). The ends and
 * the samples in \p kept, in ascending order, stay.
 *
 * A closed stroke without samples to be kept keeps that which is farthest from its ends, and so at
 * least two segments.
 */
void SimplifyStroke(std::vector<StrokeSample>& samples, std::size_t start,
  const std::vector<std::size_t>& kept, bool closed, double distance);
}

#endif
