// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRStrokeMapper
 * @brief Draws lines as strokes of ink, pencil, charcoal or brush: antialiased, with a width,
 * joins, caps and dashes.
 *
 * Put it on a vtkActor; colour and opacity are those of the actor's vtkProperty (lighting plays no
 * part). With ScalarVisibility, which is off here by default, colours are those of scalars of
 * points or cells, as for any vtkMapper; where strokes of several colours cross, that of the most
 * ink stays. The lines and polylines of the input are drawn; other cells are not.
 *
 * Each pixel gets the share of its area that a stroke covers, so multisampling is not needed. All
 * strokes of the mapper are first drawn into a layer of their own that keeps the maximum, then laid
 * over the picture: where strokes cross or join, a translucent stroke is not darker.
 *
 * Points without which the picture is the same to a sixteenth of a pixel are not drawn, as near as
 * the camera is. They are sorted out when the input changes, then for that view alone, and when it
 * is seen from elsewhere or nearer, then for all directions. In windows that ask for one frame a
 * second or more (vtkRenderWindow::DesiredUpdateRate), as interactors do while something moves,
 * input that changes may be three times as far off.
 *
 * Whether a stroke is hidden by a surface is decided along its axis, for pieces of two pixels and
 * for the whole width at once: the axis is visible unless it lies behind *all* of the surface
 * within VisibilityRadius by more than DepthTolerance. So lines on a surface and contours on its
 * edge neither fight with it nor break, however thick they are. A surface that is too near to be
 * the stroke's own hides it up to the surface's edge.
 *
 * The mapper's clipping planes, up to six, cut the axes of strokes; where they do, a stroke ends
 * with a round cap as at any other end.
 *
 * Strokes are drawn in the translucent phase, when all opaque surfaces are in the depth buffer, and
 * write no depth: translucent surfaces don't hide them. With depth peeling they are laid over the
 * picture at the renderer's end instead, also over its volumes and annotations; opaque surfaces
 * hide them as ever, translucent ones still don't.
 *
 * vtkHardwareSelector and what is built on it (vtkPropPicker, vtkScenePicker) find actors and
 * cells, not points, where strokes are drawn: as wide as they are drawn, and not where they are
 * hidden or in the gaps between dashes. In selections, VTK takes translucent surfaces for opaque
 * ones, which hide strokes. vtkCellPicker finds lines within its tolerance, as for any mapper,
 * whatever their width.
 *
 * Point arrays that are used if present: `Width` and `Opacity` (factors), `Strength` ([0, 1]),
 * `ArcLength` (unit: length; measured if it is not there). Cell array: `HidingLayers`.
 *
 * Joins, caps, dashes and media other than round, none and ink need to know how long strokes are in
 * the picture, which is measured on the CPU for each frame.
 *
 * With a SplineType, strokes are curves over the points of the lines, evaluated on the GPU when the
 * input changes or the camera comes nearer. Those whose length must be known are evaluated on the
 * CPU. Cells that are picked are those of the input.
 *
 * Media are procedural, without any bitmap. What belongs to the stroke (bristles, the pressure of
 * the hand) goes with it; the tooth of the paper stays where it is on the page, also in pictures
 * that are rendered in tiles.
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
#include <vtkTimeStamp.h>

#include "nprVTKCompat.h" // for VTK_ABI_NAMESPACE_BEGIN
#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

#ifndef __VTK_WRAP__
namespace npr
{
class StrokeGraphics;
struct CurveSettings;
struct InkArea;
struct StrokeTolerance;
struct PostponedStrokes;
}
#endif

class VTKNPRRENDERINGSTROKES_EXPORT vtkNPRStrokeMapper : public vtkPolyDataMapper
{
public:
  static vtkNPRStrokeMapper* New();
  vtkTypeMacro(vtkNPRStrokeMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Width of strokes in WidthUnit, not negative. A stroke thinner than a pixel is lighter, but
   * unbroken. Default: 2.
   */
  vtkSetClampMacro(Width, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(Width, double);
  ///@}

  /** Units of Width and Dashes: pixels, or units of the world. */
  enum Units
  {
    PIXELS = 0,
    WORLD = 1
  };

  ///@{
  /** The unit of Width. With perspective, strokes as wide in the world get thinner with the
   * distance. Default: PIXELS. */
  vtkSetClampMacro(WidthUnit, int, PIXELS, WORLD);
  vtkGetMacro(WidthUnit, int);
  void SetWidthUnitToPixels() { this->SetWidthUnit(PIXELS); }
  void SetWidthUnitToWorld() { this->SetWidthUnit(WORLD); }
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
  /** Whether the point array `Opacity` multiplies the opacity. Default: on. */
  vtkSetMacro(UseOpacityArray, bool);
  vtkGetMacro(UseOpacityArray, bool);
  vtkBooleanMacro(UseOpacityArray, bool);
  ///@}

  /** How strokes and dashes end. */
  enum Caps
  {
    ROUND_CAP = 0, ///< with half a disc
    BUTT_CAP = 1   ///< straight, at the end itself
  };

  ///@{
  /** How strokes and their dashes end. Default: round. */
  vtkSetClampMacro(Cap, int, ROUND_CAP, BUTT_CAP);
  vtkGetMacro(Cap, int);
  void SetCapToRound() { this->SetCap(ROUND_CAP); }
  void SetCapToButt() { this->SetCap(BUTT_CAP); }
  ///@}

  /** What corners of strokes look like outside. */
  enum Joins
  {
    ROUND_JOIN = 0,
    BEVEL_JOIN = 1,
    MITRE_JOIN = 2
  };

  ///@{
  /** What corners look like; turns of less than 18 degrees are none. Default: round. */
  vtkSetClampMacro(Join, int, ROUND_JOIN, MITRE_JOIN);
  vtkGetMacro(Join, int);
  void SetJoinToRound() { this->SetJoin(ROUND_JOIN); }
  void SetJoinToBevel() { this->SetJoin(BEVEL_JOIN); }
  void SetJoinToMitre() { this->SetJoin(MITRE_JOIN); }
  ///@}

  ///@{
  /** A mitre that would be longer than this, in widths from the inner to the outer corner, [1,
   * 100], is a bevel. Default: 4, as in SVG. */
  vtkSetClampMacro(MitreLimit, double, 1.0, 100.0);
  vtkGetMacro(MitreLimit, double);
  ///@}

  ///@{
  /** Lengths of dashes and of the gaps between them, in DashUnit, along the stroke from its start;
   * round caps go into the gaps. No gaps: not dashed. Default: (0, 0). */
  vtkSetVector2Macro(Dashes, double);
  vtkGetVector2Macro(Dashes, double);
  ///@}

  ///@{
  /** The same for hidden parts, which HiddenOpacity shows. Default: (0, 0). */
  vtkSetVector2Macro(HiddenDashes, double);
  vtkGetVector2Macro(HiddenDashes, double);
  ///@}

  ///@{
  /** The unit of dashes: PIXELS in the picture, or WORLD, along the array `ArcLength`. Default:
   * PIXELS. */
  vtkSetClampMacro(DashUnit, int, PIXELS, WORLD);
  vtkGetMacro(DashUnit, int);
  void SetDashUnitToPixels() { this->SetDashUnit(PIXELS); }
  void SetDashUnitToWorld() { this->SetDashUnit(WORLD); }
  ///@}

  /** What strokes are drawn with. */
  enum Media
  {
    INK = 0,      ///< even
    PENCIL = 1,   ///< pressed unevenly, less at its edges
    CHARCOAL = 2, ///< the same, crumbling at its edges
    BRUSH = 3     ///< full, with gaps between the bristles where it runs dry
  };

  ///@{
  /** What strokes are drawn with. Default: INK. */
  vtkSetClampMacro(Medium, int, INK, BRUSH);
  vtkGetMacro(Medium, int);
  void SetMediumToInk() { this->SetMedium(INK); }
  void SetMediumToPencil() { this->SetMedium(PENCIL); }
  void SetMediumToCharcoal() { this->SetMedium(CHARCOAL); }
  void SetMediumToBrush() { this->SetMedium(BRUSH); }
  ///@}

  ///@{
  /** How much the tooth of the paper shows, [0, 1]: at 1 the medium takes only to as many heights
   * of it as it is pressed hard and opaque, at 0 it is as translucent instead. Default: 0. */
  vtkSetClampMacro(PaperGrain, double, 0.0, 1.0);
  vtkGetMacro(PaperGrain, double);
  ///@}

  ///@{
  /** Distance of the heights of the paper, which the medium's own texture goes by, too. Pixels,
   * [0.1, 1000]. Default: 3. */
  vtkSetClampMacro(GrainSize, double, 0.1, 1000.0);
  vtkGetMacro(GrainSize, double);
  ///@}

  ///@{
  /** Another seed, other irregularities of the medium. Default: 0. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /** Whether strokes are hidden where the cell array `HidingLayers` is not 0. Switch DepthTest off
   * where that is all that is to hide them. Default: off. */
  vtkSetMacro(UseHidingLayers, bool);
  vtkGetMacro(UseHidingLayers, bool);
  vtkBooleanMacro(UseHidingLayers, bool);
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

  /** Values of SplineType, as in vtkNPRSplineStrokes. */
  enum SplineTypes
  {
    NONE = 0,
    CATMULL_ROM = 1,
    B_SPLINE = 2
  };

  ///@{
  /** What lines become: with NONE they are drawn as they are; else their points are control points
   * of the curves that vtkNPRSplineStrokes makes with its Tension's default. Default: NONE. */
  vtkSetClampMacro(SplineType, int, NONE, B_SPLINE);
  vtkGetMacro(SplineType, int);
  void SetSplineTypeToNone() { this->SetSplineType(NONE); }
  void SetSplineTypeToCatmullRom() { this->SetSplineType(CATMULL_ROM); }
  void SetSplineTypeToBSpline() { this->SetSplineType(B_SPLINE); }
  ///@}

  ///@{
  /** How far from its spline a curve may be drawn, and half as much again before the camera has
   * come so near that parts are chosen anew. Pixels, [0.001, 100]. Default: 0.1. */
  vtkSetClampMacro(SplineChordError, double, 0.001, 100.0);
  vtkGetMacro(SplineChordError, double);
  ///@}

  ///@{
  /** Where lines turn by more than this, curves have corners. Degrees, [0, 180]; 180: none.
   * Default: 60. */
  vtkSetClampMacro(SplineCornerAngle, double, 0.0, 180.0);
  vtkGetMacro(SplineCornerAngle, double);
  ///@}

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  bool HasOpaqueGeometry() override { return false; }
  bool HasTranslucentPolygonalGeometry() override { return true; }
  bool GetSupportsSelection() override { return true; }
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;

protected:
  vtkNPRStrokeMapper();
  ~vtkNPRStrokeMapper() override;

  double Width = 2.0;
  int WidthUnit = PIXELS;
  bool UseWidthArray = true;
  bool StrengthToWidth = false;
  double MinimumWidthFactor = 0.25;
  bool StrengthToOpacity = false;
  bool UseOpacityArray = true;
  int Cap = ROUND_CAP;
  int Join = ROUND_JOIN;
  double MitreLimit = 4.0;
  double Dashes[2] = { 0.0, 0.0 };
  double HiddenDashes[2] = { 0.0, 0.0 };
  int DashUnit = PIXELS;
  int Medium = INK;
  double PaperGrain = 0.0;
  double GrainSize = 3.0;
  int Seed = 0;
  bool UseHidingLayers = false;
  bool DepthTest = true;
  double DepthTolerance = 2.0;
  double VisibilityRadius = 2.0;
  double HiddenOpacity = 0.0;
  int SplineType = NONE;
  double SplineChordError = 0.1;
  double SplineCornerAngle = 60.0;

  void ComputeBounds() override;

private:
  vtkNPRStrokeMapper(const vtkNPRStrokeMapper&) = delete;
  void operator=(const vtkNPRStrokeMapper&) = delete;

  bool IsStyled() const;
  bool AreColorsOfCells();
  npr::StrokeTolerance GetTolerance(vtkRenderer* renderer, vtkActor* actor);
  npr::CurveSettings GetCurves() const;
  double GetMaximumError() const;
  vtkShaderProgram* ReadyProgram(const std::string& purpose);
  void DrawStrokes(vtkRenderer* renderer, vtkActor* actor, bool orderIndependent);
  // Return what is drawn to.
  npr::InkArea DrawInk(vtkRenderer* renderer, vtkActor* actor, vtkShaderProgram* program);
  npr::InkArea SetUniforms(
    vtkRenderer* renderer, vtkActor* actor, vtkShaderProgram* program, const int viewport[4]);
  void SetStyleUniforms(vtkActor* actor, vtkShaderProgram* program, const int viewport[4]);
  void SetClippingUniforms(vtkActor* actor, vtkShaderProgram* program);
  void LayInkOver(vtkActor* actor, const npr::InkArea& area, bool orderIndependent);
  void Postpone(vtkRenderer* renderer, vtkActor* actor);
  void DrawPostponed();
  void DrawForSelection(vtkRenderer* renderer, vtkActor* actor);

  double Overshoot = 0.0; // of the curves beyond the bounds of the input
  vtkTimeStamp OvershootTime;
  std::unique_ptr<npr::StrokeGraphics> Graphics;
  std::unique_ptr<npr::PostponedStrokes> Postponed;
};

#endif
