// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprDirectionTracer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>

namespace npr
{
namespace
{
using Eigen::Vector3d;
using Index = TriangleMesh::Index;

constexpr double LeastStrength = 0.05;
constexpr double Nearest = 0.5;       // spacings between curves
constexpr double StepLength = 0.2;    // spacings between the points of a curve
constexpr double ShortestCurve = 1.2; // spacings
constexpr double SeedsPerCell = 3.0;  // a cell has the area of a squared spacing
constexpr double MostSeeds = 2e6;
constexpr int MostCrossings = 1000;  // of edges within one step: then a curve is caught
constexpr double Agreement = 0.7071; // cosine of the angle that neighbours may differ by
}

//------------------------------------------------------------------------------
DirectionTracer::DirectionTracer(const TriangleMesh& mesh, const Tuples<3>& axes,
  const std::vector<float>& strengths, double spacing, double length)
  : Mesh(mesh), Axes(axes), Strengths(strengths), Spacing(spacing), HalfLength(0.5 * length)
{
}

//------------------------------------------------------------------------------
Vector3d DirectionTracer::GetPosition(const Place& place) const
{
  Vector3d position = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
  {
    position += place.Weights[i] *
      this->Mesh.GetPoint(this->Mesh.GetTriangle(place.Triangle)[i]).cast<double>();
  }
  return position;
}

//------------------------------------------------------------------------------
Vector3d DirectionTracer::GetNormal(Index triangle) const
{
  return this->Mesh.GetAreaNormal(triangle).cast<double>().stableNormalized();
}

//------------------------------------------------------------------------------
double DirectionTracer::GetStrength(const Place& place) const
{
  if (this->Strengths.empty())
  {
    return 1.0;
  }
  double strength = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    strength += place.Weights[i] * this->Strengths[this->Mesh.GetTriangle(place.Triangle)[i]];
  }
  return strength;
}

//------------------------------------------------------------------------------
Vector3d DirectionTracer::GetDirection(const Place& place, const Vector3d& towards) const
{
  Vector3d direction = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
  {
    const Vector3d axis = this->Axes[this->Mesh.GetTriangle(place.Triangle)[i]].cast<double>();
    const double cosine = axis.dot(towards);
    if (place.Weights[i] > 0.05 && std::abs(cosine) < Agreement)
    {
      return Vector3d::Zero();
    }
    direction += place.Weights[i] * (cosine < 0.0 ? -axis : axis);
  }
  const Vector3d normal = this->GetNormal(place.Triangle);
  direction -= normal.dot(direction) * normal;
  const double length = direction.norm();
  return length > 0.1 ? Vector3d(direction / length) : Vector3d::Zero();
}

//------------------------------------------------------------------------------
TracedPoint DirectionTracer::MakePoint(const Place& place) const
{
  return { this->GetPosition(place), this->GetNormal(place.Triangle), this->GetStrength(place) };
}

//------------------------------------------------------------------------------
TracedCurve DirectionTracer::Follow(Place place, Vector3d towards) const
{
  TracedCurve curve;
  const double step = StepLength * this->Spacing;
  for (double length = step; length <= this->HalfLength; length += step)
  {
    double rest = step;
    int crossings = 0;
    while (rest > 0.0)
    {
      const Vector3d direction = this->GetDirection(place, towards);
      if (direction.isZero() || ++crossings > MostCrossings)
      {
        return curve;
      }
      towards = direction;
      // How the weights change along the direction: each is 1 at its corner and 0 on the edge
      // opposite.
      const TriangleMesh::Triangle& corners = this->Mesh.GetTriangle(place.Triangle);
      const Vector3d areaNormal = this->Mesh.GetAreaNormal(place.Triangle).cast<double>();
      if (areaNormal.isZero(0.0))
      {
        return curve;
      }
      Vector3d change;
      double way = rest;
      int exit = -1;
      for (int i = 0; i < 3; ++i)
      {
        const Vector3d edge =
          (this->Mesh.GetPoint(corners[(i + 2) % 3]) - this->Mesh.GetPoint(corners[(i + 1) % 3]))
            .cast<double>();
        change[i] = areaNormal.cross(edge).dot(direction) / areaNormal.squaredNorm();
        if (change[i] < 0.0 && place.Weights[i] < -change[i] * way)
        {
          way = std::max(0.0, place.Weights[i] / -change[i]);
          exit = i;
        }
      }
      place.Weights += way * change;
      rest -= way;
      if (exit < 0)
      {
        break;
      }
      // Edge e runs from corner e to the next, so the edge opposite corner i is i + 1.
      const Index next = this->Mesh.GetNeighbour(place.Triangle, (exit + 1) % 3);
      if (next < 0)
      {
        return curve;
      }
      Place entered{ next, Vector3d::Zero() };
      for (int i = 0; i < 3; ++i)
      {
        for (int j = 0; j < 3; ++j)
        {
          if (j != exit && this->Mesh.GetTriangle(next)[i] == corners[j])
          {
            entered.Weights[i] = std::max(0.0, place.Weights[j]);
          }
        }
      }
      entered.Weights /= std::max(1e-12, entered.Weights.sum());
      place = entered;
    }
    curve.push_back(this->MakePoint(place));
    if (curve.back().Strength < LeastStrength ||
      this->IsCrowded(curve.back(), Nearest * this->Spacing))
    {
      curve.pop_back();
      return curve;
    }
  }
  return curve;
}

//------------------------------------------------------------------------------
std::array<std::int64_t, 3> DirectionTracer::GetCell(const Vector3d& position) const
{
  return { static_cast<std::int64_t>(std::floor(position.x() / this->Spacing)),
    static_cast<std::int64_t>(std::floor(position.y() / this->Spacing)),
    static_cast<std::int64_t>(std::floor(position.z() / this->Spacing)) };
}

//------------------------------------------------------------------------------
bool DirectionTracer::IsCrowded(const TracedPoint& point, double distance) const
{
  const auto cell = this->GetCell(point.Position);
  for (int x = -1; x <= 1; ++x)
  {
    for (int y = -1; y <= 1; ++y)
    {
      for (int z = -1; z <= 1; ++z)
      {
        const auto found = this->Taken.find({ cell[0] + x, cell[1] + y, cell[2] + z });
        if (found != this->Taken.end() &&
          std::any_of(found->second.begin(), found->second.end(),
            [&](const TracedPoint& other)
            {
              return (other.Position - point.Position).norm() < distance &&
                other.Normal.dot(point.Normal) > 0.0;
            }))
        {
          return true;
        }
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void DirectionTracer::Remember(const TracedCurve& curve)
{
  for (const TracedPoint& point : curve)
  {
    this->Taken[this->GetCell(point.Position)].push_back(point);
  }
}

//------------------------------------------------------------------------------
std::vector<TracedCurve> DirectionTracer::Trace(const Progress& progress)
{
  std::vector<double> areas;
  double area = 0.0;
  for (Index t = 0; t < this->Mesh.GetNumberOfTriangles(); ++t)
  {
    area += 0.5 * this->Mesh.GetAreaNormal(t).cast<double>().norm();
    areas.push_back(area);
  }
  std::vector<TracedCurve> curves;
  if (!(area > 0.0) || !std::isfinite(area))
  {
    return curves;
  }
  std::mt19937 random(1);
  const auto draw = [&random]() { return random() / 4294967296.0; };
  const auto seeds = static_cast<int>(
    std::min(MostSeeds, std::ceil(SeedsPerCell * area / (this->Spacing * this->Spacing))));
  for (int seed = 0; seed < seeds; ++seed)
  {
    if (seed % 1024 == 0 && !progress(static_cast<double>(seed) / seeds))
    {
      return curves;
    }
    const auto at = std::upper_bound(areas.begin(), areas.end(), draw() * area);
    const double root = std::sqrt(draw());
    const double side = draw();
    const Place place{ static_cast<Index>(
                         std::min<std::ptrdiff_t>(at - areas.begin(), areas.size() - 1)),
      { 1.0 - root, root * (1.0 - side), root * side } };
    const TracedPoint middle = this->MakePoint(place);
    Index nearest = 0;
    place.Weights.maxCoeff(&nearest);
    const Vector3d axis =
      this->Axes[this->Mesh.GetTriangle(place.Triangle)[nearest]].cast<double>();
    if (middle.Strength < LeastStrength || axis.isZero() || this->IsCrowded(middle, this->Spacing))
    {
      continue;
    }
    TracedCurve curve = this->Follow(place, -axis);
    std::reverse(curve.begin(), curve.end());
    curve.push_back(middle);
    const TracedCurve ahead = this->Follow(place, axis);
    curve.insert(curve.end(), ahead.begin(), ahead.end());
    if (curve.size() * StepLength >= ShortestCurve)
    {
      this->Remember(curve);
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}
}
