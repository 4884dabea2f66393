// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRZeroMeanCurvature
 * @brief Where the surface bends as much one way as the other: between its bumps and its hollows.
 *
 * The zero set of the mean curvature H = (k1 + k2) / 2, where H crosses zero steeply enough.
 *
 * A `Region` is measured by the integral of H^2 (Willmore's energy). Defaults are: Threshold 2 (H's
 * gradient times the square of the length scale), Fade 4, Smoothing 0.02, Region 0.3.
 *
 * Source: Koenderink, "Solid Shape", MIT Press 1990.
 *
 * @sa vtkNPRFeatureLines vtkNPRParabolicLines
 */
#ifndef vtkNPRZeroMeanCurvature_h
#define vtkNPRZeroMeanCurvature_h

#include "vtkNPRZeroCurvatureLines.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRZeroMeanCurvature : public vtkNPRZeroCurvatureLines
{
public:
  static vtkNPRZeroMeanCurvature* New();
  vtkTypeMacro(vtkNPRZeroMeanCurvature, vtkNPRZeroCurvatureLines);

  const char* GetName() const override { return "mean-curvature"; }
  const char* GetDescription() const override
  {
    return "where the surface bends as much one way as the other, between bumps and hollows";
  }

protected:
  vtkNPRZeroMeanCurvature();
  ~vtkNPRZeroMeanCurvature() override = default;

#ifndef __VTK_WRAP__
  double GetCurvature(double mean, double /*gaussian*/) const override
  {
    return mean;
  }
  double GetDensity(double curvature) const override
  {
    return curvature * curvature;
  }
#endif

private:
  vtkNPRZeroMeanCurvature(const vtkNPRZeroMeanCurvature&) = delete;
  void operator=(const vtkNPRZeroMeanCurvature&) = delete;
};

#endif
