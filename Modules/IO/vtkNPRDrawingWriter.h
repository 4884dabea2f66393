// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRDrawingWriter
 * @brief Puts strokes on a page and writes them: what writers of vector drawings have in common.
 *
 * The input is vtkPolyData whose lines are strokes in the world, as from vtkNPRFeatureLines or
 * vtkNPRSplineStrokes. A camera and the size of its viewport give the picture, which is put on a
 * page and cut at its margins and at the camera's near plane.
 *
 * Arrays that are used if present:
 *
 * - `LineType` (cells): the place of a line's type in `LineTypeNames` (field data), which has its
 *   look in the style and a layer by its name;
 * - `HidingLayers` (cells): lines with other values than 0 are hidden;
 * - `Strength` (points): tapers lines whose style says so;
 * - `Width` (points): factors of the style's width.
 *
 * Each line type has a layer of its visible and one of its hidden lines. Strokes are cubic curves
 * with corners where the lines have them (see CornerAngle); they pass all points within Tolerance.
 * What is too straight to have been meant for a curve stays straight. Strokes of one width are
 * lines in the file, others are outlines, filled.
 *
 * Chains are cut at points that are not finite. Strokes of one point or no width are not drawn.
 *
 * The same input gives the same bytes, for any number of threads: no date is written unless one is
 * set.
 *
 * Errors set an error code: vtkErrorCode::NoFileNameError, CannotOpenFileError,
 * OutOfDiskSpaceError, and UserError for a page, camera or array that can't be used.
 *
 * @sa vtkNPRSVGWriter, vtkNPRPDFWriter, vtkNPRDrawingStyle
 */
#ifndef vtkNPRDrawingWriter_h
#define vtkNPRDrawingWriter_h

#include "vtkNPRIOModule.h"
#include <vtkSmartPointer.h>
#include <vtkWriter.h>

#include <string>

class vtkCamera;
class vtkImageData;
class vtkNPRDrawingStyle;

namespace npr
{
struct PageDrawing;
struct PageRequest;
}

class VTKNPRIO_EXPORT vtkNPRDrawingWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkNPRDrawingWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the file. Default: null. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** The camera of the picture. Default: null. */
  virtual void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera() const;
  ///@}

  ///@{
  /** Size of the camera's viewport in pixels, 1 or more each. Default: 0, 0. */
  vtkSetVector2Macro(ViewportSize, int);
  vtkGetVector2Macro(ViewportSize, int);
  ///@}

  ///@{
  /** The style. Default: one with vtkNPRDrawingStyle's defaults. */
  virtual void SetStyle(vtkNPRDrawingStyle* style);
  vtkNPRDrawingStyle* GetStyle() const;
  ///@}

  /**
   * Values of Paper. VIEWPORT_PAPER is as large as the viewport at 96 pixels to an inch, and has no
   * margins; CUSTOM_PAPER is as large as SetPageSize() said.
   */
  enum Papers
  {
    VIEWPORT_PAPER,
    A4_PAPER,
    A3_PAPER,
    LETTER_PAPER,
    CUSTOM_PAPER
  };
  ///@{
  /** Which paper. Default: A4_PAPER. */
  vtkSetClampMacro(Paper, int, VIEWPORT_PAPER, CUSTOM_PAPER);
  vtkGetMacro(Paper, int);
  ///@}

  /** Values of Orientation; AUTOMATIC_ORIENTATION is the viewport's. */
  enum Orientations
  {
    AUTOMATIC_ORIENTATION,
    PORTRAIT,
    LANDSCAPE
  };
  ///@{
  /** Which way A4, A3 and Letter are turned. Default: AUTOMATIC_ORIENTATION. */
  vtkSetClampMacro(Orientation, int, AUTOMATIC_ORIENTATION, LANDSCAPE);
  vtkGetMacro(Orientation, int);
  ///@}

  /** Take a page of this size in millimetres: CUSTOM_PAPER. */
  void SetPageSize(double width, double height);
  /** Size of the page in millimetres, as the settings are now. */
  void GetPageSize(double size[2]) const;

  /**
   * The shorter side of the picture in millimetres, as the settings are now: what styles that know
   * no paper measure their lines by. The viewport's for FIT_VIEWPORT, else that of the room within
   * the margins. 0 for pages without room.
   */
  double GetShorterSide() const;

  ///@{
  /** Width of the margins in millimetres, not negative. Default: 10. */
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  /**
   * Values of Fit. FIT_VIEWPORT puts the whole viewport within the margins and draws what it shows;
   * FIT_STROKES does so with the strokes, also those outside of the viewport; TRUE_SCALE puts
   * their middle in the page's and draws as Scale and MillimetresPerUnit say, which needs a
   * parallel projection.
   */
  enum Fits
  {
    FIT_VIEWPORT,
    FIT_STROKES,
    TRUE_SCALE
  };
  ///@{
  /** How the picture is put on the page. Default: FIT_VIEWPORT. */
  vtkSetClampMacro(Fit, int, FIT_VIEWPORT, TRUE_SCALE);
  vtkGetMacro(Fit, int);
  ///@}

  ///@{
  /** How long a unit of the world is in millimetres, for TRUE_SCALE; positive. Default: 1. */
  vtkSetMacro(MillimetresPerUnit, double);
  vtkGetMacro(MillimetresPerUnit, double);
  ///@}

  ///@{
  /** Lengths on paper to lengths in the world, for TRUE_SCALE; positive: 0.5 is 1:2. Default: 1. */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /** Whether to draw a scale bar; it needs a parallel projection. Default: off. */
  vtkSetMacro(ScaleBar, bool);
  vtkGetMacro(ScaleBar, bool);
  vtkBooleanMacro(ScaleBar, bool);
  ///@}

  ///@{
  /** The name of a unit of the world, for the scale bar, such as "mm". Default: empty. */
  vtkSetMacro(UnitName, std::string);
  vtkGetMacro(UnitName, std::string);
  ///@}

  /** Values of HiddenLines. */
  enum HiddenLinesModes
  {
    HIDDEN_LINES_NONE,
    HIDDEN_LINES_DASHED,
    HIDDEN_LINES_SHOWN
  };
  ///@{
  /**
   * How to draw hidden lines: not, with the style's dashes, or solid. Default: none. What of them
   * runs along a visible line, or a hidden one that is drawn already, so near that they would
   * touch, is left out.
   */
  vtkSetClampMacro(HiddenLines, int, HIDDEN_LINES_NONE, HIDDEN_LINES_SHOWN);
  vtkGetMacro(HiddenLines, int);
  ///@}

  ///@{
  /** How far curves may pass from points, in millimetres; positive. Default: 0.02. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** A stroke that turns by more than this on the page has a corner. Degrees, [0, 180].
   * Default: 45. */
  vtkSetClampMacro(CornerAngle, double, 0.0, 180.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /**
   * A picture of the whole viewport, such as its shading, to lie below the strokes: unsigned chars
   * of 1 to 4 components. Default: null.
   */
  virtual void SetImage(vtkImageData* image);
  vtkImageData* GetImage() const;
  ///@}

  ///@{
  /**
   * A picture of the whole viewport in flat tones, such as toon shading without lines, to lie below
   * the strokes as filled areas with smooth borders. It may have more pixels than the viewport:
   * twice as many each way make good borders. Unsigned chars of 1 to 4 components, where an even
   * number has an opacity last; nothing is drawn where that is below a half. Default: null.
   *
   * Its tones are the colours of at least two thousandths of its opaque pixels, at most 24; they
   * have to be two thirds of it. Others, such as those of antialiased borders, count as means of
   * two. Spots and gaps of less than a square of ten Tolerances are left out.
   */
  virtual void SetTones(vtkImageData* tones);
  vtkImageData* GetTones() const;
  ///@}

  ///@{
  /** The drawing's title, in UTF-8. Default: empty. */
  vtkSetMacro(Title, std::string);
  vtkGetMacro(Title, std::string);
  ///@}

  ///@{
  /** The drawing's date, such as 2026-01-31. Default: empty, none. */
  vtkSetMacro(Date, std::string);
  vtkGetMacro(Date, std::string);
  ///@}

protected:
  vtkNPRDrawingWriter();
  ~vtkNPRDrawingWriter() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  void WriteData() override;

#ifndef __VTK_WRAP__
  /** The bytes of the file. May throw npr::DrawingError. */
  virtual std::string Encode(const npr::PageDrawing& drawing) = 0;
#endif

  char* FileName = nullptr;
  int ViewportSize[2] = { 0, 0 };
  int Paper = A4_PAPER;
  int Orientation = AUTOMATIC_ORIENTATION;
  double CustomSize[2] = { 0.0, 0.0 };
  double Margin = 10.0;
  int Fit = FIT_VIEWPORT;
  double MillimetresPerUnit = 1.0;
  double Scale = 1.0;
  bool ScaleBar = false;
  std::string UnitName;
  int HiddenLines = HIDDEN_LINES_NONE;
  double Tolerance = 0.02;
  double CornerAngle = 45.0;
  std::string Title;
  std::string Date;

private:
  vtkNPRDrawingWriter(const vtkNPRDrawingWriter&) = delete;
  void operator=(const vtkNPRDrawingWriter&) = delete;

  npr::PageRequest MakeRequest();
  double GetUsedMargin() const
  {
    return this->Paper == VIEWPORT_PAPER ? 0.0 : this->Margin;
  }
  void WriteBytes(const std::string& bytes);

  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkNPRDrawingStyle> Style;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkImageData> Tones;
};

#endif
