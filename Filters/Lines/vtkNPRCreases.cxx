// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRCreases.h"

#include "nprEdgeSides.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkNPRCreases);

namespace
{
using Index = npr::TriangleMesh::Index;

/// The angle between the sides of a fold, of which nothing is seen but the outline.
constexpr double FoldedFlat = 3.1067; // 178 degrees

/// How many times further a crease must turn the surface, too. Where it does not, it is a wrinkle
/// or a step that is too low to be seen.
constexpr double WiderView = 5.0;

/// What the sides of edges are on.
struct WeldedSides
{
  Eigen::Vector3d GetPoint(Index halfEdge) const
  {
    return this->Surface.GetMesh().GetPoint(this->Surface.GetStart(halfEdge)).cast<double>();
  }
  Index GetOther(Index halfEdge) const { return this->Surface.GetOther(halfEdge); }
  bool AreOpposite(Index halfEdge, Index other) const
  {
    return this->Surface.GetWelded(this->Surface.GetStart(halfEdge)) !=
      this->Surface.GetWelded(this->Surface.GetStart(other));
  }

  const npr::LineSurface& Surface;
};
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
  const double sharp = vtkMath::RadiansFromDegrees(this->Angle);
  const double soft = npr::SoftCreaseShare * sharp;
  const double distance = this->Tolerance * surface.GetLengthScale();
  const WeldedSides sides{ surface };
  for (vtkIdType i = begin; i < end; ++i)
  {
    const Index* side = edges.Begin(static_cast<Index>(i));
    bool accepted = false;
    if (edges.End(static_cast<Index>(i)) - side == 2)
    {
      // Triangles that run along the edge in one direction have opposite windings. Sides without
      // area have no angle.
      const bool opposite = sides.AreOpposite(side[0], side[1]);
      const auto getAngle = [&](double reach)
      {
        const Eigen::Vector3d a = npr::GetSideNormal(sides, side[0], reach);
        const Eigen::Vector3d b = npr::GetSideNormal(sides, side[1], reach);
        return a.squaredNorm() == 0.0 || b.squaredNorm() == 0.0
          ? 0.0
          : std::atan2(a.cross(b).norm(), opposite ? a.dot(b) : -a.dot(b));
      };
      // The triangles must meet at the angle, too: else each edge of a sliver beside a crease would
      // be one.
      const double angle = getAngle(0.0);
      if (angle > soft)
      {
        const double near = getAngle(distance);
        const double far = getAngle(WiderView * distance);
        const double least = std::min({ angle, near, far });
        accepted = least > sharp && (distance == 0.0 || near <= FoldedFlat);
        // Where the preparation has split the surface it knows more than can be seen from here.
        const bool isSeam = surface.GetTwin(side[0]) == npr::LineSurface::NoTwin;
        if (distance > 0.0 && this->Angle < 180.0 &&
          (accepted ? angle < npr::GetRoundAngle(sharp) : isSeam && least > soft))
        {
          const npr::BendsBeside beside =
            npr::GetBendsBeside(sides, side[0], side[1], angle, WiderView * distance);
          accepted = accepted ? !npr::IsOfRound(angle, beside, surface.GetLengthScale())
                              : npr::StandsOut(angle, beside);
        }
      }
    }
    strength[i - begin] = accepted ? 1.0f : 0.0f;
  }
}
