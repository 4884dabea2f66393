// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRRegionBorders.h"

#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(vtkNPRRegionBorders);

//------------------------------------------------------------------------------
vtkNPRRegionBorders::vtkNPRRegionBorders()
{
  this->AddTextParameter(
    "array", "name of the cell array whose values tell the regions apart", this->Array);
}

//------------------------------------------------------------------------------
void vtkNPRRegionBorders::EvaluateEdges(const npr::LineSurface& surface, const npr::LineView&,
  const npr::EdgeList& edges, vtkIdType begin, vtkIdType end, float* strength) const
{
  const std::vector<Index>& regions = surface.GetRegions(this->Array);
  for (vtkIdType i = begin; i < end; ++i)
  {
    const Index* const side = edges.Begin(static_cast<Index>(i));
    const Index* const last = edges.End(static_cast<Index>(i));
    const Index first = regions[*side / 3];
    const Index* const other =
      std::find_if(side + 1, last, [&](Index halfEdge) { return regions[halfEdge / 3] != first; });
    // The first triangle is on the left of its half-edge.
    strength[i - begin] = other == last ? 0.0f : regions[*other / 3] < first ? 1.0f : -1.0f;
  }
}
