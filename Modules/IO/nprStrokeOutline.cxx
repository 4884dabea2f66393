// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeOutline.h"

#include "nprChainTangents.h"

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
    : Chain(chain), Size(chain.Points.size()), Settings(settings), RoundCaps(roundCaps), Path(path)
  {
    // The sides have corners where the chain has them, and nowhere else.
    this->Settings.CornerCosine = -2.0;
  }

  void Add(const std::vector<char>& corners)
  {
    const std::size_t n = this->Size;
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
  /// A point of the chain with the direction there.
  struct Station
  {
    PagePoint Place;
    PagePoint Tangent;
    double Radius;

    PagePoint GetSide(double side) const { return Place + side * Radius * LeftOf(Tangent); }
  };

  /// The points from `first` to `last`; tangents look at no others than those from `lookFirst`.
  std::vector<Station> GetStations(
    std::size_t first, std::size_t last, std::size_t lookFirst, std::size_t lookLast) const
  {
    const auto point = [this](std::ptrdiff_t i) -> const PagePoint&
    { return this->Chain.Points[i % this->Size]; };
    const ChainTangents tangents(point, lookFirst, lookLast, this->Settings.Tolerance);
    std::vector<Station> stations;
    for (std::size_t i = first; i <= last; ++i)
    {
      stations.push_back({ point(i), tangents.Get(i), 0.5 * this->Chain.Widths[i % this->Size] });
    }
    return stations;
  }

  /// Where one side or the other would run backwards.
  static bool IsTight(const Station& from, const Station& to)
  {
    const PagePoint way = to.Place - from.Place;
    return (to.GetSide(1.0) - from.GetSide(1.0)).dot(way) < 0.0 ||
      (to.GetSide(-1.0) - from.GetSide(-1.0)).dot(way) < 0.0;
  }

  void AddRing()
  {
    const std::size_t n = this->Size;
    std::vector<Station> stations = this->GetStations(n, 2 * n, n / 2 + 1, 2 * n + n / 2);
    for (std::size_t i = 1; i <= n; ++i)
    {
      if (IsTight(stations[i - 1], stations[i]))
      {
        this->AddPieces(stations, true, true);
        return;
      }
    }
    PageChain left;
    PageChain right;
    left.Closed = true;
    right.Closed = true;
    stations.pop_back();
    for (const Station& station : stations)
    {
      left.Points.push_back(station.GetSide(1.0));
      right.Points.push_back(station.GetSide(-1.0));
    }
    std::reverse(right.Points.begin(), right.Points.end());
    for (PageChain* side : { &left, &right })
    {
      ThinChain(*side, 0.25 * this->Settings.Tolerance);
      FitChain(*side, this->Settings, this->Path);
    }
  }

  void AddSection(std::size_t first, std::size_t last, bool startRound, bool endRound)
  {
    this->AddPieces(this->GetStations(first, last, first, last), startRound, endRound);
  }

  /// Pieces between tight bends.
  void AddPieces(const std::vector<Station>& stations, bool startRound, bool endRound)
  {
    const std::size_t last = stations.size() - 1;
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= last; ++i)
    {
      if (IsTight(stations[i - 1], stations[i]))
      {
        if (begin < i - 1)
        {
          this->AddPiece(stations, begin, i - 1, startRound || begin > 0, true);
        }
        // The tight part itself, with the directions of its own way.
        std::vector<Station> bend{ stations[i - 1], stations[i] };
        bend[0].Tangent = (bend[1].Place - bend[0].Place).normalized();
        bend[1].Tangent = bend[0].Tangent;
        this->AddPiece(bend, 0, 1, startRound || i > 1, endRound || i < last);
        begin = i;
      }
    }
    if (begin < last)
    {
      this->AddPiece(stations, begin, last, startRound || begin > 0, endRound);
    }
  }

  void AddPiece(const std::vector<Station>& stations, std::size_t first, std::size_t last,
    bool startRound, bool endRound)
  {
    PageChain left;
    PageChain right;
    for (std::size_t i = first; i <= last; ++i)
    {
      left.Points.push_back(stations[i].GetSide(1.0));
      right.Points.push_back(stations[first + last - i].GetSide(-1.0));
    }
    ThinChain(left, 0.25 * this->Settings.Tolerance);
    ThinChain(right, 0.25 * this->Settings.Tolerance);
    FitChain(left, this->Settings, this->Path);
    this->AddEnd(stations[last], 1.0, endRound);
    FitChain(right, this->Settings, this->Path, false);
    this->AddEnd(stations[first], -1.0, startRound);
    this->Path.Close();
  }

  void AddEnd(const Station& end, double sense, bool isRound)
  {
    // A point that is thinner than what can be seen needs no cap.
    if (isRound && end.Radius > 0.5 * this->Settings.Tolerance)
    {
      AddHalfCircle(end.Place, sense * end.Tangent, end.Radius, this->Path);
    }
  }

  const PageChain& Chain;
  std::size_t Size;
  FitSettings Settings;
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
    Outline(chain, settings, roundCaps, path).Add(FindTurns(chain, settings).Corners);
  }
}
}
