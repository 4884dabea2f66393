// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRCreases.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(vtkNPRCreases);

//------------------------------------------------------------------------------
vtkNPRCreases::vtkNPRCreases()
{
  this->AddParameter("angle", "least angle between the normals of two triangles, in degrees",
    this->Angle, 0.0, 180.0);
  this->AddParameter("leastEdges", "least number of edges that make a crease; fewer are noise",
    this->LeastEdges, 1.0, 1.0e6);
}

//------------------------------------------------------------------------------
void vtkNPRCreases::EvaluateEdges(const npr::LineSurface& surface, const npr::LineView&,
  const npr::EdgeList& edges, vtkIdType begin, vtkIdType end, float* strength) const
{
  const npr::TriangleMesh& mesh = surface.GetMesh();
  const double cosine = std::cos(vtkMath::RadiansFromDegrees(this->Angle));
  for (vtkIdType i = begin; i < end; ++i)
  {
    const Index* side = edges.Begin(static_cast<Index>(i));
    const auto count = edges.End(static_cast<Index>(i)) - side;
    bool accepted = false;
    if (count == 2)
    {
      const Eigen::Vector3d a = mesh.GetAreaNormal(side[0] / 3).cast<double>();
      const Eigen::Vector3d b = mesh.GetAreaNormal(side[1] / 3).cast<double>();
      // Triangles that run along the edge in one direction have opposite windings.
      const bool opposite = surface.GetWelded(surface.GetStart(side[0])) ==
        surface.GetWelded(surface.GetStart(side[1]));
      const double dot = opposite ? -a.dot(b) : a.dot(b);
      const double norms = a.norm() * b.norm();
      // A triangle without area has no angle with another.
      accepted = norms > 0.0 && dot < cosine * norms;
    }
    strength[i - begin] = accepted ? 1.0f : 0.0f;
  }
}
