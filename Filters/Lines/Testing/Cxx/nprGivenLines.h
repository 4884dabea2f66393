// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprGivenLines.h
 * @brief Lines of a field that a test gives. Also the pattern for a definition of one's own.
 */
#ifndef nprGivenLines_h
#define nprGivenLines_h

#include "nprArrayNames.h"
#include "vtkNPRLineDefinition.h"

#include <vtkObjectFactory.h>

#include <algorithm>

namespace nprtest
{
/// Where the array "Field" is 0; if so wanted also where the array "Test" is positive, or with the
/// field's sign belonging to the array "Axes".
class GivenLines : public vtkNPRLineDefinition
{
public:
  static GivenLines* New() { VTK_STANDARD_NEW_BODY(GivenLines); }
  vtkTypeMacro(GivenLines, vtkNPRLineDefinition);

  const char* GetName() const override { return "given"; }
  const char* GetDescription() const override { return "where the array Field is 0"; }
  bool IsViewDependent() const override { return false; }
  std::vector<RequiredArray> GetRequiredArrays() const override
  {
    std::vector<RequiredArray> arrays = { { "Field", 1, "a test" } };
    if (this->Tested)
    {
      arrays.push_back({ "Test", 1, "a test" });
    }
    if (this->Axial)
    {
      arrays.push_back({ npr::names::Normals, 3, "a test" });
      arrays.push_back({ "Axes", 3, "a test" });
    }
    return arrays;
  }
  bool HasField() const override { return true; }
  bool FollowsJumps() const override { return this->Jumps; }
  const char* GetAxes() const override { return this->Axial ? "Axes" : nullptr; }
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView&, vtkIdType begin,
    vtkIdType end, float* field) const override
  {
    std::copy(surface.GetComponent("Field", 0) + begin, surface.GetComponent("Field", 0) + end,
      field + begin);
  }
  bool HasTest() const override { return this->Tested; }
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView&, const Index* points,
    vtkIdType count, const float*, float* test) const override
  {
    const float* const values = surface.GetComponent("Test", 0);
    std::transform(points, points + count, test, [values](Index point) { return values[point]; });
  }

  bool Tested = false;
  bool Axial = false;
  bool Jumps = false;

protected:
  GivenLines() = default;
  ~GivenLines() override = default;
};
}

#endif
