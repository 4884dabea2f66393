// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLineChains.h
 * @brief Joins the segments of one line type to chains.
 */
#ifndef nprLineChains_h
#define nprLineChains_h

#include "nprLineSegments.h"
#include "vtkNPRFiltersLinesModule.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace npr
{
/// Polylines over one list of vertices; chain i has those from Offsets[i] to Offsets[i + 1]. A
/// closed chain does not repeat its first vertex.
struct LineChains
{
  std::vector<LineVertex> Vertices;
  std::vector<std::size_t> Offsets = { 0 };
  std::vector<bool> Closed;
  std::size_t GetNumberOfChains() const { return this->Closed.size(); }
};

/**
 * Joins segments end to end wherever exactly two ends have one key. Where more meet, all chains
 * end. A chain takes the direction that most of its segments have. Vertices at one place become
 * one, so no chain has a piece of no length, and a chain that has no length at all is left out.
 * `origin` is what the positions will be added to: places are compared as they will be written.
 * The order of the chains follows from that of the segments alone.
 */
VTKNPRFILTERSLINES_EXPORT LineChains JoinSegments(
  const std::vector<LineSegment>& segments, const Eigen::Vector3d& origin);
}

#endif
