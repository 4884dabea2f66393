// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprRandomSeeds_h
#define nprRandomSeeds_h

#include "nprLineSurface.h"
#include "vtkNPRFiltersLinesModule.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace npr
{
/**
 * @class RandomSeeds
 * @brief Finds triangles with lines from a few that are picked, and those of the view before.
 *
 * L. Markosian, M. Kowalski, S. Trychin, L. Bourdev, D. Goldstein, J. Hughes, "Real-time
 * nonphotorealistic rendering", SIGGRAPH 1997: triangles are picked with a chance that grows with
 * how much the surface turns there; from one without a line it goes on downhill for some triangles,
 * towards smaller values of the field; from one with a line it follows the line both ways. Short
 * lines may be missed.
 *
 * Each call goes on in the sequence of random numbers, which always starts alike.
 */
class VTKNPRFILTERSLINES_EXPORT RandomSeeds
{
public:
  using Index = TriangleMesh::Index;

  /// \p candidates are the triangles to pick from; the surface, which has its normals or not, must
  /// outlive this.
  RandomSeeds(const LineSurface& surface, const std::vector<Index>& candidates);

  /// Says whether a line crosses a triangle, and how far its corners are from it: the larger two
  /// numbers are on the edge to leave by, to get closer.
  struct Answer
  {
    bool IsCrossed;
    std::array<float, 3> Distances;
  };
  using Ask = std::function<Answer(Index triangle)>;

  /// The triangles found, in ascending order. Begins at `count` that are picked and at those that
  /// the last call returned.
  const std::vector<Index>& Find(std::size_t count, const Ask& ask);

private:
  void Follow(Index triangle, const Ask& ask);

  const LineSurface& Surface;
  std::vector<Index> Candidates;
  std::vector<double> Chances; // each plus all before
  std::vector<unsigned char> Found;
  std::vector<Index> Open;
  std::vector<Index> Triangles;
  std::mt19937 Random;
};
}

#endif
