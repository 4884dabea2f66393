// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprRayTracer.h"

#ifdef NPR_USE_EMBREE

#include <embree3/rtcore.h>

#include <limits>

namespace npr
{
namespace
{
/// What Embree hands back to its callbacks: its own context must come first.
struct CrossingContext
{
  RTCIntersectContext Context;
  bool (*Visit)(void*, RayTracer::Index, float);
  void* Visitor;
};

/// Refuses the hit, so that the ray goes on, unless the visitor has seen enough.
void FilterCrossing(const RTCFilterFunctionNArguments* arguments)
{
  auto* const context = reinterpret_cast<CrossingContext*>(arguments->context);
  const auto triangle = static_cast<RayTracer::Index>(RTCHitN_primID(arguments->hit, 1, 0));
  if (context->Visit(context->Visitor, triangle, RTCRayN_tfar(arguments->ray, 1, 0)))
  {
    arguments->valid[0] = 0;
  }
}

struct NearQuery
{
  float (*Visit)(void*, RayTracer::Index, float);
  void* Visitor;
};

bool VisitNearTriangle(RTCPointQueryFunctionArguments* arguments)
{
  const auto* const query = static_cast<const NearQuery*>(arguments->userPtr);
  const float radius = query->Visit(
    query->Visitor, static_cast<RayTracer::Index>(arguments->primID), arguments->query->radius);
  const bool isLess = radius < arguments->query->radius;
  arguments->query->radius = radius;
  return isLess;
}
}

//------------------------------------------------------------------------------
class RayTracer::Internals
{
public:
  Internals(const std::vector<Eigen::Vector3f>& points,
    const std::vector<TriangleMesh::Triangle>& triangles)
    : Device(rtcNewDevice(nullptr)), Scene(rtcNewScene(this->Device))
  {
    rtcSetSceneFlags(this->Scene,
      static_cast<RTCSceneFlags>(
        RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    rtcSetSceneBuildQuality(this->Scene, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
      points.data(), 0, sizeof(Eigen::Vector3f), points.size() - 1);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
      triangles.data(), 0, sizeof(TriangleMesh::Triangle), triangles.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->Scene);
  }
  ~Internals()
  {
    rtcReleaseScene(this->Scene);
    rtcReleaseDevice(this->Device);
  }

  RTCDevice Device;
  RTCScene Scene;
};

//------------------------------------------------------------------------------
bool RayTracer::IsAvailable()
{
  return true;
}

//------------------------------------------------------------------------------
RayTracer::RayTracer(
  const std::vector<Eigen::Vector3f>& points, const std::vector<TriangleMesh::Triangle>& triangles)
  : Internal(std::make_unique<Internals>(points, triangles))
{
}

//------------------------------------------------------------------------------
void RayTracer::VisitCrossings(const Ray& ray, CrossingVisitor visit, void* visitor) const
{
  CrossingContext context;
  rtcInitIntersectContext(&context.Context);
  context.Context.filter = FilterCrossing;
  context.Visit = visit;
  context.Visitor = visitor;
  RTCRay traced;
  traced.org_x = ray.Origin.x();
  traced.org_y = ray.Origin.y();
  traced.org_z = ray.Origin.z();
  traced.tnear = ray.Near;
  traced.dir_x = ray.Direction.x();
  traced.dir_y = ray.Direction.y();
  traced.dir_z = ray.Direction.z();
  traced.time = 0.0f;
  traced.tfar = ray.Far;
  traced.mask = std::numeric_limits<unsigned int>::max();
  traced.id = 0;
  traced.flags = 0;
  rtcOccluded1(this->Internal->Scene, &context.Context, &traced);
}

//------------------------------------------------------------------------------
void RayTracer::VisitNear(
  const Eigen::Vector3f& point, float radius, NearVisitor visit, void* visitor) const
{
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  RTCPointQuery query;
  query.x = point.x();
  query.y = point.y();
  query.z = point.z();
  query.time = 0.0f;
  query.radius = radius;
  NearQuery near{ visit, visitor };
  rtcPointQuery(this->Internal->Scene, &query, &context, VisitNearTriangle, &near);
}
}

#else

namespace npr
{
class RayTracer::Internals
{
};

//------------------------------------------------------------------------------
bool RayTracer::IsAvailable()
{
  return false;
}

//------------------------------------------------------------------------------
RayTracer::RayTracer(
  const std::vector<Eigen::Vector3f>&, const std::vector<TriangleMesh::Triangle>&)
{
}

//------------------------------------------------------------------------------
void RayTracer::VisitCrossings(const Ray&, CrossingVisitor, void*) const {}

//------------------------------------------------------------------------------
void RayTracer::VisitNear(const Eigen::Vector3f&, float, NearVisitor, void*) const {}
}

#endif

namespace npr
{
//------------------------------------------------------------------------------
RayTracer::~RayTracer() = default;
}
