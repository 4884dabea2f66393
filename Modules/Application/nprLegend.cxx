// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLegend.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkScalarsToColors.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace npr
{
namespace
{
constexpr Colour Ink = { 0.16, 0.16, 0.18 };

/// An RGB image that is painted on; y runs upwards.
class Canvas
{
public:
  Canvas(vtkImageData* image)
    : Pixels(static_cast<unsigned char*>(image->GetScalarPointer())),
      Width(image->GetDimensions()[0]), Height(image->GetDimensions()[1])
  {
  }

  void Blend(int x, int y, const Colour& colour, double opacity)
  {
    if (x < 0 || y < 0 || x >= this->Width || y >= this->Height)
    {
      return;
    }
    unsigned char* pixel = this->Pixels + 3 * (static_cast<std::size_t>(y) * this->Width + x);
    for (int c = 0; c < 3; ++c)
    {
      pixel[c] = static_cast<unsigned char>(
        std::lround(pixel[c] + opacity * (255.0 * colour[c] - pixel[c])));
    }
  }

  void Fill(int x0, int y0, int x1, int y1, const Colour& colour)
  {
    for (int y = y0; y < y1; ++y)
    {
      for (int x = x0; x < x1; ++x)
      {
        this->Blend(x, y, colour, 1.0);
      }
    }
  }

  /// `anchor` is which part of the text stands at x: 0 its left end, 0.5 its middle, 1 its right
  /// end. Its top is at y. Returns its width.
  int Write(const std::string& text, int x, int y, int size, double anchor)
  {
    vtkNew<vtkTextProperty> property;
    property->SetFontFamilyToArial();
    property->SetFontSize(size);
    property->SetColor(1.0, 1.0, 1.0);
    property->SetJustificationToLeft();
    vtkNew<vtkImageData> image;
    int extent[2] = { 0, 0 };
    if (text.empty() ||
      !vtkFreeTypeTools::GetInstance()->RenderString(property, text, 72, image, extent))
    {
      return 0;
    }
    const auto left = static_cast<int>(std::lround(x - anchor * extent[0]));
    const int* const dimensions = image->GetDimensions();
    const auto* source = static_cast<const unsigned char*>(image->GetScalarPointer());
    for (int row = 0; row < std::min(extent[1], dimensions[1]); ++row)
    {
      for (int column = 0; column < std::min(extent[0], dimensions[0]); ++column)
      {
        const auto* pixel = source + 4 * (static_cast<std::size_t>(row) * dimensions[0] + column);
        this->Blend(left + column, y - extent[1] + row, Ink, pixel[3] / 255.0);
      }
    }
    return extent[0];
  }

private:
  unsigned char* Pixels;
  int Width;
  int Height;
};

void PaintBar(Canvas& canvas, const Legend& legend, int x0, int x1, int height)
{
  const int bottom = height * 54 / 100;
  const int top = height * 78 / 100;
  for (int x = x0; x < x1; ++x)
  {
    const double value =
      legend.Minimum + (legend.Maximum - legend.Minimum) * (x + 0.5 - x0) / (x1 - x0);
    Colour colour;
    legend.Colours->GetColor(value, colour.data());
    canvas.Fill(x, bottom, x + 1, top, colour);
  }
  for (const auto& [value, text] : legend.Marks)
  {
    const double place = (value - legend.Minimum) / (legend.Maximum - legend.Minimum);
    const auto x = static_cast<int>(std::lround(x0 + place * (x1 - 1 - x0)));
    canvas.Fill(x, bottom - height / 14, x + std::max(1, height / 60), bottom, Ink);
    canvas.Write(text, x, bottom - height / 9, height / 4, 0.5);
  }
}
}

//------------------------------------------------------------------------------
int GetLegendHeight(const std::array<int, 2>& size)
{
  const int shorter = std::min(size[0], size[1]);
  return shorter < 200 ? 0 : std::max(40, shorter / 12);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> AddLegend(
  vtkImageData* picture, const Legend& legend, int height, const Colour& paper)
{
  const int width = picture->GetDimensions()[0];
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, picture->GetDimensions()[1] + height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  Canvas canvas(image);
  canvas.Fill(0, 0, width, height, paper);
  std::memcpy(image->GetScalarPointer(0, height, 0), picture->GetScalarPointer(),
    static_cast<std::size_t>(picture->GetNumberOfPoints()) * 3);

  const int size = height * 3 / 10;
  const int middle = height * 66 / 100;
  const int margin = height * 6 / 10;
  const int title = canvas.Write(legend.Title, margin, middle + size / 2, size, 0.0);
  int x = margin + title + margin;
  if (legend.Colours)
  {
    PaintBar(canvas, legend, x + margin / 2, width - margin - margin / 2, height);
  }
  for (const auto& [colour, name] : legend.Strokes)
  {
    canvas.Fill(x, middle - std::max(1, height / 30), x + height, middle + height / 30, colour);
    x += height + margin / 3;
    x += canvas.Write(name, x, middle + size / 2, size, 0.0) + margin;
  }
  return image;
}
}
