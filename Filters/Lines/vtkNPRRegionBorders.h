// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRRegionBorders
 * @brief Where one region ends and another begins: edges between triangles that have different
 * values in a cell array.
 *
 * Any array of numbers will do; of one with several components all are compared. Values are
 * compared exactly, so fields that are measured or computed should be put in classes before.
 * Values that are not a number are one region. The region with the higher value is on the line's
 * left.
 *
 * @sa vtkNPRFeatureLines
 */
#ifndef vtkNPRRegionBorders_h
#define vtkNPRRegionBorders_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPRRegionBorders : public vtkNPRLineDefinition
{
public:
  static vtkNPRRegionBorders* New();
  vtkTypeMacro(vtkNPRRegionBorders, vtkNPRLineDefinition);

  const char* GetName() const override { return "region-borders"; }
  const char* GetDescription() const override { return "where the values of a cell array change"; }
  bool IsViewDependent() const override { return false; }

  ///@{
  /// The name of the cell array. Default is "RegionId", as vtkConnectivityFilter calls it.
  vtkSetMacro(Array, std::string);
  vtkGetMacro(Array, std::string);
  ///@}

#ifndef __VTK_WRAP__
  const char* GetRequiredCellArray() const override
  {
    return this->Array.c_str();
  }
  EdgeKind GetEdges() const override
  {
    return AllEdges;
  }
  void EvaluateEdges(const npr::LineSurface& surface, const npr::LineView& view,
    const npr::EdgeList& edges, vtkIdType begin, vtkIdType end, float* strength) const override;
#endif

protected:
  vtkNPRRegionBorders();
  ~vtkNPRRegionBorders() override = default;

private:
  std::string Array = "RegionId";

  vtkNPRRegionBorders(const vtkNPRRegionBorders&) = delete;
  void operator=(const vtkNPRRegionBorders&) = delete;
};

#endif
