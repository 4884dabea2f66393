// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprHilbertOrder.h
 * @brief Points in the order in which a curve that fills space passes them.
 */
#ifndef nprHilbertOrder_h
#define nprHilbertOrder_h

#include "vtkNPRFiltersCoreModule.h"
#include <vtkType.h>

#include <Eigen/Core>

#include <vector>

namespace npr
{
/**
 * The points' numbers, sorted along the Hilbert curve through the cube of their bounds (D. Hilbert
 * 1891; turned into bits after J. Skilling, "Programming the Hilbert curve", AIP Conf. Proc. 707,
 * 2004). Neighbours in the order are neighbours in space, and mostly the other way round. Equal
 * points keep their order; what is not finite comes last.
 */
VTKNPRFILTERSCORE_EXPORT std::vector<vtkIdType> GetHilbertOrder(
  const std::vector<Eigen::Vector3d>& points);
}

#endif
