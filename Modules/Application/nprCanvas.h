// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprCanvas_h
#define nprCanvas_h

#include <array>
#include <string>

class vtkImageData;

namespace npr
{
using Colour = std::array<double, 3>;

/**
 * @class Canvas
 * @brief An RGB image of bytes that is painted on; y runs upwards, and what falls beside it is left
 * out.
 */
class Canvas
{
public:
  /// The image must outlive the canvas.
  explicit Canvas(vtkImageData* image);

  void Blend(int x, int y, const Colour& colour, double opacity);
  /// The pixels x0 <= x < x1, y0 <= y < y1.
  void Fill(int x0, int y0, int x1, int y1, const Colour& colour);
  /// Another RGB image of bytes, its lower left corner at x, y.
  void Paste(vtkImageData* picture, int x, int y);
  /// `anchor` is which part of the text stands at x: 0 its left end, 0.5 its middle, 1 its right
  /// end. Its top is at y. Returns its width.
  int Write(const std::string& text, int x, int y, int size, const Colour& colour, double anchor);

private:
  unsigned char* Pixels;
  int Width;
  int Height;
};
}

#endif
