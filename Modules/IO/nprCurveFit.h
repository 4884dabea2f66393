// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCurveFit.h
 * @brief Cubic curves through, or near, the points of a chain on the page.
 *
 * The points are taken for samples of a curve that is smooth but for its corners. A corner is where
 * the chain turns by more than CornerAngle within a few tolerances; where it turns at all and does
 * so sharply in the world; and where two pieces meet that are meant to be straight. A piece is, if
 * a smooth curve through its ends would leave it by more than BendTolerance and both are sharp in
 * the world, or by more than two tolerances where it is twice as long as the next two pieces. So
 * boxes keep their edges from every side, and coarse circles become round.
 *
 * Between corners, cubic curves follow each other with common tangents; each passes all points
 * within Tolerance. A closed chain without corners has no seam.
 *
 * @par Thanks:
 * P. Schneider: An Algorithm for Automatically Fitting Digitized Curves, Graphics Gems, 1990.
 */
#ifndef nprCurveFit_h
#define nprCurveFit_h

#include "nprPagePath.h"

#include <vector>

namespace npr
{
struct FitSettings
{
  double Tolerance = 0.02;     // millimetres, positive
  double BendTolerance = 0.1;  // millimetres, at least Tolerance
  double CornerCosine = 0.707; // of the angle of a turn, beyond which it is a corner

  /// How far a corner's turn is looked for along the chain.
  double GetReach() const { return 5.0 * this->Tolerance; }
};

/// A chain without repeated points. A closed one does not repeat its first point.
struct PageChain
{
  std::vector<PagePoint> Points;
  std::vector<double> Widths; // one a point, or none
  /// The points before they came to the page, or none: what looks blunt there may be sharp here.
  std::vector<Eigen::Vector3d> World;
  bool Closed = false;
};

/// Drops points that are nearer to the last kept one than `distance`, but for the ends, and makes
/// an open chain of a closed one with less than three points left.
void ThinChain(PageChain& chain, double distance);

/// What the chain is at each of its points.
struct ChainTurns
{
  std::vector<char> Corners;  // 1 at a corner
  std::vector<char> Straight; // 1 where the piece from here to the next point is straight
};
ChainTurns FindTurns(const PageChain& chain, const FitSettings& settings);

/// Appends the fitted chain as one path, which starts with a move, if `move`, else with a line.
void FitChain(
  const PageChain& chain, const FitSettings& settings, PagePath& path, bool move = true);
}

#endif
