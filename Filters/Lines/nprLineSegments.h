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

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace npr
{
/// A place on an edge of the mesh: From + T (To - From). With T 0 it is the point From.
struct LineNode
{
  using Index = TriangleMesh::Index;
  Index From;
  Index To;
  float T;
  bool IsVertex() const { return this->T == 0.0f; }
};

/// Ends of segments on edges without a twin join where their keys agree: that of the half-edge, or
/// where there is none, of the vertex.
inline std::int64_t GetKey(
  const LineSurface& surface, const LineNode& node, TriangleMesh::Index halfEdge)
{
  return halfEdge < 0 ? std::int64_t(surface.GetNumberOfHalfEdges()) + surface.GetWelded(node.From)
                      : std::int64_t(halfEdge);
}

/// A line's way through a triangle, from one of its edges to another. Of its two ends one may lie
/// outside of what the test accepts: the line then ends between them, where the test is 0.
struct LineCrossing
{
  using Index = TriangleMesh::Index;
  Index Triangle;
  std::uint16_t Level; ///< which of the definition's
  /// For each end the edge of the triangle, plus Reversed if From is the end of that half-edge.
  std::array<std::uint8_t, 2> Places;
  std::array<float, 2> T;
  std::array<float, 2> Test;

  static constexpr std::uint8_t Reversed = 4;
  Index GetHalfEdge(int end) const { return 3 * this->Triangle + (this->Places[end] & 3); }
  bool IsCut(int end) const { return this->Test[end] < 0.0f; }
  LineNode GetNode(const LineSurface& surface, int end) const
  {
    const TriangleMesh::Triangle& corners = surface.GetMesh().GetTriangle(this->Triangle);
    const int edge = this->Places[end] & 3;
    const Index start = corners[edge];
    const Index stop = corners[edge == 2 ? 0 : edge + 1];
    return (this->Places[end] & Reversed) != 0 ? LineNode{ stop, start, this->T[end] }
                                               : LineNode{ start, stop, this->T[end] };
  }
};

/// A piece of a line along an edge of the welded surface.
struct LinePiece
{
  using Index = TriangleMesh::Index;
  const Index* Sides; ///< the half-edges on the edge: [Sides, SidesEnd)
  const Index* SidesEnd;
  std::array<LineNode, 2> Nodes;
  /// The half-edge that a node is on, or at a vertex where several lines pass, that of its line
  /// (see EdgeFans); its vertex where that is NoHalfEdge.
  std::array<Index, 2> HalfEdges;
  /// Where a node lies between the edge's low and high point.
  std::array<float, 2> FromLow;
  float Strength;

  static constexpr Index NoHalfEdge = -1;
};

/// The segments of one definition. Segment s is crossing s, or piece s - number of crossings.
struct LineSegments
{
  std::vector<LineCrossing> Crossings;
  std::vector<LinePiece> Pieces;
  std::size_t GetSize() const { return this->Crossings.size() + this->Pieces.size(); }
};

/// A segment between two vertices may come from the triangles on both of its sides, or from a
/// triangle and a seam: one is kept.
VTKNPRFILTERSLINES_EXPORT void RemoveDoubles(const LineSurface& surface, LineSegments& segments);

/// Of pieces that are whole edges, takes out those that hang together in fewer than \p least; each
/// of their points at a border counts as one piece more.
VTKNPRFILTERSLINES_EXPORT void DropShortRows(
  const LineSurface& surface, double least, std::vector<LinePiece>& pieces);
}

#endif
