// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRParabolicLines
 * @brief Where the surface turns from bulging, either way, to saddle-shaped.
 *
 * The zero set of the Gaussian curvature K = k1 k2, where K crosses zero steeply enough. There k2
 * is 0 and the gradient of K is k1 (S, T), with the derivatives of k2 along the principal
 * directions.
 *
 * Source: Klein's parabolic curves, after Hilbert, Cohn-Vossen, "Anschauliche Geometrie", 1932
 * ("Geometry and the Imagination"), chapter 29.
 *
 * @sa vtkNPRFeatureLines vtkNPRZeroMeanCurvature
 */
#ifndef vtkNPRParabolicLines_h
#define vtkNPRParabolicLines_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRParabolicLines : public vtkNPRLineDefinition
{
public:
  static vtkNPRParabolicLines* New();
  vtkTypeMacro(vtkNPRParabolicLines, vtkNPRLineDefinition);

  const char* GetName() const override { return "parabolic"; }
  const char* GetDescription() const override
  {
    return "where the surface turns from bulging to saddle-shaped";
  }
  bool IsViewDependent() const override { return false; }

  ///@{
  /// The least gradient of the Gaussian curvature, times the cube of the length scale (no unit).
  /// Range [0, 1e9]. Default is 400.
  vtkSetClampMacro(Threshold, double, 0.0, 1.0e9);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /// How far above the threshold (in its unit) a line has its full strength. Range [1e-6, 1e9].
  /// Default is 800.
  vtkSetClampMacro(Fade, double, 1.0e-6, 1.0e9);
  vtkGetMacro(Fade, double);
  ///@}

  ///@{
  /// The least gradient of k2, over the square of k1 (no unit, whatever the length scale); lines
  /// have their full strength at twice as much. Where k2 changes its sign more slowly than that,
  /// the place is not certain on measured surfaces. Range [0, 1e6]; 0 for no such bound. Default
  /// is 0.5: parabolic lines of a torus stay where its tube is thicker than half of its hole's
  /// mean radius.
  vtkSetClampMacro(Steepness, double, 0.0, 1.0e6);
  vtkGetMacro(Steepness, double);
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
  vtkNPRParabolicLines();
  ~vtkNPRParabolicLines() override = default;

private:
  double Threshold = 400.0;
  double Fade = 800.0;
  double Steepness = 0.5;

  vtkNPRParabolicLines(const vtkNPRParabolicLines&) = delete;
  void operator=(const vtkNPRParabolicLines&) = delete;
};

#endif
