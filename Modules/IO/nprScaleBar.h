// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprScaleBar.h
 * @brief A bar on the page that is a round number of the world's units long.
 */
#ifndef nprScaleBar_h
#define nprScaleBar_h

#include "nprPageDrawing.h"

#include <string>

namespace npr
{
/// In the lower left corner of the area.
PageLayer MakeScaleBar(
  const PageRectangle& area, double millimetresOnPagePerUnit, const std::string& unitName);

/// Such as "1:2" or "5:1".
std::string ScaleText(double scale);
}

#endif
