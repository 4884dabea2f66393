// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprDrawingInks.h
 * @brief From a style document to the looks of lines on paper.
 */
#ifndef nprDrawingInks_h
#define nprDrawingInks_h

class vtkNPRDrawingStyle;

namespace npr
{
struct StyleDocument;

/// A thousandth of the image's shorter side is so many millimetres. What a pen can't do, is drawn
/// as one would: what fades gets thinner, and of media only the width and colour are left.
void SetInks(const StyleDocument& document, double millimetresPerUnit, vtkNPRDrawingStyle* inks);
}

#endif
