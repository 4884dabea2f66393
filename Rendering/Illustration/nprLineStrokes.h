// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprLineStrokes_h
#define nprLineStrokes_h

#include "nprPageScale.h"
#include "nprStrokeFilters.h"
#include "nprStyleDocument.h"

#include <vtkSmartPointer.h>

class vtkActor;
class vtkAlgorithmOutput;
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
 * lines -> selection -> StrokeFilters -> mapper, which leaves out what the depth buffer hides; or
 * parts of the selection, as somebody has cut it where surfaces hide it -> StrokeFilters -> mapper.
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

  /// The lines that are long enough.
  vtkAlgorithmOutput* GetLinesPort();

  /// @name Strokes along parts of the lines, cut where surfaces hide them
  ///@{
  /// The parts, in the world; those of these lines have this LineType.
  void SetParts(vtkAlgorithmOutput* parts, int lineType);
  /// The strokes along them, up to date. Ends at which a line has been cut do not taper.
  vtkPolyData* GetPartStrokes();
  /// Whether they are drawn instead of the whole lines.
  void DrawParts(bool parts);
  ///@}

private:
  LineStyle Style;
  vtkSmartPointer<vtkMatrix4x4> Matrix;
  vtkSmartPointer<vtkNPRLineSelection> Selection;
  StrokeFilters Filters;
  vtkSmartPointer<vtkNPRLineSelection> Parts;
  StrokeFilters PartFilters;
  vtkSmartPointer<vtkNPRStrokeMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
};
}

#endif
