// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRCurvatureTensor
 * @brief Estimates the curvature of a triangle mesh.
 *
 * A sphere of radius r with outward normals has the curvature +1/r: convex is positive. The output
 * has the point arrays CurvatureTensor (6, in space, XX YY ZZ XY YZ XZ), PrincipalCurvature1 and
 * PrincipalCurvature2 (the first has the larger magnitude), PrincipalDirection1 and
 * PrincipalDirection2 (unit; the first x the second = the normal; at an umbilic arbitrary),
 * MeanCurvature, GaussianCurvature, and BorderPoints (1 where the estimate is one-sided: at
 * borders, at creases that the preparation has split, and at edges with more than two triangles).
 *
 * The input's normals (the active ones, else the array "Normals") are used as they are; what is
 * missing or not finite is computed as vtkNPRSurfaceNormals does, and the output has all normals.
 *
 * S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004,
 * with the mixed Voronoi areas of M. Meyer et al., "Discrete Differential-Geometry Operators for
 * Triangulated 2-Manifolds", VisMath 2002. It converges with the square of the edge length on
 * regular meshes; on irregular ones the error stalls at a few per cent: see SmoothingRadius.
 * @sa vtkNPRSurfaceNormals vtkNPRCurvatureDerivatives
 */
#ifndef vtkNPRCurvatureTensor_h
#define vtkNPRCurvatureTensor_h

#include "vtkNPRFiltersCurvatureModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSCURVATURE_EXPORT vtkNPRCurvatureTensor : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRCurvatureTensor* New();
  vtkTypeMacro(vtkNPRCurvatureTensor, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Standard deviation of a smoothing of the curvature tensor along the surface, as a fraction of
  /// the surface's length scale (see nprSurfaceDiffusion.h). Nothing flows across creases that the
  /// preparation has split. 0 (the default) does not smooth; useful values go up to about 0.1. The
  /// work grows with the square of radius / edge length, and ends at 1000 steps.
  vtkSetClampMacro(SmoothingRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SmoothingRadius, double);
  ///@}

protected:
  vtkNPRCurvatureTensor();
  ~vtkNPRCurvatureTensor() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRCurvatureTensor(const vtkNPRCurvatureTensor&) = delete;
  void operator=(const vtkNPRCurvatureTensor&) = delete;

  double SmoothingRadius = 0.0;
};

#endif
