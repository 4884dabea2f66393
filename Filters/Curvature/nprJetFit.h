// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprJetFit.h
 * @brief A polynomial height over a plane, fitted to points by weighted least squares.
 */
#ifndef nprJetFit_h
#define nprJetFit_h

#include "nprTangentFrame.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace npr
{
/// The coefficients of 1; x, y; xx, xy, yy; xxx, xxy, xyy, yyy; ... up to degree 4.
using JetCoefficients = std::array<double, 15>;

inline constexpr int CountCoefficients(int degree)
{
  return (degree + 1) * (degree + 2) / 2;
}

/**
 * @class JetFit
 * @brief Gathers points, then solves.
 *
 * The normal equations of polynomials consist of few numbers: the sums of w x^a y^b over the
 * points, 45 for degree 4 instead of the 120 of the matrix, so that a fit takes about 60 sums a
 * point.
 */
class JetFit
{
public:
  /// Two points side by side, as the processor adds them.
  using Lanes = Eigen::Array2d;

  /// All pairs must then be set.
  void Start(std::size_t numberOfPairs) { this->Pairs.resize(numberOfPairs); }
  /// Coordinates and weights are best of about 1. For one point alone the other's weight is zero.
  void Set(std::size_t i, const Lanes& x, const Lanes& y, const Lanes& z, const Lanes& weight)
  {
    Pair& pair = this->Pairs[i];
    pair.X = x;
    pair.Y = y;
    pair.Z = z;
    pair.W = weight;
  }

  /**
   * Fits the polynomial of the greatest degree, up to the given one, that the points determine.
   * @return the degree; less than 2 if not even a quadric is determined.
   */
  int Solve(int degree, JetCoefficients& jet);

  /// Sum of the weighted squares of what the polynomial leaves.
  double GetResidual(const JetCoefficients& jet) const;

private:
  /// The sums of w x^a y^b and of w z x^a y^b: [a][b].
  template<int Degree>
  struct Moments
  {
    double Plain[2 * Degree + 1][2 * Degree + 1];
    double WithHeight[Degree + 1][Degree + 1];
  };
  template<int A, int Degree>
  void Sum(Moments<Degree>& moments);
  template<int Degree>
  int SolveDegree(JetCoefficients& jet);

  struct Pair
  {
    Lanes X, Y, Z, W;
    Lanes Power; // W times a power of X
  };
  std::vector<Pair, Eigen::aligned_allocator<Pair>> Pairs;
};

/// What a surface does at a point. Form and cubic refer to MakeTangentFrame(Normal).
struct SurfaceJet
{
  Eigen::Vector3d Normal;
  Eigen::Vector3d Form;
  Eigen::Vector4d Cubic;
};

/// The graph of the polynomial at x = y = 0; its axes are the frame's and, for the height, normal.
SurfaceJet Differentiate(
  const JetCoefficients& jet, const TangentFrame& frame, const Eigen::Vector3d& normal);
}

#endif
