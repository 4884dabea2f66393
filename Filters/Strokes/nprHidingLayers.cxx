// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprHidingLayers.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace npr
{
namespace
{
// The rule of vtkNPRStrokeVisibility, where these numbers are explained.
constexpr double SeenEdgeOn = 0.25;  // cosine between the normal and the direction to the eye
constexpr double ReachInSizes = 4.0; // of the triangle
constexpr double ReachInPixels = 2.0;
constexpr double ReachInGaps = 5.0;    // of the point from the surface
constexpr double LeastAgreement = 0.5; // cosine between two normals
constexpr double GapInSizes = 0.1;     // that a point of the surface may have
constexpr double LeastGapInPixels = 0.5;
constexpr double MostGapInPixels = 4.0;

/// Squared distance of the origin from a segment.
double GetSquaredDistance(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  const Eigen::Vector3d along = to - from;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp(-from.dot(along) / squared, 0.0, 1.0) : 0.0;
  return (from + t * along).squaredNorm();
}

/// Squared distance of the origin from a triangle.
double GetSquaredDistance(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  if (squared > 0.0 && a.cross(b).dot(normal) >= 0.0 && b.cross(c).dot(normal) >= 0.0 &&
    c.cross(a).dot(normal) >= 0.0)
  {
    const double height = a.dot(normal);
    return height * height / squared;
  }
  return std::min({ GetSquaredDistance(a, b), GetSquaredDistance(b, c), GetSquaredDistance(c, a) });
}
}

//------------------------------------------------------------------------------
HidingLayers::HidingLayers(
  const HidingSurfaces& surfaces, const ImageProjection& projection, int most)
  : Surfaces(surfaces), Projection(projection), Most(most)
{
}

//------------------------------------------------------------------------------
double HidingLayers::GetSize(Index triangle) const
{
  return std::sqrt(this->Surfaces.GetAreaNormal(triangle).norm());
}

//------------------------------------------------------------------------------
double HidingLayers::GetDistance(Index triangle) const
{
  return std::sqrt(GetSquaredDistance(this->Surfaces.GetCorner(triangle, 0) - this->Point,
    this->Surfaces.GetCorner(triangle, 1) - this->Point,
    this->Surfaces.GetCorner(triangle, 2) - this->Point));
}

//------------------------------------------------------------------------------
bool HidingLayers::IsInside(Index triangle) const
{
  for (int e = 0; e < 3; ++e)
  {
    const double squared = GetSquaredDistance(this->Surfaces.GetCorner(triangle, e) - this->Point,
      this->Surfaces.GetCorner(triangle, (e + 1) % 3) - this->Point);
    if (squared <= this->Surfaces.GetTolerance() * this->Surfaces.GetTolerance())
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
int HidingLayers::Count(const Vector& point, const Vector& normal)
{
  this->Point = point;
  this->Normal = normal;
  this->IsOwnKnown = false;
  const Vector toEye = this->Projection.GetRayToEye(point);
  const double distance = toEye.norm();
  if (!(distance > 0.0))
  {
    return 0;
  }
  this->ToEye = toEye / distance;
  this->PixelSize = this->Projection.GetPixelSize(this->Projection.Project(point).Depth);
  this->Crossings.clear();
  const bool isFirstEnough = this->Most == 1;
  auto visit = [&](Index triangle, float t)
  {
    if (this->IsOwn(triangle, t))
    {
      return true;
    }
    this->Crossings.push_back(
      { t, triangle, this->Surfaces.GetAreaNormal(triangle).dot(this->ToEye) < 0.0 });
    return !isFirstEnough;
  };
  const RayTracer::Ray ray{ point.cast<float>(), this->ToEye.cast<float>(),
    static_cast<float>(this->Surfaces.GetTolerance()),
    this->Projection.IsParallel() ? std::numeric_limits<float>::infinity()
                                  : static_cast<float>(distance) };
  this->Surfaces.GetTracer().VisitCrossings(ray, visit);
  return std::min(this->Most, this->CountCrossings());
}

//------------------------------------------------------------------------------
int HidingLayers::CountCrossings()
{
  if (this->Crossings.size() < 2)
  {
    return static_cast<int>(this->Crossings.size());
  }
  std::sort(this->Crossings.begin(), this->Crossings.end(),
    [](const Crossing& a, const Crossing& b)
    { return a.Distance != b.Distance ? a.Distance < b.Distance : a.Triangle < b.Triangle; });
  // A ray through an edge or a corner crosses one surface there, though it may meet several of its
  // triangles: they share a point.
  int layers = 0;
  for (std::size_t i = 0; i < this->Crossings.size(); ++i)
  {
    const TriangleMesh::Triangle& corners = this->Surfaces.GetTriangle(this->Crossings[i].Triangle);
    bool isSame = false;
    for (std::size_t j = i; j-- > 0 && !isSame &&
         this->Crossings[i].Distance - this->Crossings[j].Distance <=
           this->Surfaces.GetTolerance();)
    {
      const TriangleMesh::Triangle& others =
        this->Surfaces.GetTriangle(this->Crossings[j].Triangle);
      isSame = this->Crossings[i].FromFront == this->Crossings[j].FromFront &&
        std::any_of(corners.begin(), corners.end(),
          [&](Index corner)
          { return std::find(others.begin(), others.end(), corner) != others.end(); });
    }
    layers += isSame ? 0 : 1;
  }
  return layers;
}

//------------------------------------------------------------------------------
bool HidingLayers::IsOwn(Index triangle, double distance)
{
  if (!this->IsOwnKnown)
  {
    this->FindOwnSurface();
    this->IsOwnKnown = true;
  }
  for (const Step& step : this->Own)
  {
    if (step.Triangle == triangle)
    {
      return step.IsSource || distance <= this->Reach;
    }
  }
  return std::find(this->Touching.begin(), this->Touching.end(), triangle) != this->Touching.end();
}

//------------------------------------------------------------------------------
bool HidingLayers::FindNearest()
{
  const double tolerance = this->Surfaces.GetTolerance();
  const double farthest = std::max(tolerance, MostGapInPixels * this->PixelSize);
  this->Nearest = -1;
  this->Gap = farthest;
  this->Touching.clear();
  auto visit = [&](Index triangle, float radius)
  {
    const double distance = this->GetDistance(triangle);
    if (distance <= tolerance)
    {
      this->Touching.push_back(triangle);
    }
    // Of two at the same distance the first, in whatever order they come.
    if (distance < this->Gap || (distance == this->Gap && triangle < this->Nearest))
    {
      this->Gap = distance;
      this->Nearest = triangle;
    }
    return std::min(radius, static_cast<float>(std::max(1.01 * this->Gap, 2.0 * tolerance)));
  };
  this->Surfaces.GetTracer().VisitNear(
    this->Point.cast<float>(), static_cast<float>(farthest + tolerance), visit);
  if (this->Nearest < 0)
  {
    return false;
  }
  return this->Gap <= std::max({ tolerance, LeastGapInPixels * this->PixelSize,
                        GapInSizes * this->GetSize(this->Nearest) });
}

//------------------------------------------------------------------------------
void HidingLayers::FindOwnSurface()
{
  this->Own.clear();
  this->Reach = 0.0;
  if (!this->FindNearest())
  {
    return;
  }
  const double tolerance = this->Surfaces.GetTolerance();
  this->Reach = ReachInGaps * this->Gap;
  const Vector normal =
    this->Normal.squaredNorm() > 0.0 ? this->Normal : this->Surfaces.GetAreaNormal(this->Nearest);
  if (std::abs(normal.dot(this->ToEye)) <= SeenEdgeOn * normal.norm() &&
    this->IsInside(this->Nearest))
  {
    this->Reach = std::max({ this->Reach, ReachInSizes * this->GetSize(this->Nearest),
      ReachInPixels * this->PixelSize });
  }
  this->Collect(2.0 * this->Gap + tolerance, this->Reach);
}

//------------------------------------------------------------------------------
void HidingLayers::Collect(double sourceReach, double reach)
{
  const auto isKnown = [this](Index triangle)
  {
    return std::any_of(this->Own.begin(), this->Own.end(),
      [triangle](const Step& step) { return step.Triangle == triangle; });
  };
  const auto getUnitNormal = [this](Index triangle)
  { return this->Surfaces.GetAreaNormal(triangle).stableNormalized(); };
  // First those that the point lies on, then from each of them as far as the surface goes on
  // smoothly.
  this->Own.push_back({ this->Nearest, getUnitNormal(this->Nearest), true });
  for (const bool areSources : { true, false })
  {
    for (std::size_t i = 0; i < this->Own.size(); ++i)
    {
      const Step step = this->Own[i];
      for (int e = 0; e < 3; ++e)
      {
        const Index next = this->Surfaces.GetNeighbour(step.Triangle, e);
        if (next < 0 || isKnown(next) ||
          this->GetDistance(next) > (areSources ? sourceReach : reach))
        {
          continue;
        }
        const Vector normal = getUnitNormal(next);
        if (areSources)
        {
          this->Own.push_back({ next, normal, true });
          continue;
        }
        const Vector turned =
          this->Surfaces.IsAlike(step.Triangle, e) ? step.Normal : Vector(-step.Normal);
        if (normal.dot(turned) >= LeastAgreement)
        {
          this->Own.push_back({ next, turned, false });
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void HidingLayers::FindPiercings(
  const Vector& from, const Vector& to, std::vector<double>& places) const
{
  const Vector along = to - from;
  const double length = along.norm();
  const double tolerance = this->Surfaces.GetTolerance();
  auto visit = [&](Index, float t)
  {
    if (t > tolerance && t < length - tolerance)
    {
      places.push_back(t / length);
    }
    return true;
  };
  const RayTracer::Ray ray{ from.cast<float>(), (along / length).cast<float>(), 0.0f,
    static_cast<float>(length) };
  this->Surfaces.GetTracer().VisitCrossings(ray, visit);
}
}
