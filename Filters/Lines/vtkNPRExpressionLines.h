// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRExpressionLines
 * @brief Lines of your own, given as formulas at run time.
 *
 * Lines run where the Field has one of the Levels and the Test holds. Both are texts, in the
 * language of ExprTk without all that changes or repeats something: numbers, names, + - * / % ^,
 * comparisons, and, or, not(), a ? b : c, parentheses, functions such as sqrt, abs, min, sin. Upper
 * and lower case differ, so K and k, or P and p, are two names. For example
 * @code
 *   lines->SetField("kr");
 *   lines->SetTest("dwkr > 2 and 20 * ndotv > 0");
 * @endcode
 *
 * @par Names
 * | name | meaning |
 * | --- | --- |
 * | ndotv, sintheta | cosine and sine of the angle between normal and eye |
 * | kr | radial curvature II(w,w) / (w.w), times L |
 * | dwkr | derivative of kr towards the eye where kr is 0, times L^2 |
 * | k1, k2, H | principal curvatures and their mean, times L |
 * | K | Gaussian curvature k1 k2, times L^2 |
 * | P, Q, S, T | derivatives of k1 along e1 and e2, and of k2 along e1 and e2, times L^2 |
 * | e1x e1y e1z, e2x ... | unit principal directions |
 * | nx ..., vx ..., wx ... | normal, direction to the eye, and that without its part along n |
 * | px, py, pz | position, in units of the model |
 * | pi, and your Constants | |
 * | any point array of the input | array_0, array_1 ... or, of three, array_x, array_y, array_z for
 *   one with components |
 *
 * L is the surface's length scale. So curvatures have no unit, and a threshold means the same
 * whatever the unit and size of the model.
 *
 * @par Names of arrays
 * In an array's name all that is no letter, digit or _ becomes _. Where then it does not start with
 * a letter, or is a word of the language or one of the names above, array_ is put in front:
 * "Wall thickness" is Wall_thickness, "2nd" is array_2nd, "P" is array_P. Where two arrays get one
 * name, it is that of the one that has it as it is, else of the first.
 *
 * @par The test
 * It holds where it is > 0; the line's strength rises smoothly from 0 there to 1 where it is 1. At
 * the top level of the test, also in parentheses, comparisons are not 0 or 1: a > b is the margin
 * (a - b) / Fade, `and` takes the least of its parts, `or` the greatest. So lines end where the
 * test turns, inside triangles, and fade out to there. Anything else is taken as it is.
 *
 * @par Errors
 * FindProblem() tells of wrong texts without any input; that a name exists in the input is seen at
 * Update. Where field or test is not a number there are no lines; a warning counts the triangles.
 *
 * @par Time
 * Only the quantities that the texts name are computed, and the lines depend on the view only when
 * one of them does.
 *
 * @sa vtkNPRFeatureLines vtkNPRSuggestiveContours
 */
#ifndef vtkNPRExpressionLines_h
#define vtkNPRExpressionLines_h

#include "vtkNPRLineDefinition.h"

#include <memory>
#include <string>
#include <vector>

class VTKNPRFILTERSLINES_EXPORT vtkNPRExpressionLines : public vtkNPRLineDefinition
{
public:
  static vtkNPRExpressionLines* New();
  vtkTypeMacro(vtkNPRExpressionLines, vtkNPRLineDefinition);

  /// "expression" until they get a name of their own.
  const char* GetName() const override;
  const char* GetDescription() const override;
  bool IsViewDependent() const override;

  ///@{
  /// What the lines are called in the output and in messages, and by AddKind(). Letters, digits, _
  /// and -. Default is empty, for "expression".
  void SetName(const std::string& name) { this->SetTextParameter("name", name); }
  ///@}

  ///@{
  /// The formula that has a level on the lines. Default is empty, an error.
  void SetField(const std::string& field) { this->SetTextParameter("field", field); }
  std::string GetField() const { return this->Field; }
  ///@}

  ///@{
  /// The formula that is > 0 where lines are wanted, see above. Default is empty: everywhere.
  void SetTest(const std::string& test) { this->SetTextParameter("test", test); }
  std::string GetTest() const { return this->Test; }
  ///@}

  ///@{
  /// How far a comparison in the test must hold for the full strength, in the unit of its sides. It
  /// is one for all: where they differ, give one a factor, as in dwkr > 2 and 20 * ndotv > 0. Range
  /// [1e-12, 1e12]. Default is 1.
  vtkSetClampMacro(Fade, double, 1.0e-12, 1.0e12);
  vtkGetMacro(Fade, double);
  ///@}

  ///@{
  /// The values of the field that lines are drawn at, in the field's unit. Taken as single
  /// precision. Default is 0 alone.
  void SetLevels(const std::vector<double>& levels) { this->SetParameter("levels", levels); }
  std::vector<double> GetLevels() const { return this->Levels; }
  ///@}

  /// @name Constants
  ///@{
  /// A number with a name, to use in both formulas; one of the same name is replaced. False, and
  /// nothing is added, when it is no name, or one that means something already.
  bool AddConstant(const std::string& name, double value);
  void RemoveAllConstants() { this->SetTextParameter("constants", std::string()); }
  /// All of them as a text: "a = 1, b = 0.5".
  void SetConstants(const std::string& text) { this->SetTextParameter("constants", text); }
  std::string GetConstants() const { return this->Constants; }
  ///@}

  std::string FindProblem() const override;

#ifndef __VTK_WRAP__
  std::vector<RequiredArray> GetRequiredArrays() const override;
  std::string FindError(const npr::LineSurface& surface) const override;
  void BindInput(vtkPolyData* input) override;
  void BeginView(const npr::LineSurface& surface, const npr::LineView& view) override;
  void EndView(const npr::LineSurface& surface) override;
  bool HasField() const override
  {
    return true;
  }
  std::vector<float> GetLevels(const npr::LineSurface& surface) const override;
  void EvaluateField(const npr::LineSurface& surface, const npr::LineView& view, vtkIdType begin,
    vtkIdType end, float* field) const override;
  bool HasTest() const override;
  void EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view, const Index* points,
    vtkIdType count, const float* fall, float* test) const override;
#endif

protected:
  vtkNPRExpressionLines();
  ~vtkNPRExpressionLines() override;

private:
  std::string Name;
  std::string Field;
  std::string Test;
  double Fade = 1.0;
  std::vector<double> Levels = { 0.0 };
  std::string Constants;

  class Internals;
  const std::unique_ptr<Internals> Internal;

  vtkNPRExpressionLines(const vtkNPRExpressionLines&) = delete;
  void operator=(const vtkNPRExpressionLines&) = delete;
};

#endif
