// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprActorIllustration_h
#define nprActorIllustration_h

#include "nprSurfacePipeline.h"
#include "vtkNPRRenderingIllustrationModule.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkActor;
class vtkAlgorithm;
class vtkMapper;
class vtkMatrix4x4;
class vtkNPRLineSelection;
class vtkNPRSplineStrokes;
class vtkNPRStrokeMapper;
class vtkPolyData;
class vtkProperty;
class vtkRenderer;

namespace npr
{
struct LineStyle;
struct StyleDocument;

/// The sizes that tie a style's page units to a view of the model.
struct VTKNPRRENDERINGILLUSTRATION_EXPORT PageScale
{
  double PixelsPerUnit = 1.0;        ///< Pixels in a thousandth of the image's shorter side.
  double PixelsPerUnitOfWidth = 1.0; ///< The same, but for widths: small images keep visible lines.
  double WorldPerPixel = 1.0;        ///< Length of a pixel's side at the focal point.

  static PageScale Of(vtkRenderer* renderer);

  /// What a thousandth of the image's shorter side is in the coordinates of a model.
  double GetUnit(vtkMatrix4x4* modelToWorld) const;
};

/**
 * @class ActorIllustration
 * @brief One actor of the user's, its surface prepared and shaded, and the strokes on it.
 *
 * The actor stays in the renderer and keeps its matrix, so that it can be moved and picked as
 * before; only its mapper and property are exchanged, until this object is destroyed.
 */
class ActorIllustration
{
public:
  /// Whether the actor shows a surface that can be illustrated.
  static bool Accepts(vtkActor* actor);

  ActorIllustration(
    vtkActor* actor, vtkRenderer* renderer, const StyleDocument& style, const PageScale& scale);
  ~ActorIllustration();
  ActorIllustration(const ActorIllustration&) = delete;
  void operator=(const ActorIllustration&) = delete;

  SurfacePipeline& GetPipeline() { return this->Pipeline; }

  /// Widths in pixels and the fineness of splines follow the window and the camera.
  void SetScale(const PageScale& scale);

  /// @name The length scale that thresholds refer to, in the world
  ///@{
  double GetWorldLengthScale() { return this->Pipeline.GetLengthScale() * this->MatrixScale; }
  void SetWorldLengthScale(double scale);
  ///@}

  /// Whether the actor is still the one that this object has changed.
  bool IsCurrent() const;

private:
  struct Strokes
  {
    vtkSmartPointer<vtkNPRLineSelection> Selection;
    vtkSmartPointer<vtkNPRSplineStrokes> Splines;
    vtkSmartPointer<vtkNPRStrokeMapper> Mapper;
    vtkSmartPointer<vtkActor> Actor;
    double WidthInUnits = 1.0;
    double MinimumLengthInUnits = 0.0;
  };

  /// A textured surface is shown as it is in the file, another one prepared and refined.
  void ShadeSurface(const StyleDocument& style, vtkPolyData* textured);
  void AddStrokes(const LineStyle& line, vtkMatrix4x4* matrix);

  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkMapper> OriginalMapper;
  vtkSmartPointer<vtkProperty> OriginalProperty;
  vtkSmartPointer<vtkMapper> SurfaceMapper;
  vtkSmartPointer<vtkAlgorithm> Source; // only where the mapper does not show a vtkPolyData
  SurfacePipeline Pipeline;
  std::vector<Strokes> AllStrokes;
  double MatrixScale = 1.0;
  double SampledPixel = 0.0;
};
}

#endif
