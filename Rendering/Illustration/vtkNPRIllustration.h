// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRIllustration
 * @brief Draws what a renderer shows as an illustration.
 *
 * Give it a renderer with actors and a style; Apply() prepares the actors' surfaces, puts the
 * style's shading, lights and paper on the renderer, and adds one actor of strokes for each kind
 * of line and actor. From then on Render() alone keeps everything current: lines follow the
 * camera, the actors' matrices, their visibility and their data. Which details are drawn, and how
 * finely a coarse mesh is refined, is settled by Apply() for the view as it is then.
 *
 * @code
 * vtkNew<vtkNPRIllustrationStyle> style;
 * style->LoadBuiltIn("technical");
 * vtkNew<vtkNPRIllustration> illustration;
 * illustration->SetRenderer(renderer);
 * illustration->SetStyle(style);
 * illustration->Apply();
 * window->Render();
 * @endcode
 *
 * Actors are shown through a mapper of ours while the illustration is on; Remove() gives back their
 * own mappers and properties and the renderer's pass, lights and background. A renderer has one
 * illustration: Apply() removes another that is on it. An actor that is added later is illustrated
 * by the next Apply(). Actors with wireframe or point representation, without surface, parts of
 * assemblies and other props are left as they are; of an illustrated actor only the surface is
 * shown. Depth peeling is off meanwhile.
 *
 * Invokes vtkCommand::ProgressEvent with the progress of its filters.
 *
 * @sa vtkNPRIllustrationStyle, vtkNPRViewpoint, vtkNPRFeatureLines, vtkNPRShadingPass
 */
#ifndef vtkNPRIllustration_h
#define vtkNPRIllustration_h

#include "vtkNPRRenderingIllustrationModule.h"
#include <vtkObject.h>
#include <vtkSmartPointer.h> // for the renderer and the style

#include <memory> // for what is put on the renderer
#include <string> // for names of stages

class vtkNPRIllustrationStyle;
class vtkPolyData;
class vtkRenderer;

class VTKNPRRENDERINGILLUSTRATION_EXPORT vtkNPRIllustration : public vtkObject
{
public:
  static vtkNPRIllustration* New();
  vtkTypeMacro(vtkNPRIllustration, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// @name The renderer to illustrate
  /// Setting another one removes the illustration from the last.
  ///@{
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer() const;
  ///@}

  /// @name The style; default: the built-in "technical"
  /// A change of it shows after the next Apply().
  ///@{
  void SetStyle(vtkNPRIllustrationStyle* style);
  vtkNPRIllustrationStyle* GetStyle() const;
  ///@}

  enum StrokeVisibilityType
  {
    DEPTH_BUFFER = 0, ///< by the picture's depth buffer: fast, but lines may break
    EXACT = 1         ///< by the surfaces themselves, as for a drawing on paper: lines stay whole
  };

  /**
   * @name How it is found which strokes surfaces hide
   *
   * EXACT cuts the lines with vtkNPRStrokeVisibility before they become strokes: strokes end where
   * a surface covers them, never within themselves. It costs time for each new view, more for the
   * first one and when surfaces move. While an interactor moves something (the window's
   * DesiredUpdateRate is one frame a second or more) the depth buffer serves.
   *
   * In both cases strokes are hidden by all opaque actors of the renderer that are shown as
   * surfaces, illustrated or not; translucent ones hide nothing. Points, wires and what is no
   * vtkActor hide strokes with DEPTH_BUFFER only.
   *
   * A change shows in the next render. Default: EXACT; in builds without Embree DEPTH_BUFFER, and
   * EXACT is an error.
   */
  ///@{
  void SetStrokeVisibility(int visibility);
  int GetStrokeVisibility() const { return this->StrokeVisibility; }
  void SetStrokeVisibilityToDepthBuffer() { this->SetStrokeVisibility(DEPTH_BUFFER); }
  void SetStrokeVisibilityToExact() { this->SetStrokeVisibility(EXACT); }
  ///@}

  /// Put the illustration on the renderer, in place of what an earlier call put there. The camera
  /// and the size of the window should be set by then: the size of a pixel decides which details
  /// are drawn. Returns false, with an error, without a renderer.
  bool Apply();

  /// Give back the renderer and its actors as they were.
  void Remove();

  /// The lines of all actors for the camera as it stands, as chained polylines in the world, before
  /// the style's minimum length and splines; see vtkNPRFeatureLines for their arrays. Returns
  /// false, with an error, before Apply().
  bool GetLines(vtkPolyData* lines);

  /**
   * The strokes that draw the lines of all actors for the camera as it stands, in the world, for a
   * drawing on paper: long enough, smooth and shaped as the style says, and cut where surfaces hide
   * them. Cell arrays HidingLayers (0 where they are visible; see vtkNPRStrokeVisibility) and
   * LineType, by the names in the field data LineTypeNames, for which
   * vtkNPRIllustrationStyle::GetDrawingStyle() gives the looks; point arrays Strength, and Width
   * and Opacity where the style needs them. More hiding layers than `maximumLayers` are not
   * counted. Hidden and visible pieces that are shorter than 0.005 of the image's shorter side are
   * put together with their neighbours. Returns false, with an error, before Apply() and in builds
   * without Embree. No window has to be rendered, but it must have its size. Clipping planes of
   * mappers, which cut what is shown on screen, cut nothing here.
   */
  bool GetStrokes(vtkPolyData* strokes, int maximumLayers = 1);

  /// How many types of lines the style draws; 0 before Apply().
  int GetNumberOfLineTypes() const;

  /// Whether lines of a LineType (see GetLines()) are drawn from the next render on. Nothing is
  /// prepared anew; Apply() shows all again.
  void SetLineVisibility(int lineType, bool visible);

  /// Seconds spent so far in "prepare", "curvature" or "lines", by the filters of the
  /// illustration that is on the renderer, and in "visibility" and "strokes" where StrokeVisibility
  /// is EXACT and by GetStrokes(); 0 for other names.
  double GetStageSeconds(const std::string& stage) const;

protected:
  vtkNPRIllustration();
  ~vtkNPRIllustration() override;

private:
  vtkNPRIllustration(const vtkNPRIllustration&) = delete;
  void operator=(const vtkNPRIllustration&) = delete;

  /// Whether this build can find what surfaces hide; else an error has been said.
  bool CheckEmbree();

  class Internals;
  std::unique_ptr<Internals> Internal;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkNPRIllustrationStyle> Style;
  int StrokeVisibility;
};

#endif
