// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRZeroMeanCurvature
 * @brief Where the surface bends as much one way as the other: between its bumps and its hollows.
 *
 * The zero set of the mean curvature H = (k1 + k2) / 2, where H crosses zero steeply enough. Its
 * gradient is ((P + S) / 2, (Q + T) / 2) along the principal directions.
 *
 * Source: Koenderink, "Solid Shape", MIT Press 1990.
 *
 * @sa vtkNPRFeatureLines vtkNPRParabolicLines
 */
#ifndef vtkNPRZeroMeanCurvature_h
#define vtkNPRZeroMeanCurvature_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRZeroMeanCurvature : public vtkNPRLineDefinition
{
public:
  static vtkNPRZeroMeanCurvature* New();
  vtkTypeMacro(vtkNPRZeroMeanCurvature, vtkNPRLineDefinition);

  const char* GetName() const override { return "mean-curvature"; }
  const char* GetDescription() const override
  {
    return "where the surface bends as much one way as the other, between bumps and hollows";
  }
  bool IsViewDependent() const override { return false; }

  ///@{
  /// The least gradient of the mean curvature, times the square of the length scale (no unit).
  /// Range [0, 1e6]. Default is 10.
  vtkSetClampMacro(Threshold, double, 0.0, 1.0e6);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /// How far above the threshold (in its unit) a line has its full strength. Range [1e-6, 1e6].
  /// Default is 20.
  vtkSetClampMacro(Fade, double, 1.0e-6, 1.0e6);
  vtkGetMacro(Fade, double);
  ///@}

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  bool HasField() const override
  {
    return true;
  }
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
  bool HasTest() const override
  {
    return true;
  }
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view, const Index* points,
    vtkIdType count, const float* fall, float* test) const override;
#endif

protected:
  vtkNPRZeroMeanCurvature();
  ~vtkNPRZeroMeanCurvature() override = default;

private:
  double Threshold = 10.0;
  double Fade = 20.0;

  vtkNPRZeroMeanCurvature(const vtkNPRZeroMeanCurvature&) = delete;
  void operator=(const vtkNPRZeroMeanCurvature&) = delete;
};

#endif
