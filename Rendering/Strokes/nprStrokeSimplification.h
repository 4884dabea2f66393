// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeSimplification_h
#define nprStrokeSimplification_h

#include "nprVTKCompat.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkMatrix4x4;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace npr
{
struct StrokeRecord;

/// From where strokes are seen: what lies on one sight line looks alike.
struct StrokeSight
{
  /// Homogeneous, in the coordinates of the strokes: a place, or, where the last number is 0, the
  /// direction to it; all 0: from anywhere.
  std::array<double, 4> Eye = { 0, 0, 0, 0 };
  /// How far points may be moved along sight lines, in units of StrokeTolerance::Length.
  float Depth = std::numeric_limits<float>::infinity();

  bool IsAnywhere() const { return this->Eye == std::array<double, 4>{ 0, 0, 0, 0 }; }
  bool operator==(const StrokeSight& other) const
  {
    return this->Eye == other.Eye && this->Depth == other.Depth;
  }
};

/// How far what is drawn of a stroke may be from what it is.
struct StrokeTolerance
{
  float Length = 0.0f; // of the axis, in the coordinates of the input; 0: every point is drawn
  float Width = std::numeric_limits<float>::infinity(); // of these factors; without a limit unused
  float Strength = std::numeric_limits<float>::infinity();
  float Opacity = std::numeric_limits<float>::infinity();
  float ArcLength = std::numeric_limits<float>::infinity(); // in the coordinates of the input
  float Color = 2.0f;                                       // of 255
  StrokeSight Sight;

  StrokeTolerance Scaled(float factor) const;
  StrokeTolerance FromAnywhere() const;
  /// In coordinates with another origin.
  StrokeTolerance Relative(const std::array<double, 3>& origin) const;
  /// Whether what keeps to the other one keeps to this one, too, wherever both are seen from.
  bool Allows(const StrokeTolerance& other) const;
};

/**
 * The records of a stroke that are needed for the others to be found on the segments between them.
 * A record that is not finite (of the kind 0) is kept, and so are its neighbours.
 *
 * @param colors four numbers for each record; null: none
 */
void SimplifyStroke(const std::vector<StrokeRecord>& records, const unsigned char* colors,
  const StrokeTolerance& tolerance, std::vector<std::size_t>& kept);

/// Whether widths or opacities change so fast between two records that the end of a stroke there
/// would be seen to reach beyond the other, thinner or fainter one.
bool IsSteep(const StrokeRecord& a, const StrokeRecord& b, const StrokeTolerance& tolerance);

/// From where a camera sees strokes that a matrix takes to the world; from anywhere where it has no
/// inverse.
StrokeSight FindSight(vtkCamera* camera, vtkMatrix4x4* matrix);

/// The size of a pixel where it is smallest on what has these bounds, in its coordinates; 0 if that
/// can't be told.
double FindSmallestPixel(vtkRenderer* renderer, vtkMatrix4x4* matrix, const double bounds[6]);
}

#endif
