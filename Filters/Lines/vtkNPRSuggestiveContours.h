// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSuggestiveContours
 * @brief Where a contour is about to appear: lines that would be contours in a nearby view.
 *
 * The zero set of the radial curvature (the normal curvature in the direction of the eye), where
 * its derivative D towards the eye exceeds a threshold and the surface faces the eye. The field is
 * multiplied by sin^2 and D by sin of the angle between normal and eye, so nothing is divided by a
 * length that vanishes where the surface is seen head-on:
 *
 *   sin D = sin C(w,w,w) + 2 K cos, with w the unit direction of the eye in the tangent plane.
 *
 * Lines fade in from the threshold, and out where the surface is seen head-on, where they are
 * unstable.
 *
 * Sources: DeCarlo, Finkelstein, Rusinkiewicz, Santella, "Suggestive contours for conveying shape",
 * SIGGRAPH 2003; DeCarlo, Finkelstein, Rusinkiewicz, "Interactive rendering of suggestive contours
 * with temporal coherence", NPAR 2004.
 *
 * @par Scaled props
 * Curvature is that of the model itself, also where a prop scales it unevenly.
 *
 * @sa vtkNPRFeatureLines vtkNPROccludingContours
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
  /// The least derivative of the radial curvature, times the square of the length scale (no unit).
  /// Range [0, 1e6]. Default is 2.
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

private:
  double Threshold = 2.0;
  double Fade = 2.0;
  double MinimumAngle = 15.0;
  double ContourFade = 0.02;

  vtkNPRSuggestiveContours(const vtkNPRSuggestiveContours&) = delete;
  void operator=(const vtkNPRSuggestiveContours&) = delete;
};

#endif
