// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeSplitter_h
#define nprStrokeSplitter_h

#include "nprHidingEdges.h"
#include "nprHidingLayers.h"
#include "nprHidingSurfaces.h"
#include "nprImageProjection.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace npr
{
/// A stretch of a stroke with one number of layers. Places on a stroke are the number of a point
/// and what part of the way to the next has been gone. On a closed stroke a part that does not end
/// after its begin goes over the first point.
struct StrokePart
{
  /// The number of layers of what is not in the image: behind the eye, or no number.
  static constexpr int Nowhere = -1;

  int Layers = 0;
  double Begin = 0.0;
  double End = 0.0;
  double Length = 0.0; // in the image, in pixels

  bool IsOverFirstPoint() const { return this->End <= this->Begin; }
};

/// Parts shorter than \p least become part of their neighbours: the shortest first, if both
/// neighbours are alike with both of them, else with the longer one (or the one that there is; of
/// two as long, the one before). Hidden parts at the ends of open strokes stay. The last part of a
/// closed stroke is a neighbour of its first.
/// \p size is the number of segments of the stroke.
std::vector<StrokePart> MergeParts(
  std::vector<StrokePart> parts, double least, bool isClosed, std::size_t size);

/**
 * @class StrokeSplitter
 * @brief Cuts strokes where their number of hiding layers changes. One object for each thread.
 */
class StrokeSplitter
{
public:
  using Vector = Eigen::Vector3d;

  StrokeSplitter(const HidingSurfaces& surfaces, const HidingEdges& edges,
    const ImageProjection& projection, int most);

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

  const std::vector<Vector>* Points = nullptr;
  const std::vector<Vector>* Normals = nullptr;
  std::vector<double> Places;
  std::vector<StrokePart> Parts;
  double Unseen = 0.0; // pixels since the last ray
};
}

#endif
