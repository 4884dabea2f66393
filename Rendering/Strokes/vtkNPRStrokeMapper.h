// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRStrokeMapper
 * @brief Draws lines as strokes of ink: antialiased, with a width, round joins and round caps.
 *
 * Put it on a vtkActor; colour and opacity are those of the actor's vtkProperty (lighting plays no
 * part). The lines and polylines of the input are drawn; other cells are not.
 *
 * Each pixel gets the share of its area that a stroke covers, so multisampling is not needed. All
 * strokes of the mapper are first drawn into a layer of their own that keeps the maximum, then laid
 * over the picture: where strokes cross or join, a translucent stroke is not darker.
 *
 * Whether a stroke is hidden by a surface is decided along its axis, and for its whole width
 * at once: the axis is visible unless it lies behind *all* of the surface within VisibilityRadius
 * by more than DepthTolerance. So lines on a surface and contours on its edge neither fight with
 * it nor break, however thick they are. A surface that is too near to be the stroke's own hides
 * it up to the surface's edge.
 *
 * The mapper's clipping planes, up to six, cut the axes of strokes; where they do, a stroke ends
 * with a round cap as at any other end.
 *
 * Strokes are drawn in the translucent phase, when all opaque surfaces are in the depth buffer, and
 * write no depth: translucent surfaces don't hide them. They have no part in hardware selection.
 * With depth peeling they are not drawn, with a warning; VTK's default order-independent
 * translucency is served.
 *
 * Point arrays that are used if present: `Width` (multiplies Width; unit: pixels where Width is 1),
 * `Strength` ([0, 1]).
 *
 * @par Thanks:
 * Coverage from the distance to a segment: E. Chan, F. Durand: Fast Prefiltered Lines, GPU Gems 2,
 * 2005. Visibility of a stroke by its spine: F. Cole, A. Finkelstein: Two Fast Methods for
 * High-Quality Line Visibility, 2010.
 *
 * @sa vtkNPRSplineStrokes
 */
#ifndef vtkNPRStrokeMapper_h
#define vtkNPRStrokeMapper_h

#include "vtkNPRRenderingStrokesModule.h"
#include <vtkPolyDataMapper.h>

#include "nprVTKCompat.h" // for VTK_ABI_NAMESPACE_BEGIN
#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

class VTKNPRRENDERINGSTROKES_EXPORT vtkNPRStrokeMapper : public vtkPolyDataMapper
{
public:
  static vtkNPRStrokeMapper* New();
  vtkTypeMacro(vtkNPRStrokeMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Width of strokes in pixels, [0, 1000]. A stroke thinner than a pixel is lighter, but unbroken.
   * Default: 2.
   */
  vtkSetClampMacro(Width, double, 0.0, 1000.0);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /** Whether the point array `Width` multiplies Width. Default: on. */
  vtkSetMacro(UseWidthArray, bool);
  vtkGetMacro(UseWidthArray, bool);
  vtkBooleanMacro(UseWidthArray, bool);
  ///@}

  ///@{
  /**
   * Whether the point array `Strength` scales the width, from MinimumWidthFactor at 0 to 1 at 1, so
   * that lines taper. Default: off.
   */
  vtkSetMacro(StrengthToWidth, bool);
  vtkGetMacro(StrengthToWidth, bool);
  vtkBooleanMacro(StrengthToWidth, bool);
  ///@}

  ///@{
  /** What remains of the width at strength 0, [0, 1]. Default: 0.25. */
  vtkSetClampMacro(MinimumWidthFactor, double, 0.0, 1.0);
  vtkGetMacro(MinimumWidthFactor, double);
  ///@}

  ///@{
  /** Whether the point array `Strength` multiplies the opacity. Default: off. */
  vtkSetMacro(StrengthToOpacity, bool);
  vtkGetMacro(StrengthToOpacity, bool);
  vtkBooleanMacro(StrengthToOpacity, bool);
  ///@}

  ///@{
  /** Whether surfaces hide strokes. Default: on. */
  vtkSetMacro(DepthTest, bool);
  vtkGetMacro(DepthTest, bool);
  vtkBooleanMacro(DepthTest, bool);
  ///@}

  ///@{
  /**
   * How far behind a surface a stroke is still visible, in sizes of a pixel there; not negative.
   * Default: 2.
   */
  vtkSetClampMacro(DepthTolerance, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(DepthTolerance, double);
  ///@}

  ///@{
  /**
   * Radius of the neighbourhood whose farthest surface decides, in pixels, 1 or more. A larger one
   * closes gaps of contours that lie on a coarse mesh; strokes also reach that far behind the edges
   * of their own surface. Default: 2.
   */
  vtkSetClampMacro(VisibilityRadius, double, 1.0, 100.0);
  vtkGetMacro(VisibilityRadius, double);
  ///@}

  ///@{
  /** Opacity of the hidden parts, relative to the visible ones, [0, 1]. Default: 0. */
  vtkSetClampMacro(HiddenOpacity, double, 0.0, 1.0);
  vtkGetMacro(HiddenOpacity, double);
  ///@}

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  bool HasOpaqueGeometry() override { return false; }
  bool HasTranslucentPolygonalGeometry() override { return true; }
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;

protected:
  vtkNPRStrokeMapper();
  ~vtkNPRStrokeMapper() override;

  double Width = 2.0;
  bool UseWidthArray = true;
  bool StrengthToWidth = false;
  double MinimumWidthFactor = 0.25;
  bool StrengthToOpacity = false;
  bool DepthTest = true;
  double DepthTolerance = 2.0;
  double VisibilityRadius = 2.0;
  double HiddenOpacity = 0.0;

private:
  vtkNPRStrokeMapper(const vtkNPRStrokeMapper&) = delete;
  void operator=(const vtkNPRStrokeMapper&) = delete;

  void DrawInk(vtkRenderer* renderer, vtkActor* actor, vtkShaderProgram* program);
  void SetUniforms(
    vtkRenderer* renderer, vtkActor* actor, vtkShaderProgram* program, const int viewport[4]);
  void SetClippingUniforms(vtkActor* actor, vtkShaderProgram* program);
  void LayInkOver(vtkOpenGLRenderWindow* window, vtkActor* actor, bool orderIndependent);

  class Graphics;
  std::unique_ptr<Graphics> Resources;
};

#endif
