// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprEdgeSides.h
 * @brief The surface on the two sides of an edge, and whether the edge is a soft crease.
 *
 * All is written for a surface of half-edges 3 * triangle + edge, with
 *
 *     Eigen::Vector3d GetPoint(Index halfEdge) const;       // where it starts
 *     Index GetOther(Index halfEdge) const;                 // beyond the edge, or negative
 *     bool AreOpposite(Index halfEdge, Index other) const;  // whether they run in two directions
 */
#ifndef nprEdgeSides_h
#define nprEdgeSides_h

#include "nprTriangleMesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace npr
{
/// Which share of the angle of a crease an edge needs that stands out from the edges beside it.
inline constexpr double SoftCreaseShare = 0.5;
/// Below which angle an edge between two facets of a round face is no crease: 1.3 times that of a
/// crease, but no more than 50 degrees. The side of a hole of eight facets is round, a box is not.
inline double GetRoundAngle(double creaseAngle)
{
  constexpr double share = 1.3;
  constexpr double most = 0.8727; // 50 degrees
  return std::min(share * creaseAngle, most);
}

/**
 * @class PathAcross
 * @brief A straight path that leaves the middle of an edge at a right angle, over the triangle on
 * one side and those beyond it: the edges on its way are unfolded.
 */
template<typename Surface>
class PathAcross
{
public:
  using Index = TriangleMesh::Index;
  using Vector = Eigen::Vector3d;

  PathAcross(const Surface& surface, Index halfEdge) : Sides(surface)
  {
    this->Enter(halfEdge);
    this->Place = { 0.5 * this->Length, 0.0 };
    this->FindExit();
  }

  /// Unit normal of the triangle that it is in, turned as the first one is; zero without area.
  const Vector& GetNormal() const { return this->Normal; }
  /// How far the apex of that triangle is from the edge that the path came over.
  double GetHeight() const { return this->Apex[1]; }
  /// How far it goes in that triangle. Negative where it goes nowhere.
  double GetStep() const { return this->Step; }
  /// The angle between that triangle and the one before, in radians; negative where the surface is
  /// hollow there, as seen from the side of the normals.
  double GetBend() const { return this->Bend; }

  /// On to the next triangle. False at a border, at triangles without area, and after so many
  /// that it must be winding around a point.
  bool Advance()
  {
    constexpr int mostTriangles = 100;
    if (this->Step < 0.0 || ++this->NumberOfTriangles > mostTriangles)
    {
      return false;
    }
    const Index leaving = 3 * (this->HalfEdge / 3) + (this->HalfEdge + (this->Right ? 1 : 2)) % 3;
    const Index next = this->Sides.GetOther(leaving);
    if (next < 0)
    {
      return false;
    }
    const double length = this->ExitEdge.norm();
    const double along =
      (this->Place + this->Step * this->Direction - this->ExitFrom).dot(this->ExitEdge) / length;
    this->Direction = { this->Direction.dot(this->ExitEdge) / length,
      Cross(this->Direction, this->ExitEdge) / length };
    // Mostly it runs the other way in the next triangle.
    const bool opposite = this->Sides.AreOpposite(leaving, next);
    this->Place = { opposite ? length - along : along, 0.0 };
    if (opposite)
    {
      this->Direction[0] = -this->Direction[0];
    }
    else
    {
      this->Turned = -this->Turned;
    }
    const Vector before = this->Normal;
    const Vector start = this->Sides.GetPoint(leaving);
    this->Enter(next);
    const double angle = std::atan2(before.cross(this->Normal).norm(), before.dot(this->Normal));
    const Vector apex = this->Sides.GetPoint(3 * (next / 3) + (next + 2) % 3);
    this->Bend = before.dot(apex - start) > 0.0 ? -angle : angle;
    this->FindExit();
    return true;
  }

private:
  using Vector2 = Eigen::Vector2d;

  static double Cross(const Vector2& a, const Vector2& b) { return a[0] * b[1] - a[1] * b[0]; }

  /// Lays out a triangle with one of its half-edges as the x axis, its third corner above it.
  void Enter(Index halfEdge)
  {
    this->HalfEdge = halfEdge;
    const Index first = 3 * (halfEdge / 3);
    const Vector start = this->Sides.GetPoint(halfEdge);
    const Vector edge = this->Sides.GetPoint(first + (halfEdge + 1) % 3) - start;
    const Vector side = this->Sides.GetPoint(first + (halfEdge + 2) % 3) - start;
    const Vector area = edge.cross(side);
    this->Length = edge.norm();
    this->Apex = this->Length > 0.0
      ? Vector2(side.dot(edge) / this->Length, area.norm() / this->Length)
      : Vector2(0.0, 0.0);
    this->Normal = this->Turned * area.normalized();
  }

  void FindExit()
  {
    // Where the apex is on the left of the path, it leaves by the edge on the right.
    this->Right = Cross(this->Direction, this->Apex - this->Place) > 0.0;
    this->ExitFrom = this->Right ? Vector2(this->Length, 0.0) : this->Apex;
    this->ExitEdge = (this->Right ? this->Apex : Vector2(0.0, 0.0)) - this->ExitFrom;
    const double across = Cross(this->Direction, this->ExitEdge);
    this->Step = this->ExitEdge.norm() > 0.0 && across > 0.0
      ? std::max(0.0, Cross(this->ExitFrom - this->Place, this->ExitEdge) / across)
      : -1.0;
  }

  const Surface& Sides;
  Index HalfEdge = 0;
  int NumberOfTriangles = 1;
  double Length = 0.0;
  Vector2 Apex;
  Vector Normal;
  double Turned = 1.0;
  Vector2 Place;
  Vector2 Direction = { 0.0, 1.0 };
  bool Right = false;
  Vector2 ExitFrom;
  Vector2 ExitEdge;
  double Step = 0.0;
  double Bend = 0.0;
};

/// The mean normal on one side of an edge, as far as a distance; not a unit vector.
template<typename Surface>
Eigen::Vector3d GetSideNormal(const Surface& surface, TriangleMesh::Index halfEdge, double distance)
{
  PathAcross<Surface> path(surface, halfEdge);
  if (path.GetHeight() >= distance)
  {
    return path.GetNormal();
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  do
  {
    const double step = path.GetStep();
    if (step < 0.0)
    {
      break;
    }
    sum += std::min(step, distance) * path.GetNormal();
    distance -= step;
  } while (distance > 0.0 && path.Advance());
  return sum;
}

/// Goes over the bends of the surface on one side of an edge: visit(distance, bend), in radians and
/// negative where it is hollow, says whether to go on.
template<typename Surface, typename Visitor>
void VisitBends(const Surface& surface, TriangleMesh::Index halfEdge, const Visitor& visit)
{
  PathAcross<Surface> path(surface, halfEdge);
  double distance = path.GetStep();
  while (path.Advance() && visit(distance, path.GetBend()))
  {
    distance += path.GetStep();
  }
}

/// What is on the two sides of an edge.
struct BendsBeside
{
  std::array<double, 2> Largest; ///< angles between triangles, in radians, on each side
  double Nearest;                ///< how far the nearest bent edge is on any of them
};

/**
 * The largest angles between the triangles of the next edges across that may be of the same round
 * face as an edge, on the one side of it and on the other. Between wide facets those are not that
 * are bent the other way, or so much more that the face ends there; between small ones, such as a
 * scan's, which go up and down by its noise, all may be.
 *
 * Looked at are the edges three times as far as the nearest that is bent: so the far ends of flat
 * faces do not matter. What is nearer than the least distance does not tell how far to look, since
 * it may be a sliver's.
 *
 * @param angle between the two triangles of the edge, in radians
 */
template<typename Surface>
BendsBeside GetBendsBeside(const Surface& surface, TriangleMesh::Index first,
  TriangleMesh::Index second, double angle, double leastDistance)
{
  constexpr double leastBend = 0.0175; // one degree: less is flat
  // Round-off must not tell an edge at the very distance from one beyond it.
  constexpr double reach = 3.001;
  constexpr double mostRatio = 2.2;
  constexpr double wide = 10.0; // least distances
  const double own = std::copysign(angle,
    PathAcross<Surface>(surface, first)
      .GetNormal()
      .dot(surface.GetPoint(first) - surface.GetPoint(3 * (second / 3) + (second + 2) % 3)));
  double nearest = std::numeric_limits<double>::infinity();
  for (const TriangleMesh::Index side : { first, second })
  {
    VisitBends(surface, side,
      [&](double distance, double bend)
      {
        if (distance >= leastDistance && std::abs(bend) > leastBend)
        {
          nearest = std::min(nearest, distance);
        }
        return distance < nearest;
      });
  }
  const bool isWide = nearest > wide * leastDistance;
  std::array<double, 2> largest = { 0.0, 0.0 };
  for (const int side : { 0, 1 })
  {
    // Each path starts from its own triangle, whose normal may be turned.
    const TriangleMesh::Index start = side == 0 ? first : second;
    const bool isTurned = side == 1 && !surface.AreOpposite(first, second);
    VisitBends(surface, start,
      [&](double distance, double bend)
      {
        const double ratio = (isTurned ? -bend : bend) / own;
        if (distance > reach * nearest || (isWide && ratio > mostRatio))
        {
          return false;
        }
        largest[side] = std::max(largest[side], isWide ? ratio * angle : std::abs(bend));
        return true;
      });
  }
  return { largest, nearest };
}

/// Whether an edge that is bent by an angle stands out from those beside it. In a round face that
/// has been made triangles of, all edges across are bent about alike, however coarse it is, and
/// half as much where it goes over into a flat one; where it ends in a fold, the fold is bent more.
inline bool StandsOut(double angle, const BendsBeside& beside)
{
  constexpr double ratio = 2.0;
  return ratio * (beside.Largest[0] + beside.Largest[1]) < angle;
}

/// Whether an edge may be between two facets of a round face: those on both sides are bent alike,
/// and the facets are small beside the surface. Those of a nut or a bar can be seen.
inline bool IsOfRound(double angle, const BendsBeside& beside, double lengthScale)
{
  constexpr double widest = 0.05; // length scales
  constexpr double ratio = 0.75;
  const auto [less, more] = std::minmax({ beside.Largest[0], beside.Largest[1] });
  return beside.Nearest < widest * lengthScale && less > ratio * angle && angle > ratio * more;
}
}

#endif
