// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprChainTangents.h
 * @brief Tangents of a smooth run of points, which may be noisy up to a tolerance.
 */
#ifndef nprChainTangents_h
#define nprChainTangents_h

#include "nprPagePath.h"

#include <cmath>
#include <cstddef>

namespace npr
{
/**
 * @class ChainTangents
 * @brief Looks at points from `First` to `Last` of a chain, given by a function of their number.
 *
 * A tangent is taken over a reach that starts with a few tolerances, and doubles as long as the
 * points within lie on one straight line but for half the tolerance: where points are dense
 * and noisy, one that is next to another says little.
 */
template<typename GetPoint>
class ChainTangents
{
public:
  ChainTangents(const GetPoint& point, std::ptrdiff_t first, std::ptrdiff_t last, double tolerance)
    : Point(point), First(first), Last(last), Tolerance(tolerance)
  {
  }

  /// The unit vector along the chain at a point; at the first and last ones, of what is between.
  PagePoint Get(std::ptrdiff_t i) const
  {
    return i == this->First ? this->GetAtEnd(i, 1)
      : i == this->Last     ? PagePoint(-this->GetAtEnd(i, -1))
                            : this->GetInside(i);
  }

private:
  static constexpr int Doublings = 6;

  /// The first point from `i` on that is out of reach, or the last one.
  std::ptrdiff_t Find(std::ptrdiff_t from, std::ptrdiff_t i, int step, double reach) const
  {
    const std::ptrdiff_t end = step > 0 ? this->Last : this->First;
    while (from != end && (from == i || (this->Point(from) - this->Point(i)).norm() < reach))
    {
      from += step;
    }
    return from;
  }

  bool IsBetween(std::ptrdiff_t i, std::ptrdiff_t a, std::ptrdiff_t b) const
  {
    const PagePoint chord = this->Point(b) - this->Point(a);
    const PagePoint off = this->Point(i) - this->Point(a);
    const double along = off.dot(chord);
    return std::abs(off.x() * chord.y() - off.y() * chord.x()) <=
      0.5 * this->Tolerance * chord.norm() &&
      along > 0.0 && along < chord.squaredNorm();
  }

  PagePoint GetInside(std::ptrdiff_t i) const
  {
    double reach = 4.0 * this->Tolerance;
    std::ptrdiff_t before = this->Find(i, i, -1, reach);
    std::ptrdiff_t after = this->Find(i, i, 1, reach);
    for (int k = 0; k < Doublings && before != this->First && after != this->Last; ++k)
    {
      reach *= 2.0;
      const std::ptrdiff_t farBefore = this->Find(before, i, -1, reach);
      const std::ptrdiff_t farAfter = this->Find(after, i, 1, reach);
      if (!this->IsBetween(before, farBefore, farAfter) ||
        !this->IsBetween(i, farBefore, farAfter) || !this->IsBetween(after, farBefore, farAfter))
      {
        break;
      }
      before = farBefore;
      after = farAfter;
    }
    // Of the circle through three points.
    const PagePoint in = this->Point(i) - this->Point(before);
    const PagePoint out = this->Point(after) - this->Point(i);
    const double inLength = in.norm();
    const double outLength = out.norm();
    const PagePoint sum = in * (outLength / inLength) + out * (inLength / outLength);
    return (sum.norm() > 1e-9 * (inLength + outLength) ? sum : in).normalized();
  }

  /// Away from the end.
  PagePoint GetAtEnd(std::ptrdiff_t i, int step) const
  {
    const std::ptrdiff_t end = step > 0 ? this->Last : this->First;
    double reach = 4.0 * this->Tolerance;
    std::ptrdiff_t one = this->Find(i, i, step, reach);
    std::ptrdiff_t two = one == end ? one : this->Find(one + step, i, step, 2.0 * reach);
    for (int k = 0; k < Doublings && two != end; ++k)
    {
      reach *= 2.0;
      const std::ptrdiff_t three = this->Find(two, i, step, 2.0 * reach);
      if (!this->IsBetween(one, i, three) || !this->IsBetween(two, i, three))
      {
        break;
      }
      one = two;
      two = three;
    }
    // Of a circle, too.
    const PagePoint first = this->Point(one) - this->Point(i);
    const PagePoint second = this->Point(two) - this->Point(one);
    const double a = first.norm();
    const double b = second.norm();
    if (!(b > 0.0))
    {
      return first.normalized();
    }
    const PagePoint bent = first / a + (first / a - second / b) * (a / (a + b));
    return (bent.dot(first) > 0.0 ? bent : first).normalized();
  }

  const GetPoint& Point;
  std::ptrdiff_t First;
  std::ptrdiff_t Last;
  double Tolerance;
};
}

#endif
