// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCrossingMaker.h"

#include "nprHermite.h"
#include "nprLanes.h"
#include "vtkNPRLineDefinition.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npr
{
//------------------------------------------------------------------------------
CrossingMaker::CrossingMaker(
  const LineSurface& surface, const std::vector<float>& levels, const FieldValues& values)
  : Surface(surface), Levels(levels), Values(values)
{
}

//------------------------------------------------------------------------------
void CrossingMaker::Add(
  const std::vector<CrossedTriangle>& crossed, std::vector<LineCrossing>& crossings) const
{
  for (const CrossedTriangle& triangle : crossed)
  {
    this->Add(triangle, crossings);
  }
}

//------------------------------------------------------------------------------
void CrossingMaker::AddAccepted(
  const std::vector<CrossedTriangle>& crossed, std::vector<LineCrossing>& crossings) const
{
  // What is accepted is as good as random, so that branches would be slow, and triangles lie far
  // apart in memory.
  constexpr std::size_t ahead = 16;
  std::array<CrossedTriangle, 128> accepted;
  for (std::size_t first = 0; first < crossed.size(); first += accepted.size())
  {
    const std::size_t last = std::min(first + accepted.size(), crossed.size());
    std::size_t size = 0;
    for (std::size_t i = first; i < last; ++i)
    {
      const CrossedTriangle& later = crossed[std::min(i + ahead, crossed.size() - 1)];
      Prefetch(&this->Surface.GetMesh().GetTriangle(later.Triangle));
      accepted[size] = crossed[i];
      size += this->MayBeAccepted(crossed[i].Triangle);
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Add(accepted[i], crossings);
    }
  }
}

//------------------------------------------------------------------------------
// False where the test accepts nothing of a triangle.
bool CrossingMaker::MayBeAccepted(Index triangle) const
{
  const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(triangle);
  return (this->Values.GetTest(c[0]) > 0.0f) | (this->Values.GetTest(c[1]) > 0.0f) |
    (this->Values.GetTest(c[2]) > 0.0f);
}

//------------------------------------------------------------------------------
void CrossingMaker::Add(const CrossedTriangle& crossed, std::vector<LineCrossing>& crossings) const
{
  if (this->Values.GetAxes())
  {
    this->AddByAxes(crossed, crossings);
    return;
  }
  const Index triangle = crossed.Triangle;
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
  // Which corners are above is as good as random, so that branches would be slow. With bit i for
  // corner i: the edge that leads from above to below, and the one that leads back. From the first
  // to the second, what is above is on the left.
  struct Way
  {
    int Down;
    int Up;
  };
  constexpr std::array<Way, 8> ways = { { { 0, 0 }, { 0, 2 }, { 1, 0 }, { 1, 2 }, { 2, 1 },
    { 0, 1 }, { 2, 0 }, { 0, 0 } } };
  constexpr std::array<int, 3> next = { 1, 2, 0 };
  const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(triangle);
  const FieldValues::Side* const sides = this->Values.GetSides();
  const double value = this->Levels[level];
  std::size_t above = 0;
  std::array<double, 3> distance;
  for (int i = 0; i < 3; ++i)
  {
    above |= std::size_t(sides[c[i]] > level) << i;
    distance[i] = std::abs(this->Values[c[i]] - value);
  }
  const auto [down, up] = ways[above];
  // Always from the end above.
  const auto divide = [&](int from, int to)
  { return static_cast<float>(distance[from] / (distance[from] + distance[to])); };
  LineCrossing crossing;
  crossing.Triangle = triangle;
  crossing.Level = static_cast<std::uint16_t>(level);
  crossing.Test = { 1.0f, 1.0f };
  crossing.Places = { static_cast<std::uint8_t>(down),
    static_cast<std::uint8_t>(up | LineCrossing::Reversed) };
  crossing.T = { divide(down, next[down]), divide(next[up], up) };
  // From a vertex to itself is no line.
  if (crossing.T[0] != 0.0f || crossing.T[1] != 0.0f ||
    this->Surface.GetWelded(c[down]) != this->Surface.GetWelded(c[next[up]]))
  {
    crossings.push_back(crossing);
  }
}

//------------------------------------------------------------------------------
void CrossingMaker::AddByAxes(
  const CrossedTriangle& crossed, std::vector<LineCrossing>& crossings) const
{
  const TriangleMesh::Triangle& c = this->Surface.GetMesh().GetTriangle(crossed.Triangle);
  LineCrossing crossing;
  crossing.Triangle = crossed.Triangle;
  crossing.Level = 0;
  crossing.Test = { 1.0f, 1.0f };
  std::array<Index, 2> vertices = { -1, -1 };
  const std::array<int, 2> edges = { (crossed.Edges & 1u) != 0 ? 0 : 1,
    (crossed.Edges & 4u) != 0 ? 2 : 1 };
  for (int n = 0; n < 2; ++n)
  {
    const int e = edges[n];
    const Index start = c[e];
    const Index stop = c[e == 2 ? 0 : e + 1];
    const double atStart = std::abs(double(this->Values[start]));
    const double atStop = std::abs(double(this->Values[stop]));
    const bool isReversed = (atStop < atStart) |
      (atStop == atStart && this->Surface.GetWelded(stop) < this->Surface.GetWelded(start));
    const double sum = atStart + atStop;
    // Both ends are 0 only where axes turn against their order in space.
    crossing.T[n] = sum > 0.0 ? static_cast<float>(std::min(atStart, atStop) / sum) : 0.5f;
    crossing.Places[n] = static_cast<std::uint8_t>(e | (isReversed ? LineCrossing::Reversed : 0));
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
