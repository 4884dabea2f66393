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
constexpr double SeenEdgeOn = 0.25;     // cosine between the normal and the direction to the eye
constexpr double StripSeenEdgeOn = 0.1; // the same beside a crease
constexpr double ReachInSizes = 4.0;    // of the triangle
constexpr double ReachInPixels = 2.0;
constexpr double ReachInGaps = 5.0; // of the point from the surface
constexpr double OnEdgeInTolerances = 0.1;
constexpr double LeastAgreement = 0.1; // cosine between two normals
constexpr double GapInSizes = 0.1;     // that a point of the surface may have
constexpr double LeastGapInPixels = 0.5;
constexpr double MostGapInPixels = 4.0;
constexpr double TouchingReach = 5.0;    // of the distance at which surfaces touch
constexpr double SideInTolerances = 4.0; // from a surface that is seen edge-on
constexpr double SideOfContour = 0.02;   // sines of the angles from which on it is known

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
  : Surfaces(surfaces), Projection(projection), Most(most), OwnSlots(256, -1)
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
  // Few pieces of lines inside of triangles are so near to an edge.
  const double tolerance = OnEdgeInTolerances * this->Surfaces.GetTolerance();
  for (int e = 0; e < 3; ++e)
  {
    const double squared = GetSquaredDistance(this->Surfaces.GetCorner(triangle, e) - this->Point,
      this->Surfaces.GetCorner(triangle, (e + 1) % 3) - this->Point);
    if (squared <= tolerance * tolerance)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
int HidingLayers::Count(
  const Vector& point, const Vector& normal, const Vector& along, bool mayBeEdgeOn)
{
  this->Along = along;
  const int layers = this->CountAt(point, normal);
  if (!mayBeEdgeOn)
  {
    return layers;
  }
  const Vector aside = SideInTolerances * this->Surfaces.GetTolerance() * this->FindEdgeOnNormal();
  return aside.squaredNorm() > 0.0
    ? std::min(this->CountAt(point - aside, normal), this->CountAt(point + aside, normal))
    : layers;
}

//------------------------------------------------------------------------------
HidingLayers::Vector HidingLayers::FindEdgeOnNormal()
{
  if (!this->AreSourcesKnown)
  {
    this->FindSources();
  }
  Index first = this->Surfaces.GetNumberOfTriangles();
  Vector found = Vector::Zero();
  const auto look = [&](Index triangle)
  {
    const Vector normal = this->Surfaces.GetAreaNormal(triangle).stableNormalized();
    if (triangle < first && std::abs(normal.dot(this->ToEye)) <= ExactlyEdgeOn)
    {
      first = triangle;
      found = normal;
    }
  };
  for (const Step& step : this->Own)
  {
    if (step.IsSource)
    {
      look(step.Triangle);
    }
  }
  for (const Index triangle : this->Touching)
  {
    look(triangle);
  }
  return found;
}

//------------------------------------------------------------------------------
int HidingLayers::CountAt(const Vector& point, const Vector& normal)
{
  this->Point = point;
  this->Normal = normal;
  this->AreSourcesKnown = false;
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
    if (this->IsOwn(triangle, t) || this->TouchesBody(triangle, t))
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
  // Beyond this nothing is own, wherever the point lies.
  const double gap = MostGapInPixels * this->PixelSize + this->Surfaces.GetTolerance();
  if (distance > ReachInGaps * gap + ReachInSizes * this->Surfaces.GetLongestEdge())
  {
    return false;
  }
  if (!this->AreSourcesKnown)
  {
    this->FindSources();
  }
  const Index known = this->FindOwn(triangle);
  if (known >= 0)
  {
    const Step& step = this->Own[known];
    return step.IsSource || (distance <= this->Reach && !this->IsInFront(step));
  }
  if (std::find(this->Touching.begin(), this->Touching.end(), triangle) != this->Touching.end())
  {
    return true;
  }
  if (distance > this->Reach)
  {
    return false;
  }
  while (this->NextStep < this->Own.size())
  {
    this->AddAround(this->NextStep++);
    const Index found = this->FindOwn(triangle);
    if (found >= 0)
    {
      return !this->IsInFront(this->Own[found]);
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool HidingLayers::IsBehindItself() const
{
  const double length = this->Normal.norm();
  return length > 0.0 && std::abs(this->Normal.dot(this->ToEye)) <= SideOfContour * length &&
    this->Along.dot(this->ToEye.cross(this->Normal)) < -SideOfContour * length * this->Along.norm();
}

//------------------------------------------------------------------------------
bool HidingLayers::IsInFront(const Step& step) const
{
  const double side = this->Surfaces.GetAreaNormal(step.Triangle).dot(this->ToEye);
  return this->BehindItself && (step.Normal.dot(this->Normal) < 0.0 ? side < 0.0 : side > 0.0);
}

//------------------------------------------------------------------------------
bool HidingLayers::TouchesBody(Index triangle, double distance)
{
  const double most = MostGapInPixels * this->PixelSize;
  const double error = this->Surfaces.GetChordError(triangle);
  const Vector normal = this->Surfaces.GetAreaNormal(triangle);
  const double depth = distance * std::abs(normal.dot(this->ToEye));
  if (depth > std::min(most, error + this->Surfaces.GetLargestChordError()) * normal.norm())
  {
    return false;
  }
  if (!this->AreSourcesKnown)
  {
    this->FindSources();
  }
  if (this->Own.empty() ||
    this->Surfaces.GetBody(triangle) == this->Surfaces.GetBody(this->Nearest))
  {
    return false;
  }
  double ownError = 0.0;
  for (const Step& step : this->Own)
  {
    ownError =
      step.IsSource ? std::max(ownError, this->Surfaces.GetChordError(step.Triangle)) : ownError;
  }
  const double touching = std::min(most, error + ownError);
  return depth <= touching * normal.norm() &&
    this->GetDistance(triangle) <= TouchingReach * touching;
}

//------------------------------------------------------------------------------
HidingLayers::Index HidingLayers::FindOwn(Index triangle) const
{
  const std::size_t mask = this->OwnSlots.size() - 1;
  for (std::size_t slot = triangle & mask;; slot = (slot + 1) & mask)
  {
    const Index place = this->OwnSlots[slot];
    if (place < 0 || this->Own[place].Triangle == triangle)
    {
      return place;
    }
  }
}

//------------------------------------------------------------------------------
void HidingLayers::AddOwn(const Step& step)
{
  const auto put = [this](std::size_t place)
  {
    const std::size_t mask = this->OwnSlots.size() - 1;
    std::size_t slot = this->Own[place].Triangle & mask;
    while (this->OwnSlots[slot] >= 0)
    {
      slot = (slot + 1) & mask;
    }
    this->OwnSlots[slot] = static_cast<Index>(place);
  };
  this->Own.push_back(step);
  if (2 * this->Own.size() > this->OwnSlots.size())
  {
    this->OwnSlots.assign(2 * this->OwnSlots.size(), -1);
    for (std::size_t place = 0; place + 1 < this->Own.size(); ++place)
    {
      put(place);
    }
  }
  put(this->Own.size() - 1);
}

//------------------------------------------------------------------------------
void HidingLayers::ClearOwn()
{
  if (!this->Own.empty())
  {
    std::fill(this->OwnSlots.begin(), this->OwnSlots.end(), -1);
    this->Own.clear();
  }
  this->NextStep = 0;
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
void HidingLayers::FindSources()
{
  this->AreSourcesKnown = true;
  this->Inside = false;
  this->BehindItself = false;
  this->DistanceMatters = false;
  this->ClearOwn();
  this->Reach = 0.0;
  if (!this->FindNearest())
  {
    return;
  }
  const double tolerance = this->Surfaces.GetTolerance();
  this->Reach = ReachInGaps * this->Gap;
  const Vector normal =
    this->Normal.squaredNorm() > 0.0 ? this->Normal : this->Surfaces.GetAreaNormal(this->Nearest);
  this->Inside = this->IsInside(this->Nearest);
  if (this->Inside)
  {
    this->BehindItself = this->IsBehindItself();
    this->Reach = std::max(this->Reach, ReachInPixels * this->PixelSize);
    if (std::abs(normal.dot(this->ToEye)) <= SeenEdgeOn * normal.norm())
    {
      this->Reach = std::max(this->Reach, ReachInSizes * this->GetSize(this->Nearest));
    }
  }
  const auto add = [this](Index triangle)
  {
    this->AddOwn(
      { triangle, this->Surfaces.GetAreaNormal(triangle).stableNormalized(), true, false });
  };
  add(this->Nearest);
  for (std::size_t i = 0; i < this->Own.size(); ++i)
  {
    for (int e = 0; e < 3; ++e)
    {
      const Index next = this->Surfaces.GetNeighbour(this->Own[i].Triangle, e);
      if (next >= 0 && this->FindOwn(next) < 0 &&
        this->GetDistance(next) <= 2.0 * this->Gap + tolerance)
      {
        add(next);
      }
    }
  }
  // A contour along a crease, and the last strip of the surface before it that turns away.
  const bool isBesideEdgeOn = this->Gap <= tolerance && !this->Inside &&
    std::any_of(this->Own.begin(), this->Own.end(),
      [&](const Step& step) { return std::abs(step.Normal.dot(this->ToEye)) <= StripSeenEdgeOn; });
  this->DistanceMatters = isBesideEdgeOn || this->Inside;
  if (isBesideEdgeOn)
  {
    this->Reach = std::max(this->Reach, ReachInPixels * this->PixelSize);
  }
}

//------------------------------------------------------------------------------
void HidingLayers::AddAround(std::size_t place)
{
  const Step step = this->Own[place];
  for (int e = 0; e < 3; ++e)
  {
    const Index next = this->Surfaces.GetNeighbour(step.Triangle, e);
    if (next < 0 || this->FindOwn(next) >= 0)
    {
      continue;
    }
    const bool isAlike = this->Surfaces.IsAlike(step.Triangle, e);
    const Vector turned = isAlike ? step.Normal : Vector(-step.Normal);
    const Vector normal = this->Surfaces.GetAreaNormal(next);
    const bool isSmooth = normal.dot(turned) >= LeastAgreement * normal.norm();
    const double reach = step.IsBeyondOutline ? ReachInPixels * this->PixelSize : this->Reach;
    if (isSmooth && this->IsWithinReach(next, reach))
    {
      this->AddOwn({ next, turned, false, step.IsBeyondOutline });
    }
    else if (this->Inside && !this->BehindItself && !step.IsBeyondOutline &&
      this->IsOutlineNearby(step.Triangle, e))
    {
      this->AddOwn({ next, normal.stableNormalized(), false, true });
    }
  }
}

//------------------------------------------------------------------------------
bool HidingLayers::IsOutlineNearby(Index triangle, int edge) const
{
  const double most = ReachInPixels * this->PixelSize;
  if (GetSquaredDistance(this->Surfaces.GetCorner(triangle, edge) - this->Point,
        this->Surfaces.GetCorner(triangle, (edge + 1) % 3) - this->Point) > most * most)
  {
    return false;
  }
  const double side = this->Surfaces.GetAreaNormal(triangle).dot(this->ToEye);
  const double other =
    this->Surfaces.GetAreaNormal(this->Surfaces.GetNeighbour(triangle, edge)).dot(this->ToEye);
  return (side < 0.0) != (this->Surfaces.IsAlike(triangle, edge) ? other < 0.0 : other >= 0.0);
}

//------------------------------------------------------------------------------
bool HidingLayers::IsWithinReach(Index triangle, double reach) const
{
  for (int corner = 0; corner < 3; ++corner)
  {
    const Vector here = this->Surfaces.GetCorner(triangle, corner) - this->Point;
    if (here.squaredNorm() <= reach * reach)
    {
      return true;
    }
  }
  return this->GetDistance(triangle) <= reach;
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
