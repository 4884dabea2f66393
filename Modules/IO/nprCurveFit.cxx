// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCurveFit.h"

#include "nprChainTangents.h"
#include "nprCubicFit.h"

#include <vtkType.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace npr
{
namespace
{
// Radians. On the page, the tip of a narrow ellipse turns by this at most, however coarse it is;
// and what is a corner in the world is one on the page if it turns by this at least.
constexpr double LargestTurnOfCircle = 2.0;
constexpr double LeastCornerTurn = 0.14;

double Turn(const PagePoint& in, const PagePoint& out)
{
  return std::atan2(std::abs(in.x() * out.y() - in.y() * out.x()), in.dot(out));
}

/// Whether a chain turns at one of its points, in the world if it is from there, by so much that no
/// circle was meant: more than from side to side of a polygon with nine sides.
bool IsSharpInWorld(
  const PageChain& chain, std::size_t before, std::size_t i, std::size_t after, double pageTurn)
{
  constexpr double SharpTurn = 40.0 * 3.14159265358979323846 / 180.0;
  if (chain.World.empty())
  {
    return pageTurn > SharpTurn;
  }
  const Eigen::Vector3d in = chain.World[i] - chain.World[before];
  const Eigen::Vector3d out = chain.World[after] - chain.World[i];
  return in.dot(out) < std::cos(SharpTurn) * in.norm() * out.norm();
}

/// Looks along a chain from one of its points.
class Neighbours
{
public:
  Neighbours(const PageChain& chain, double reach)
    : Points(chain.Points), Closed(chain.Closed), Reach(reach)
  {
  }

  std::size_t Next(std::size_t i, int step) const
  {
    const std::size_t n = this->Points.size();
    return step > 0 ? (i + 1 == n ? 0 : i + 1) : (i == 0 ? n - 1 : i - 1);
  }

  /// Calls `visit(j)` for the points after `i`, in steps of `step`, that are within reach on the
  /// way along the chain. Returns the place where the reach ends, or else the chain.
  template<typename Visit>
  PagePoint Walk(std::size_t i, int step, const Visit& visit) const
  {
    const std::size_t n = this->Points.size();
    const std::size_t end = this->Closed ? i : step > 0 ? n - 1 : 0;
    double left = this->Reach;
    std::size_t here = i;
    do
    {
      const std::size_t there = this->Next(here, step);
      const PagePoint way = this->Points[there] - this->Points[here];
      const double length = way.norm();
      if (length > left)
      {
        return this->Points[here] + way * (left / length);
      }
      left -= length;
      here = there;
      if (here != i)
      {
        visit(here);
      }
    } while (here != end);
    return this->Points[here];
  }

private:
  const std::vector<PagePoint>& Points;
  bool Closed;
  double Reach;
};
}

//------------------------------------------------------------------------------
void ThinChain(PageChain& chain, double distance)
{
  const std::size_t n = chain.Points.size();
  if (n < 2)
  {
    return;
  }
  const double least = distance * distance;
  std::vector<std::size_t> kept{ 0 };
  for (std::size_t i = 1; i < n; ++i)
  {
    if ((chain.Points[i] - chain.Points[kept.back()]).squaredNorm() > least)
    {
      kept.push_back(i);
    }
  }
  if (chain.Closed)
  {
    while (kept.size() > 1 &&
      (chain.Points[kept.back()] - chain.Points[kept.front()]).squaredNorm() <= least)
    {
      kept.pop_back();
    }
    chain.Closed = kept.size() > 2;
  }
  else if (kept.back() != n - 1)
  {
    // The end stays where it is.
    if (kept.size() > 1)
    {
      kept.back() = n - 1;
    }
    else if (chain.Points[n - 1] != chain.Points[0])
    {
      kept.push_back(n - 1);
    }
  }
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    chain.Points[i] = chain.Points[kept[i]];
    if (!chain.Widths.empty())
    {
      chain.Widths[i] = chain.Widths[kept[i]];
    }
    if (!chain.World.empty())
    {
      chain.World[i] = chain.World[kept[i]];
    }
  }
  chain.Points.resize(kept.size());
  chain.Widths.resize(chain.Widths.empty() ? 0 : kept.size());
  chain.World.resize(chain.World.empty() ? 0 : kept.size());
}

//------------------------------------------------------------------------------
ChainTurns FindTurns(const PageChain& chain, const FitSettings& settings)
{
  const std::vector<PagePoint>& points = chain.Points;
  const std::size_t n = points.size();
  const std::size_t pieces = chain.Closed ? n : n - 1;
  ChainTurns turns{ std::vector<char>(n, 0), std::vector<char>(n, 0) };

  std::vector<double> angles(n, 0.0);
  std::vector<char> sharp(n, 0);
  std::vector<char> sharpInWorld(n, 0);
  std::vector<char> meant(n, 0);
  std::vector<double> foldings(n, -VTK_DOUBLE_MAX);
  const Neighbours near(chain, settings.GetReach());
  const auto ignore = [](std::size_t) {};
  for (std::size_t i = chain.Closed ? 0 : 1; i < pieces; ++i)
  {
    const std::size_t before = near.Next(i, -1);
    const std::size_t after = near.Next(i, 1);
    angles[i] = Turn(points[i] - points[before], points[after] - points[i]);
    sharpInWorld[i] = IsSharpInWorld(chain, before, i, after, angles[i]);
    const PagePoint in = points[i] - near.Walk(i, -1, ignore);
    const PagePoint out = near.Walk(i, 1, ignore) - points[i];
    foldings[i] = -in.dot(out);
    sharp[i] = -foldings[i] < settings.CornerCosine * in.norm() * out.norm();
    const bool isSparse = (points[i] - points[before]).norm() > settings.GetReach() &&
      (points[after] - points[i]).norm() > settings.GetReach();
    if (isSparse && !sharpInWorld[i] && angles[i] < LargestTurnOfCircle)
    {
      sharp[i] = 0; // a coarse circle, seen from its edge
    }
    meant[i] = isSparse && sharpInWorld[i] && angles[i] > LeastCornerTurn;
  }

  const auto isSharpOrEnd = [&](std::size_t i)
  { return sharpInWorld[i] || (!chain.Closed && (i == 0 || i + 1 == n)); };
  const auto getLength = [&](std::size_t i)
  { return (points[near.Next(i, 1)] - points[i]).norm(); };
  // Over the next two pieces, if there are two.
  const auto getWay = [&](std::size_t i, int step)
  {
    const std::size_t one = near.Next(i, step);
    const std::size_t two = near.Next(one, step);
    const std::size_t end = step > 0 ? n - 1 : 0;
    return !chain.Closed && (i == end || one == end)
      ? VTK_DOUBLE_MAX
      : (points[one] - points[i]).norm() + (points[two] - points[one]).norm();
  };
  for (std::size_t i = 0; i < pieces; ++i)
  {
    const std::size_t after = near.Next(i, 1);
    const double length = getLength(i);
    // How far an arc that turns by this angle leaves its chord.
    const double bend = length * std::max(angles[i], angles[after]) / 8;
    turns.Straight[i] = (bend > settings.BendTolerance && isSharpOrEnd(i) && isSharpOrEnd(after)) ||
      (bend > 2.0 * settings.Tolerance &&
        (getWay(i, -1) < 0.5 * length || getWay(after, 1) < 0.5 * length));
  }

  for (std::size_t i = chain.Closed ? 0 : 1; i < pieces; ++i)
  {
    const bool betweenStraights = turns.Straight[near.Next(i, -1)] && turns.Straight[i];
    // Of the points around a corner, the one where the chain folds most is it.
    bool most = sharp[i] != 0;
    if (most)
    {
      near.Walk(i, -1, [&](std::size_t j) { most = most && foldings[i] > foldings[j]; });
      near.Walk(i, 1, [&](std::size_t j) { most = most && foldings[i] >= foldings[j]; });
    }
    turns.Corners[i] = most || betweenStraights || meant[i];
  }
  return turns;
}

//------------------------------------------------------------------------------
void FitChain(const PageChain& chain, const FitSettings& settings, PagePath& path, bool move)
{
  const std::size_t n = chain.Points.size();
  if (n == 0)
  {
    return;
  }
  const ChainTurns turns = FindTurns(chain, settings);
  const std::size_t pieces = chain.Closed ? n : n - 1;

  // A closed chain begins at a corner, if it has one.
  std::size_t begin = 0;
  if (chain.Closed)
  {
    const auto corner = std::find(turns.Corners.begin(), turns.Corners.end(), 1);
    const auto straight = std::find(turns.Straight.begin(), turns.Straight.end(), 1);
    begin = corner != turns.Corners.end() ? corner - turns.Corners.begin()
      : straight != turns.Straight.end()  ? straight - turns.Straight.begin()
                                          : 0;
  }
  const auto point = [&](std::ptrdiff_t i) -> const PagePoint& { return chain.Points[i % n]; };
  // Where a section goes over into a straight piece, it takes that one's direction.
  const auto getStraightTangent = [&](std::size_t i, std::size_t piece)
  {
    return turns.Straight[piece] && !turns.Corners[i % n]
      ? GivenTangent((point(piece + 1) - point(piece)).normalized())
      : GivenTangent();
  };
  std::vector<PagePoint> section;

  if (move)
  {
    path.MoveTo(chain.Points[begin]);
  }
  else if ((path.Points.back() - chain.Points[begin]).norm() > 1e-9)
  {
    path.LineTo(chain.Points[begin]);
  }
  for (std::size_t first = begin; first < begin + pieces;)
  {
    if (turns.Straight[first % n])
    {
      path.LineTo(chain.Points[(first + 1) % n]);
      ++first;
      continue;
    }
    std::size_t last = first + 1;
    while (last < begin + pieces && !turns.Corners[last % n] && !turns.Straight[last % n])
    {
      ++last;
    }
    section.clear();
    for (std::size_t i = first; i <= last; ++i)
    {
      section.push_back(point(i));
    }

    GivenTangent start;
    GivenTangent end;
    if (last - first == n && !turns.Corners[begin] && !turns.Straight[begin])
    {
      // No seam: one tangent, from the points on both sides of it.
      start = ChainTangents(point, first + 1, first + 2 * n - 1, settings.Tolerance).Get(last);
      end = start;
    }
    else
    {
      start = getStraightTangent(first, (first + n - 1) % n);
      end = getStraightTangent(last, last % n);
    }
    FitSection(section, start, end, settings, path);
    first = last;
  }
  if (chain.Closed)
  {
    path.Close();
  }
}
}
