// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSVGWriter.h"

#include "nprSVGDocument.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPRSVGWriter);

std::string vtkNPRSVGWriter::Encode(const npr::PageDrawing& drawing)
{
  return npr::EncodeSVG(drawing);
}
