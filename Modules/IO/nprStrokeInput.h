// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprStrokeInput.h
 * @brief Strokes as filters give them: polylines, and what their arrays say about each.
 */
#ifndef nprStrokeInput_h
#define nprStrokeInput_h

#include "nprPageView.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkIdList;
class vtkPolyData;

namespace npr
{
class StrokeInput
{
public:
  /// Throws DrawingError if an array doesn't fit. Without `LineType` all lines are of one type.
  explicit StrokeInput(vtkPolyData* strokes);

  vtkIdType GetNumberOfLines() const { return this->NumberOfLines; }
  const std::vector<std::string>& GetTypeNames() const { return this->TypeNames; }
  int GetType(vtkIdType line) const;
  bool IsHidden(vtkIdType line) const;

  /// What a line's width at a point depends on.
  struct WidthRule
  {
    double Width; // times the array of widths, where there is one
    double Taper; // the share that is left without strength
  };

  struct Chain
  {
    std::vector<WorldPoint> Points;
    bool Closed = false;
  };
  /// The runs of finite points of a line, without repeated points. `ids` is room to work in.
  void GetChains(
    vtkIdType line, const WidthRule& rule, vtkIdList* ids, std::vector<Chain>& chains) const;

private:
  double GetWidth(vtkIdType point, const WidthRule& rule) const;

  vtkPolyData* Strokes;
  vtkIdType NumberOfLines = 0;
  vtkIdType FirstCell = 0;
  vtkDataArray* Types = nullptr;
  vtkDataArray* Hiding = nullptr;
  vtkDataArray* Strengths = nullptr;
  vtkDataArray* Widths = nullptr;
  std::vector<std::string> TypeNames;
};
}

#endif
