// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRExpressionLines.h"

#include "nprLineFormula.h"

#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

vtkStandardNewMacro(vtkNPRExpressionLines);

namespace
{
using ConstantsMap = npr::Expression::Constants;

bool IsFreeName(const std::string& name)
{
  return npr::Expression::IsName(name) && !npr::Expression::IsReserved(name) &&
    !npr::LineNames().Find(name);
}

std::string WriteConstants(const ConstantsMap& constants)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  for (const auto& [name, value] : constants)
  {
    text << (text.tellp() > 0 ? ", " : "") << name << " = " << value;
  }
  return text.str();
}

// Of "a = 1, b = 0.5". False, with what stands where one was expected, when that is none.
bool ReadConstants(const std::string& text, ConstantsMap& constants, std::string& wrong)
{
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');)
  {
    std::istringstream stream(part);
    stream.imbue(std::locale::classic());
    stream >> std::ws;
    std::string name;
    double value = 0.0;
    while (stream && stream.peek() != '=' && !std::isspace(stream.peek()))
    {
      name += static_cast<char>(stream.get());
    }
    stream >> std::ws;
    if (stream.get() != '=' || !(stream >> value) || !(stream >> std::ws).eof() ||
      !IsFreeName(name))
    {
      wrong = part;
      return false;
    }
    constants[name] = value;
  }
  return true;
}

ConstantsMap GetConstantsOf(const std::string& text)
{
  ConstantsMap constants;
  std::string wrong;
  ReadConstants(text, constants, wrong);
  return constants;
}
}

class vtkNPRExpressionLines::Internals
{
public:
  std::unique_ptr<npr::LineFormula> Field;
  std::unique_ptr<npr::LineFormula> Test; // null where lines are wanted everywhere
  vtkMTimeType MTime = 0;                 // the definition's, when the formulas were made
  std::string Error;
  bool HasWarned = false;

  std::vector<npr::LineFormula*> GetFormulas() const
  {
    std::vector<npr::LineFormula*> formulas = { this->Field.get(), this->Test.get() };
    formulas.erase(std::remove(formulas.begin(), formulas.end(), nullptr), formulas.end());
    return formulas;
  }
};

//------------------------------------------------------------------------------
vtkNPRExpressionLines::vtkNPRExpressionLines() : Internal(new Internals)
{
  this->AddTextParameter("name", "what the lines are called", this->Name);
  this->AddTextParameter("field", "the formula that has a level on the lines", this->Field);
  this->AddTextParameter("test", "the formula that is > 0 where lines are wanted", this->Test);
  this->AddParameter("fade", "how far comparisons in the test must hold for the full strength",
    this->Fade, 1.0e-12, 1.0e12);
  this->AddParameter("levels", "values of the field that lines are drawn at", this->Levels,
    std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max());
  this->AddTextParameter(
    "constants", "numbers with names, such as \"a = 1, b = 0.5\"", this->Constants);
}

vtkNPRExpressionLines::~vtkNPRExpressionLines() = default;

//------------------------------------------------------------------------------
const char* vtkNPRExpressionLines::GetName() const
{
  return this->Name.empty() ? "expression" : this->Name.c_str();
}

//------------------------------------------------------------------------------
const char* vtkNPRExpressionLines::GetDescription() const
{
  return this->Field.empty() ? "where a formula of your own is 0 and a test of your own holds"
                             : this->Field.c_str();
}

//------------------------------------------------------------------------------
bool vtkNPRExpressionLines::IsViewDependent() const
{
  const npr::LineNames names;
  for (const std::string& text : { this->Field, this->Test })
  {
    for (const std::string& name : npr::Expression::GetNames(text))
    {
      const npr::LineNames::Meaning* meaning = names.Find(name);
      if (meaning && meaning->Quantity->ViewDependent)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkNPRExpressionLines::AddConstant(const std::string& name, double value)
{
  if (!IsFreeName(name) || !std::isfinite(value))
  {
    return false;
  }
  ConstantsMap constants = GetConstantsOf(this->Constants);
  constants[name] = value;
  this->SetConstants(WriteConstants(constants));
  return true;
}

//------------------------------------------------------------------------------
std::string vtkNPRExpressionLines::FindProblem() const
{
  if (!std::all_of(this->Name.begin(), this->Name.end(),
        [](char c) { return npr::Expression::IsName(std::string("a") + c) || c == '-'; }))
  {
    return "their name may have letters, digits, _ and - only";
  }
  if (this->Field.empty())
  {
    return "they have no field: give a formula, such as kr";
  }
  ConstantsMap constants;
  std::string wrong;
  if (!ReadConstants(this->Constants, constants, wrong))
  {
    return "constants are written a = 1, b = 0.5, with names that mean nothing yet; not \"" +
      wrong + "\"";
  }
  std::string problem = npr::Expression::FindProblem(this->Field, npr::Expression::Value);
  if (!problem.empty())
  {
    return "field \"" + this->Field + "\", " + problem;
  }
  if (!this->Test.empty())
  {
    problem = npr::Expression::FindProblem(this->Test, npr::Expression::Condition);
  }
  return problem.empty() ? problem : "test \"" + this->Test + "\", " + problem;
}

//------------------------------------------------------------------------------
std::string vtkNPRExpressionLines::FindError(const npr::LineSurface&) const
{
  return this->Internal->Error;
}

//------------------------------------------------------------------------------
void vtkNPRExpressionLines::BindInput(vtkPolyData* input)
{
  Internals& internal = *this->Internal;
  if (internal.MTime != this->GetMTime())
  {
    internal.Field.reset();
    internal.Test.reset();
    internal.MTime = this->GetMTime();
  }
  internal.Error = this->FindProblem();
  const npr::LineNames names(input->GetPointData());
  const ConstantsMap constants = GetConstantsOf(this->Constants);
  const auto bind = [&](const char* part, const std::string& text, npr::Expression::Meaning meaning,
                      std::unique_ptr<npr::LineFormula>& formula)
  {
    std::vector<npr::LineNames::Meaning> variables;
    for (const std::string& name : npr::Expression::GetNames(text))
    {
      const npr::LineNames::Meaning* found = names.Find(name);
      if (constants.count(name) > 0)
      {
        continue;
      }
      if (!found)
      {
        internal.Error = std::string(part) + " \"" + text + "\", column " +
          std::to_string(npr::Expression::GetColumn(text, name)) + ": there is no name '" + name +
          "'; there are: " + names.Describe() +
          (constants.empty() ? "" : "; constants: " + this->Constants);
        formula.reset();
        return;
      }
      variables.push_back(*found);
    }
    // What is compiled is kept as long as it says the same.
    if (!formula || formula->GetVariables() != variables)
    {
      formula = std::make_unique<npr::LineFormula>(
        text, meaning, this->Fade, std::move(variables), constants);
      internal.HasWarned = false;
    }
  };
  if (internal.Error.empty())
  {
    bind("field", this->Field, npr::Expression::Value, internal.Field);
  }
  if (internal.Error.empty() && !this->Test.empty())
  {
    bind("test", this->Test, npr::Expression::Condition, internal.Test);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRExpressionLines::GetRequiredArrays() const
{
  std::vector<RequiredArray> arrays;
  for (const npr::LineFormula* formula : this->Internal->GetFormulas())
  {
    for (const npr::LineNames::Meaning& variable : formula->GetVariables())
    {
      if (!variable.Quantity)
      {
        arrays.push_back({ variable.Array.c_str(), variable.Components, nullptr });
      }
    }
  }
  // Also before there is an input.
  const npr::LineNames names;
  for (const std::string& text : { this->Field, this->Test })
  {
    for (const std::string& name : npr::Expression::GetNames(text))
    {
      if (const npr::LineNames::Meaning* meaning = names.Find(name))
      {
        const auto& needed = meaning->Quantity->Arrays;
        arrays.insert(arrays.end(), needed.begin(), needed.end());
      }
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
void vtkNPRExpressionLines::BeginView(const npr::LineSurface&, const npr::LineView&)
{
  for (npr::LineFormula* formula : this->Internal->GetFormulas())
  {
    formula->TakeUndefinedPoints();
  }
}

//------------------------------------------------------------------------------
void vtkNPRExpressionLines::EndView(const npr::LineSurface& surface)
{
  std::vector<bool> undefined;
  std::string where;
  for (npr::LineFormula* formula : this->Internal->GetFormulas())
  {
    const std::vector<Index> points = formula->TakeUndefinedPoints();
    if (points.empty())
    {
      continue;
    }
    undefined.resize(surface.GetMesh().GetNumberOfPoints());
    for (const Index point : points)
    {
      undefined[point] = true;
    }
    where += (where.empty() ? "the " : ", and the ") +
      std::string(formula == this->Internal->Field.get() ? "field" : "test") + " at " +
      std::to_string(points.size()) + " points";
  }
  if (undefined.empty() || this->Internal->HasWarned)
  {
    return;
  }
  const auto& triangles = surface.GetMesh().GetTriangles();
  const auto left = std::count_if(triangles.begin(), triangles.end(),
    [&](const npr::TriangleMesh::Triangle& corners)
    { return undefined[corners[0]] || undefined[corners[1]] || undefined[corners[2]]; });
  vtkWarningMacro("In the lines \"" << this->GetName() << "\" " << where
                                    << " is not a finite number; the " << left
                                    << " triangles there have no lines.");
  // Once, and not for each frame.
  this->Internal->HasWarned = true;
}

//------------------------------------------------------------------------------
std::vector<float> vtkNPRExpressionLines::GetLevels(const npr::LineSurface&) const
{
  std::vector<float> levels(this->Levels.begin(), this->Levels.end());
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

//------------------------------------------------------------------------------
void vtkNPRExpressionLines::EvaluateField(const npr::LineSurface& surface,
  const npr::LineView& view, vtkIdType begin, vtkIdType end, float* field) const
{
  this->Internal->Field->Evaluate(surface, view, npr::PointSpan::Range(begin, end), field + begin);
}

//------------------------------------------------------------------------------
bool vtkNPRExpressionLines::HasTest() const
{
  return !this->Test.empty();
}

//------------------------------------------------------------------------------
void vtkNPRExpressionLines::EvaluateTest(const npr::LineSurface& surface, const npr::LineView& view,
  const Index* points, vtkIdType count, const float*, float* test) const
{
  this->Internal->Test->Evaluate(surface, view, npr::PointSpan::List(points, count), test);
}
