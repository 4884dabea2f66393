// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRTopographicLines
 * @brief Lines of equal height, as on maps: planes across a direction cut the surface.
 *
 * The height is p.a, with a the unit vector of the direction. With a spacing the lines are at its
 * multiples in the coordinates of the model, so they stay in place when the surface is cut or
 * grows.
 *
 * Source: Cayley, "On contour and slope lines", Philosophical Magazine 18, 1859.
 *
 * @sa vtkNPRFeatureLines vtkNPRIsoLines
 */
#ifndef vtkNPRTopographicLines_h
#define vtkNPRTopographicLines_h

#include "vtkNPRLevelLines.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRTopographicLines : public vtkNPRLevelLines
{
public:
  static vtkNPRTopographicLines* New();
  vtkTypeMacro(vtkNPRTopographicLines, vtkNPRLevelLines);

  const char* GetName() const override { return "topographic"; }
  const char* GetDescription() const override { return "lines of equal height, as on maps"; }

  ///@{
  /// The direction of the height in the coordinates of the model, of any length but 0. Default is
  /// (0, 0, 1).
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

#ifndef __VTK_WRAP__
  double GetLevelOffset(const npr::LineSurface& surface) const override;
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
  std::string FindError(const npr::LineSurface& surface) const override;
#endif

protected:
  vtkNPRTopographicLines();
  ~vtkNPRTopographicLines() override = default;

private:
  double Direction[3] = { 0.0, 0.0, 1.0 };

  vtkNPRTopographicLines(const vtkNPRTopographicLines&) = delete;
  void operator=(const vtkNPRTopographicLines&) = delete;
};

#endif
