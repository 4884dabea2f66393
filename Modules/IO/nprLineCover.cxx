// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineCover.h"

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
constexpr double SmallestCell = 0.1; // millimetres
constexpr double MostCells = 4000.0; // in a row
constexpr int Sixteenths = 16;
constexpr double HalfTurn = 3.14159265358979323846;

/// A place of a chain: after this point, and how far on the way to the next.
struct Sample
{
  std::size_t Point;
  double T;
  double Length; // of the chain up to here
};

/// Calls visit(sample, place, along) at steps along a chain that is open.
template<typename Visit>
void Walk(const PageChain& chain, double step, const Visit& visit)
{
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < chain.Points.size(); ++i)
  {
    const PagePoint along = chain.Points[i + 1] - chain.Points[i];
    const double size = along.norm();
    const int parts = std::max(1, static_cast<int>(std::ceil(size / step)));
    for (int k = 0; k < parts; ++k)
    {
      const double t = (k + 0.5) / parts;
      visit(Sample{ i, t, length + t * size }, PagePoint(chain.Points[i] + t * along), along);
    }
    length += size;
  }
}

PageChain Open(const PageChain& chain)
{
  PageChain open = chain;
  if (open.Closed)
  {
    const auto repeatFirst = [](auto& values)
    {
      if (!values.empty())
      {
        values.push_back(values.front());
      }
    };
    repeatFirst(open.Points);
    repeatFirst(open.Widths);
    repeatFirst(open.World);
    open.Closed = false;
  }
  return open;
}

/// From one place of an open chain to another.
PageChain GetPart(const PageChain& chain, const Sample& from, const Sample& to)
{
  PageChain part;
  const auto take = [&](const auto& values, auto& taken)
  {
    if (values.empty())
    {
      return;
    }
    const auto at = [&values](const Sample& sample)
    {
      using Value = typename std::decay_t<decltype(values)>::value_type;
      const Value& before = values[sample.Point];
      return sample.T > 0.0 ? Value(before + sample.T * (values[sample.Point + 1] - before))
                            : before;
    };
    taken.push_back(at(from));
    taken.insert(taken.end(), values.begin() + from.Point + 1, values.begin() + to.Point + 1);
    if (to.T > 0.0)
    {
      taken.push_back(at(to));
    }
  };
  take(chain.Points, part.Points);
  take(chain.Widths, part.Widths);
  take(chain.World, part.World);
  return part;
}

/// Stretches of samples that are alike.
struct Run
{
  bool Covered;
  std::size_t Begin;
  std::size_t End; // behind the last

  double GetLength(const std::vector<Sample>& samples, double whole) const
  {
    return (this->End < samples.size() ? samples[this->End].Length : whole) -
      (this->Begin > 0 ? samples[this->Begin].Length : 0.0);
  }
};

std::vector<Run> MakeRuns(const std::vector<char>& covered)
{
  std::vector<Run> runs;
  for (std::size_t i = 0; i < covered.size(); ++i)
  {
    if (runs.empty() || runs.back().Covered != (covered[i] != 0))
    {
      runs.push_back({ covered[i] != 0, i, i });
    }
    runs.back().End = i + 1;
  }
  return runs;
}

/// Turns runs of one kind that are too short.
void Turn(std::vector<char>& covered, bool kind, const std::vector<Sample>& samples, double whole,
  double least)
{
  for (const Run& run : MakeRuns(covered))
  {
    if (run.Covered == kind && run.GetLength(samples, whole) < least)
    {
      std::fill(covered.begin() + run.Begin, covered.begin() + run.End, kind ? 0 : 1);
    }
  }
}
}

//------------------------------------------------------------------------------
LineCover::LineCover(const PageRectangle& area) : Corner(area.Least)
{
  const PagePoint size = area.GetSize();
  this->Cell = std::max(SmallestCell, size.maxCoeff() / MostCells);
  this->Columns = std::max(1, static_cast<int>(std::ceil(size.x() / this->Cell)));
  this->Rows = std::max(1, static_cast<int>(std::ceil(size.y() / this->Cell)));
  this->Marks.assign(static_cast<std::size_t>(this->Columns) * this->Rows, 0);
}

//------------------------------------------------------------------------------
LineCover::Directions LineCover::GetDirections(const PagePoint& along, int spread)
{
  const double turn = std::atan2(along.y(), along.x()) / HalfTurn + 1.0;
  const int sixteenth = static_cast<int>(turn * Sixteenths) % Sixteenths;
  int directions = 0;
  for (int i = -spread; i <= spread; ++i)
  {
    directions |= 1 << (sixteenth + i + Sixteenths) % Sixteenths;
  }
  return static_cast<Directions>(directions);
}

//------------------------------------------------------------------------------
void LineCover::Mark(const PageChain& chain)
{
  Walk(Open(chain), 0.5 * this->Cell,
    [this](const Sample&, const PagePoint& place, const PagePoint& along)
    {
      const PagePoint cell = (place - this->Corner) / this->Cell;
      const int x = static_cast<int>(std::floor(cell.x()));
      const int y = static_cast<int>(std::floor(cell.y()));
      if (x >= 0 && y >= 0 && x < this->Columns && y < this->Rows)
      {
        this->Marks[static_cast<std::size_t>(y) * this->Columns + x] |= GetDirections(along, 0);
      }
    });
}

//------------------------------------------------------------------------------
bool LineCover::IsCovered(const PagePoint& place, Directions directions, double distance) const
{
  const PagePoint cell = (place - this->Corner) / this->Cell;
  const double reach = distance / this->Cell;
  const int firstX = std::max(0, static_cast<int>(std::floor(cell.x() - reach)));
  const int firstY = std::max(0, static_cast<int>(std::floor(cell.y() - reach)));
  const int lastX = std::min(this->Columns - 1, static_cast<int>(std::floor(cell.x() + reach)));
  const int lastY = std::min(this->Rows - 1, static_cast<int>(std::floor(cell.y() + reach)));
  for (int y = firstY; y <= lastY; ++y)
  {
    for (int x = firstX; x <= lastX; ++x)
    {
      const PagePoint way = PagePoint(x + 0.5, y + 0.5) - cell;
      if ((this->Marks[static_cast<std::size_t>(y) * this->Columns + x] & directions) != 0 &&
        way.norm() <= reach)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::vector<PageChain> LineCover::Cut(const PageChain& chain, double distance, double least) const
{
  const PageChain open = Open(chain);
  std::vector<Sample> samples;
  std::vector<char> covered;
  double whole = 0.0;
  for (std::size_t i = 0; i + 1 < open.Points.size(); ++i)
  {
    whole += (open.Points[i + 1] - open.Points[i]).norm();
  }
  Walk(open, 2.0 * this->Cell,
    [&](const Sample& sample, const PagePoint& place, const PagePoint& along)
    {
      samples.push_back(sample);
      covered.push_back(this->IsCovered(place, GetDirections(along, 1), distance) ? 1 : 0);
    });
  // Where lines only touch, or cross, neither ends.
  Turn(covered, true, samples, whole, least);
  if (std::find(covered.begin(), covered.end(), 1) == covered.end())
  {
    return { chain };
  }
  Turn(covered, false, samples, whole, least);
  std::vector<PageChain> parts;
  for (const Run& run : MakeRuns(covered))
  {
    if (!run.Covered)
    {
      const Sample begin = run.Begin > 0 ? samples[run.Begin] : Sample{ 0, 0.0, 0.0 };
      const Sample end =
        run.End < samples.size() ? samples[run.End] : Sample{ open.Points.size() - 1, 0.0, whole };
      parts.push_back(GetPart(open, begin, end));
    }
  }
  return parts;
}
}
