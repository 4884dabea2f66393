// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRParabolicLines
 * @brief Where the surface turns from bulging, either way, to saddle-shaped.
 *
 * The zero set of the Gaussian curvature K = k1 k2, where K crosses zero steeply enough.
 *
 * A `Region` is measured by its total curvature, the integral of K: the solid angle of its normals,
 * in steradians. Up to where a bump is steepest that is 2 pi (1 - cos a) for a slope of the angle
 * a. Defaults are: Threshold 5 (K's gradient times the cube of the length scale), Fade 10,
 * Smoothing 0.05, Region 0.3.
 *
 * Source: Klein's parabolic curves, after Hilbert, Cohn-Vossen, "Anschauliche Geometrie", 1932
 * ("Geometry and the Imagination"), chapter 29.
 *
 * @sa vtkNPRFeatureLines vtkNPRZeroMeanCurvature
 */
#ifndef vtkNPRParabolicLines_h
#define vtkNPRParabolicLines_h

#include "vtkNPRZeroCurvatureLines.h"

#include <cmath>

class VTKNPRFILTERSLINES_EXPORT vtkNPRParabolicLines : public vtkNPRZeroCurvatureLines
{
public:
  static vtkNPRParabolicLines* New();
  vtkTypeMacro(vtkNPRParabolicLines, vtkNPRZeroCurvatureLines);

  const char* GetName() const override { return "parabolic"; }
  const char* GetDescription() const override
  {
    return "where the surface turns from bulging to saddle-shaped";
  }

protected:
  vtkNPRParabolicLines();
  ~vtkNPRParabolicLines() override = default;

#ifndef __VTK_WRAP__
  double GetCurvature(double /*mean*/, double gaussian) const override
  {
    return gaussian;
  }
  double GetDensity(double curvature) const override
  {
    return std::abs(curvature);
  }
#endif

private:
  vtkNPRParabolicLines(const vtkNPRParabolicLines&) = delete;
  void operator=(const vtkNPRParabolicLines&) = delete;
};

#endif
