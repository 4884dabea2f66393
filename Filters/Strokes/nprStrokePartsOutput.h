// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokePartsOutput_h
#define nprStrokePartsOutput_h

#include "nprStrokeParts.h"
#include "nprVTKCompat.h"
#include "vtkNPRFiltersStrokesModule.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkIdList;
class vtkPoints;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// Whether a polyline ends at the point where it begins, and is more than there and back.
VTKNPRFILTERSSTROKES_EXPORT bool IsClosedStroke(vtkPoints* points, vtkIdList* ids);

/// Writes the parts of each polyline of the input that are anywhere, as vtkNPRStrokeVisibility
/// documents. \p parts has as many entries as the input has lines.
VTKNPRFILTERSSTROKES_EXPORT void WriteStrokeParts(
  vtkPolyData* input, const std::vector<std::vector<StrokePart>>& parts, vtkPolyData* output);
}

#endif
