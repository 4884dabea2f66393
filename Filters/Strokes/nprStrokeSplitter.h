// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeSplitter_h
#define nprStrokeSplitter_h

#include "nprHidingEdges.h"
#include "nprHidingLayers.h"
#include "nprHidingSurfaces.h"
#include "nprImageProjection.h"
#include "nprStrokeParts.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace npr
{
/**
 * @class StrokeSplitter
 * @brief Cuts strokes where their number of hiding layers changes. One object for each thread.
 */
class StrokeSplitter
{
public:
  using Vector = Eigen::Vector3d;

  /// \p isMirrored if what was on the left of the strokes, seen from outside, is on their right.
  StrokeSplitter(const HidingSurfaces& surfaces, const HidingEdges& edges,
    const ImageProjection& projection, int most, bool isMirrored);

  /// \p points relative to the surfaces' centre; \p normals as many, or none. Neighbouring parts
  /// have different layers.
  std::vector<StrokePart> Split(
    const std::vector<Vector>& points, const std::vector<Vector>& normals);

private:
  void SplitSegment(std::size_t segment);
  /// A piece of a segment that nothing begins or ends to hide.
  void AddPiece(std::size_t segment, double begin, double end, double length, bool mayBeEdgeOn);
  void Append(int layers, double begin, double end, double length);
  int CountLayers(std::size_t segment, double place, bool mayBeEdgeOn);

  const HidingSurfaces& Surfaces;
  const HidingEdges& Edges;
  const ImageProjection& Projection;
  HidingLayers Layers;
  const double Direction; // of the strokes, that has on its left what it had: 1 or -1

  const std::vector<Vector>* Points = nullptr;
  const std::vector<Vector>* Normals = nullptr;
  std::vector<double> Places;
  std::vector<StrokePart> Parts;
  double Unseen = 0.0; // pixels since the last ray
};
}

#endif
