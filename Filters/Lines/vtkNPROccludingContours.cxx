// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPROccludingContours.h"

#include "nprArrayNames.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPROccludingContours);

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPROccludingContours::GetRequiredArrays() const
{
  return { { npr::names::Normals, 3, "vtkNPRSurfaceNormals" } };
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
