// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLegend.h
 * @brief The strip below a picture that says what its colours or strokes mean.
 */
#ifndef nprLegend_h
#define nprLegend_h

#include "nprCanvas.h"

#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;
class vtkScalarsToColors;

namespace npr
{
struct Legend
{
  std::string Title;
  /// A bar of these colours over [Minimum, Maximum], with marks; null for none.
  vtkSmartPointer<vtkScalarsToColors> Colours;
  double Minimum = 0.0;
  double Maximum = 1.0;
  std::vector<std::pair<double, std::string>> Marks;
  /// Or samples of strokes, each with its name.
  std::vector<std::pair<Colour, std::string>> Strokes;
};

/// How high the legend of an image of this size is, in pixels; 0 where the image is too small to
/// read one.
int GetLegendHeight(const std::array<int, 2>& size);

/// The picture with the legend below it, on the same paper.
vtkSmartPointer<vtkImageData> AddLegend(
  vtkImageData* picture, const Legend& legend, int height, const Colour& paper);
}

#endif
