// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPointWelding.h
 * @brief Finds points that lie in the same place.
 */
#ifndef nprPointWelding_h
#define nprPointWelding_h

#include "nprTriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace npr
{
/// For each point, the first point within the tolerance of it that is not itself welded to an
/// earlier one (so itself, mostly). Points that are not finite stay alone.
/// @param tolerance length; 0: exactly equal coordinates only
std::vector<TriangleMesh::Index> FindCoincidentPoints(
  const std::vector<Eigen::Vector3d>& points, double tolerance);
}

#endif
