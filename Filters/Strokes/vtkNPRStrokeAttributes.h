// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRStrokeAttributes
 * @brief Says how strokes look, in arrays: their width and opacity at each point; and lets their
 * lines overshoot and wobble.
 *
 * The point arrays `Width` and `Opacity` (float; factors, which vtkNPRStrokeMapper multiplies its
 * own width and opacity by) are products: of a constant, of any number of terms, and of a taper
 * towards the ends. Where the input has arrays of these names, they are factors, too, so that
 * filters can follow each other.
 *
 * A term is a ramp over a point array: below one value of it the factor is one number, above
 * another value another, and between them it changes evenly or smoothly. So any array serves:
 *
 * - `ViewDistance` (length in the world): nearer is wider;
 * - `Strength` ([0, 1]);
 * - curvatures of the surface, or whatever else there is on the points;
 * - `CurveCurvature`, which this filter makes when a term asks for it: how much the curve itself
 *   bends, so that strokes are thicker where they do (Saito et al.). It is taken from the circle
 *   through three points of the curve that are Reach apart, on the average over as far to both
 *   sides, times the unit of lengths (of MODEL: times the field data LengthScale, else the
 *   diagonal of the bounds), and so has no dimension;
 * - `Shade`, which this filter makes from the array `Normals` and LightDirection when a term asks
 *   for it: the cosine of the angle between both, averaged in the same way, so that strokes are
 *   thicker away from the light;
 * - `IsophoteDistance` (heights of the view; needs the unit VIEW), which this filter makes from the
 *   arrays `Normals` and `kr` (the radial curvature; see vtkNPRFeatureLines::AddQuantity()) when a
 *   term asks for it: how far from a contour the surface is darker than IsophoteLevel, averaged in
 *   the same way, so that strokes are as thick as the shade that they stand for (Goodwin et al.).
 *   A ramp from 0 to that many heights keeps it within bounds.
 *
 * Lengths (of tapers, overshoots, waves) are in the unit of LengthUnit: shares of each stroke's own
 * length, units of the model, or heights of the view, for which the filter needs a camera. Then
 * everything is measured as it is on the page, and the camera's changes count as the filter's own.
 *
 * A stroke whose first and last points are at one place is closed: it neither tapers nor
 * overshoots, and wobbles without a seam. Where strokes have been cut by their visibility (cell
 * array `HidingLayers`), an end at the place of an end of another part with another number of
 * layers is no end of the stroke and does neither, too. Averages go on over such ends, where the
 * parts of a stroke come one after the other, as vtkNPRStrokeVisibility gives them. As the parts
 * that have been dropped are not known, let this filter come before the one that cuts, if you can.
 *
 * Points are added where the input's are too far apart for a taper or a wave. Numeric point arrays
 * are interpolated, cell arrays copied; field data is passed. The point array `ArcLength` (unit:
 * length) goes on from the input's value at the first point of a stroke, or from 0. As in
 * vtkNPRSplineStrokes, repeated points count once, and points that are not finite split a line.
 *
 * The result does not depend on the number of threads.
 *
 * @par Thanks:
 * Width by the bends of the curve and by the distance from its ends: S. Saito, A. Kani, Y. Chang,
 * M. Nakajima: Curvature-based stroke rendering, The Visual Computer 24, 2008. Width by the light:
 * T. Goodwin, I. Vollick, A. Hertzmann: Isophote Distance: A Shading Approach to Artistic Stroke
 * Thickness, NPAR 2007.
 *
 * @sa vtkNPRSplineStrokes vtkNPRStrokeMapper
 */
#ifndef vtkNPRStrokeAttributes_h
#define vtkNPRStrokeAttributes_h

#include "vtkNPRFiltersStrokesModule.h"
#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h> // for the camera

#include "nprVTKCompat.h" // for VTK_ABI_NAMESPACE_BEGIN
#include <string>         // for names of arrays
#include <vector>         // for terms

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkMatrix4x4;
VTK_ABI_NAMESPACE_END

class VTKNPRFILTERSSTROKES_EXPORT vtkNPRStrokeAttributes : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRStrokeAttributes* New();
  vtkTypeMacro(vtkNPRStrokeAttributes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What a term is a factor of. */
  enum Attributes
  {
    WIDTH = 0,
    OPACITY = 1
  };

  /** How a term goes from its first factor to its second. */
  enum Shapes
  {
    LINEAR = 0,
    SMOOTH = 1
  };

  /** What lengths are measured in: shares of the stroke, units of the model, or heights of the
   * view. */
  enum LengthUnits
  {
    STROKE = 0,
    MODEL = 1,
    VIEW = 2
  };

  ///@{
  /** A factor of all widths, [0, 1000]. Default: 1. */
  vtkSetClampMacro(ConstantWidth, double, 0.0, 1000.0);
  vtkGetMacro(ConstantWidth, double);
  ///@}

  ///@{
  /** A factor of all opacities, [0, 1]. Default: 1. */
  vtkSetClampMacro(ConstantOpacity, double, 0.0, 1.0);
  vtkGetMacro(ConstantOpacity, double);
  ///@}

  /** @name Terms
   * A ramp over a point array; of several components the magnitude counts.
   */
  ///@{
  /**
   * Adds a term: a factor of WIDTH or OPACITY by a point array (or `CurveCurvature`). It goes from
   * 0 to 1, evenly, over the range that the array has in the data, until told otherwise. Returns
   * its number.
   */
  int AddTerm(int attribute, const char* array);
  /**
   * The values of the array, in its unit, between which the factor changes; `from` may be the
   * larger. Values that are not finite count as `from`. Two equal values stand for the range of the
   * finite values in the data.
   */
  void SetTermRange(int term, double from, double to);
  /** The factors at both, 0 or more; of opacity, up to 1. */
  void SetTermFactors(int term, double atFrom, double atTo);
  /** LINEAR or SMOOTH (3x^2 - 2x^3). */
  void SetTermShape(int term, int shape);
  /**
   * Whether the factor is averaged along the stroke, over Reach to both sides, as `Shade` is: for
   * arrays with noise, such as the curvature of a scan. Default: off.
   */
  void SetTermAverage(int term, bool average);
  int GetNumberOfTerms() const { return static_cast<int>(this->Terms.size()); }
  void RemoveAllTerms();
  ///@}

  ///@{
  /** The unit of the lengths below. VIEW needs a camera. Default: STROKE. */
  vtkSetClampMacro(LengthUnit, int, STROKE, VIEW);
  vtkGetMacro(LengthUnit, int);
  void SetLengthUnitToStroke() { this->SetLengthUnit(STROKE); }
  void SetLengthUnitToModel() { this->SetLengthUnit(MODEL); }
  void SetLengthUnitToView() { this->SetLengthUnit(VIEW); }
  ///@}

  ///@{
  /** For the unit VIEW: from where strokes are seen. Default: none. */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera() const;
  ///@}

  ///@{
  /** For the unit VIEW: from the strokes to the world, as vtkProp3D::GetMatrix(). Default: none. */
  void SetMatrix(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetMatrix() const;
  ///@}

  ///@{
  /**
   * From how far along the stroke to both sides `CurveCurvature`, `Shade` and `IsophoteDistance`
   * are taken, in the unit of LengthUnit: what is smaller is no bend and no shade. Default: 0.02.
   */
  vtkSetClampMacro(Reach, double, 1e-6, VTK_FLOAT_MAX);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /**
   * Towards the light, for `Shade` and `IsophoteDistance`; in the model, or with the unit VIEW as
   * the viewer sees it: to his right, upwards, towards him. Not zero. Default: (-0.5, 0.7, 0.5).
   */
  vtkSetVector3Macro(LightDirection, double);
  vtkGetVector3Macro(LightDirection, double);
  ///@}

  ///@{
  /**
   * For `IsophoteDistance`: the cosine of the angle between normal and light up to which a surface
   * is dark, [-1, 1]. Default: -0.5.
   */
  vtkSetClampMacro(IsophoteLevel, double, -1.0, 1.0);
  vtkGetMacro(IsophoteLevel, double);
  ///@}

  ///@{
  /**
   * How far from a true end a stroke tapers, in the unit of LengthUnit; at most half of the stroke.
   * At the share x of this length the factor is x (2 - x) of the way from that at the end to 1.
   * Default: 0, not at all.
   */
  vtkSetClampMacro(TaperLength, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(TaperLength, double);
  ///@}

  ///@{
  /** The factor of the width at a tapered end, [0, 1]. Default: 0. */
  vtkSetClampMacro(TaperedWidth, double, 0.0, 1.0);
  vtkGetMacro(TaperedWidth, double);
  ///@}

  ///@{
  /** The factor of the opacity at a tapered end, [0, 1]. Default: 1. */
  vtkSetClampMacro(TaperedOpacity, double, 0.0, 1.0);
  vtkGetMacro(TaperedOpacity, double);
  ///@}

  ///@{
  /**
   * The most that Width may be for each unit of LengthUnit that a stroke is large, so that small
   * holes are not filled with ink. A loop is four times its area by its length large, as a circle
   * is by its diameter; another stroke as a half circle of its length. Those that are too wide are
   * made narrower as a whole, though never to less than a quarter. Default: 0, no limit.
   */
  vtkSetClampMacro(WidthPerSize, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(WidthPerSize, double);
  ///@}

  ///@{
  /** How far strokes go on, straight, beyond their true ends; in the unit of LengthUnit.
   * Default: 0. */
  vtkSetClampMacro(OvershootLength, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(OvershootLength, double);
  ///@}

  ///@{
  /**
   * How far the line strays from its place at most, in each direction, in the unit of LengthUnit.
   * Default: 0, not at all.
   */
  vtkSetClampMacro(WobbleAmplitude, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(WobbleAmplitude, double);
  ///@}

  ///@{
  /** The length of the waves, in the unit of LengthUnit, 1e-4 or more. Default: 0.1. */
  vtkSetClampMacro(WobbleWavelength, double, 1e-4, VTK_FLOAT_MAX);
  vtkGetMacro(WobbleWavelength, double);
  ///@}

  ///@{
  /**
   * Another seed, other waves. Each stroke has its own: by the cell array `ChainId`, if it is
   * there, so that they stay while the camera moves, else by its number. Default: 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkNPRStrokeAttributes();
  ~vtkNPRStrokeAttributes() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double ConstantWidth = 1.0;
  double ConstantOpacity = 1.0;
  int LengthUnit = STROKE;
  double Reach = 0.02;
  double LightDirection[3] = { -0.5, 0.7, 0.5 };
  double IsophoteLevel = -0.5;
  double TaperLength = 0.0;
  double TaperedWidth = 0.0;
  double TaperedOpacity = 1.0;
  double WidthPerSize = 0.0;
  double OvershootLength = 0.0;
  double WobbleAmplitude = 0.0;
  double WobbleWavelength = 0.1;
  int Seed = 0;

private:
  vtkNPRStrokeAttributes(const vtkNPRStrokeAttributes&) = delete;
  void operator=(const vtkNPRStrokeAttributes&) = delete;

  struct Term
  {
    int Attribute = WIDTH;
    std::string Array;
    double From = 0.0;
    double To = 0.0;
    double AtFrom = 0.0;
    double AtTo = 1.0;
    int Shape = LINEAR;
    bool Average = false;
  };
  Term* FindTerm(int term);
  bool Uses(const char* array) const;
  bool MultiplyTerm(const Term& term, vtkPolyData* output, float* factors);

  std::vector<Term> Terms;
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkMatrix4x4> Matrix;
};

#endif
