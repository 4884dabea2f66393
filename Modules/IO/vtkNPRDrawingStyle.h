// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRDrawingStyle
 * @brief How lines look on paper: for each line type its width, colour, caps, joins and dashes.
 *
 * A line type is named as in the field data array `LineTypeNames` of the strokes, such as
 * "contours" or "creases". The line types of vtkNPRFeatureLines have widths of drawing practice
 * (ISO 128: 0.18, 0.25, 0.35, 0.5 mm), heaviest for contours, and those that fade out taper; others
 * are 0.25 mm wide. All are black.
 *
 * Hidden lines look as the visible ones of their type, but for HiddenWidthFactor, HiddenOpacity and
 * HiddenDashes; they don't taper.
 *
 * @sa vtkNPRSVGWriter, vtkNPRPDFWriter
 */
#ifndef vtkNPRDrawingStyle_h
#define vtkNPRDrawingStyle_h

#include "vtkNPRIOModule.h"
#include <vtkObject.h>

#include <memory>
#include <string>

namespace npr
{
struct LineInk;
}

class VTKNPRIO_EXPORT vtkNPRDrawingStyle : public vtkObject
{
public:
  static vtkNPRDrawingStyle* New();
  vtkTypeMacro(vtkNPRDrawingStyle, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The style's name, which files tell. Default: "ink". */
  vtkSetMacro(Name, std::string);
  vtkGetMacro(Name, std::string);
  ///@}

  ///@{
  /** Width in millimetres, or in points (1/72 inch); not negative. 0 draws nothing. */
  void SetWidth(const char* lineType, double millimetres);
  double GetWidth(const char* lineType) const;
  void SetWidthInPoints(const char* lineType, double points);
  ///@}

  /** Colour; each part in [0, 1]. */
  void SetColor(const char* lineType, double red, double green, double blue);

  /** Opacity, [0, 1]. Where strokes of one line type overlap, they are not darker. */
  void SetOpacity(const char* lineType, double opacity);

  /** How strokes end. */
  enum Caps
  {
    BUTT_CAP,
    ROUND_CAP,
    SQUARE_CAP
  };
  void SetCap(const char* lineType, int cap);

  /** What corners look like. */
  enum Joins
  {
    MITER_JOIN,
    ROUND_JOIN,
    BEVEL_JOIN
  };
  void SetJoin(const char* lineType, int join);

  /**
   * What share of the width is left where the point array `Strength` is 0, [0, 1]; the width is
   * whole where it is 1. With 1, strokes don't taper.
   */
  void SetTaper(const char* lineType, double share);

  /**
   * Dashes of the visible lines: lengths of a dash and a gap, and of a second dash and gap for
   * chain lines; millimetres. 0, 0: solid, the default. Dashed lines don't taper.
   */
  void SetDashes(
    const char* lineType, double dash, double gap, double secondDash = 0.0, double secondGap = 0.0);

  ///@{
  /** Width of hidden lines as a share of the visible ones', not negative. Default: 0.6. */
  vtkSetClampMacro(HiddenWidthFactor, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(HiddenWidthFactor, double);
  ///@}

  ///@{
  /** Opacity of hidden lines as a share of the visible ones', [0, 1]. Default: 1. */
  vtkSetClampMacro(HiddenOpacity, double, 0.0, 1.0);
  vtkGetMacro(HiddenOpacity, double);
  ///@}

  ///@{
  /** Dash and gap of hidden lines, millimetres. Default: 1.6, 0.8. */
  vtkSetVector2Macro(HiddenDashes, double);
  vtkGetVector2Macro(HiddenDashes, double);
  ///@}

#ifndef __VTK_WRAP__
  /** All of it for the visible lines of a type, or for the hidden ones (dashed). */
  npr::LineInk GetInk(const std::string& lineType, bool hidden) const;
#endif

protected:
  vtkNPRDrawingStyle();
  ~vtkNPRDrawingStyle() override;

  std::string Name = "ink";
  double HiddenWidthFactor = 0.6;
  double HiddenOpacity = 1.0;
  double HiddenDashes[2] = { 1.6, 0.8 };

private:
  vtkNPRDrawingStyle(const vtkNPRDrawingStyle&) = delete;
  void operator=(const vtkNPRDrawingStyle&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
