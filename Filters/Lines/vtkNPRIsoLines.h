// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRIsoLines
 * @brief Lines of equal value of a point array of the surface, such as a temperature.
 *
 * The field is one component of the array, or its magnitude. Its levels are so many over its range,
 * the multiples of a spacing, or given one by one.
 *
 * Source: Dobkin, Levy, Thurston, Wilks, "Contour tracing by piecewise linear approximations", ACM
 * Transactions on Graphics 9, 1990.
 *
 * @sa vtkNPRFeatureLines vtkNPRTopographicLines
 */
#ifndef vtkNPRIsoLines_h
#define vtkNPRIsoLines_h

#include "vtkNPRLevelLines.h"

#include <string>
#include <vector>

class VTKNPRFILTERSLINES_EXPORT vtkNPRIsoLines : public vtkNPRLevelLines
{
public:
  static vtkNPRIsoLines* New();
  vtkTypeMacro(vtkNPRIsoLines, vtkNPRLevelLines);

  const char* GetName() const override { return "isolines"; }
  const char* GetDescription() const override { return "lines of equal value of a point array"; }

  ///@{
  /// The name of the point array. Default is empty, which is an error.
  vtkSetMacro(Array, std::string);
  vtkGetMacro(Array, std::string);
  ///@}

  ///@{
  /// Which component of the array, from 0 on; -1 for its magnitude, which of an array with one
  /// component is its value. Default is -1.
  vtkSetClampMacro(Component, double, -1.0, 1.0e6);
  vtkGetMacro(Component, double);
  ///@}

  ///@{
  /// Levels given one by one, instead of Levels and Spacing; empty for these. Default is empty.
  void SetValues(const std::vector<double>& values);
  const std::vector<double>& GetValues() const { return this->Values; }
  ///@}

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  std::vector<float> GetLevels(const npr::LineSurface& surface) const override;
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
  std::string FindError(const npr::LineSurface& surface) const override;
#endif

protected:
  vtkNPRIsoLines();
  ~vtkNPRIsoLines() override = default;

private:
  std::string Array;
  double Component = -1.0;
  std::vector<double> Values;

  vtkNPRIsoLines(const vtkNPRIsoLines&) = delete;
  void operator=(const vtkNPRIsoLines&) = delete;
};

#endif
