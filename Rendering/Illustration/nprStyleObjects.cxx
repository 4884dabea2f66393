// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStyleObjects.h"

#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRLineDefinition.h"
#include "vtkNPRShadingStyle.h"
#include "vtkNPRShadingStyles.h"
#include "vtkNPRSnippetStyle.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <locale>
#include <sstream>

namespace npr
{
namespace
{
constexpr const char* Paper = "paper";

/// The parameters that an object takes, for a message.
template<typename Object>
std::string DescribeParameters(Object* object)
{
  std::string text;
  for (int i = 0; i < object->GetNumberOfParameters(); ++i)
  {
    text += std::string(i == 0 ? "" : "; ") + object->GetParameterName(i) + ": " +
      object->GetParameterDescription(i);
  }
  return text.empty() ? "none" : text;
}

// What a parameter takes.
struct Shape
{
  bool IsKnown = false;
  bool IsText = false;
  int Size = 0; // of numbers; 0 for any
};

Shape GetShape(vtkNPRShadingStyle* style, const std::string& name)
{
  for (int i = 0; i < style->GetNumberOfParameters(); ++i)
  {
    if (name == style->GetParameterName(i))
    {
      return { true, false, style->GetParameterSize(i) };
    }
  }
  return {};
}

Shape GetShape(vtkNPRLineDefinition* definition, const std::string& name)
{
  const int size = definition->GetParameterSize(name.c_str());
  const bool isList = size == vtkNPRLineDefinition::AnyNumber;
  return { size >= 0, size == 0, isList ? 0 : std::max(size, 0) };
}

bool SetNumbers(
  vtkNPRShadingStyle* style, const std::string& name, const std::vector<double>& numbers)
{
  return style->SetParameter(name, numbers);
}

bool SetNumbers(
  vtkNPRLineDefinition* definition, const std::string& name, const std::vector<double>& numbers)
{
  return definition->SetParameter(name.c_str(), numbers);
}

bool SetText(vtkNPRShadingStyle*, const std::string&, const std::string&)
{
  return false; // they have none
}

bool SetText(vtkNPRLineDefinition* definition, const std::string& name, const std::string& text)
{
  return definition->SetTextParameter(name.c_str(), text);
}

// The numbers of a parameter that takes so many (0: any).
std::vector<double> GetNumbers(const ParameterValue& value, int size, const std::string& path)
{
  if (const auto* text = std::get_if<std::string>(&value))
  {
    if (size != 3)
    {
      throw StyleError(path + " must be " + (size == 1 ? "a number" : "a list of numbers"));
    }
    try
    {
      const Color color = ParseColor(*text);
      return { color.begin(), color.end() };
    }
    catch (const StyleError& error)
    {
      throw StyleError(path + " is not a colour: " + error.what());
    }
  }
  const auto& numbers = std::get<std::vector<double>>(value);
  if (size > 0 && numbers.size() != static_cast<std::size_t>(size))
  {
    throw StyleError(path + " must be " +
      (size == 1 ? "one number" : "a list of " + std::to_string(size) + " numbers"));
  }
  return numbers;
}

template<typename Object>
void SetParameters(Object* object, const Parameters& parameters, const std::string& path,
  const std::string& commonKeys)
{
  for (const auto& [name, value] : parameters)
  {
    const std::string key = path + "/" + name;
    const Shape shape = GetShape(object, name);
    if (!shape.IsKnown)
    {
      throw StyleError(key + " is not known here; its own keys are: " + DescribeParameters(object) +
        (commonKeys.empty() ? "" : "; the others: " + commonKeys));
    }
    const auto* text = std::get_if<std::string>(&value);
    if (shape.IsText && !text)
    {
      throw StyleError(key + " must be a text in quotes");
    }
    if (!(shape.IsText ? SetText(object, name, *text)
                       : SetNumbers(object, name, GetNumbers(value, shape.Size, key))))
    {
      throw StyleError(key + " is out of range; there are: " + DescribeParameters(object));
    }
  }
}
}

//------------------------------------------------------------------------------
bool IsPaper(const ShadingStyle& shading)
{
  return shading.Style == Paper;
}

//------------------------------------------------------------------------------
bool NeedsShading(const StyleDocument& document)
{
  return !IsPaper(document.Shading) || document.Outline.Kind != OutlineStyle::None;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkNPRShadingStyle> MakeShadingStyle(const ShadingStyle& shading)
{
  if (IsPaper(shading))
  {
    return vtkSmartPointer<vtkNPRSnippetStyle>::New();
  }
  auto style = vtk::TakeSmartPointer(vtkNPRShadingStyles::CreateStyle(shading.Style));
  if (!style)
  {
    std::string names = Paper;
    for (int i = 0; i < vtkNPRShadingStyles::GetNumberOfStyles(); ++i)
    {
      names += std::string(", ") + vtkNPRShadingStyles::GetStyleName(i);
    }
    throw StyleError("/shading/style '" + shading.Style + "' is not known; there are: " + names);
  }
  SetParameters(style.Get(), shading.StyleParameters, "/shading", shading.CommonKeys);
  return style;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkNPRLineDefinition> MakeLineDefinition(
  const LineStyle& line, const std::string& path)
{
  auto definition = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(line.Type.c_str()));
  if (!definition)
  {
    std::string names;
    for (int i = 0; i < vtkNPRLineDefinition::GetNumberOfLineNames(); ++i)
    {
      names += (i == 0 ? "" : ", ") + std::string(vtkNPRLineDefinition::GetLineName(i));
    }
    throw StyleError(path + ": unknown kind of line '" + line.Type + "'; there are: " + names);
  }
  SetParameters(definition.Get(), line.DefinitionParameters, path, line.CommonKeys);
  return definition;
}

//------------------------------------------------------------------------------
bool NeedsCurvature(const LineStyle& line, const std::string& path)
{
  const auto arrays = MakeLineDefinition(line, path)->GetRequiredArrays();
  return std::any_of(arrays.begin(), arrays.end(),
    [](const vtkNPRLineDefinition::RequiredArray& array)
    { return array.Maker && array.Maker == std::string("vtkNPRCurvatureTensor"); });
}

//------------------------------------------------------------------------------
std::vector<LineStyle> GetDrawnLines(const StyleDocument& document)
{
  std::vector<LineStyle> lines;
  std::copy_if(document.Lines.begin(), document.Lines.end(), std::back_inserter(lines),
    [](const LineStyle& line) { return !line.Optional; });
  return lines;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetLineNames(const StyleDocument& document)
{
  std::vector<std::string> names;
  for (const LineStyle& line : GetDrawnLines(document))
  {
    const std::string name = MakeLineDefinition(line, "/lines")->GetName();
    std::string other = name;
    for (int i = 2; std::find(names.begin(), names.end(), other) != names.end(); ++i)
    {
      other = name + " " + std::to_string(i);
    }
    names.push_back(other);
  }
  return names;
}

//------------------------------------------------------------------------------
ParameterValue ParseLineParameter(
  const LineStyle& line, const std::string& name, const std::string& text)
{
  auto definition = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(line.Type.c_str()));
  if (definition && definition->GetParameterSize(name.c_str()) == 0)
  {
    return text;
  }
  std::vector<double> numbers;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  for (double number; stream >> number;)
  {
    numbers.push_back(number);
    if (stream.peek() != ',')
    {
      break;
    }
    stream.get();
  }
  // What is no list of numbers is left to be refused, or to be a colour.
  return !numbers.empty() && stream.peek() == EOF ? ParameterValue(numbers) : ParameterValue(text);
}

//------------------------------------------------------------------------------
void CheckStyleNames(const StyleDocument& document)
{
  if (!IsPaper(document.Shading))
  {
    MakeShadingStyle(document.Shading);
  }
  else if (!document.Shading.StyleParameters.empty())
  {
    throw StyleError("/shading/" + document.Shading.StyleParameters.begin()->first +
      " is not known; the style \"paper\" has no parameters");
  }
  const std::string& estimator = document.Geometry.Estimator;
  if (!estimator.empty() && vtkNPRCurvatureTensor::FindEstimator(estimator.c_str()) < 0)
  {
    std::string names;
    for (int i = 0; i < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++i)
    {
      names += (i == 0 ? "" : ", ") + std::string(vtkNPRCurvatureTensor::GetEstimatorName(i));
    }
    throw StyleError("/geometry/estimator '" + estimator + "' is not known; there are: " + names);
  }
  for (std::size_t i = 0; i < document.Lines.size(); ++i)
  {
    const std::string path = "/lines/" + std::to_string(i);
    const std::string problem = MakeLineDefinition(document.Lines[i], path)->FindProblem();
    if (!problem.empty())
    {
      throw StyleError(path + ": " + problem);
    }
  }
}
}
