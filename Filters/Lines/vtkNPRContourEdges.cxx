// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRContourEdges.h"

#include "nprPlaneBounds.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPRContourEdges);

namespace
{
using Index = npr::TriangleMesh::Index;
}

//------------------------------------------------------------------------------
// 1 for triangles that face the eye, or are seen edge-on; else 0.
void vtkNPRContourEdges::EvaluateTriangles(const npr::LineSurface& surface,
  const npr::LineView& view, vtkIdType begin, vtkIdType end, signed char* values) const
{
  const npr::TriangleMesh& mesh = surface.GetMesh();
  const Eigen::Vector3d eye(view.Eye[0], view.Eye[1], view.Eye[2]);
  if (view.Perspective != 0.0f)
  {
    for (vtkIdType t = begin; t < end; ++t)
    {
      const npr::TrianglePlane plane(mesh, static_cast<Index>(t));
      values[t] = plane.Normal.dot(eye - plane.Corner) >= 0.0;
    }
    return;
  }
  // A direction is a unit vector of floats: half of the last digit of each component was rounded,
  // and it may have been as much again before.
  constexpr double rounding = 1.0 / (1 << 24);
  for (vtkIdType t = begin; t < end; ++t)
  {
    const Eigen::Vector3d normal = npr::TrianglePlane(mesh, static_cast<Index>(t)).Normal;
    values[t] = normal.dot(eye) >= -rounding * normal.lpNorm<1>();
  }
}

//------------------------------------------------------------------------------
signed char vtkNPRContourEdges::BoundTriangles(
  const npr::PlaneBounds& planes, const npr::LineView& view) const
{
  const auto [low, high] = planes.GetRange(view);
  return low > 0.0 ? 1 : high < 0.0 ? 0 : MixedTriangles;
}

//------------------------------------------------------------------------------
void vtkNPRContourEdges::CompareTriangles(const npr::LineSurface& surface,
  const npr::EdgeList& edges, vtkIdType begin, vtkIdType end, const signed char* values,
  float* strength) const
{
  if (edges.AreOriented)
  {
    const Index* const sides = edges.HalfEdges.data();
    for (vtkIdType i = begin; i < end; ++i)
    {
      strength[i - begin] =
        static_cast<float>(values[sides[2 * i] / 3] - values[sides[2 * i + 1] / 3]);
    }
    return;
  }
  for (vtkIdType i = begin; i < end; ++i)
  {
    const Index* side = edges.Begin(static_cast<Index>(i));
    const Index* const last = edges.End(static_cast<Index>(i));
    if (last - side == 1)
    {
      strength[i - begin] = 1.0f; // the triangle is on its left
      continue;
    }
    // How many more triangles lie on the left of the first triangle's half-edge than on its right.
    const Index start = surface.GetWelded(surface.GetStart(*side));
    int balance = 0;
    for (; side != last; ++side)
    {
      const bool forward = surface.GetWelded(surface.GetStart(*side)) == start;
      balance += (values[*side / 3] == 1) == forward ? 1 : -1;
    }
    strength[i - begin] = balance == 0 ? 0.0f : balance > 0 ? 1.0f : -1.0f;
  }
}
