// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPageView.h
 * @brief From the world to the page: a camera's picture, placed on paper and cut at its edges.
 */
#ifndef nprPageView_h
#define nprPageView_h

#include "nprCurveFit.h"
#include "nprPageDrawing.h"

#include <Eigen/Core>

#include <vector>

class vtkCamera;

namespace npr
{
/// A point of a chain before it is on the page.
struct WorldPoint
{
  Eigen::Vector3d Position;
  double Width;
};

class PageView
{
public:
  PageView(vtkCamera* camera, int viewportWidth, int viewportHeight);

  /// Pixels of the viewport that a unit of the world is wide, in a parallel projection.
  double GetPixelsPerUnit() const { return this->PixelsPerUnit; }
  const Eigen::Vector2d& GetViewport() const { return this->Viewport; }

  /// Where a point is seen, in pixels from the upper left corner of the viewport. False if it is
  /// not in front of the near plane.
  bool GetPixel(const Eigen::Vector3d& position, Eigen::Vector2d& pixel) const;

  /// Puts the pixel `center` at `place` on the page; nothing is drawn outside of `area`.
  void Place(const Eigen::Vector2d& center, const PagePoint& place, double millimetresPerPixel,
    const PageRectangle& area);

  /**
   * Appends what is seen of a chain inside the area, as one chain for each visit. A closed chain
   * that is not cut stays closed.
   *
   * Segments are cut at the sides of the area and at the near plane in turn, by one bit each
   * (E. Cohen, I. Sutherland; see W. Newman, R. Sproull: Principles of Interactive Computer
   * Graphics, 1973), in homogeneous coordinates, so before the division by depth.
   */
  void Draw(const std::vector<WorldPoint>& chain, bool closed, std::vector<PageChain>& drawn) const;

private:
  static constexpr int NumberOfSides = 5;
  // x, y and w of the homogeneous place, and the distance from the near plane.
  using Homogeneous = Eigen::Vector4d;
  using Distances = Eigen::Matrix<double, NumberOfSides, 1>;

  Distances GetDistances(const Homogeneous& point) const;

  Eigen::Matrix4d ToPixels;
  Eigen::Matrix4d ToPage;
  Eigen::Vector2d Viewport;
  double PixelsPerUnit = 1.0;
  PageRectangle Area;
};
}

#endif
