// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPDFLayers.h
 * @brief Layers of a PDF, which cairo can't write.
 *
 * Layers are optional content groups (ISO 32000-1, 8.11), which viewers list by name and switch.
 */
#ifndef nprPDFLayers_h
#define nprPDFLayers_h

#include <string>
#include <vector>

namespace npr
{
/**
 * Lays the pages of a PDF over each other, the first one lowest. They become one page, and each a
 * layer of it, which is on by default. There is a name for each page; without any names the first
 * page stays, empty. The same input gives the same bytes.
 *
 * Throws DrawingError if it is no such PDF.
 */
std::string LayPagesAsLayers(const std::string& pdf, const std::vector<std::string>& names);
}

#endif
