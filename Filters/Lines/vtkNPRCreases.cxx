// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRCreases.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkNPRCreases);

namespace
{
using Index = npr::TriangleMesh::Index;

/// The cosine of the angle between the sides of a fold, of which nothing is seen but the outline.
constexpr double FoldedFlat = -0.9994; // 178 degrees

/// How many times further a crease must turn the surface, too. Where it does not, it is a wrinkle
/// or a step that is too low to be seen.
constexpr double WiderView = 5.0;

/// A triangle with one of its half-edges as the x axis, its third corner above it.
struct Flat
{
  Flat(const npr::LineSurface& surface, Index halfEdge)
  {
    const npr::TriangleMesh& mesh = surface.GetMesh();
    const Index third = surface.GetEnd(3 * (halfEdge / 3) + (halfEdge + 1) % 3);
    const Eigen::Vector3d start = mesh.GetPoint(surface.GetStart(halfEdge)).cast<double>();
    const Eigen::Vector3d edge = mesh.GetPoint(surface.GetEnd(halfEdge)).cast<double>() - start;
    const Eigen::Vector3d side = mesh.GetPoint(third).cast<double>() - start;
    this->Length = edge.norm();
    this->Normal = edge.cross(side);
    if (this->Length > 0.0)
    {
      this->Apex = { side.dot(edge) / this->Length, this->Normal.norm() / this->Length };
    }
    this->Normal.normalize();
  }

  double Length = 0.0;
  Eigen::Vector2d Apex = Eigen::Vector2d::Zero();
  Eigen::Vector3d Normal;
};

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// The mean normal of the surface on one side of an edge: along the straight path that leaves its
/// middle at a right angle, as far as the distance. The edges on its way are unfolded.
Eigen::Vector3d GetSideNormal(const npr::LineSurface& surface, Index halfEdge, double distance)
{
  constexpr int mostTriangles = 100; // a path around a point of many slivers ends somewhere
  Flat flat(surface, halfEdge);
  if (flat.Apex[1] >= distance)
  {
    return flat.Normal;
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector2d place(0.5 * flat.Length, 0.0);
  Eigen::Vector2d direction(0.0, 1.0);
  double turned = 1.0;
  for (int i = 0; i < mostTriangles && distance > 0.0; ++i)
  {
    // Where the apex is on the left of the path, it leaves by the edge on the right.
    const bool right = Cross(direction, flat.Apex - place) > 0.0;
    const Eigen::Vector2d from = right ? Eigen::Vector2d(flat.Length, 0.0) : flat.Apex;
    const Eigen::Vector2d edge = (right ? flat.Apex : Eigen::Vector2d(0.0, 0.0)) - from;
    const double length = edge.norm();
    const double across = Cross(direction, edge);
    if (!(length > 0.0 && across > 0.0))
    {
      break;
    }
    const double step = std::max(0.0, Cross(from - place, edge) / across);
    sum += turned * std::min(step, distance) * flat.Normal;
    distance -= step;
    const Index leaving = 3 * (halfEdge / 3) + (halfEdge + (right ? 1 : 2)) % 3;
    const Index next = surface.GetOther(leaving);
    if (next == npr::LineSurface::NoTwin)
    {
      break;
    }
    const double along = (place + step * direction - from).dot(edge) / length;
    direction = { direction.dot(edge) / length, across / length };
    // Mostly it runs the other way in the next triangle.
    const bool opposite =
      surface.GetWelded(surface.GetStart(leaving)) != surface.GetWelded(surface.GetStart(next));
    place = { opposite ? length - along : along, 0.0 };
    if (opposite)
    {
      direction[0] = -direction[0];
    }
    else
    {
      turned = -turned;
    }
    halfEdge = next;
    flat = Flat(surface, halfEdge);
  }
  return sum;
}
}

//------------------------------------------------------------------------------
vtkNPRCreases::vtkNPRCreases()
{
  this->AddParameter(
    "angle", "least angle between the two sides of an edge, in degrees", this->Angle, 0.0, 180.0);
  this->AddParameter("tolerance",
    "how far from the edge its sides are looked at, in length scales: what is narrower makes no "
    "crease",
    this->Tolerance, 0.0, 1.0);
  this->AddParameter("leastEdges", "least number of edges that make a crease; fewer are noise",
    this->LeastEdges, 1.0, 1.0e6);
}

//------------------------------------------------------------------------------
void vtkNPRCreases::EvaluateEdges(const npr::LineSurface& surface, const npr::LineView&,
  const npr::EdgeList& edges, vtkIdType begin, vtkIdType end, float* strength) const
{
  const double cosine = std::cos(vtkMath::RadiansFromDegrees(this->Angle));
  const double distance = this->Tolerance * surface.GetLengthScale();
  for (vtkIdType i = begin; i < end; ++i)
  {
    const Index* side = edges.Begin(static_cast<Index>(i));
    bool accepted = false;
    if (edges.End(static_cast<Index>(i)) - side == 2)
    {
      // Triangles that run along the edge in one direction have opposite windings.
      const bool opposite = surface.GetWelded(surface.GetStart(side[0])) ==
        surface.GetWelded(surface.GetStart(side[1]));
      // Sides without area have no angle.
      const auto isSharp = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, double least)
      {
        const double dot = opposite ? -a.dot(b) : a.dot(b);
        const double norms = a.norm() * b.norm();
        return norms > 0.0 && dot < cosine * norms && dot >= least * norms;
      };
      // The triangles must meet at the angle, too: else each edge of a sliver beside a crease would
      // be one.
      const auto isSharpWithin = [&](double reach, double least)
      {
        return isSharp(
          GetSideNormal(surface, side[0], reach), GetSideNormal(surface, side[1], reach), least);
      };
      accepted = isSharp(Flat(surface, side[0]).Normal, Flat(surface, side[1]).Normal, -2.0) &&
        (distance == 0.0 ||
          (isSharpWithin(distance, FoldedFlat) && isSharpWithin(WiderView * distance, -2.0)));
    }
    strength[i - begin] = accepted ? 1.0f : 0.0f;
  }
}
