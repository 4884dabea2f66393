// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprToneRegions.h
 * @brief The areas of a picture that have one colour each, by their borders.
 */
#ifndef nprToneRegions_h
#define nprToneRegions_h

#include <Eigen/Core>

#include <array>
#include <vector>

class vtkImageData;

namespace npr
{
/// One loop of points around each of its pieces and holes; pixels from the picture's upper left
/// corner, y down.
struct ToneRegion
{
  std::array<double, 3> Color;
  std::vector<std::vector<Eigen::Vector2d>> Loops;
};

/**
 * The regions of a picture of flat tones, as toon shading without lines gives it: unsigned chars of
 * 1 to 4 components, where an even number has an opacity last. What is less than half opaque is
 * nothing.
 *
 * Tones are the colours of at least two thousandths of the picture's opaque pixels. Others, which
 * soften the borders between tones, count as means of two.
 *
 * A region has its own tone and all darker ones, so that each is laid over the one before and no
 * gap is to be seen between neighbours: the first is the lightest, and all that is opaque.
 *
 * The borders are where the share of the region's tones is a half, smoothed by a Gaussian of one
 * pixel: they pass the picture's own within a small part of a pixel.
 *
 * Throws DrawingError where more than a third of the pixels have none of the tones.
 */
std::vector<ToneRegion> FindToneRegions(vtkImageData* image);
}

#endif
