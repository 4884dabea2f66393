// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRNonManifoldEdges
 * @brief Where sheets of a surface meet: edges with three or more triangles.
 *
 * Edges are counted on the welded surface, so those that vtkNPRSurfacePreparation has split are
 * still found, by its WeldedPointIds. An edge with one triangle belongs to vtkNPRBoundaries, one
 * with two to vtkNPRCreases; so no edge is drawn twice where all three are.
 *
 * @sa vtkNPRFeatureLines vtkNPRCreases vtkNPRBoundaries
 */
#ifndef vtkNPRNonManifoldEdges_h
#define vtkNPRNonManifoldEdges_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRNonManifoldEdges : public vtkNPRLineDefinition
{
public:
  static vtkNPRNonManifoldEdges* New();
  vtkTypeMacro(vtkNPRNonManifoldEdges, vtkNPRLineDefinition);

  const char* GetName() const override { return "non-manifold"; }
  const char* GetDescription() const override
  {
    return "where more than two triangles meet at an edge";
  }
  bool IsViewDependent() const override { return false; }

#ifndef __VTK_WRAP__
  EdgeKind GetEdges() const override
  {
    return SeamEdges;
  }
  void EvaluateEdges(const npr::LineSurface& surface, const npr::LineView& view,
    const npr::EdgeList& edges, vtkIdType begin, vtkIdType end, float* strength) const override;
#endif

protected:
  vtkNPRNonManifoldEdges() = default;
  ~vtkNPRNonManifoldEdges() override = default;

private:
  vtkNPRNonManifoldEdges(const vtkNPRNonManifoldEdges&) = delete;
  void operator=(const vtkNPRNonManifoldEdges&) = delete;
};

#endif
