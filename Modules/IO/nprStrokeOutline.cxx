// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeOutline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace npr
{
namespace
{
PagePoint LeftOf(const PagePoint& tangent)
{
  return { tangent.y(), -tangent.x() };
}

/// Half a circle from where the path is, around `center`, over `forward`.
void AddHalfCircle(const PagePoint& center, const PagePoint& forward, double radius, PagePath& path)
{
  const double handle = 0.5522847498 * radius; // of a quarter of a circle
  const PagePoint left = LeftOf(forward);
  const PagePoint top = center + radius * forward;
  const PagePoint end = center - radius * left;
  path.CurveTo(center + radius * left + handle * forward, top + handle * left, top);
  path.CurveTo(top - handle * left, end + handle * forward, end);
}

class Outline
{
public:
  Outline(const PageChain& chain, const FitSettings& settings, bool roundCaps, PagePath& path)
    : Chain(chain), Settings(settings), Turns(FindTurns(chain, settings)), RoundCaps(roundCaps),
      Path(path)
  {
    // The sides have corners where the chain has them, and nowhere else.
    this->Settings.CornerCosine = -2.0;
    this->FindTightBends();
  }

  void Add()
  {
    const std::size_t n = this->Chain.Points.size();
    const std::vector<char>& corners = this->Turns.Corners;
    std::size_t begin = 0;
    if (this->Chain.Closed)
    {
      const auto corner = std::find(corners.begin(), corners.end(), 1);
      if (corner == corners.end())
      {
        this->AddRing();
        return;
      }
      begin = corner - corners.begin();
    }
    const std::size_t end = begin + (this->Chain.Closed ? n : n - 1);
    for (std::size_t first = begin; first < end;)
    {
      std::size_t last = first + 1;
      while (last < end && !corners[last % n])
      {
        ++last;
      }
      this->AddSection(first, last, this->RoundCaps || this->Chain.Closed || first != begin,
        this->RoundCaps || this->Chain.Closed || last != end);
      first = last;
    }
  }

private:
  double GetRadius(std::size_t i) const { return 0.5 * this->Chain.Widths[i]; }

  PagePoint GetSide(std::size_t i, double side) const
  {
    return this->Chain.Points[i] + side * this->GetRadius(i) * LeftOf(this->Turns.Tangents[i]);
  }

  /// Where a side runs backwards, the stroke is cut as at a corner.
  void FindTightBends()
  {
    const std::size_t n = this->Chain.Points.size();
    for (std::size_t i = this->Chain.Closed ? 0 : 1; i < n; ++i)
    {
      const std::size_t before = i == 0 ? n - 1 : i - 1;
      const PagePoint way = this->Chain.Points[i] - this->Chain.Points[before];
      for (const double side : { -1.0, 1.0 })
      {
        if ((this->GetSide(i, side) - this->GetSide(before, side)).dot(way) < 0.0)
        {
          this->Turns.Corners[i] = i + 1 < n || this->Chain.Closed;
          this->Turns.Corners[before] = before > 0 || this->Chain.Closed;
        }
      }
    }
  }

  void AddRing()
  {
    const std::size_t n = this->Chain.Points.size();
    PageChain ring;
    ring.Closed = true;
    for (std::size_t i = 0; i < n; ++i)
    {
      ring.Points.push_back(this->GetSide(i, 1.0));
    }
    FitChain(ring, this->Settings, this->Path);
    for (std::size_t i = 0; i < n; ++i)
    {
      ring.Points[n - 1 - i] = this->GetSide(i, -1.0);
    }
    FitChain(ring, this->Settings, this->Path);
  }

  /// The tangents at a section's ends are its own, not those around a corner.
  PagePoint GetTangent(std::size_t i, std::size_t first, std::size_t last) const
  {
    const std::size_t n = this->Chain.Points.size();
    if ((i == first || i == last) && this->Turns.Corners[i % n])
    {
      const std::size_t other = i == first ? i + 1 : i - 1;
      const PagePoint way =
        (this->Chain.Points[other % n] - this->Chain.Points[i % n]) * (i == first ? 1.0 : -1.0);
      return way.normalized();
    }
    return this->Turns.Tangents[i % n];
  }

  void AddSection(std::size_t first, std::size_t last, bool startRound, bool endRound)
  {
    const std::size_t n = this->Chain.Points.size();
    PageChain left;
    PageChain right;
    for (std::size_t i = first; i <= last; ++i)
    {
      const PagePoint off = this->GetRadius(i % n) * LeftOf(this->GetTangent(i, first, last));
      left.Points.push_back(this->Chain.Points[i % n] + off);
      right.Points.push_back(this->Chain.Points[i % n] - off);
    }
    std::reverse(right.Points.begin(), right.Points.end());
    ThinChain(left, 0.25 * this->Settings.Tolerance);
    ThinChain(right, 0.25 * this->Settings.Tolerance);

    FitChain(left, this->Settings, this->Path);
    this->AddEnd(last % n, this->GetTangent(last, first, last), endRound);
    FitChain(right, this->Settings, this->Path, false);
    this->AddEnd(first % n, -this->GetTangent(first, first, last), startRound);
    this->Path.Close();
  }

  void AddEnd(std::size_t i, const PagePoint& forward, bool isRound)
  {
    // A point that is thinner than what can be seen needs no cap.
    if (isRound && this->GetRadius(i) > 0.5 * this->Settings.Tolerance)
    {
      AddHalfCircle(this->Chain.Points[i], forward, this->GetRadius(i), this->Path);
    }
  }

  const PageChain& Chain;
  FitSettings Settings;
  ChainTurns Turns;
  bool RoundCaps;
  PagePath& Path;
};
}

//------------------------------------------------------------------------------
void LimitWidthChange(PageChain& chain, double slope)
{
  const std::size_t n = chain.Points.size();
  const auto limit = [&](std::size_t from, std::size_t to)
  {
    const double way = (chain.Points[to] - chain.Points[from]).norm();
    chain.Widths[to] = std::min(chain.Widths[to], chain.Widths[from] + slope * way);
  };
  // Around a closed chain twice: what is narrow at its end holds at its begin, too.
  for (int round = 0; round < (chain.Closed ? 2 : 1); ++round)
  {
    for (std::size_t i = chain.Closed ? 0 : 1; i < n; ++i)
    {
      limit(i == 0 ? n - 1 : i - 1, i);
    }
    for (std::size_t i = chain.Closed ? n : n - 1; i > 0; --i)
    {
      limit(i == n ? 0 : i, i - 1);
    }
  }
}

//------------------------------------------------------------------------------
void AddOutline(const PageChain& chain, const FitSettings& settings, bool roundCaps, PagePath& path)
{
  if (chain.Points.size() > 1)
  {
    Outline(chain, settings, roundCaps, path).Add();
  }
}
}
