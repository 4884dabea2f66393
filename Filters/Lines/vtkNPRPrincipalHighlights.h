// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRPrincipalHighlights
 * @brief Where a surface faces the eye best on the way across the direction in which it bends most.
 *
 * The zero set of v.e, with v the unit vector to the eye and e the direction of the first principal
 * curvature k1: there the eye is straight above the other principal direction. Light from the eye
 * gleams along these lines, on the crests of forms and in the depths of their folds. They are drawn
 * where the surface bends clearly more along e than across it and faces the eye: where
 * (k1^2 - k2^2) n.v exceeds a threshold. Lines on crests (k1 > 0) and in folds (k1 < 0) may be
 * drawn alone. Drawn light on dark, they complement contours and suggestive contours.
 *
 * Source: D. DeCarlo, S. Rusinkiewicz, "Highlight lines for conveying shape", NPAR 2007.
 *
 * @par Scaled props
 * Curvature is that of the model itself, also where a prop scales it unevenly.
 *
 * @sa vtkNPRFeatureLines vtkNPRSuggestiveContours
 */
#ifndef vtkNPRPrincipalHighlights_h
#define vtkNPRPrincipalHighlights_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRPrincipalHighlights : public vtkNPRLineDefinition
{
public:
  static vtkNPRPrincipalHighlights* New();
  vtkTypeMacro(vtkNPRPrincipalHighlights, vtkNPRLineDefinition);

  const char* GetName() const override { return "principal-highlights"; }
  const char* GetDescription() const override
  {
    return "where crests and folds face the eye, for light lines on dark";
  }
  bool IsViewDependent() const override { return true; }

  ///@{
  /// The least (k1^2 - k2^2) n.v, times the square of the length scale (no unit). Range [0, 1e6].
  /// Default is 16.
  vtkSetClampMacro(Threshold, double, 0.0, 1.0e6);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /// How far above the threshold (in its unit) a line has its full strength. Range [1e-6, 1e6].
  /// Default is 16.
  vtkSetClampMacro(Fade, double, 1.0e-6, 1.0e6);
  vtkGetMacro(Fade, double);
  ///@}

  ///@{
  /// Which of them are drawn: 1 for those on crests only, -1 for those in folds only, 0 for both
  /// (no unit). Range [-1, 1]. Default is 0.
  vtkSetClampMacro(Side, double, -1.0, 1.0);
  vtkGetMacro(Side, double);
  ///@}

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  bool HasField() const override
  {
    return true;
  }
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
  const char* GetAxes() const override;
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
  vtkNPRPrincipalHighlights();
  ~vtkNPRPrincipalHighlights() override = default;

private:
  double Threshold = 16.0;
  double Fade = 16.0;
  double Side = 0.0;

  vtkNPRPrincipalHighlights(const vtkNPRPrincipalHighlights&) = delete;
  void operator=(const vtkNPRPrincipalHighlights&) = delete;
};

#endif
