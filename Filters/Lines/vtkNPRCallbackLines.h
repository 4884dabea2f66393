// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRCallbackLines
 * @brief Lines of your own, whose field and test an observer computes for all points at once.
 *
 * Once for each view, on the thread that updates the filter, the object invokes
 * vtkCommand::UpdateDataEvent. The observer asks for quantities with GetQuantity(), and gives the
 * values at all points back with SetField() and, where lines are not wanted everywhere, SetTest().
 * So functions of languages that know one thread, such as Python, define lines; see
 * vtknpr.define_lines there.
 *
 * Lines run where the field is 0 and the test is > 0; their strength rises smoothly from 0 there to
 * 1 where the test is 1.
 *
 * @sa vtkNPRFeatureLines vtkNPRExpressionLines
 */
#ifndef vtkNPRCallbackLines_h
#define vtkNPRCallbackLines_h

#include "vtkNPRLineDefinition.h"

#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
VTK_ABI_NAMESPACE_END

class VTKNPRFILTERSLINES_EXPORT vtkNPRCallbackLines : public vtkNPRLineDefinition
{
public:
  static vtkNPRCallbackLines* New();
  vtkTypeMacro(vtkNPRCallbackLines, vtkNPRLineDefinition);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetName() const override { return this->Name.c_str(); }
  const char* GetDescription() const override { return "where a function of your own is 0"; }
  bool IsViewDependent() const override { return this->ViewDependent; }

  /// What the lines are called in the output and in messages, and by AddKind(). Default is
  /// "callback".
  void SetName(const std::string& name) { this->SetTextParameter("name", name); }

  ///@{
  /// Whether the values change with the view. If not, the observer is called once for a surface.
  /// Default is on.
  vtkSetMacro(ViewDependent, bool);
  vtkGetMacro(ViewDependent, bool);
  vtkBooleanMacro(ViewDependent, bool);
  ///@}

  /// @name For the observer, during the event
  ///@{
  /// The names of all quantities: ndotv, kr ... as vtkNPRExpressionLines documents them, but
  /// vectors (e1, e2, n, v, w, p) as one each.
  static std::vector<std::string> GetQuantityNames();
  /// The values of a quantity, or of a point array of the input, at all points, in the order of the
  /// input. Null, with an error
  /// that says what is missing, when there is none. Not to be changed.
  vtkDataArray* GetQuantity(const char* name);
  int GetNumberOfPoints() const;
  /// Where the eye is, or in parallel projection the unit vector towards it, in the model's space.
  void GetEye(double eye[3]) const;
  bool IsEyeAtInfinity() const;
  /// One number for each point of the input. False, with an error, when there are not so many.
  bool SetField(vtkDataArray* field);
  bool SetTest(vtkDataArray* test);
  ///@}

  /// A copy asks the observers of the other one.
  void CopyParameters(vtkNPRLineDefinition* other) override;

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  /// Whether the observer has asked for a quantity that is made from them.
  bool NeedsDerivatives() const override;
  void BindInput(vtkPolyData* input) override;
  void BeginView(const npr::LineSurface& surface, const npr::LineView& view) override;
  bool HasField() const override
  {
    return true;
  }
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
  bool HasTest() const override;
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view, const Index* points,
    vtkIdType count, const float* fall, float* test) const override;
#endif

protected:
  vtkNPRCallbackLines();
  ~vtkNPRCallbackLines() override;

private:
  std::string Name = "callback";
  bool ViewDependent = true;

  class Internals;
  const std::unique_ptr<Internals> Internal;

  vtkNPRCallbackLines(const vtkNPRCallbackLines&) = delete;
  void operator=(const vtkNPRCallbackLines&) = delete;
};

#endif
