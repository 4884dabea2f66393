// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRApparentRidges
 * @brief Where a surface, as it is seen, turns faster than anywhere else on the way across.
 *
 * Ridges and valleys of the view-dependent curvature q: how fast the normal turns on the screen,
 * not on the surface. The zero set of the derivative of q along the direction in which it is
 * greatest, where q exceeds a threshold and has a maximum along that direction, and where the
 * surface faces the eye. Seen head-on they are the ridges and valleys of the surface; toward the
 * contour they slide as the eye moves, and there q grows without bound: the contour itself is
 * their limit, which vtkNPROccludingContours draws.
 *
 * A maximum must also be sharp. How fast the derivative falls on the screen is measured in units of
 * q^3, which makes it a number that belongs to the form alone, not to its size or the view's. Seen
 * head-on a circle has -1 (so bulges have no line), a parabola at its vertex 2.
 *
 * Source: T. Judd, F. Durand, E. Adelson, "Apparent ridges for line drawing", SIGGRAPH 2007. The
 * derivative is computed at each point by itself (see nprViewCurvature.h); the measure of
 * sharpness is our own.
 *
 * @par Scaled props
 * Curvature is that of the model itself, also where a prop scales it unevenly.
 *
 * @sa vtkNPRFeatureLines vtkNPRRidges vtkNPROccludingContours
 */
#ifndef vtkNPRApparentRidges_h
#define vtkNPRApparentRidges_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRApparentRidges : public vtkNPRLineDefinition
{
public:
  static vtkNPRApparentRidges* New();
  vtkTypeMacro(vtkNPRApparentRidges, vtkNPRLineDefinition);

  const char* GetName() const override { return "apparent-ridges"; }
  const char* GetDescription() const override
  {
    return "where the surface, as it is seen, turns most on the way across";
  }
  bool IsViewDependent() const override { return true; }

  ///@{
  /// The least view-dependent curvature, times the length scale (no unit): a sphere as large as the
  /// surface has about 1 where it is seen head-on. Range [0, 1e6]. Default is 6.
  vtkSetClampMacro(Threshold, double, 0.0, 1.0e6);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /// How far above the threshold (in its unit) a line has its full strength. Range [1e-6, 1e6].
  /// Default is 4.
  vtkSetClampMacro(Fade, double, 1.0e-6, 1.0e6);
  vtkGetMacro(Fade, double);
  ///@}

  ///@{
  /// How sharp the maximum must be at least, see above (no unit); from twice as sharp on a line has
  /// its full strength. Range [1e-6, 1e6]. Default is 0.2.
  vtkSetClampMacro(Sharpness, double, 1.0e-6, 1.0e6);
  vtkGetMacro(Sharpness, double);
  ///@}

  ///@{
  /// Lines fade out towards the contour where the cosine of the angle between normal and eye is
  /// smaller than this (no unit). Small, for the line continues the contour that it meets. Range
  /// [1e-6, 1]. Default is 0.1.
  vtkSetClampMacro(ContourFade, double, 1.0e-6, 1.0);
  vtkGetMacro(ContourFade, double);
  ///@}

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  bool HasField() const override
  {
    return true;
  }
  bool HasViewAxes() const override
  {
    return true;
  }
  void EvaluateFieldAndAxes(const npr::LineSurface& surface, const npr::LineView& view,
    vtkIdType begin, vtkIdType end, float* field, npr::AxisPoint* points) const override;
  bool IsMaximum() const override
  {
    return true;
  }
  std::array<float, 2> GetFacingRange() const override
  {
    return { 0.0f, 1.0f };
  }
  bool HasTest() const override
  {
    return true;
  }
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view, const Index* points,
    vtkIdType count, const float* fall, float* test) const override;
#endif

protected:
  vtkNPRApparentRidges();
  ~vtkNPRApparentRidges() override = default;

private:
  double Threshold = 6.0;
  double Fade = 4.0;
  double Sharpness = 0.2;
  double ContourFade = 0.1;

  vtkNPRApparentRidges(const vtkNPRApparentRidges&) = delete;
  void operator=(const vtkNPRApparentRidges&) = delete;
};

#endif
