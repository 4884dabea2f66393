// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStrokeChains.h"

#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
bool IsSamePlace(const Vector3& a, const Vector3& b)
{
  return !(vtkMath::Distance2BetweenPoints(a.data(), b.data()) > 0);
}

/// Beside spans that are so much shorter, a spline overshoots: its tangent, half the way from one
/// neighbour to the other, is more than three times a span (Fritsch, Carlson 1980).
constexpr double LongestReach = 6.0;
/// The cosine of a turn that can not be seen: 5 degrees.
constexpr double Straight = 0.9962;

/// At the ends of spans of one length, which turn alike, the distance of a spline from the middle
/// of a span, as a share of that length times the sine of the turn.
constexpr double ShareOfBulge = 0.125;

/// Whether a chain from a over b to c turns by more than an angle. Where a spline would overshoot,
/// half of the angle suffices, and so does no turn at all: there, the parts of a spline meet
/// smoothly even so.
bool IsCorner(
  const Vector3& a, const Vector3& b, const Vector3& c, double cosine, double maximumBulge)
{
  Vector3 in, out;
  vtkMath::Subtract(b.data(), a.data(), in.data());
  vtkMath::Subtract(c.data(), b.data(), out.data());
  const double inLength = vtkMath::Norm(in.data());
  const double outLength = vtkMath::Norm(out.data());
  const double lengths = inLength * outLength;
  const double turn = lengths > 0 ? vtkMath::Dot(in.data(), out.data()) / lengths : 1.0;
  if (turn < cosine)
  {
    return true;
  }
  if (maximumBulge > 0.0 &&
    ShareOfBulge * std::max(inLength, outLength) * std::sqrt(std::max(1.0 - turn * turn, 0.0)) >
      maximumBulge)
  {
    return true;
  }
  const double longestReach = LongestReach * std::min(inLength, outLength);
  if (turn > Straight)
  {
    return cosine >= -1.0 && inLength + outLength > longestReach;
  }
  // By the cosine of twice the turn; unless no turn is a corner.
  const bool turnsHalf = cosine >= -1.0 && (turn < 0.0 || 2.0 * turn * turn - 1.0 < cosine);
  return turnsHalf && std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), c.data())) > longestReach;
}
}

//------------------------------------------------------------------------------
std::vector<StrokeChain> MakeStrokeChains(vtkPoints* points, vtkIdList* ids)
{
  std::vector<StrokeChain> chains(1);
  chains[0].Points.reserve(ids->GetNumberOfIds());
  bool cut = false;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    StrokePoint point;
    point.Id = ids->GetId(i);
    points->GetPoint(point.Id, point.Position.data());
    if (!std::isfinite(point.Position[0]) || !std::isfinite(point.Position[1]) ||
      !std::isfinite(point.Position[2]))
    {
      cut = true;
      if (!chains.back().Points.empty())
      {
        chains.emplace_back();
      }
      continue;
    }
    std::vector<StrokePoint>& chain = chains.back().Points;
    if (chain.empty() || !IsSamePlace(chain.back().Position, point.Position))
    {
      chain.push_back(point);
    }
  }
  if (!cut && chains[0].Points.size() > 3 &&
    IsSamePlace(chains[0].Points.front().Position, chains[0].Points.back().Position))
  {
    chains[0].Points.pop_back();
    chains[0].Closed = true;
  }
  return chains;
}

//------------------------------------------------------------------------------
double GetCornerCosine(double angle)
{
  // However the cosine of a turn is rounded.
  return angle < 180.0 ? std::cos(vtkMath::RadiansFromDegrees(angle)) : -2.0;
}

//------------------------------------------------------------------------------
std::vector<SplinePart> SplitAtCorners(
  const StrokeChain& chain, double cornerCosine, double maximumBulge)
{
  const std::size_t n = chain.Points.size();
  std::vector<std::size_t> corners;
  for (std::size_t i = chain.Closed ? 0 : 1; i < (chain.Closed ? n : n - 1); ++i)
  {
    if (IsCorner(chain.Points[i > 0 ? i - 1 : n - 1].Position, chain.Points[i].Position,
          chain.Points[i + 1 < n ? i + 1 : 0].Position, cornerCosine, maximumBulge))
    {
      corners.push_back(i);
    }
  }
  std::vector<SplinePart> parts;
  if (chain.Closed && corners.empty())
  {
    parts.emplace_back(chain, 0, n, true);
    return parts;
  }
  // A closed chain is opened at its first corner.
  const std::size_t begin = chain.Closed ? corners.front() : 0;
  if (chain.Closed)
  {
    corners.erase(corners.begin());
  }
  corners.push_back(chain.Closed ? begin + n : n - 1);
  std::size_t first = begin;
  for (std::size_t corner : corners)
  {
    parts.emplace_back(chain, first, corner - first + 1, false);
    first = corner;
  }
  return parts;
}
}
