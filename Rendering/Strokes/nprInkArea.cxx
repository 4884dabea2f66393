// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprInkArea.h"

#include "nprStrokeBuffer.h"

#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace npr
{
namespace
{
// Pixels: software renderers work on squares of this size.
constexpr int TileSize = 64;
// What is longer, in tiles, is far outside of the viewport; all tiles of its bounds are taken.
constexpr double LongestWalk = 1024.0;

/// A place on the screen, in pixels; behind the eye it has none.
struct Projected
{
  bool IsInFront;
  double X;
  double Y;
};

class Projection
{
public:
  Projection(vtkMatrix4x4* toDevice, const float viewportSize[2])
    : Matrix(toDevice), Width(viewportSize[0]), Height(viewportSize[1])
  {
  }

  template<typename Number>
  Projected Project(const Number place[3]) const
  {
    double clip[4];
    for (int c : { 0, 1, 3 })
    {
      clip[c] = this->Matrix->Element[3][c];
      for (int i = 0; i < 3; ++i)
      {
        clip[c] += place[i] * this->Matrix->Element[i][c];
      }
    }
    return { clip[3] > 0.0, this->Width * (0.5 * clip[0] / clip[3] + 0.5),
      this->Height * (0.5 * clip[1] / clip[3] + 0.5) };
  }

private:
  vtkMatrix4x4* Matrix;
  double Width;
  double Height;
};

class TileMap
{
public:
  TileMap(const float viewportSize[2], double reach) : Reach(reach)
  {
    for (int c = 0; c < 2; ++c)
    {
      this->Size[c] = static_cast<int>(viewportSize[c]);
      this->Tiles[c] = (this->Size[c] + TileSize - 1) / TileSize;
    }
    this->Marks.assign(static_cast<std::size_t>(this->Tiles[0]) * this->Tiles[1], 0);
  }

  void MarkAll() { this->Marks.assign(this->Marks.size(), 1); }

  void MarkSegment(const Projected& a, const Projected& b)
  {
    if (!a.IsInFront || !b.IsInFront)
    {
      // What reaches behind the eye may be anywhere.
      if (a.IsInFront || b.IsInFront)
      {
        this->MarkAll();
      }
      return;
    }
    const double steps = std::ceil(std::max(std::abs(b.X - a.X), std::abs(b.Y - a.Y)) / TileSize);
    if (!(steps <= LongestWalk))
    {
      this->MarkBounds(a, b);
      return;
    }
    Projected from = a;
    for (int step = 1; step <= std::max(steps, 1.0); ++step)
    {
      const double t = step / std::max(steps, 1.0);
      const Projected to = { true, a.X + t * (b.X - a.X), a.Y + t * (b.Y - a.Y) };
      this->MarkBounds(from, to);
      from = to;
    }
  }

  InkArea GetArea() const
  {
    InkArea area;
    int low[2] = { this->Size[0], this->Size[1] };
    int high[2] = { 0, 0 };
    for (int row = 0; row < this->Tiles[1]; ++row)
    {
      const auto begin = this->Marks.begin() + static_cast<std::ptrdiff_t>(row) * this->Tiles[0];
      const auto end = begin + this->Tiles[0];
      for (auto from = std::find(begin, end, 1); from != end;)
      {
        const auto to = std::find(from, end, 0);
        const int x = static_cast<int>(from - begin) * TileSize;
        const int y = row * TileSize;
        const int right = std::min(static_cast<int>(to - begin) * TileSize, this->Size[0]);
        const int top = std::min(y + TileSize, this->Size[1]);
        area.Rectangles.push_back({ x, y, right - x, top - y });
        low[0] = std::min(low[0], x);
        low[1] = std::min(low[1], y);
        high[0] = std::max(high[0], right);
        high[1] = std::max(high[1], top);
        from = std::find(to, end, 1);
      }
    }
    if (!area.IsEmpty())
    {
      area.Bounds = { low[0], low[1], high[0] - low[0], high[1] - low[1] };
    }
    return area;
  }

private:
  void MarkBounds(const Projected& a, const Projected& b)
  {
    const int left = this->GetTile(std::min(a.X, b.X) - this->Reach, 0);
    const int right = this->GetTile(std::max(a.X, b.X) + this->Reach, 0);
    const int bottom = this->GetTile(std::min(a.Y, b.Y) - this->Reach, 1);
    const int top = this->GetTile(std::max(a.Y, b.Y) + this->Reach, 1);
    for (int y = std::max(bottom, 0); y <= std::min(top, this->Tiles[1] - 1); ++y)
    {
      for (int x = std::max(left, 0); x <= std::min(right, this->Tiles[0] - 1); ++x)
      {
        this->Marks[static_cast<std::size_t>(y) * this->Tiles[0] + x] = 1;
      }
    }
  }

  /// The tile of a pixel; -1 or the number of tiles for what is outside.
  int GetTile(double pixel, int axis) const
  {
    const double tile = std::floor(pixel / TileSize);
    return static_cast<int>(std::min(std::max(tile, -1.0), static_cast<double>(this->Tiles[axis])));
  }

  double Reach;
  int Size[2];
  int Tiles[2];
  std::vector<char> Marks;
};
}

//------------------------------------------------------------------------------
InkArea FindInkArea(
  const StrokeRecords& records, vtkMatrix4x4* toDevice, const float viewportSize[2], double reach)
{
  const Projection projection(toDevice, viewportSize);
  TileMap tiles(viewportSize, reach);
  Projected last = { false, 0.0, 0.0 };
  bool isDrawn = false;
  for (const StrokeRecord& record : records.Records)
  {
    const Projected here = projection.Project(record.Position);
    if (isDrawn)
    {
      tiles.MarkSegment(last, here);
    }
    isDrawn = (static_cast<int>(record.Kind) & Drawn) != 0;
    last = here;
  }
  return tiles.GetArea();
}

//------------------------------------------------------------------------------
InkArea FindInkBounds(
  const StrokeRecords& records, vtkMatrix4x4* toDevice, const float viewportSize[2], double reach)
{
  const Projection projection(toDevice, viewportSize);
  double low[2] = { viewportSize[0], viewportSize[1] };
  double high[2] = { 0.0, 0.0 };
  for (int corner = 0; corner < 8; ++corner)
  {
    double place[3];
    for (int i = 0; i < 3; ++i)
    {
      place[i] = ((corner >> i) & 1) != 0 ? records.HalfSize[i] : -records.HalfSize[i];
    }
    const Projected projected = projection.Project(place);
    const double pixel[2] = { projected.X, projected.Y };
    for (int c = 0; c < 2; ++c)
    {
      // What reaches behind the eye may be anywhere.
      low[c] = projected.IsInFront ? std::min(low[c], pixel[c] - reach) : 0.0;
      high[c] = projected.IsInFront ? std::max(high[c], pixel[c] + reach) : viewportSize[c];
    }
  }
  InkArea area;
  for (int c = 0; c < 2; ++c)
  {
    const double first = std::floor(std::max(low[c], 0.0));
    const double end = std::ceil(std::min(high[c], static_cast<double>(viewportSize[c])));
    area.Bounds[c] = static_cast<int>(first);
    area.Bounds[2 + c] = static_cast<int>(std::max(end - first, 0.0));
  }
  if (area.Bounds[2] > 0 && area.Bounds[3] > 0)
  {
    area.Rectangles.push_back(area.Bounds);
  }
  return area;
}
}
