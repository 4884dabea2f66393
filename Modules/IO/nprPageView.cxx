// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPageView.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace npr
{
namespace
{
/// A cut segment's ends as shares of its way; none if nothing is inside.
struct Span
{
  double From = 0.0;
  double To = 1.0;
  bool Empty = false;
};

template<typename Distances>
unsigned int GetOutcode(const Distances& distances)
{
  unsigned int code = 0;
  for (int side = 0; side < distances.size(); ++side)
  {
    code |= distances[side] < 0.0 ? 1u << side : 0u;
  }
  return code;
}

template<typename Distances>
Span Cut(const Distances& start, unsigned int startCode, const Distances& end, unsigned int endCode)
{
  Span span;
  span.Empty = (startCode & endCode) != 0;
  const unsigned int crossed = startCode | endCode;
  for (int side = 0; side < start.size() && !span.Empty; ++side)
  {
    if (!(crossed & 1u << side))
    {
      continue;
    }
    const double t = start[side] / (start[side] - end[side]);
    if (startCode & 1u << side)
    {
      span.From = std::max(span.From, t);
    }
    else
    {
      span.To = std::min(span.To, t);
    }
    span.Empty = span.From >= span.To;
  }
  return span;
}
}

//------------------------------------------------------------------------------
PageView::PageView(vtkCamera* camera, int viewportWidth, int viewportHeight)
  : Viewport(viewportWidth, viewportHeight)
{
  vtkMatrix4x4* const composite = camera->GetCompositeProjectionTransformMatrix(
    static_cast<double>(viewportWidth) / viewportHeight, -1.0, 1.0);
  Eigen::Matrix4d toClip;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      toClip(i, j) = composite->GetElement(i, j);
    }
  }
  const Eigen::Vector2d half = 0.5 * this->Viewport;
  this->ToPixels.row(0) = half.x() * (toClip.row(3) + toClip.row(0));
  this->ToPixels.row(1) = half.y() * (toClip.row(3) - toClip.row(1));
  this->ToPixels.row(2) = toClip.row(3);
  this->ToPixels.row(3) = toClip.row(3) + toClip.row(2);
  this->ToPage = this->ToPixels;
  this->PixelsPerUnit = half.y() * toClip.row(1).head<3>().norm();
}

//------------------------------------------------------------------------------
bool PageView::GetPixel(const Eigen::Vector3d& position, Eigen::Vector2d& pixel) const
{
  const Homogeneous point = this->ToPixels * position.homogeneous();
  pixel = point.head<2>() / point[2];
  return point[3] > 0.0 && pixel.allFinite();
}

//------------------------------------------------------------------------------
void PageView::Place(const Eigen::Vector2d& center, const PagePoint& place,
  double millimetresPerPixel, const PageRectangle& area)
{
  const PagePoint corner = place - millimetresPerPixel * center;
  this->ToPage = this->ToPixels;
  for (int i = 0; i < 2; ++i)
  {
    this->ToPage.row(i) =
      millimetresPerPixel * this->ToPixels.row(i) + corner[i] * this->ToPixels.row(2);
  }
  this->Area = area;
}

//------------------------------------------------------------------------------
PageView::Distances PageView::GetDistances(const Homogeneous& point) const
{
  Distances distances;
  distances << point[0] - this->Area.Least.x() * point[2],
    this->Area.Most.x() * point[2] - point[0], point[1] - this->Area.Least.y() * point[2],
    this->Area.Most.y() * point[2] - point[1], point[3];
  return distances;
}

//------------------------------------------------------------------------------
void PageView::Draw(
  const std::vector<WorldPoint>& chain, bool closed, std::vector<PageChain>& drawn) const
{
  const std::size_t n = chain.size();
  if (n < 2)
  {
    return;
  }
  const std::size_t firstDrawn = drawn.size();
  const std::size_t segments = closed ? n : n - 1;
  bool isCut = false;
  bool open = false; // whether the last chain goes on

  Homogeneous start = this->ToPage * chain[0].Position.homogeneous();
  Distances startDistances = this->GetDistances(start);
  unsigned int startCode = GetOutcode(startDistances);
  const bool startsInside = startCode == 0;
  for (std::size_t i = 0; i < segments; ++i)
  {
    const WorldPoint& from = chain[i];
    const WorldPoint& to = chain[i + 1 < n ? i + 1 : 0];
    const Homogeneous end = this->ToPage * to.Position.homogeneous();
    const Distances endDistances = this->GetDistances(end);
    const unsigned int endCode = GetOutcode(endDistances);
    const Span span = Cut(startDistances, startCode, endDistances, endCode);
    const auto add = [&](double t)
    {
      const Homogeneous point = start + t * (end - start);
      drawn.back().Points.emplace_back(point.head<2>() / point[2]);
      drawn.back().Widths.push_back(from.Width + t * (to.Width - from.Width));
      drawn.back().World.emplace_back(from.Position + t * (to.Position - from.Position));
    };
    if (span.Empty)
    {
      isCut = true;
      open = false;
    }
    else
    {
      isCut = isCut || startCode != 0 || endCode != 0;
      if (!open)
      {
        drawn.emplace_back();
        add(span.From);
      }
      add(span.To);
      open = endCode == 0;
    }
    start = end;
    startDistances = endDistances;
    startCode = endCode;
  }
  if (!closed || drawn.size() == firstDrawn)
  {
    return;
  }
  PageChain& last = drawn.back();
  if (!isCut)
  {
    last.Points.pop_back();
    last.Widths.pop_back();
    last.World.pop_back();
    last.Closed = true;
  }
  else if (open && startsInside && drawn.size() > firstDrawn + 1)
  {
    // The chain begins in the middle of a visit.
    PageChain& first = drawn[firstDrawn];
    last.Points.insert(last.Points.end(), first.Points.begin() + 1, first.Points.end());
    last.Widths.insert(last.Widths.end(), first.Widths.begin() + 1, first.Widths.end());
    last.World.insert(last.World.end(), first.World.begin() + 1, first.World.end());
    first = std::move(last);
    drawn.pop_back();
  }
}
}
