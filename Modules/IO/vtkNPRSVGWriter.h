// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSVGWriter
 * @brief Writes strokes as an SVG drawing: millimetres on paper, curves, and layers for Inkscape.
 *
 * A user unit is a millimetre. Each layer is a group that Inkscape shows as a layer, named by the
 * line type and "(visible)" or "(hidden)". The element `metadata` tells the style, the scale and
 * the camera. An image is embedded as PNG.
 *
 * @sa vtkNPRDrawingWriter has all settings; vtkNPRPDFWriter
 */
#ifndef vtkNPRSVGWriter_h
#define vtkNPRSVGWriter_h

#include "vtkNPRDrawingWriter.h"

class VTKNPRIO_EXPORT vtkNPRSVGWriter : public vtkNPRDrawingWriter
{
public:
  static vtkNPRSVGWriter* New();
  vtkTypeMacro(vtkNPRSVGWriter, vtkNPRDrawingWriter);

protected:
  vtkNPRSVGWriter() = default;
  ~vtkNPRSVGWriter() override = default;

#ifndef __VTK_WRAP__
  std::string Encode(const npr::PageDrawing& drawing) override;
#endif

private:
  vtkNPRSVGWriter(const vtkNPRSVGWriter&) = delete;
  void operator=(const vtkNPRSVGWriter&) = delete;
};

#endif
