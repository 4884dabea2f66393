// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeReader_h
#define nprStrokeReader_h

#include "nprStrokeBuffer.h"
#include "nprVTKCompat.h"

#include <vtkType.h>

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
VTK_ABI_NAMESPACE_END

namespace npr
{
bool IsFinite(const std::array<double, 3>& x);

/// Numbers of an array, read without a call for each where they stand one after another as floats.
class StrokeNumbers
{
public:
  explicit StrokeNumbers(vtkDataArray* array);

  bool Exist() const { return this->Array != nullptr; }
  double Get(vtkIdType tuple, int component) const;

private:
  vtkDataArray* Array;
  const float* Values = nullptr;
  int Components = 1;
};

/**
 * @class StrokeReader
 * @brief What the points of strokes are and what arrays say of them, as the records of strokes have
 * it.
 */
class StrokeReader
{
public:
  /// @param colors four numbers for each point, or for each cell; null: none
  StrokeReader(vtkPolyData* strokes, vtkUnsignedCharArray* colors, bool ofCells);

  /// Whether there is no finite point.
  bool IsEmpty() const { return this->Empty; }
  /// Without records, but with the origin and size of what is read.
  const StrokeRecords& GetFrame() const { return this->Frame; }

  bool HasWidths() const { return this->Widths.Exist(); }
  bool HasArcLengths() const { return this->ArcLengths.Exist(); }
  bool HasColors() const { return this->Colors != nullptr; }

  std::array<double, 3> GetPlace(vtkIdType id) const;
  /// What a point at a place is. Its kind is 1, or 0 if it is not finite.
  StrokeRecord Read(vtkIdType id, const std::array<double, 3>& place) const;
  /// The colour of a point of a line, four numbers; there must be colours.
  void ReadColor(vtkIdType line, vtkIdType id, unsigned char* color) const;
  /// Whether surfaces hide a line, as HidingLayers says.
  bool IsHidden(vtkIdType line) const;

private:
  vtkPolyData* Strokes;
  StrokeNumbers Places;
  StrokeNumbers Widths;
  StrokeNumbers Strengths;
  StrokeNumbers Opacities;
  StrokeNumbers ArcLengths;
  vtkDataArray* Layers;
  vtkUnsignedCharArray* Colors;
  bool ColorsOfCells;
  bool Empty = true;
  StrokeRecords Frame;
};
}

#endif
