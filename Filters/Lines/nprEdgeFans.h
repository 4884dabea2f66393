// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprEdgeFans_h
#define nprEdgeFans_h

#include "nprLineSegments.h"
#include "vtkNPRFiltersLinesModule.h"

#include <vector>

namespace npr
{
/**
 * @class EdgeFans
 * @brief Says how lines between triangles of two values go on where more than two of their edges
 * meet: around one fan of triangles.
 *
 * A piece has triangles of one value on its left. Around the vertex at its end these form a fan,
 * which the piece bounds on one side; the line goes on along the edge that bounds it on the other.
 * No two pieces have the same fan there, so what goes on where does not depend on any order, and
 * where the boundary of all triangles of a value is made of loops, so are the lines.
 *
 * Along an edge with more than two triangles, those of one value that run in one direction are
 * joined, in their order, to those that run in the other; what is left over bounds fans.
 */
class VTKNPRFILTERSLINES_EXPORT EdgeFans
{
public:
  using Index = TriangleMesh::Index;

  /// The surface must outlive this.
  explicit EdgeFans(const LineSurface& surface) : Surface(surface) {}

  /// Gives the ends of whole edges the half-edges that they join by where more than two meet.
  /// \p values are those of all triangles.
  void Join(const std::vector<signed char>& values, std::vector<LinePiece>& pieces);

private:
  static constexpr Index None = LinePiece::NoHalfEdge;
  Index FindMatch(const std::vector<signed char>& values, Index halfEdge) const;
  Index FindSide(const std::vector<signed char>& values, const LinePiece& piece) const;
  Index FindNext(const std::vector<signed char>& values, Index side) const;

  const LineSurface& Surface;
  std::vector<unsigned char> Counts; // for each vertex, of ends; 0 between two calls
};
}

#endif
