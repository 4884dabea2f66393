// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprImageMeasures.h
 * @brief The kernels of the image comparison: ink, distances, connected pieces, SSIM.
 */
#ifndef nprImageMeasures_h
#define nprImageMeasures_h

#include <cstdint>
#include <vector>

class vtkImageData;

namespace npr
{
/// One channel, or one quantity for each pixel; rows from bottom to top as in vtkImageData.
struct Plane
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Values;

  Plane(int width, int height, float value = 0.0f);
  float& At(int x, int y) { return this->Values[static_cast<std::size_t>(y) * this->Width + x]; }
  float At(int x, int y) const
  {
    return this->Values[static_cast<std::size_t>(y) * this->Width + x];
  }
};

/// The image as four planes, red, green, blue and alpha, in [0, 1]. Missing channels are filled:
/// grey becomes red, green and blue; alpha becomes 1.
std::vector<Plane> SplitChannels(vtkImageData* image);

enum class Polarity
{
  Dark, ///< ink darker than what it is drawn on
  Light ///< ink lighter than what it is drawn on
};

/**
 * The largest contrast, over the channels, of a pixel against the paper around it, in [0, 1].
 *
 * The paper is the morphological closing (dark ink) or opening (light ink) of the channel with a
 * square of 2 * reach + 1 pixels: what is narrower than the square is ink, and what is wider, such
 * as a shaded surface, a tone that varies and the border between two of them, is paper. So the
 * same measure serves drawings on plain paper and on shading. (Serra, Image Analysis and
 * Mathematical Morphology, 1982: the top-hat transform.)
 */
Plane InkStrength(const std::vector<Plane>& channels, Polarity polarity, int reach);

/// Whether the strokes of the image are darker or lighter than what they are drawn on.
Polarity FindPolarity(const std::vector<Plane>& channels);

using Mask = std::vector<std::uint8_t>;
Mask Threshold(const Plane& plane, float threshold);

/**
 * The Euclidean distance in pixels of each pixel to the nearest one of the mask, exact; more than
 * the image's diagonal where the mask is empty. (Felzenszwalb & Huttenlocher, Distance Transforms
 * of Sampled Functions, 2012.)
 */
Plane DistanceTo(const Mask& mask, int width, int height);

/// The length in pixels of the longest of the mask's connected pieces: the longer side of its
/// bounding box. Pixels that share a corner are connected.
int LongestPiece(const Mask& mask, int width, int height);

/**
 * Structural similarity of two channels at each pixel, Gaussian window of sigma 1.5 over 11x11
 * pixels. (Wang, Bovik, Sheikh, Simoncelli, Image Quality Assessment, 2004.) K1 = 0.1, K2 = 0.05:
 * with the paper's 0.01 and 0.03, two levels of noise on black or on plain paper count for much.
 */
Plane StructuralSimilarity(const Plane& a, const Plane& b);

/// Whether nothing is drawn: a plain image, or VTK's gradient background and nothing else.
bool IsBlank(const std::vector<Plane>& channels);
}

#endif
