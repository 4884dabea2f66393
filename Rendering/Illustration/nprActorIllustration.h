// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprActorIllustration_h
#define nprActorIllustration_h

#include "nprLineStrokes.h"
#include "nprPageScale.h"
#include "nprSurfacePipeline.h"

#include <vtkAlgorithmOutput.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

class vtkActor;
class vtkAlgorithm;
class vtkMapper;
class vtkMatrix4x4;
class vtkNPROutlineNormals;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkPolyDataNormals;
class vtkProperty;
class vtkRenderer;
class vtkTexture;

namespace npr
{
struct StyleDocument;

/**
 * @class ActorIllustration
 * @brief One actor of the user's, its surface prepared and shaded, and the strokes on it.
 *
 * The actor stays in the renderer and keeps its matrix, so that it can be moved as before; only its
 * mapper, property and texture are exchanged, until this object is destroyed.
 */
class ActorIllustration
{
public:
  /// Whether the actor shows a surface that can be illustrated.
  static bool Accepts(vtkActor* actor);

  /// Prepares the surface, which may take long; progress is called with fractions.
  ActorIllustration(vtkActor* actor, vtkRenderer* renderer, const StyleDocument& style,
    const PageScale& scale, std::function<void(double)> progress);
  ~ActorIllustration();
  ActorIllustration(const ActorIllustration&) = delete;
  void operator=(const ActorIllustration&) = delete;

  SurfacePipeline& GetPipeline() { return this->Pipeline; }
  vtkActor* GetActor() { return this->Actor; }

  /// One for each definition, in order.
  std::vector<LineStrokes>& GetStrokes() { return this->AllStrokes; }

  /// Whether the user shows the actor, with the illustration on it.
  bool IsShown();

  /// Whether the lines of a definition (by its index) are drawn from the next frame on; all are at
  /// first.
  void SetLineVisibility(int index, bool visible);

  /// Before each frame: what the user has done to the actor, its mapper, the camera or the window.
  void Follow(const PageScale& scale);

  /// After that: whether the far side of the surface need be drawn in the frame.
  void CullBackFaces();

  /// @name The length scale that thresholds refer to, in the world
  ///@{
  double GetWorldLengthScale() { return this->Pipeline.GetLengthScale() * this->MatrixScale; }
  void SetWorldLengthScale(double scale);
  ///@}

private:
  void Connect();
  void ShadeSurface(const StyleDocument& style);
  void SetScale(const PageScale& scale);

  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkMapper> OriginalMapper;
  vtkSmartPointer<vtkProperty> OriginalProperty;
  vtkSmartPointer<vtkTexture> OriginalTexture;
  vtkSmartPointer<vtkPolyDataMapper> SurfaceMapper;
  vtkSmartPointer<vtkAlgorithm> Source;                 // the surface of what is no vtkPolyData
  vtkSmartPointer<vtkPolyDataNormals> ShownNormals;     // of a textured surface that has none
  vtkSmartPointer<vtkAlgorithmOutput> Input;            // what the user's mapper shows
  vtkSmartPointer<vtkNPROutlineNormals> OutlineNormals; // for enlarged back faces
  bool CullsBackFaces = false;                          // as the user's property says
  bool IsTextured = false;                              // and so shown as it is, not refined
  SurfacePipeline Pipeline;
  std::vector<LineStrokes> AllStrokes;
  double MatrixScale = 1.0;
  double SampledPixel = 0.0;
};
}

#endif
