// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineStrokes_h
#define nprLineStrokes_h

#include "nprPageScale.h"
#include "nprStrokeFilters.h"
#include "nprStyleDocument.h"

#include <vtkSmartPointer.h>

class vtkActor;
class vtkCamera;
class vtkMatrix4x4;
class vtkNPRLineSelection;
class vtkNPRStrokeMapper;
class vtkPolyData;

namespace npr
{
class SurfacePipeline;

/**
 * @class LineStrokes
 * @brief The strokes that draw one kind of line on one surface.
 *
 * lines -> selection -> StrokeFilters -> mapper.
 */
class LineStrokes
{
public:
  /// @param index of the definition among those of the pipeline's feature lines
  /// @param light that strokes are thicker away from, if the style says so
  LineStrokes(const LineStyle& line, int index, const LightStyle& light, SurfacePipeline& pipeline,
    vtkMatrix4x4* matrix);
  LineStrokes(LineStrokes&&);
  ~LineStrokes();

  vtkActor* GetActor();
  vtkNPRStrokeMapper* GetMapper();

  /// Whether they are drawn while their surface is.
  bool IsVisible = true;

  /// Before each frame. `modelPixel` is the size of a pixel in the model; splines are sampled anew
  /// for it when `resample` says so.
  void SetScale(const PageScale& scale, vtkCamera* camera, double modelPixel, bool resample);

  /// @name For drawings on paper, where what is hidden is cut from the lines first
  ///@{
  /// The lines that are long enough, up to date.
  vtkPolyData* GetLines();
  /// The strokes along parts of them, which are in the world. Ends at which a line has been cut do
  /// not taper.
  vtkSmartPointer<vtkPolyData> MakeStrokes(
    vtkPolyData* parts, const PageScale& scale, vtkCamera* camera) const;
  ///@}

private:
  LineStyle Style;
  LightStyle Light;
  bool IsStraight;
  vtkSmartPointer<vtkNPRLineSelection> Selection;
  StrokeFilters Filters;
  vtkSmartPointer<vtkNPRStrokeMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
};
}

#endif
