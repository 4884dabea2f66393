// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprCornerAreas_h
#define nprCornerAreas_h

#include <array>

namespace npr
{
/**
 * Mixed Voronoi areas of a triangle's corners (Meyer et al. 2003): they add up to the area, and
 * each is the part of the triangle that is nearest to its corner, but for obtuse triangles.
 *
 * @param dots of the two edges that leave each corner
 * @param squares of the edges opposite the corners
 * @param doubleArea not zero
 */
template<typename Real>
std::array<Real, 3> ComputeCornerAreas(
  const std::array<Real, 3>& dots, const std::array<Real, 3>& squares, Real doubleArea)
{
  for (int i = 0; i < 3; ++i)
  {
    if (dots[i] < Real(0))
    {
      std::array<Real, 3> areas;
      areas.fill(Real(0.125) * doubleArea);
      areas[i] *= Real(2);
      return areas;
    }
  }
  // An eighth of each square times the cotangent of the angle opposite.
  const Real scale = Real(0.125) / doubleArea;
  const Real shares[3] = { scale * dots[0] * squares[0], scale * dots[1] * squares[1],
    scale * dots[2] * squares[2] };
  return { shares[1] + shares[2], shares[2] + shares[0], shares[0] + shares[1] };
}
}

#endif
