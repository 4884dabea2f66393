// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprEdgePieces.h
 * @brief Pieces of lines that run along edges of the mesh.
 */
#ifndef nprEdgePieces_h
#define nprEdgePieces_h

#include "nprEdgeFans.h"
#include "nprFieldValues.h"
#include "nprLineSegments.h"
#include "nprPlaneBounds.h"
#include "vtkNPRFiltersLinesModule.h"

#include <vector>

class vtkNPRLineDefinition;

namespace npr
{
/// Appends the pieces of seams where the field jumps from one side of 0 to the other: the line goes
/// on exactly where the lines in the triangles on both sides end. The field has been evaluated
/// there.
VTKNPRFILTERSLINES_EXPORT void AddJumpPieces(
  const LineSurface& surface, const FieldValues& values, std::vector<LinePiece>& pieces);

/**
 * @class EdgePieces
 * @brief Finds the edges that a definition accepts. Keeps its memory from one call to the next.
 */
class VTKNPRFILTERSLINES_EXPORT EdgePieces
{
public:
  using Index = TriangleMesh::Index;

  /// Both must outlive this. The surface has built its inner edges if the definition wants them.
  EdgePieces(const LineSurface& surface, const vtkNPRLineDefinition& definition);

  void Add(const LineView& view, std::vector<LinePiece>& pieces);

private:
  /// A row of triangles that a view may have no edges between.
  struct Row
  {
    PlaneBounds Planes;
    Index EdgesEnd;            // of its inner edges, by their first triangles
    std::size_t NeighboursEnd; // of the other rows that these edges lead to
  };
  void BuildRows();
  void EvaluateTriangles(const LineView& view);
  bool HasOneValue(Index row) const;
  void AddSpan(const LineView& view, const EdgeList& edges, Index begin, Index end,
    std::vector<LinePiece>& accepted) const;

  const LineSurface& Surface;
  const vtkNPRLineDefinition& Definition;
  // Where the definition compares triangles:
  std::vector<Row> Rows;
  std::vector<Index> Neighbours;
  std::vector<signed char> RowValues;
  std::vector<signed char> Values; // of the triangles
  EdgeFans Fans;
  std::vector<LinePiece> Found;
};
}

#endif
