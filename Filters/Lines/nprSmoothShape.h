// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprSmoothShape_h
#define nprSmoothShape_h

#include "nprLineSurface.h"
#include "nprTupleArrays.h"

#include <memory>
#include <vector>

namespace npr
{
class SurfaceDiffusion;

/// Normals and curvature of a surface, smoothed along it (see SurfaceDiffusion), for lines that
/// are to show its form and not its grain. What is not a number stays at its point.
struct SmoothShape
{
  /// @param smoothing the standard deviation of the Gaussian, over the length scale; 0 for none
  /// @param withNormals whether normals are smoothed, too
  SmoothShape(const LineSurface& surface, double smoothing, bool withNormals);
  ~SmoothShape();

  /// Smooths a field of numbers along the surface; the radius in the tensors' radii.
  void Smooth(std::vector<float>& values, double radius) const;

  Tuples<3> Normals;
  Tuples<6> Tensors;          ///< times the length scale; 0 where they are no numbers
  std::vector<char> IsNumber; ///< of the point's normal and tensor

private:
  double Radius;                               // length
  std::unique_ptr<SurfaceDiffusion> Diffusion; // where it is smoothed
};
}

#endif
