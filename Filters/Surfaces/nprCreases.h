// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCreases.h
 * @brief Finds the creases of a triangle mesh, and cuts the mesh open along them.
 */
#ifndef nprCreases_h
#define nprCreases_h

#include "nprTriangleMesh.h"
#include "vtkNPRFiltersSurfacesModule.h"

#include <array>
#include <vector>

namespace npr
{
/// For each triangle, for each of its edges, whether it is a crease.
using EdgeFlags = std::vector<std::array<unsigned char, 3>>;

/**
 * The edges whose triangles meet at more than an angle (needs the neighbours).
 *
 * Noise must not shatter a scan. So the angle must also lie between the means over the nearest
 * triangles of either side, and of edges that hang together fewer than six (a border they end at
 * counts for three) are left out. An edge whose triangles are oriented against each other always is
 * a crease.
 *
 * @param angle degrees, 0 (flat) to 180
 */
VTKNPRFILTERSSURFACES_EXPORT EdgeFlags FindCreases(const TriangleMesh& mesh, double angle);

/**
 * Gives each group of triangles that hang together around a point a copy of the point of its own
 * (needs the neighbours). Groups are parted by creases, borders and non-manifold edges. The first
 * group keeps the point; the copies are numbered from the number of points on.
 *
 * @param triangles in: those of the mesh; out: with the copies in place
 * @return for each copy, the point that it is a copy of
 */
VTKNPRFILTERSSURFACES_EXPORT std::vector<TriangleMesh::Index> SplitPoints(const TriangleMesh& mesh,
  const EdgeFlags& creases, std::vector<TriangleMesh::Triangle>& triangles);
}

#endif
