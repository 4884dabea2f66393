// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprRayTracer_h
#define nprRayTracer_h

#include "nprTriangleMesh.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace npr
{
/**
 * @class RayTracer
 * @brief Which triangles a ray crosses, and which are near a point: Embree behind a narrow door.
 *
 * The hierarchy is built by the constructor, and many threads may ask at once. Rays are traced in
 * robust mode: none passes between two triangles that share an edge. The answers do not depend on
 * the number of threads, but their order may.
 */
class RayTracer
{
public:
  using Index = TriangleMesh::Index;

  /// Whether this build has Embree. Without it there is no other RayTracer than an empty one.
  static bool IsAvailable();

  /// Keeps neither copies nor references: the arrays must stay as they are while rays are traced.
  /// \p points needs one more point at its end, which is not used: Embree reads beyond the last.
  RayTracer(const std::vector<Eigen::Vector3f>& points,
    const std::vector<TriangleMesh::Triangle>& triangles);
  ~RayTracer();
  RayTracer(const RayTracer&) = delete;
  RayTracer& operator=(const RayTracer&) = delete;

  struct Ray
  {
    Eigen::Vector3f Origin;
    Eigen::Vector3f Direction;
    float Near;
    float Far;
  };
  /// Calls `visit(triangle, distance)` for each triangle that the ray crosses, in no order, until
  /// that answers false.
  template<typename Visitor>
  void VisitCrossings(const Ray& ray, Visitor& visit) const
  {
    this->VisitCrossings(
      ray,
      [](void* visitor, Index triangle, float distance)
      { return (*static_cast<Visitor*>(visitor))(triangle, distance); },
      &visit);
  }

  /// Calls `visit(triangle, radius)` for each triangle whose bounds are in the radius, in no order.
  /// It answers the new radius, never larger.
  template<typename Visitor>
  void VisitNear(const Eigen::Vector3f& point, float radius, Visitor& visit) const
  {
    this->VisitNear(
      point, radius,
      [](void* visitor, Index triangle, float current)
      { return (*static_cast<Visitor*>(visitor))(triangle, current); },
      &visit);
  }

private:
  using CrossingVisitor = bool (*)(void*, Index, float);
  using NearVisitor = float (*)(void*, Index, float);
  void VisitCrossings(const Ray& ray, CrossingVisitor visit, void* visitor) const;
  void VisitNear(
    const Eigen::Vector3f& point, float radius, NearVisitor visit, void* visitor) const;

  class Internals;
  std::unique_ptr<Internals> Internal;
};
}

#endif
