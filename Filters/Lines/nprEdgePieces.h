// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprEdgePieces.h
 * @brief Pieces of lines that run along edges of the mesh.
 */
#ifndef nprEdgePieces_h
#define nprEdgePieces_h

#include "nprFieldValues.h"
#include "nprLineSegments.h"
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

/// Appends the edges that a definition accepts.
VTKNPRFILTERSLINES_EXPORT void AddEdgePieces(const LineSurface& surface,
  const vtkNPRLineDefinition& definition, const LineView& view, std::vector<LinePiece>& pieces);
}

#endif
