// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCrossingMaker.h"

#include "nprHermite.h"
#include "vtkNPRLineDefinition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace npr
{
//------------------------------------------------------------------------------
CrossingMaker::CrossingMaker(
  const LineSurface& surface, const std::vector<float>& levels, const FieldValues& values)
  : Surface(surface), Levels(levels), Values(values)
{
}

//------------------------------------------------------------------------------
void CrossingMaker::Add(Index triangle, std::vector<LineCrossing>& crossings) const
{
  if (this->Values.GetAxes())
  {
    this->AddByAxes(triangle, crossings);
    return;
  }
  const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(triangle);
  const FieldValues::Side* const sides = this->Values.GetSides();
  const std::size_t low = std::min({ sides[c[0]], sides[c[1]], sides[c[2]] });
  const std::size_t high = std::max({ sides[c[0]], sides[c[1]], sides[c[2]] });
  for (std::size_t level = low; level < high; ++level)
  {
    this->AddAtLevel(triangle, level, crossings);
  }
}

//------------------------------------------------------------------------------
void CrossingMaker::AddAtLevel(
  Index triangle, std::size_t level, std::vector<LineCrossing>& crossings) const
{
  constexpr int next[4] = { 1, 2, 0, 1 };
  const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(triangle);
  const FieldValues::Side* const sides = this->Values.GetSides();
  const double value = this->Levels[level];
  std::array<bool, 3> isAbove;
  std::array<double, 3> distance;
  for (int i = 0; i < 3; ++i)
  {
    isAbove[i] = sides[c[i]] > level;
    distance[i] = std::abs(this->Values[c[i]] - value);
  }
  // One corner is alone on its side. The line leaves by the edge after it if it is above, and else
  // by the edge before it: so what is above is on the left.
  const int alone = isAbove[0] == isAbove[1] ? 2 : isAbove[0] == isAbove[2] ? 1 : 0;
  const int after = next[alone];
  const int before = next[alone + 1];
  const auto divide = [](double from, double to) { return static_cast<float>(from / (from + to)); };
  LineCrossing crossing;
  crossing.Triangle = triangle;
  crossing.Level = static_cast<std::uint16_t>(level);
  crossing.Test = { 1.0f, 1.0f };
  if (isAbove[alone])
  {
    crossing.Places = { static_cast<std::uint8_t>(alone),
      static_cast<std::uint8_t>(before | LineCrossing::Reversed) };
    crossing.T = { divide(distance[alone], distance[after]),
      divide(distance[alone], distance[before]) };
  }
  else
  {
    crossing.Places = { static_cast<std::uint8_t>(before),
      static_cast<std::uint8_t>(alone | LineCrossing::Reversed) };
    crossing.T = { divide(distance[before], distance[alone]),
      divide(distance[after], distance[alone]) };
  }
  // From a vertex to itself is no line.
  if (crossing.T[0] != 0.0f || crossing.T[1] != 0.0f ||
    (!isAbove[alone] && this->Surface.GetWelded(c[before]) != this->Surface.GetWelded(c[after])))
  {
    crossings.push_back(crossing);
  }
}

//------------------------------------------------------------------------------
void CrossingMaker::AddByAxes(Index triangle, std::vector<LineCrossing>& crossings) const
{
  const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(triangle);
  const auto rank = [this](Index point)
  { return std::make_pair(std::abs(this->Values[point]), this->Surface.GetWelded(point)); };
  LineCrossing crossing;
  crossing.Triangle = triangle;
  crossing.Level = 0;
  crossing.Test = { 1.0f, 1.0f };
  std::array<Index, 2> vertices = { -1, -1 };
  int found = 0;
  for (int e = 0; e < 3; ++e)
  {
    if (!this->Values.GetAxes()->IsCrossed(3 * triangle + e, this->Values.Get()))
    {
      continue;
    }
    const int n = found++;
    const Index start = c[e];
    const Index stop = c[e == 2 ? 0 : e + 1];
    const bool isReversed = rank(stop) < rank(start);
    const double from = std::abs(double(this->Values[isReversed ? stop : start]));
    const double sum = from + std::abs(double(this->Values[isReversed ? start : stop]));
    // Both ends are 0 only where axes turn against their order in space.
    crossing.T[n] = sum > 0.0 ? static_cast<float>(from / sum) : 0.5f;
    crossing.Places[n] = static_cast<std::uint8_t>(e + (isReversed ? LineCrossing::Reversed : 0));
    if (crossing.T[n] == 0.0f)
    {
      vertices[n] = this->Surface.GetWelded(isReversed ? stop : start);
    }
  }
  // From a vertex to itself is no line.
  if (vertices[0] < 0 || vertices[0] != vertices[1])
  {
    crossings.push_back(crossing);
  }
}

//------------------------------------------------------------------------------
void CrossingMaker::UseSlopes(const vtkNPRLineDefinition& definition, const LineView& view,
  std::vector<LineCrossing>& crossings) const
{
  std::vector<Index> from;
  std::vector<Index> to;
  for (const LineCrossing& crossing : crossings)
  {
    for (int n = 0; n < 2; ++n)
    {
      const LineNode node = crossing.GetNode(this->Surface, n);
      from.push_back(node.From);
      to.push_back(node.To);
    }
  }
  std::vector<float> atFrom(from.size());
  std::vector<float> atTo(from.size());
  definition.EvaluateSlopes(this->Surface, view, from.data(), to.data(),
    static_cast<vtkIdType>(from.size()), atFrom.data(), atTo.data());
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    LineCrossing& crossing = crossings[i / 2];
    float& t = crossing.T[i % 2];
    // Along seams, jumps are where the values say.
    const bool isInside =
      this->Surface.GetTwin(crossing.GetHalfEdge(static_cast<int>(i % 2))) != LineSurface::NoTwin;
    if (t != 0.0f && isInside)
    {
      const double level = this->Levels[crossing.Level];
      t = static_cast<float>(FindHermiteRoot(
        this->Values[from[i]] - level, this->Values[to[i]] - level, atFrom[i], atTo[i], t));
    }
  }
}

//------------------------------------------------------------------------------
void CrossingMaker::SetTests(std::vector<LineCrossing>& crossings) const
{
  std::size_t kept = 0;
  for (LineCrossing& crossing : crossings)
  {
    for (int n = 0; n < 2; ++n)
    {
      const LineNode node = crossing.GetNode(this->Surface, n);
      const float from = this->Values.GetTest(node.From);
      crossing.Test[n] = from + node.T * (this->Values.GetTest(node.To) - from);
    }
    // Also false where the test is not a number.
    if (std::max(crossing.Test[0], crossing.Test[1]) > 0.0f && std::isfinite(crossing.Test[0]) &&
      std::isfinite(crossing.Test[1]))
    {
      crossings[kept++] = crossing;
    }
  }
  crossings.resize(kept);
}
}
