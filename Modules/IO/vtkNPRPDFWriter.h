// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRPDFWriter
 * @brief Writes strokes as a PDF drawing of one page, by cairo and qpdf.
 *
 * The same drawing as vtkNPRSVGWriter's, in the same layers by the same names: optional content
 * groups (PDF 1.5), listed from the lowest to the highest and all on, which viewers switch. The
 * document's subject tells the style, the scale and the camera.
 *
 * @sa vtkNPRDrawingWriter has all settings; vtkNPRSVGWriter
 */
#ifndef vtkNPRPDFWriter_h
#define vtkNPRPDFWriter_h

#include "vtkNPRDrawingWriter.h"

class VTKNPRIO_EXPORT vtkNPRPDFWriter : public vtkNPRDrawingWriter
{
public:
  static vtkNPRPDFWriter* New();
  vtkTypeMacro(vtkNPRPDFWriter, vtkNPRDrawingWriter);

protected:
  vtkNPRPDFWriter() = default;
  ~vtkNPRPDFWriter() override = default;

#ifndef __VTK_WRAP__
  std::string Encode(const npr::PageDrawing& drawing) override;
#endif

private:
  vtkNPRPDFWriter(const vtkNPRPDFWriter&) = delete;
  void operator=(const vtkNPRPDFWriter&) = delete;
};

#endif
