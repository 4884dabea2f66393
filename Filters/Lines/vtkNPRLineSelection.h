// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRLineSelection
 * @brief The lines of one kind, and long enough, out of the feature lines of a surface.
 *
 * vtkNPRFeatureLines gives all kinds in one output; this filter takes one of them, so that each
 * kind can become strokes of its own look. Points and the polylines' cells keep their arrays.
 *
 * @sa vtkNPRFeatureLines, vtkNPRSplineStrokes
 */
#ifndef vtkNPRLineSelection_h
#define vtkNPRLineSelection_h

#include "vtkNPRFiltersLinesModule.h"
#include <vtkPolyDataAlgorithm.h>

#include <string> // for the name of the kind

class VTKNPRFILTERSLINES_EXPORT vtkNPRLineSelection : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRLineSelection* New();
  vtkTypeMacro(vtkNPRLineSelection, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// @name The kind of line, a name in the input's LineTypeNames
  /// Empty (the default) takes all kinds. A name that does not occur selects nothing.
  ///@{
  vtkSetMacro(LineType, std::string);
  vtkGetMacro(LineType, std::string);
  ///@}

  /// @name The kind of line, as the index of its definition in vtkNPRFeatureLines
  /// Tells two definitions of one kind apart. -1 (the default) leaves the choice to LineType.
  ///@{
  vtkSetMacro(LineIndex, int);
  vtkGetMacro(LineIndex, int);
  ///@}

  /// @name Shorter polylines are left out; unit: length, >= 0, default 0
  ///@{
  vtkSetClampMacro(MinimumLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumLength, double);
  ///@}

protected:
  vtkNPRLineSelection() = default;
  ~vtkNPRLineSelection() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRLineSelection(const vtkNPRLineSelection&) = delete;
  void operator=(const vtkNPRLineSelection&) = delete;

  std::string LineType;
  int LineIndex = -1;
  double MinimumLength = 0.0;
};

#endif
