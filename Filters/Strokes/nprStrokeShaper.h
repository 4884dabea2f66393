// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeShaper_h
#define nprStrokeShaper_h

#include "nprStrokeMeasure.h"
#include "nprStrokeSamples.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace npr
{
/// What is done to strokes along their way. Lengths are in units of a StrokeMeasure.
struct StrokeShape
{
  bool RelativeToStroke = false; ///< lengths are shares of the stroke's, and so is CurvatureUnit
  double Reach = 0.0;            ///< of curvatures and averages, to both sides
  bool Curvatures = false;       ///< whether they are wanted
  double CurvatureUnit = 1.0;    ///< what they are multiplied by
  double TaperLength = 0.0;
  double OvershootLength = 0.0;
  double WobbleAmplitude = 0.0;
  double WobbleWavelength = 1.0;

  /// The same with lengths in units of the measure, for a stroke of that length.
  StrokeShape For(double length) const;
};

/// What belongs to a stroke, besides its shape.
struct StrokeTraits
{
  bool StartIsTrue = true; ///< whether it begins there, and has not been cut
  bool EndIsTrue = true;
  std::uint32_t Seed = 0;
};

struct ShapedStrokes : SampledStrokes
{
  // For each sample.
  std::vector<float> Tapers;     // 1, and towards a tapered end 0
  std::vector<float> Lengths;    // measured from the start of the stroke
  std::vector<float> Curvatures; // empty where none are wanted
  // For each stroke.
  std::vector<double> Reaches;
  std::vector<char> Closed;
  std::vector<Eigen::Vector3d> Areas; // around the origin, by the right-hand rule

  /// How large a stroke is, without its wobbles: a loop four times its area by its length, which is
  /// a circle's diameter, another one as a half circle of its length.
  double GetSize(std::size_t stroke) const;

  /// Replaces a value of each sample by the average over the reach to both sides along the stroke.
  void Average(float* values) const;

  /// Makes the widths of a stroke less, all by the same factor, so that none is more than its size
  /// allows. Sizes are in units of the measure or, relative, shares of the stroke's length.
  void LimitWidths(float* widths, double perSize, bool isRelative) const;
};

/// Appends one stroke, overshooting and wobbling, with as many points as its attributes need.
/// @param firstArcLength that at its first point
void ShapeStroke(const StrokeChain& chain, const StrokeMeasure& measure, const StrokeShape& shape,
  const StrokeTraits& traits, double firstArcLength, ShapedStrokes& strokes);
}

#endif
