// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeFilters_h
#define nprStrokeFilters_h

#include "nprPageScale.h"
#include "nprStyleDocument.h"

#include <vtkSmartPointer.h>

class vtkAlgorithm;
class vtkCamera;
class vtkMatrix4x4;
class vtkNPRSplineStrokes;
class vtkNPRStrokeAttributes;

namespace npr
{
/**
 * @class StrokeFilters
 * @brief What turns chains of points into strokes that look as a style says: splines -> attributes,
 * where the style has any.
 */
class StrokeFilters
{
public:
  /// @param light that strokes are thicker away from, if the style says so
  /// @param straight whether chains are to be left as they are
  /// @param matrix from the chains to the world
  StrokeFilters(
    const LineStyle& line, const LightStyle& light, bool straight, vtkMatrix4x4* matrix);
  StrokeFilters(StrokeFilters&&);
  ~StrokeFilters();

  vtkAlgorithm* GetFirst();
  vtkAlgorithm* GetLast() const;

  /// Lengths on the page, for a view.
  void SetScale(const PageScale& scale, vtkCamera* camera);
  /// How finely splines are sampled: for pixels of this size, in the coordinates of the chains.
  void SetPixel(double size);
  /// How far splines may leave the chains before these have corners, in their coordinates.
  void SetMaximumBulge(double length);
  /// How far smoothing may move the chains' points, in their coordinates.
  void SetMaximumShift(double length);

private:
  StrokeStyle Style;
  double Width;
  vtkSmartPointer<vtkNPRSplineStrokes> Splines;
  vtkSmartPointer<vtkNPRStrokeAttributes> Attributes; // null where the style needs none
};
}

#endif
