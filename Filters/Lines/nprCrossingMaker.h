// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprCrossingMaker_h
#define nprCrossingMaker_h

#include "nprFieldValues.h"
#include "nprLineSegments.h"
#include "nprLineSurface.h"

#include <cstddef>
#include <vector>

class vtkNPRLineDefinition;

namespace npr
{
/// A triangle that a line runs through.
struct CrossedTriangle
{
  TriangleMesh::Index Triangle;
  unsigned int Edges; ///< where the field has axes, those that are crossed: bit e for edge e
};

/**
 * @class CrossingMaker
 * @brief Finds where lines enter and leave triangles that are known to have some.
 *
 * A place on an edge is always found from one of its ends, so that both triangles there find the
 * same bits, and an exact zero its vertex: from the end above the level, or where the field has
 * axes and so no end is above, from the one that is nearer to 0.
 */
class CrossingMaker
{
public:
  using Index = TriangleMesh::Index;

  /// All must outlive this.
  CrossingMaker(
    const LineSurface& surface, const std::vector<float>& levels, const FieldValues& values);

  /// Appends those of triangles, the lowest level first.
  void Add(const std::vector<CrossedTriangle>& crossed, std::vector<LineCrossing>& crossings) const;

  /// The same but for triangles of which the test accepts nothing.
  void AddAccepted(
    const std::vector<CrossedTriangle>& crossed, std::vector<LineCrossing>& crossings) const;

  /// Moves crossings to where the cubics with the slopes of the field at the ends of edges are 0.
  void UseSlopes(const vtkNPRLineDefinition& definition, const LineView& view,
    std::vector<LineCrossing>& crossings) const;

  /// Gives crossings their tests, and drops those of which nothing is accepted.
  void SetTests(std::vector<LineCrossing>& crossings) const;

private:
  bool MayBeAccepted(Index triangle) const;
  void Add(const CrossedTriangle& crossed, std::vector<LineCrossing>& crossings) const;
  void AddAtLevel(Index triangle, std::size_t level, std::vector<LineCrossing>& crossings) const;
  void AddByAxes(const CrossedTriangle& crossed, std::vector<LineCrossing>& crossings) const;

  const LineSurface& Surface;
  const std::vector<float>& Levels;
  const FieldValues& Values;
};
}

#endif
