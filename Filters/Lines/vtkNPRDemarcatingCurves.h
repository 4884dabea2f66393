// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRDemarcatingCurves
 * @brief Between valley and ridge: where the surface's steps turn from hollow to bulging.
 *
 * Around a point the surface is like a step, which bends most quickly along the unit tangent vector
 * g that maximises C(g,g,g), the derivative of the curvature along itself. The curve runs where the
 * normal curvature across the step vanishes, II(g,g) = 0, and is as strong as C(g,g,g).
 *
 * Where C has two equal maxima, g turns from one to the other at once, and II(g,g) may jump over 0:
 * no line crosses an edge between whose ends g turns by more than 45 degrees.
 *
 * Source: Kolomenkin, Shimshoni, Tal, "Demarcating curves for shape illustration", SIGGRAPH Asia
 * 2008.
 *
 * @sa vtkNPRFeatureLines
 */
#ifndef vtkNPRDemarcatingCurves_h
#define vtkNPRDemarcatingCurves_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRDemarcatingCurves : public vtkNPRLineDefinition
{
public:
  static vtkNPRDemarcatingCurves* New();
  vtkTypeMacro(vtkNPRDemarcatingCurves, vtkNPRLineDefinition);

  const char* GetName() const override { return "demarcating"; }
  const char* GetDescription() const override
  {
    return "between valleys and ridges: where steps turn from hollow to bulging";
  }
  bool IsViewDependent() const override { return false; }

  ///@{
  /// The least derivative of the curvature across the step, times the square of the length scale
  /// (no unit). Range [0, 1e6]. Default is 15.
  vtkSetClampMacro(Threshold, double, 0.0, 1.0e6);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /// How far above the threshold (in its unit) a line has its full strength. Range [1e-6, 1e6].
  /// Default is 15.
  vtkSetClampMacro(Fade, double, 1.0e-6, 1.0e6);
  vtkGetMacro(Fade, double);
  ///@}

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  bool HasField() const override
  {
    return true;
  }
  /// They turn with no view, but there is no array of them.
  bool HasViewAxes() const override
  {
    return true;
  }
  bool HasEvenField() const override
  {
    return true;
  }
  void EvaluateFieldAndAxes(const npr::LineSurface& surface, const npr::LineView& view,
    vtkIdType begin, vtkIdType end, float* field, npr::AxisPoint* points) const override;
  bool HasTest() const override
  {
    return true;
  }
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view, const Index* points,
    vtkIdType count, const float* fall, float* test) const override;
#endif

protected:
  vtkNPRDemarcatingCurves();
  ~vtkNPRDemarcatingCurves() override = default;

private:
  double Threshold = 15.0;
  double Fade = 15.0;

  vtkNPRDemarcatingCurves(const vtkNPRDemarcatingCurves&) = delete;
  void operator=(const vtkNPRDemarcatingCurves&) = delete;
};

#endif
