// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRCurvatureDerivatives
 * @brief Estimates how the curvature of a triangle mesh changes along it.
 *
 * The output has the point array CurvatureDerivatives (4: P, Q, S, T = the derivatives of the first
 * principal curvature along the first and second principal direction, then of the second one; in
 * 1/length^2). The input needs the array CurvatureTensor of vtkNPRCurvatureTensor; the frame is
 * that of its PrincipalDirection1, or, where that is missing, comes from the tensor and is added.
 * To turn a principal direction over changes the sign of all four. DerivativeDoubt says where they
 * mean something, as that of vtkNPRCurvatureTensor.
 *
 * S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004. On
 * irregular meshes third derivatives are noise; smooth the tensor before, or the result here.
 *
 * Of pieces of a surface, and of what happens if the filter is aborted, the same holds as for
 * vtkNPRSurfaceNormals.
 * @sa vtkNPRCurvatureTensor
 */
#ifndef vtkNPRCurvatureDerivatives_h
#define vtkNPRCurvatureDerivatives_h

#include "vtkNPRFiltersCurvatureModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSCURVATURE_EXPORT vtkNPRCurvatureDerivatives : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRCurvatureDerivatives* New();
  vtkTypeMacro(vtkNPRCurvatureDerivatives, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Standard deviation of a smoothing of the derivatives along the surface, as a fraction of the
  /// surface's length scale (see nprSurfaceDiffusion.h). Nothing flows across creases that the
  /// preparation has split. 0 (the default) does not smooth; useful values go up to about 0.1. The
  /// work grows with the square of radius / edge length, and ends at 1000 steps.
  vtkSetClampMacro(SmoothingRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SmoothingRadius, double);
  ///@}

protected:
  vtkNPRCurvatureDerivatives();
  ~vtkNPRCurvatureDerivatives() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRCurvatureDerivatives(const vtkNPRCurvatureDerivatives&) = delete;
  void operator=(const vtkNPRCurvatureDerivatives&) = delete;

  /// False if it was aborted: then the output is unfinished.
  bool Compute(vtkPolyData* input, vtkPolyData* output);

  double SmoothingRadius = 0.0;
};

#endif
