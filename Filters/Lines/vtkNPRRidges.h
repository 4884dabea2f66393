// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRRidges
 * @brief Where a surface bends outwards more than anywhere else on the way across.
 *
 * The zero set of P, the derivative of the first principal curvature k along its own direction,
 * where k exceeds a threshold and has a maximum along that direction. Ridges belong to the shape,
 * so they stay where they are in all views. Where the lines of the largest curvature meet at
 * umbilics, ridges end.
 *
 * A maximum must also be sharp. On cylinders, tori and fillets k is constant across, and no noise
 * in it is to make a line. How fast P falls along the direction is measured in units of k^3, which
 * makes it a number that belongs to the cross-section's form alone, not to its size: 0 for a
 * circle, 3 for a parabola at its vertex, 3 (1 - b^2/a^2) for an ellipse with the half-axes a > b.
 *
 * Source: Y. Ohtake, A. Belyaev, H.-P. Seidel, "Ridge-Valley Lines on Meshes via Implicit Surface
 * Fitting", SIGGRAPH 2004; the measure of sharpness is our own.
 *
 * @sa vtkNPRFeatureLines vtkNPRValleys
 */
#ifndef vtkNPRRidges_h
#define vtkNPRRidges_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRRidges : public vtkNPRLineDefinition
{
public:
  static vtkNPRRidges* New();
  vtkTypeMacro(vtkNPRRidges, vtkNPRLineDefinition);

  const char* GetName() const override { return "ridges"; }
  const char* GetDescription() const override
  {
    return "where the surface bends outwards most on the way across";
  }
  bool IsViewDependent() const override { return false; }

  ///@{
  /// The least curvature across the line, times the length scale (no unit): a sphere as large as
  /// the surface has about 1. Range [0, 1e6]. Default is 4.
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

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  bool HasField() const override
  {
    return true;
  }
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
  const char* GetAxes() const override;
  bool IsMaximum() const override
  {
    return true;
  }
  bool HasTest() const override
  {
    return true;
  }
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view, const Index* points,
    vtkIdType count, const float* fall, float* test) const override;
#endif

protected:
  vtkNPRRidges();
  ~vtkNPRRidges() override = default;

  /// The side of the surface that the lines are the ridges of: 1 is outside, -1 inside.
  virtual float GetSide() const
  {
    return 1.0f;
  }

private:
  double Threshold = 4.0;
  double Fade = 4.0;
  double Sharpness = 0.2;

  vtkNPRRidges(const vtkNPRRidges&) = delete;
  void operator=(const vtkNPRRidges&) = delete;
};

#endif
