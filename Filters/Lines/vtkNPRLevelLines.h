// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRLevelLines
 * @brief Lines at even levels of a field that no view changes: the base of height lines and others.
 *
 * The levels are so many over the field's range, in the middles of equal parts of it, so that none
 * touches the extremes; or, when a spacing is given, its multiples.
 *
 * @sa vtkNPRTopographicLines vtkNPRIsoLines
 */
#ifndef vtkNPRLevelLines_h
#define vtkNPRLevelLines_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRLevelLines : public vtkNPRLineDefinition
{
public:
  vtkAbstractTypeMacro(vtkNPRLevelLines, vtkNPRLineDefinition);

  bool IsViewDependent() const override { return false; }

  /// The most levels that are extracted.
  static constexpr int MaximumLevels = 1000;

  ///@{
  /// How many levels there are over the range of the field; a whole number. Range [1, 1000].
  vtkSetClampMacro(Levels, double, 1.0, MaximumLevels);
  vtkGetMacro(Levels, double);
  ///@}

  ///@{
  /// The distance from level to level, in the unit of the field; 0 to have so many Levels. It is an
  /// error when it gives more than 1000. Default is 0.
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

#ifndef __VTK_WRAP__
  bool HasField() const override
  {
    return true;
  }
  std::vector<float> GetLevels(const npr::LineSurface& surface) const override;
  std::string FindError(const npr::LineSurface& surface) const override;
#endif

protected:
  explicit vtkNPRLevelLines(double levels);
  ~vtkNPRLevelLines() override = default;

private:
  double Levels;
  double Spacing = 0.0;

  vtkNPRLevelLines(const vtkNPRLevelLines&) = delete;
  void operator=(const vtkNPRLevelLines&) = delete;
};

#endif
