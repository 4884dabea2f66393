// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPlainLines.h
 * @brief Lines as one writes them down from the papers: the yardstick of the benchmark.
 *
 * One thread, single precision, the whole mesh in every view: first what the view makes of the
 * points, then a loop over the triangles. The result is a bag of segments; nothing is joined. It
 * shares no code with the library, so it also checks it.
 */
#ifndef nprPlainLines_h
#define nprPlainLines_h

#include "nprPlainCurvature.h"

#include <array>
#include <vector>

namespace nprbench
{
struct PlainSegment
{
  PlainMesh::Vector From;
  PlainMesh::Vector To;
  float FromStrength;
  float ToStrength;
};

/// Each function replaces the segments by those of its kind of line.
class PlainLines
{
public:
  using Vector = PlainMesh::Vector;
  using Triangle = PlainMesh::Triangle;

  /// Takes a mesh whose curvature and derivatives are there. Thresholds are those of the library's
  /// definitions: curvatures are multiplied by the length scale.
  PlainLines(PlainMesh mesh, float lengthScale);

  const std::vector<PlainSegment>& GetSegments() const { return this->Segments; }

  void FindContours(const Vector& eye);
  /// Suggestive contours (DeCarlo et al. 2003, 2004), and with them the contours.
  void FindSuggestiveContours(const Vector& eye);
  /// Judd, Durand and Adelson 2007; the derivative by differences over the triangles at a point.
  void FindApparentRidges(const Vector& eye);
  /// Ohtake, Belyaev and Seidel 2004, both.
  void FindRidgesAndValleys();
  /// Levels of n.v and of height along a direction; ascending.
  void FindIsophotes(const Vector& eye, const std::vector<float>& levels);
  void FindTopographicLines(const Vector& direction, const std::vector<float>& levels);

private:
  using Corners = std::array<float, 3>;

  void SetUpView(const Vector& eye);
  void ComputeRadialCurvature(const Vector& eye);
  void ComputeViewCurvature();
  void ComputeViewDerivative();
  void AddLevels(const std::vector<float>& levels);
  void AddContour(const Triangle& t);
  /// The segment where a field, of different signs at the corners, is 0, as far as a test is
  /// positive.
  void AddSegment(const Triangle& t, const Corners& field, const Corners& test);
  /// The same where the field is the derivative of something along directions that may be turned
  /// over, and only where that is a maximum.
  void AddMaximum(const Triangle& t, const std::vector<Vector>& directions, Corners derivative,
    const Corners& test);

  PlainMesh Mesh;
  float LengthScale;
  std::vector<PlainSegment> Segments;
  std::vector<float> Facing; // n.v, or the height
  std::vector<Vector> ToEye;
  std::vector<float> RadialCurvature;
  std::vector<float> Test;
  std::vector<float> ViewCurvature;
  std::vector<Vector> ViewDirection;
  std::vector<float> ViewDerivative;
};
}

#endif
