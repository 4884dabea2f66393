// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLegend.h"

#include "nprCanvas.h"

#include <vtkImageData.h>
#include <vtkScalarsToColors.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
constexpr Colour Ink = { 0.16, 0.16, 0.18 };

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
    canvas.Write(text, x, bottom - height / 9, height / 4, Ink, 0.5);
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
  canvas.Paste(picture, 0, height);

  const int size = height * 3 / 10;
  const int middle = height * 66 / 100;
  const int margin = height * 6 / 10;
  const int title = canvas.Write(legend.Title, margin, middle + size / 2, size, Ink, 0.0);
  int x = margin + title + margin;
  if (legend.Colours)
  {
    PaintBar(canvas, legend, x + margin / 2, width - margin - margin / 2, height);
  }
  for (const auto& [colour, name] : legend.Strokes)
  {
    canvas.Fill(x, middle - std::max(1, height / 30), x + height, middle + height / 30, colour);
    x += height + margin / 3;
    x += canvas.Write(name, x, middle + size / 2, size, Ink, 0.0) + margin;
  }
  return image;
}
}
