// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLineSegments.h
 * @brief The pieces that lines are joined from, and what is taken out before.
 */
#ifndef nprLineSegments_h
#define nprLineSegments_h

#include "nprLineSurface.h"
#include "vtkNPRFiltersLinesModule.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace npr
{
/// A point of a line.
struct LineVertex
{
  Eigen::Vector3d Position; ///< relative to the origin of the surface
  Eigen::Vector3f Normal;
  float Strength;
};

/// A piece of a line in one triangle or along one edge. Pieces join where their keys agree.
struct LineSegment
{
  std::array<std::int64_t, 2> Keys;
  std::array<LineVertex, 2> Vertices;
};

/// Keys from \p firstVertexKey on are those of welded points. A segment between two of them may
/// come from the triangles on both of its sides, or from a triangle and a seam: one is kept.
VTKNPRFILTERSLINES_EXPORT void RemoveDoubles(
  std::vector<LineSegment>& segments, std::int64_t firstVertexKey);

/// Of segments that all run between welded points, takes out those that hang together in fewer than
/// \p least; each of their points at a border counts as one segment more.
VTKNPRFILTERSLINES_EXPORT void DropShortRows(std::vector<LineSegment>& segments,
  const LineSurface& surface, std::int64_t firstVertexKey, double least);
}

#endif
