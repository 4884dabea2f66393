// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPointMeasures.h
 * @brief Corrected curvature measures at the points of a mesh (nprCorrectedMeasures.h), and what is
 * fitted to those around a point.
 */
#ifndef nprPointMeasures_h
#define nprPointMeasures_h

#include "nprNeighbourhood.h"
#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"

#include <Eigen/Core>

#include <vector>

namespace npr
{
/// What is collected at a point. The form is the mean over the area, and refers to
/// MakeTangentFrame(normal): a multiple of the identity and a part that turns by twice the angle.
struct alignas(32) PointMeasure
{
  /// The first axis of the frame; then the area, in squares of the mesh's unit.
  Eigen::Vector4f AxisAndArea;
  /// (UU + VV) / 2, (UU - VV) / 2, UV, and 0.
  Eigen::Vector4f Form;
};

std::vector<PointMeasure> MeasurePoints(const TriangleMesh& mesh, const Tuples<3>& normals);

/// The form at a point and its derivative, over MakeTangentFrame(normal).
struct LinearForm
{
  Eigen::Vector3f Form = Eigen::Vector3f::Zero();
  Eigen::Vector4f Cubic = Eigen::Vector4f::Zero();
  bool IsKnown = false;
};

/// Fits to the measures as they are around a point. One object for each thread.
class MeasureFit
{
public:
  using Index = TriangleMesh::Index;

  /// As thread locals need it; to be assigned to.
  MeasureFit() = default;
  /// All must outlive this object.
  MeasureFit(const PointGraph& graph, const std::vector<OrientedPoint>& points,
    const std::vector<PointMeasure>& measures)
    : Points(&points), Measures(&measures), Around(graph, points)
  {
  }

  /// Within a radius (length), along so many edges at most.
  LinearForm Fit(Index point, double radius, int rings);

private:
  const std::vector<OrientedPoint>* Points = nullptr;
  const std::vector<PointMeasure>* Measures = nullptr;
  Neighbourhood Around;
};
}

#endif
