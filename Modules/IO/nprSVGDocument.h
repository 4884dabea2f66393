// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSVGDocument.h
 * @brief A drawing as the text of an SVG file.
 */
#ifndef nprSVGDocument_h
#define nprSVGDocument_h

#include "nprPageDrawing.h"

#include <string>

namespace npr
{
std::string EncodeSVG(const PageDrawing& drawing);

/// Text for XML: special characters escaped, and '?' for what XML can't hold.
std::string EscapeXML(const std::string& text);
}

#endif
