// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprHidingEdges_h
#define nprHidingEdges_h

#include "nprHidingSurfaces.h"
#include "nprImageProjection.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

namespace npr
{
/**
 * @class HidingEdges
 * @brief The edges behind which the number of hiding layers changes, in a grid over the image.
 *
 * These are the contour edges (one triangle faces the eye, the other does not) and those with
 * another number of triangles than two: where no such edge is in front of it, a line that does not
 * go through a surface has the same number of layers all along (Appel, "The notion of quantitative
 * invisibility and the machine rendering of solids", 1967).
 */
class HidingEdges
{
public:
  /// Only what is within \p bounds of the image, in pixels, is looked for.
  HidingEdges(const HidingSurfaces& surfaces, const ImageProjection& projection,
    const Eigen::AlignedBox2d& bounds);

  /// The segment's ends must be in front of the eye. Adds the places, in ]0, 1[ along the segment
  /// (not along its image), where an edge in front of it crosses it; some come more than once.
  void FindCrossings(const ImageProjection::Place& from, const ImageProjection::Place& to,
    std::vector<double>& places) const;

  /// Whether a triangle that is seen exactly edge-on may be where the segment is in the image.
  bool MayBeEdgeOn(const ImageProjection::Place& from, const ImageProjection::Place& to) const;

private:
  using Index = TriangleMesh::Index;
  struct Edge
  {
    ImageProjection::Place From;
    ImageProjection::Place To;
  };

  /// The edges of one part of the triangles.
  struct Part
  {
    std::vector<Edge> Edges;
    std::vector<Edge> EdgeOn; // all those of triangles that are seen edge-on
  };
  void FindEdges(const HidingSurfaces& surfaces);
  void AddEdge(const HidingSurfaces& surfaces, Index triangle, int edge, std::vector<Edge>& edges);
  void FillGrid();
  /// Calls `visit(cell)` for all cells that a segment of the image is in.
  template<typename Visitor>
  void VisitCells(
    const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Visitor& visit) const;
  int GetColumn(double x) const;
  int GetRow(double y) const;

  const ImageProjection& Projection;
  Eigen::AlignedBox2d Bounds;
  std::vector<Edge> Edges;
  std::vector<Edge> EdgeOn;
  std::array<int, 2> Size = { 1, 1 };
  double CellSize = 1.0;
  std::vector<std::uint32_t> Offsets;  // of each cell among the entries
  std::vector<std::uint32_t> Entries;  // edges
  std::vector<unsigned char> IsEdgeOn; // cells
};
}

#endif
