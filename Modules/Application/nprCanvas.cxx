// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCanvas.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace npr
{
//------------------------------------------------------------------------------
Canvas::Canvas(vtkImageData* image)
  : Pixels(static_cast<unsigned char*>(image->GetScalarPointer())),
    Width(image->GetDimensions()[0]), Height(image->GetDimensions()[1])
{
}

//------------------------------------------------------------------------------
void Canvas::Blend(int x, int y, const Colour& colour, double opacity)
{
  if (x < 0 || y < 0 || x >= this->Width || y >= this->Height)
  {
    return;
  }
  unsigned char* pixel = this->Pixels + 3 * (static_cast<std::size_t>(y) * this->Width + x);
  for (int c = 0; c < 3; ++c)
  {
    pixel[c] =
      static_cast<unsigned char>(std::lround(pixel[c] + opacity * (255.0 * colour[c] - pixel[c])));
  }
}

//------------------------------------------------------------------------------
void Canvas::Fill(int x0, int y0, int x1, int y1, const Colour& colour)
{
  for (int y = y0; y < y1; ++y)
  {
    for (int x = x0; x < x1; ++x)
    {
      this->Blend(x, y, colour, 1.0);
    }
  }
}

//------------------------------------------------------------------------------
void Canvas::Paste(vtkImageData* picture, int x, int y)
{
  const int first = std::max(0, -x);
  const int last = std::min(picture->GetDimensions()[0], this->Width - x);
  for (int row = std::max(0, -y);
       first < last && row < std::min(picture->GetDimensions()[1], this->Height - y); ++row)
  {
    std::memcpy(this->Pixels + 3 * (static_cast<std::size_t>(y + row) * this->Width + x + first),
      picture->GetScalarPointer(first, row, 0), 3 * static_cast<std::size_t>(last - first));
  }
}

//------------------------------------------------------------------------------
int Canvas::Write(
  const std::string& text, int x, int y, int size, const Colour& colour, double anchor)
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
      this->Blend(left + column, y - extent[1] + row, colour, pixel[3] / 255.0);
    }
  }
  return extent[0];
}
}
