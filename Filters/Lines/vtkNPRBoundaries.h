// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRBoundaries
 * @brief Where an open surface ends: edges with one triangle, which is on their left.
 *
 * @sa vtkNPRFeatureLines vtkNPRCreases
 */
#ifndef vtkNPRBoundaries_h
#define vtkNPRBoundaries_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRBoundaries : public vtkNPRLineDefinition
{
public:
  static vtkNPRBoundaries* New();
  vtkTypeMacro(vtkNPRBoundaries, vtkNPRLineDefinition);

  const char* GetName() const override { return "boundaries"; }
  const char* GetDescription() const override { return "where an open surface ends"; }
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
  vtkNPRBoundaries() = default;
  ~vtkNPRBoundaries() override = default;

private:
  vtkNPRBoundaries(const vtkNPRBoundaries&) = delete;
  void operator=(const vtkNPRBoundaries&) = delete;
};

#endif
