// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprScaleBar.h"

#include "nprNumberText.h"

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
constexpr double LongestBar = 60.0;  // millimetres
constexpr double LongestShare = 0.4; // of the area's width
constexpr double TickHeight = 1.5;
constexpr double TextHeight = 3.0;

/// The largest of 1, 2, 5, 10, 20 ... (and their parts) up to `most`.
double RoundNumberUpTo(double most)
{
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  const double factor = most / power;
  return power * (factor >= 5.0 ? 5.0 : factor >= 2.0 ? 2.0 : 1.0);
}
}

//------------------------------------------------------------------------------
PageLayer MakeScaleBar(
  const PageRectangle& area, double millimetresOnPagePerUnit, const std::string& unitName)
{
  const double most = std::min(LongestBar, LongestShare * area.GetSize().x());
  const double units = RoundNumberUpTo(most / millimetresOnPagePerUnit);
  const double length = units * millimetresOnPagePerUnit;

  PageLayer layer;
  layer.Name = "scale bar";
  layer.Ink.Width = 0.25;
  layer.Ink.Cap = LineInk::SQUARE_CAP;
  layer.Ink.Join = LineInk::MITER_JOIN;
  const PagePoint left(area.Least.x() + TickHeight, area.Most.y() - TickHeight);
  const PagePoint right = left + PagePoint(length, 0.0);
  const PagePoint tick(0.0, -TickHeight);
  layer.Path.MoveTo(left + tick);
  layer.Path.LineTo(left);
  layer.Path.LineTo(right);
  layer.Path.LineTo(right + tick);
  layer.Shapes.push_back({ layer.Path.Commands.size(), layer.Path.Points.size(), false });
  layer.Texts.push_back({ 0.5 * (left + right) + PagePoint(0.0, -1.0), TextHeight,
    NumberText(units) + (unitName.empty() ? "" : " " + unitName) });
  return layer;
}

//------------------------------------------------------------------------------
std::string ScaleText(double scale)
{
  return scale < 1.0 ? "1:" + NumberText(1.0 / scale) : NumberText(scale) + ":1";
}
}
