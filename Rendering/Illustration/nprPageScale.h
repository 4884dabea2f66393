// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprPageScale_h
#define nprPageScale_h

class vtkMatrix4x4;
class vtkRenderer;

namespace npr
{
/// The sizes that tie a style's page units to a view of the model. A unit is a thousandth of the
/// image's shorter side.
struct PageScale
{
  double PixelsPerUnit = 1.0;
  double PixelsPerUnitOfWidth = 1.0; ///< Of lines: small images keep visible ones.
  double ViewHeightsPerUnit = 0.001;
  double WorldPerPixel = 1.0; ///< Length of a pixel's side at the focal point.

  static PageScale Of(vtkRenderer* renderer);

  /// What a unit is in the coordinates of a model.
  double GetUnit(vtkMatrix4x4* modelToWorld) const;
};

/// How much a matrix enlarges, on the average over directions; 1 for a singular one.
double ComputeScale(vtkMatrix4x4* matrix);
}

#endif
