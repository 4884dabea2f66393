// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLineCover.h
 * @brief Which places of a page have a line already, and in which direction it runs.
 */
#ifndef nprLineCover_h
#define nprLineCover_h

#include "nprCurveFit.h"
#include "nprPageDrawing.h"

#include <cstdint>
#include <vector>

namespace npr
{
/**
 * Hidden lines that run along other lines, which they would touch, only blur them: dashes beside a
 * line look like teeth, and two dashed lines in one place like one that is not dashed.
 */
class LineCover
{
public:
  explicit LineCover(const PageRectangle& area);

  void Mark(const PageChain& chain);

  /// What of a chain is farther than a distance from all marked lines that run as it does. What is
  /// shorter than `least` neither cuts the chain nor remains of it where it is cut.
  std::vector<PageChain> Cut(const PageChain& chain, double distance, double least) const;

private:
  using Directions = std::uint16_t; // a bit for each sixteenth of half a turn

  static Directions GetDirections(const PagePoint& along, int spread);
  bool IsCovered(const PagePoint& place, Directions directions, double distance) const;

  double Cell;
  PagePoint Corner;
  int Columns;
  int Rows;
  std::vector<Directions> Marks;
};
}

#endif
