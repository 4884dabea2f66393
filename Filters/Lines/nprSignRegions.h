// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSignRegions.h
 * @brief The regions where a field has one sign, and a field without those that weigh little.
 */
#ifndef nprSignRegions_h
#define nprSignRegions_h

#include "nprLineSurface.h"
#include "vtkNPRFiltersLinesModule.h"

#include <vector>

namespace npr
{
/**
 * Turns the field's sign over where a region of one sign weighs too little, so that it becomes a
 * part of what surrounds it. The lightest region goes first; with it all its neighbours become one,
 * which weighs as much as they do together, less what the lost one did. So the weights of noise
 * cancel out, and of what is left every region weighs enough, or is the only one of its part of the
 * surface. The zero set of the new field is a part of that of the old one, at the same places.
 *
 * What a piece of a surface has at ghost triangles may go on in others: such regions are kept.
 * Values that are not numbers are in no region.
 *
 * Fleeting features of level sets are taken away so by the persistence of their extrema (H.
 * Edelsbrunner, D. Letscher, A. Zomorodian, "Topological persistence and simplification", 2002);
 * here by an integral, which noise changes less than an extremum.
 *
 * @param density of the weight, per area: at each point, of the field's sign
 * @param least weight of a region
 */
VTKNPRFILTERSLINES_EXPORT void MergeLightRegions(const LineSurface& surface,
  const std::vector<float>& density, double least, std::vector<float>& field);
}

#endif
