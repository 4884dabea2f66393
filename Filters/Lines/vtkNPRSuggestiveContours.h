// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSuggestiveContours
 * @brief Where a contour is about to appear: lines that would be contours in a nearby view.
 *
 * The zero set of the radial curvature kr (the normal curvature in the direction of the eye), where
 * its derivative towards the eye, dwkr, exceeds a threshold and the surface faces the eye:
 *
 *   kr = II(w,w) / |w|^2,  dwkr = C(w,w,w) / |w|^3 + 2 K cot(theta),
 *
 * with w the part of the direction to the eye in the tangent plane. The difference between dwkr and
 * the threshold is multiplied by the sine of the angle theta between normal and eye, so nothing is
 * divided by a length that vanishes where the surface is seen head-on. Lines fade in from the
 * threshold, and out where the surface is seen head-on, where they are unstable.
 *
 * @par As an expression
 * vtkNPRExpressionLines with the field, the test and the constant
 * @code
 *   kr
 *   if(ndotv > 0 and sintheta > a,
 *     min((dwkr - 2) * sintheta / 2, (sintheta - a) / a, ndotv / 0.02),
 *     min((sintheta - a) / a, ndotv / 0.02))
 *   a = 0.25881904510252074
 * @endcode
 * gives these lines to the last bit: there stand Threshold, Fade, ContourFade and, as a, the sine
 * of MinimumAngle. (Where the surface is seen head-on or from behind, dwkr means nothing.) Without
 * a MinimumAngle the terms with a are missing.
 *
 * Sources: DeCarlo, Finkelstein, Rusinkiewicz, Santella, "Suggestive contours for conveying shape",
 * SIGGRAPH 2003; DeCarlo, Finkelstein, Rusinkiewicz, "Interactive rendering of suggestive contours
 * with temporal coherence", NPAR 2004.
 *
 * @par Scaled props
 * Curvature is that of the model itself, also where a prop scales it unevenly.
 *
 * @sa vtkNPRFeatureLines vtkNPROccludingContours vtkNPRSuggestiveHighlights vtkNPRExpressionLines
 */
#ifndef vtkNPRSuggestiveContours_h
#define vtkNPRSuggestiveContours_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRSuggestiveContours : public vtkNPRLineDefinition
{
public:
  static vtkNPRSuggestiveContours* New();
  vtkTypeMacro(vtkNPRSuggestiveContours, vtkNPRLineDefinition);

  const char* GetName() const override { return "suggestive"; }
  const char* GetDescription() const override
  {
    return "where a contour would appear in a nearby view";
  }
  bool IsViewDependent() const override { return true; }

  ///@{
  /// The least derivative of the radial curvature towards the eye, times the square of the length
  /// scale (no unit). Range [0, 1e6]. Default is 2.
  vtkSetClampMacro(Threshold, double, 0.0, 1.0e6);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /// How far above the threshold (in its unit, times the sine of the angle between normal and eye)
  /// a line has its full strength. Range [1e-6, 1e6]. Default is 2.
  vtkSetClampMacro(Fade, double, 1.0e-6, 1.0e6);
  vtkGetMacro(Fade, double);
  ///@}

  ///@{
  /// Lines end where the angle between normal and eye is smaller than this, in degrees; they have
  /// their full strength from twice its sine on. Range [0, 45]. Default is 15.
  vtkSetClampMacro(MinimumAngle, double, 0.0, 45.0);
  vtkGetMacro(MinimumAngle, double);
  ///@}

  ///@{
  /// Lines fade out towards the contour where the cosine of the angle between normal and eye is
  /// smaller than this (no unit). Small, for the line continues the contour that it meets. Range
  /// [1e-6, 1]. Default is 0.02.
  vtkSetClampMacro(ContourFade, double, 1.0e-6, 1.0);
  vtkGetMacro(ContourFade, double);
  ///@}

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  bool HasField() const override
  {
    return true;
  }
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
  std::array<float, 2> GetFacingRange() const override
  {
    return { 0.0f, 1.0f };
  }
  void BoundField(const npr::LineSurface& surface, vtkIdType begin, vtkIdType end,
    signed char* sign) const override;
  bool HasTest() const override
  {
    return true;
  }
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view, const Index* points,
    vtkIdType count, const float* fall, float* test) const override;
#endif

protected:
  vtkNPRSuggestiveContours();
  ~vtkNPRSuggestiveContours() override = default;

  /// 1 where kr is to rise towards the eye, -1 where it is to fall.
  virtual double GetSide() const
  {
    return 1.0;
  }

private:
  double Threshold = 2.0;
  double Fade = 2.0;
  double MinimumAngle = 15.0;
  double ContourFade = 0.02;

  vtkNPRSuggestiveContours(const vtkNPRSuggestiveContours&) = delete;
  void operator=(const vtkNPRSuggestiveContours&) = delete;
};

#endif
