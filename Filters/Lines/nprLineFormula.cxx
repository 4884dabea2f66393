// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprLineFormula.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <tuple>
#include <utility>

namespace npr
{
namespace
{
constexpr const char* Axes = "xyz";
constexpr const char* ArrayPrefix = "array_";

std::string MakeName(const std::string& array)
{
  std::string name = array;
  for (char& c : name)
  {
    if (!Expression::IsName(std::string("a") + c))
    {
      c = '_';
    }
  }
  return name;
}
}

//------------------------------------------------------------------------------
bool LineNames::Meaning::operator==(const Meaning& other) const
{
  return std::tie(this->Name, this->Quantity, this->Array, this->Components, this->Component) ==
    std::tie(other.Name, other.Quantity, other.Array, other.Components, other.Component);
}

//------------------------------------------------------------------------------
LineNames::LineNames()
{
  for (const ViewQuantity& quantity : GetViewQuantities())
  {
    for (int c = 0; c < quantity.Components; ++c)
    {
      const std::string axis = quantity.Components == 1 ? "" : std::string(1, Axes[c]);
      this->Meanings.push_back({ quantity.Name + axis, &quantity, "", quantity.Components, c });
    }
  }
}

//------------------------------------------------------------------------------
LineNames::LineNames(vtkPointData* arrays) : LineNames()
{
  // First those that are names as they are.
  for (const bool exact : { true, false })
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = arrays->GetArray(i);
      const std::string given = array && array->GetName() ? array->GetName() : "";
      const std::string name = MakeName(given);
      if (!given.empty() && (name == given) == exact)
      {
        this->AddArray(given, name, array->GetNumberOfComponents());
      }
    }
  }
}

//------------------------------------------------------------------------------
void LineNames::AddArray(const std::string& array, const std::string& name, int components)
{
  const auto add = [&](const std::string& suffix, int component)
  {
    std::string full = name + suffix;
    const Meaning* taken = this->Find(full);
    if (!Expression::IsName(full) || Expression::IsReserved(full) || (taken && taken->Quantity))
    {
      full = ArrayPrefix + full;
    }
    if (!this->Find(full))
    {
      this->Meanings.push_back({ full, nullptr, array, components, component });
    }
  };
  if (components == 1)
  {
    add("", 0);
    return;
  }
  for (int c = 0; c < components; ++c)
  {
    add("_" + std::to_string(c), c);
    if (components == 3)
    {
      add(std::string("_") + Axes[c], c);
    }
  }
}

//------------------------------------------------------------------------------
const LineNames::Meaning* LineNames::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Meanings.begin(), this->Meanings.end(),
    [&](const Meaning& meaning) { return meaning.Name == name; });
  return found == this->Meanings.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
std::string LineNames::Describe() const
{
  std::string quantities;
  std::string arrays;
  for (const Meaning& meaning : this->Meanings)
  {
    if (!meaning.Quantity && meaning.Components == 3 && std::isdigit(meaning.Name.back()))
    {
      continue; // it has another name, too
    }
    std::string& list = meaning.Quantity ? quantities : arrays;
    list += (list.empty() ? "" : ", ") + meaning.Name;
  }
  return quantities + (arrays.empty() ? "" : "; of the input's point arrays: " + arrays);
}

//------------------------------------------------------------------------------
LineFormula::LineFormula(const std::string& text, Expression::Meaning meaning, double fade,
  std::vector<LineNames::Meaning> variables, Expression::Constants constants)
  : Text(text), Meaning(meaning), Fade(fade), Variables(std::move(variables)),
    Constants(std::move(constants))
{
}

//------------------------------------------------------------------------------
std::unique_ptr<Expression> LineFormula::TakeExpression()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Idle.empty())
    {
      std::unique_ptr<Expression> expression = std::move(this->Idle.back());
      this->Idle.pop_back();
      return expression;
    }
  }
  std::vector<std::string> names;
  for (const LineNames::Meaning& variable : this->Variables)
  {
    names.push_back(variable.Name);
  }
  return std::make_unique<Expression>(
    this->Text, this->Meaning, this->Fade, names, this->Constants);
}

//------------------------------------------------------------------------------
void LineFormula::Evaluate(
  const LineSurface& surface, const LineView& view, const PointSpan& points, float* values)
{
  // So few that all of them stay in the cache.
  constexpr vtkIdType Size = 512;
  std::unique_ptr<Expression> expression = this->TakeExpression();
  std::vector<double> buffer(Size * (this->Variables.size() + 1));
  std::vector<double*> columns;
  for (std::size_t c = 0; c <= this->Variables.size(); ++c)
  {
    columns.push_back(buffer.data() + Size * c);
  }
  double* result = columns.back();
  std::vector<Index> undefined;
  for (vtkIdType first = 0; first < points.GetNumberOfPoints(); first += Size)
  {
    const PointSpan part =
      points.GetPart(first, std::min(first + Size, points.GetNumberOfPoints()));
    const vtkIdType count = part.GetNumberOfPoints();
    for (std::size_t c = 0; c < this->Variables.size(); ++c)
    {
      const LineNames::Meaning& variable = this->Variables[c];
      if (variable.Quantity)
      {
        variable.Quantity->Evaluate(surface, view, part, variable.Component, columns[c]);
        continue;
      }
      const float* array = surface.GetComponent(variable.Array.c_str(), variable.Component);
      for (vtkIdType i = 0; i < count; ++i)
      {
        columns[c][i] = array[part[i]];
      }
    }
    expression->Evaluate(columns.data(), count, result);
    for (vtkIdType i = 0; i < count; ++i)
    {
      values[first + i] = static_cast<float>(result[i]);
      if (!std::isfinite(values[first + i]))
      {
        undefined.push_back(part[i]);
      }
    }
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Idle.push_back(std::move(expression));
  this->Undefined.insert(this->Undefined.end(), undefined.begin(), undefined.end());
}

//------------------------------------------------------------------------------
std::vector<LineFormula::Index> LineFormula::TakeUndefinedPoints()
{
  std::vector<Index> points;
  points.swap(this->Undefined);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}
}
