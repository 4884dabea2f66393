// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCurvatureOptions.h
 * @brief The options that say how curvature is estimated, and from a model to its curvature.
 */
#ifndef nprCurvatureOptions_h
#define nprCurvatureOptions_h

#include <vtkSmartPointer.h>

#include <string>

namespace CLI
{
class App;
}
class vtkNPRCurvatureTensor;
class vtkNPRSurfacePreparation;
class vtkPolyData;

namespace npr
{
class Reporter;

struct CurvatureOptions
{
  CurvatureOptions();

  std::string Estimator;
  double Radius = 0.0;
  double Smoothing = 0.0;

  void AddTo(CLI::App& command);

  /// The prepared surface with all arrays of curvature. Normals of the file play no part: they are
  /// often those of facets, or of another surface; nor does a radius that it was estimated with.
  vtkSmartPointer<vtkPolyData> Compute(
    vtkNPRSurfacePreparation* preparation, vtkPolyData* model, Reporter& reporter) const;

  /// How a surface's curvature was estimated, to standard output.
  void Print(vtkPolyData* surface) const;
};

/// A clean, oriented mesh; the seams of closed surfaces, whose sides rounding has parted, too.
void Prepare(vtkNPRSurfacePreparation* preparation, vtkPolyData* model, Reporter& reporter);
}

#endif
