// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLooseEdges_h
#define nprLooseEdges_h

#include "nprTriangleMesh.h"
#include "vtkNPRFiltersCoreModule.h"

#include <array>
#include <vector>

namespace npr
{
/// An edge of a network, between two points.
struct NetworkEdge
{
  std::array<TriangleMesh::Index, 2> Points;
  bool IsSoft; ///< kept only if the network holds both of its ends
};

/**
 * Finds the soft edges that lead nowhere: those with an end at which there is no other edge, and
 * when these are taken out, again, until none is left. What stays leads from a firm edge or a
 * held point to another, or closes.
 *
 * @param held for each point, 1 where the network goes on beyond it, as at a border, else 0
 * @return 1 for each edge that is loose, else 0
 */
VTKNPRFILTERSCORE_EXPORT std::vector<char> FindLooseEdges(
  const std::vector<NetworkEdge>& edges, std::vector<TriangleMesh::Index> held);
}

#endif
