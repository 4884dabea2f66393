// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRNonManifoldEdges.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPRNonManifoldEdges);

//------------------------------------------------------------------------------
void vtkNPRNonManifoldEdges::EvaluateEdges(const npr::LineSurface&, const npr::LineView&,
  const npr::EdgeList& edges, vtkIdType begin, vtkIdType end, float* strength) const
{
  for (vtkIdType i = begin; i < end; ++i)
  {
    const Index edge = static_cast<Index>(i);
    strength[i - begin] = edges.End(edge) - edges.Begin(edge) > 2 ? 1.0f : 0.0f;
  }
}
