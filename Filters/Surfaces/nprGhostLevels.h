// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprGhostLevels.h
 * @brief How filters whose results depend on a neighbourhood work on surfaces that come in pieces.
 *
 * A pipeline may ask for piece 2 of 7. Next to the piece's border a value then depends on triangles
 * of other pieces; so a filter asks for so many rings of them more than it is asked for (ghost
 * levels: cells whose vtkGhostType says that they belong to another piece), takes them like all
 * others, and drops them from what it hands on. What belongs to the surface as a whole can not be
 * had so and travels as field data: see LengthScale and NeighbourhoodRadius in nprArrayNames.h.
 */
#ifndef nprGhostLevels_h
#define nprGhostLevels_h

#include "nprVTKCompat.h"
#include "vtkNPRFiltersSurfacesModule.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// Whether one of several pieces is asked for.
VTKNPRFILTERSSURFACES_EXPORT bool IsPiece(vtkInformation* output);

/// For RequestUpdateExtent: asks the input for `rings` ghost levels more than the output is asked
/// for. Nothing more is asked for if the surface is wanted in one piece.
VTKNPRFILTERSSURFACES_EXPORT void RequestGhostLevels(
  vtkInformation* input, vtkInformation* output, int rings);

/// For the end of RequestData: drops the ghost cells beyond the levels that the output is asked
/// for, and the points that only they had; without ghost levels also the arrays vtkGhostType, as
/// vtkPolyData::RemoveGhostCells() does. Nothing is dropped if the surface is wanted in one piece.
VTKNPRFILTERSSURFACES_EXPORT void DropExtraGhostLevels(
  vtkPolyData* surface, vtkInformation* output);
}

#endif
