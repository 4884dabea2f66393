// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeCuts_h
#define nprStrokeCuts_h

#include "nprSplines.h"
#include "nprVTKCompat.h"

#include <vtkType.h>

#include <array>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/// A cell array with one number for each cell; null where there is none.
vtkDataArray* GetCellNumbers(vtkPolyData* strokes, const char* name);

/**
 * @class StrokeCuts
 * @brief Where strokes have been cut because their visibility changes, by the cell arrays
 * HidingLayers and ChainId.
 */
class StrokeCuts
{
public:
  explicit StrokeCuts(vtkPolyData* strokes);

  /// Whether the end of a line at a place is the end of another part of its chain, too, that
  /// another number of surfaces hides.
  bool IsCut(vtkIdType line, const Vector3& place) const;

  /// Whether a line begins where another of its chain ends, as parts of one stroke do.
  bool Continues(vtkIdType line, vtkIdType other) const;

private:
  double Get(vtkDataArray* array, vtkIdType line) const;

  vtkDataArray* Layers;
  vtkDataArray* ChainIds;
  vtkIdType FirstCell;
  std::map<Vector3, std::vector<vtkIdType>> Ends;
  std::vector<std::array<Vector3, 2>> Places; // of each line's ends; not numbers where it has none
};
}

#endif
