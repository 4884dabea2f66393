// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPROccludingContours
 * @brief The outline: where the surface turns away from the eye.
 *
 * The field is the normal times the vector to the eye (not normalised: the zero set is the same,
 * and on a flat face the sign never changes). Where the surface is split at creases the line runs
 * along the edges that have a front and a back side, and it runs along borders; so the outline has
 * no gaps.
 *
 * Sources: the zero set on smooth surfaces as in Hertzmann and Zorin, "Illustrating smooth
 * surfaces", SIGGRAPH 2000; edges as in Markosian et al., "Real-time nonphotorealistic rendering",
 * SIGGRAPH 1997.
 *
 * @sa vtkNPRFeatureLines vtkNPRSuggestiveContours
 */
#ifndef vtkNPROccludingContours_h
#define vtkNPROccludingContours_h

#include "vtkNPRLineDefinition.h"

class VTKNPRFILTERSLINES_EXPORT vtkNPROccludingContours : public vtkNPRLineDefinition
{
public:
  static vtkNPROccludingContours* New();
  vtkTypeMacro(vtkNPROccludingContours, vtkNPRLineDefinition);

  const char* GetName() const override { return "contours"; }
  const char* GetDescription() const override
  {
    return "where the surface turns away from the eye: the outline";
  }
  bool IsViewDependent() const override { return true; }

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  bool HasField() const override
  {
    return true;
  }
  std::array<float, 2> GetFacingRange() const override
  {
    return { 0.0f, 0.0f };
  }
  std::vector<RequiredArray> GetSlopeArrays() const override;
  void EvaluateSlopes(const npr::LineSurface& surface, const npr::LineView& view, const Index* from,
    const Index* to, vtkIdType count, float* atFrom, float* atTo) const override;
  bool FollowsJumps() const override
  {
    return true;
  }
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
#endif

protected:
  vtkNPROccludingContours() = default;
  ~vtkNPROccludingContours() override = default;

private:
  vtkNPROccludingContours(const vtkNPROccludingContours&) = delete;
  void operator=(const vtkNPROccludingContours&) = delete;
};

#endif
