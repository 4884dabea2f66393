// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPROccludingContours.h"

#include "nprArrayNames.h"

#include <vtkObjectFactory.h>

#include <Eigen/Core>

vtkStandardNewMacro(vtkNPROccludingContours);

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPROccludingContours::GetRequiredArrays() const
{
  return { { npr::names::Normals, 3, "vtkNPRSurfaceNormals" } };
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPROccludingContours::GetSlopeArrays() const
{
  return { { npr::names::CurvatureTensor, 6, "vtkNPRCurvatureTensor" } };
}

//------------------------------------------------------------------------------
void vtkNPROccludingContours::EvaluateSlopes(const npr::LineSurface& surface,
  const npr::LineView& view, const Index* from, const Index* to, vtkIdType count, float* atFrom,
  float* atTo) const
{
  const npr::TriangleMesh& mesh = surface.GetMesh();
  const Eigen::Vector3f eye(view.Eye[0], view.Eye[1], view.Eye[2]);
  // Along a curve on the surface with the tangent x, n.(eye - p) changes by II(x, eye - p): n.x is
  // 0 there. The edge is the chord of such a curve.
  const auto getSlope = [&](Index point, const Eigen::Vector3f& edge)
  {
    const auto get = [&](const char* name, int component)
    { return surface.GetComponent(name, component)[point]; };
    const auto tensor = [&](int component) { return get(npr::names::CurvatureTensor, component); };
    const Eigen::Vector3f turn(tensor(0) * edge.x() + tensor(3) * edge.y() + tensor(5) * edge.z(),
      tensor(3) * edge.x() + tensor(1) * edge.y() + tensor(4) * edge.z(),
      tensor(5) * edge.x() + tensor(4) * edge.y() + tensor(2) * edge.z());
    return turn.dot(eye - view.Perspective * mesh.GetPoint(point));
  };
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Eigen::Vector3f edge = mesh.GetPoint(to[i]) - mesh.GetPoint(from[i]);
    atFrom[i] = getSlope(from[i], edge);
    atTo[i] = getSlope(to[i], edge);
  }
}

//------------------------------------------------------------------------------
void vtkNPROccludingContours::EvaluateField(const npr::LineSurface& surface,
  const npr::LineView& view, vtkIdType begin, vtkIdType end, float* field) const
{
  const float* px = surface.GetCoordinate(0);
  const float* py = surface.GetCoordinate(1);
  const float* pz = surface.GetCoordinate(2);
  const float* nx = surface.GetComponent(npr::names::Normals, 0);
  const float* ny = surface.GetComponent(npr::names::Normals, 1);
  const float* nz = surface.GetComponent(npr::names::Normals, 2);
  const float x = view.Eye[0];
  const float y = view.Eye[1];
  const float z = view.Eye[2];
  const float s = view.Perspective;
  for (vtkIdType i = begin; i < end; ++i)
  {
    field[i] = nx[i] * (x - s * px[i]) + ny[i] * (y - s * py[i]) + nz[i] * (z - s * pz[i]);
  }
}
