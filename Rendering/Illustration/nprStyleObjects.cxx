// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStyleObjects.h"

#include "nprStyleDocument.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRLineDefinition.h"
#include "vtkNPRShadingStyle.h"
#include "vtkNPRShadingStyles.h"

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

bool SetParameter(
  vtkNPRShadingStyle* style, const std::string& name, const std::vector<double>& values)
{
  return style->SetParameter(name, values);
}

bool SetParameter(
  vtkNPRLineDefinition* definition, const std::string& name, const std::vector<double>& values)
{
  return values.size() == 1 && definition->SetParameter(name.c_str(), values[0]);
}

template<typename Object>
void SetParameters(Object* object, const Parameters& parameters, const std::string& path)
{
  for (const auto& [name, values] : parameters)
  {
    if (!SetParameter(object, name, values))
    {
      throw StyleError(path + "/" + name +
        " is not known here, or its value is out of range; besides the common keys there are: " +
        DescribeParameters(object));
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
vtkSmartPointer<vtkNPRShadingStyle> MakeShadingStyle(const ShadingStyle& shading)
{
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
  SetParameters(style.Get(), shading.StyleParameters, "/shading");
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
  SetParameters(definition.Get(), line.DefinitionParameters, path);
  return definition;
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
    MakeLineDefinition(document.Lines[i], "/lines/" + std::to_string(i));
  }
}
}
