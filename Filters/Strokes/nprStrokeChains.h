// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprStrokeChains.h
 * @brief From polylines to clean chains of points, and to the smooth parts between their corners.
 */
#ifndef nprStrokeChains_h
#define nprStrokeChains_h

#include "nprSplines.h"
#include "nprVTKCompat.h"
#include "vtkNPRFiltersStrokesModule.h"

#include <vtkType.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkIdList;
class vtkPoints;
VTK_ABI_NAMESPACE_END

namespace npr
{
struct StrokePoint
{
  Vector3 Position;
  vtkIdType Id;
};

struct StrokeChain
{
  std::vector<StrokePoint> Points;
  bool Closed = false; // the last point then joins the first, which is not repeated
};

/// The finite runs of a polyline, without repeated points. A run of three different points or more
/// whose last is at the place of its first is closed, if it is the whole polyline.
VTKNPRFILTERSSTROKES_EXPORT std::vector<StrokeChain> MakeStrokeChains(
  vtkPoints* points, vtkIdList* ids);

/// What is smooth of a chain: spans of a spline over its points from one corner to the next.
class SplinePart
{
public:
  SplinePart(const StrokeChain& chain, std::size_t first, std::size_t size, bool closed)
    : Chain(&chain), First(first), Size(static_cast<std::ptrdiff_t>(size)), Closed(closed)
  {
  }

  /// Whether it is a whole closed chain; its spans then wrap.
  bool IsClosed() const { return this->Closed; }

  /// Spans have the numbers from this one on, before GetEndSpan(). The B-spline reaches an open end
  /// only if that end counts three times: one more span.
  std::ptrdiff_t GetFirstSpan(SplineKind kind) const
  {
    return kind == SplineKind::BSpline && !this->Closed ? -1 : 0;
  }
  std::ptrdiff_t GetEndSpan(SplineKind kind) const
  {
    return this->Size - (this->Closed ? 0 : 1) - this->GetFirstSpan(kind);
  }

  /// A span runs from (near) the point of its number to the next one. Beyond open ends, these are
  /// repeated.
  const StrokePoint& GetPoint(std::ptrdiff_t i) const
  {
    const std::ptrdiff_t within = this->Closed
      ? (i + this->Size) % this->Size
      : std::min(std::max<std::ptrdiff_t>(i, 0), this->Size - 1);
    return this->Chain
      ->Points[(this->First + static_cast<std::size_t>(within)) % this->Chain->Points.size()];
  }

private:
  const StrokeChain* Chain;
  std::size_t First;
  std::ptrdiff_t Size;
  bool Closed;
};

/// The points of one span of a part after another.
class SpanPoints
{
public:
  SpanPoints(const SplinePart& part, std::ptrdiff_t span) : Part(part), Next(span + 3)
  {
    for (std::ptrdiff_t i = 0; i < 4; ++i)
    {
      this->Points[i] = &part.GetPoint(span - 1 + i);
    }
  }

  void Advance()
  {
    std::copy(this->Points.begin() + 1, this->Points.end(), this->Points.begin());
    this->Points.back() = &this->Part.GetPoint(this->Next++);
  }

  const StrokePoint& GetStart() const { return *this->Points[1]; }
  const StrokePoint& GetEnd() const { return *this->Points[2]; }
  CubicSpan MakeSpan(const SplineBasis& basis) const
  {
    return npr::MakeSpan(basis,
      { this->Points[0]->Position, this->Points[1]->Position, this->Points[2]->Position,
        this->Points[3]->Position });
  }

private:
  const SplinePart& Part;
  std::ptrdiff_t Next;
  std::array<const StrokePoint*, 4> Points;
};

/// From an angle in degrees to what SplitAtCorners() takes; no turn is a corner at 180 degrees.
VTKNPRFILTERSSTROKES_EXPORT double GetCornerCosine(double angle);

/// The parts of a chain between points where it turns by more than an angle; beside a span so long
/// that a spline would overshoot the other, by more than half of it, or not at all. A closed chain
/// with corners is opened at the first one; without, it is one closed part.
/// A point is a corner, too, where a spline would leave the spans beside it by more than a
/// distance; 0: however far.
VTKNPRFILTERSSTROKES_EXPORT std::vector<SplinePart> SplitAtCorners(
  const StrokeChain& chain, double cornerCosine, double maximumBulge = 0.0);
}

#endif
