// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprHidingLayers_h
#define nprHidingLayers_h

#include "nprHidingSurfaces.h"
#include "nprImageProjection.h"

#include <Eigen/Core>

#include <vector>

namespace npr
{
/// The cosine between its normal and the direction to the eye, up to which a triangle is seen
/// exactly edge-on.
inline constexpr double ExactlyEdgeOn = 1e-4;

/**
 * @class HidingLayers
 * @brief Counts how many layers of surface are between a point and the eye, by the rule that
 * vtkNPRStrokeVisibility documents.
 *
 * One object for each thread. The surface around the point is looked at only where a ray meets
 * something so near that it may belong to it.
 */
class HidingLayers
{
public:
  using Index = TriangleMesh::Index;
  using Vector = Eigen::Vector3d;

  /// No more than \p most layers are counted; 1 ends each ray at the first.
  HidingLayers(const HidingSurfaces& surfaces, const ImageProjection& projection, int most);

  /// \p normal of the smooth surface that the point lies on, outwards, or zero where that is not
  /// known; \p along the stroke, which has the front of the surface on its left if it is a contour;
  /// \p mayBeEdgeOn false if the point surely lies on no triangle that is seen exactly edge-on.
  int Count(const Vector& point, const Vector& normal, const Vector& along, bool mayBeEdgeOn);

  /// Whether how far something is from the last point may decide whether it hides it. Where nothing
  /// is in front, it is not asked.
  bool DependsOnDistance() const { return this->AreSourcesKnown && this->DistanceMatters; }

  /// Adds the places, in ]0, 1[, where a segment goes through a surface.
  void FindPiercings(const Vector& from, const Vector& to, std::vector<double>& places) const;

private:
  struct Crossing
  {
    float Distance;
    Index Triangle;
    bool FromFront;
  };
  struct Step
  {
    Index Triangle;
    Vector Normal; // of the triangle that the steps began at, turned as this one is
    bool IsSource;
    bool IsBeyondOutline; // beside the point, on the side that is seen
  };

  int CountAt(const Vector& point, const Vector& normal);
  /// Unit normal of a triangle that the point lies on and that is seen exactly edge-on, or zero.
  Vector FindEdgeOnNormal();
  /// Whether a crossing is with the surface that the point lies on, near it.
  bool IsOwn(Index triangle, double distance);
  /// Whether a crossing is with another body, where that touches the own one as far as the chords
  /// of both can tell.
  bool TouchesBody(Index triangle, double distance);
  /// Whether the point is of a contour where the surface is hollow along the sight line.
  bool IsBehindItself() const;
  /// Whether a triangle of the own surface is one that hides a contour behind it.
  bool IsInFront(const Step& step) const;
  /// Begins the own surface with the triangles that the point lies on.
  void FindSources();
  /// Sets the nearest triangle, the distance from it, and which triangles touch the point. False if
  /// it is too far for the point to be on the surface.
  bool FindNearest();
  /// The triangles beside one of the own surface that also belong to it.
  void AddAround(std::size_t step);
  void AddOwn(const Step& step);
  /// The place of a triangle in Own, or -1.
  Index FindOwn(Index triangle) const;
  void ClearOwn();
  double GetDistance(Index triangle) const;
  bool IsWithinReach(Index triangle, double reach) const;
  /// Whether an edge is in the outline of the mesh, and in the image next to the point.
  bool IsOutlineNearby(Index triangle, int edge) const;
  bool IsInside(Index triangle) const;
  double GetSize(Index triangle) const;
  int CountCrossings();

  const HidingSurfaces& Surfaces;
  const ImageProjection& Projection;
  const int Most;

  // What is known of the point.
  Vector Point;
  Vector Normal;
  Vector Along;
  Vector ToEye; // unit
  double PixelSize = 0.0;
  bool AreSourcesKnown = false;
  bool DistanceMatters = false;
  bool Inside = false; // of the nearest triangle, and not on one of its edges
  bool BehindItself = false;
  Index Nearest = -1;
  double Gap = 0.0;   // distance from the nearest triangle
  double Reach = 0.0; // how far the own surface hides nothing
  std::vector<Index> Touching;
  // Grows step by step, from the sources outwards, no farther than crossings are to be found in it.
  std::vector<Step> Own;
  std::size_t NextStep = 0;
  std::vector<Index> OwnSlots; // places in Own by the triangle, or -1

  std::vector<Crossing> Crossings;
};
}

#endif
