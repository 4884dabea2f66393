// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRLineDefinition.h"

#include "nprArrayNames.h"
#include "nprFieldAxes.h"
#include "vtkNPRApparentRidges.h"
#include "vtkNPRBoundaries.h"
#include "vtkNPRContourEdges.h"
#include "vtkNPRCreases.h"
#include "vtkNPRDemarcatingCurves.h"
#include "vtkNPRExpressionLines.h"
#include "vtkNPRIsoLines.h"
#include "vtkNPRIsophotes.h"
#include "vtkNPRNonManifoldEdges.h"
#include "vtkNPROccludingContours.h"
#include "vtkNPRParabolicLines.h"
#include "vtkNPRPrincipalHighlights.h"
#include "vtkNPRRegionBorders.h"
#include "vtkNPRRidges.h"
#include "vtkNPRSuggestiveContours.h"
#include "vtkNPRSuggestiveHighlights.h"
#include "vtkNPRTopographicLines.h"
#include "vtkNPRValleys.h"
#include "vtkNPRZeroMeanCurvature.h"

#include <vtkSmartPointer.h>

#include <algorithm>
#include <limits>

namespace
{
// All kinds of lines; each class says its own name.
using Maker = vtkNPRLineDefinition* (*)();
const Maker Makers[] = {
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPROccludingContours::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRContourEdges::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRSuggestiveContours::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRSuggestiveHighlights::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRRidges::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRValleys::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRApparentRidges::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRPrincipalHighlights::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRDemarcatingCurves::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRParabolicLines::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRZeroMeanCurvature::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRIsophotes::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRTopographicLines::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRIsoLines::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRCreases::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRBoundaries::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRNonManifoldEdges::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRRegionBorders::New()); },
  [] { return static_cast<vtkNPRLineDefinition*>(vtkNPRExpressionLines::New()); },
};
constexpr int NumberOfMakers = static_cast<int>(sizeof(Makers) / sizeof(Makers[0]));

std::vector<vtkSmartPointer<vtkNPRLineDefinition>>& GetAddedKinds()
{
  static std::vector<vtkSmartPointer<vtkNPRLineDefinition>> kinds;
  return kinds;
}

vtkNPRLineDefinition* NewBuiltIn(const std::string& name)
{
  for (const Maker& maker : Makers)
  {
    vtkNPRLineDefinition* definition = maker();
    if (name == definition->GetName())
    {
      return definition;
    }
    definition->Delete();
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
int vtkNPRLineDefinition::GetNumberOfLineNames()
{
  return NumberOfMakers + static_cast<int>(GetAddedKinds().size());
}

//------------------------------------------------------------------------------
const char* vtkNPRLineDefinition::GetLineName(int index)
{
  if (index < 0 || index >= GetNumberOfLineNames())
  {
    return nullptr;
  }
  if (index >= NumberOfMakers)
  {
    return GetAddedKinds()[index - NumberOfMakers]->GetName();
  }
  // The name is a literal, so it outlives the object.
  return vtk::TakeSmartPointer(Makers[index]())->GetName();
}

//------------------------------------------------------------------------------
vtkNPRLineDefinition* vtkNPRLineDefinition::NewFromName(const char* name)
{
  if (!name)
  {
    return nullptr;
  }
  for (const auto& kind : GetAddedKinds())
  {
    if (std::string(name) == kind->GetName())
    {
      vtkNPRLineDefinition* definition = kind->NewInstance();
      definition->CopyParameters(kind);
      return definition;
    }
  }
  return NewBuiltIn(name);
}

//------------------------------------------------------------------------------
bool vtkNPRLineDefinition::AddKind(vtkNPRLineDefinition* definition)
{
  const std::string name = definition ? definition->GetName() : "";
  if (name.empty() || vtk::TakeSmartPointer(NewBuiltIn(name)))
  {
    return false;
  }
  RemoveKind(name.c_str());
  GetAddedKinds().emplace_back(definition);
  return true;
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::RemoveKind(const char* name)
{
  auto& kinds = GetAddedKinds();
  kinds.erase(
    std::remove_if(kinds.begin(), kinds.end(),
      [&](const auto& definition) { return name && std::string(name) == definition->GetName(); }),
    kinds.end());
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::CopyParameters(vtkNPRLineDefinition* other)
{
  for (const Parameter& parameter : other->Parameters)
  {
    if (parameter.Text)
    {
      this->SetTextParameter(parameter.Name, *parameter.Text);
    }
    else
    {
      this->SetParameter(parameter.Name, parameter.GetNumbers());
    }
  }
}

//------------------------------------------------------------------------------
bool vtkNPRLineDefinition::IsForAnySurface() const
{
  return !this->GetRequiredCellArray() &&
    std::none_of(this->Parameters.begin(), this->Parameters.end(),
      [](const Parameter& parameter) { return parameter.Text && parameter.Text->empty(); });
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::AddParameter(
  const char* name, const char* description, double& value, double minimum, double maximum)
{
  this->Parameters.push_back({ name, description, &value, 1, minimum, maximum, nullptr, nullptr });
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::AddParameter(
  const char* name, const char* description, double (&values)[3], double minimum, double maximum)
{
  this->Parameters.push_back({ name, description, values, 3, minimum, maximum, nullptr, nullptr });
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::AddParameter(const char* name, const char* description,
  std::vector<double>& values, double minimum, double maximum)
{
  this->Parameters.push_back(
    { name, description, nullptr, AnyNumber, minimum, maximum, &values, nullptr });
}

//------------------------------------------------------------------------------
std::vector<double> vtkNPRLineDefinition::Parameter::GetNumbers() const
{
  return this->List ? *this->List
    : this->Values  ? std::vector<double>(this->Values, this->Values + this->Size)
                    : std::vector<double>();
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::AddTextParameter(
  const char* name, const char* description, std::string& text)
{
  this->Parameters.push_back({ name, description, nullptr, 0, 0.0, 0.0, nullptr, &text });
}

//------------------------------------------------------------------------------
const vtkNPRLineDefinition::Parameter* vtkNPRLineDefinition::FindParameter(const char* name) const
{
  for (const Parameter& parameter : this->Parameters)
  {
    if (name && std::string(name) == parameter.Name)
    {
      return &parameter;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
const char* vtkNPRLineDefinition::GetParameterName(int index) const
{
  return index < 0 || index >= this->GetNumberOfParameters() ? nullptr
                                                             : this->Parameters[index].Name;
}

//------------------------------------------------------------------------------
const char* vtkNPRLineDefinition::GetParameterDescription(int index) const
{
  return index < 0 || index >= this->GetNumberOfParameters() ? nullptr
                                                             : this->Parameters[index].Description;
}

//------------------------------------------------------------------------------
int vtkNPRLineDefinition::GetParameterSize(const char* name) const
{
  const Parameter* parameter = this->FindParameter(name);
  return parameter ? parameter->Size : -1;
}

//------------------------------------------------------------------------------
bool vtkNPRLineDefinition::SetParameter(const char* name, double value)
{
  return this->SetParameter(name, std::vector<double>{ value });
}

//------------------------------------------------------------------------------
bool vtkNPRLineDefinition::SetParameter(const char* name, const std::vector<double>& values)
{
  const Parameter* parameter = this->FindParameter(name);
  if (!parameter || parameter->Text)
  {
    return false;
  }
  const std::size_t size = static_cast<std::size_t>(parameter->Size);
  // Written so that a NaN is refused.
  if ((parameter->List ? values.size() > size : values.size() != size) ||
    !std::all_of(values.begin(), values.end(),
      [parameter](double value)
      { return value >= parameter->Minimum && value <= parameter->Maximum; }))
  {
    return false;
  }
  if (parameter->GetNumbers() != values)
  {
    if (parameter->List)
    {
      *parameter->List = values;
    }
    else
    {
      std::copy(values.begin(), values.end(), parameter->Values);
    }
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRLineDefinition::SetTextParameter(const char* name, const std::string& text)
{
  const Parameter* parameter = this->FindParameter(name);
  if (!parameter || !parameter->Text)
  {
    return false;
  }
  if (*parameter->Text != text)
  {
    *parameter->Text = text;
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkNPRLineDefinition::GetParameter(const char* name) const
{
  const std::vector<double> numbers = this->GetParameterValues(name);
  return numbers.empty() ? std::numeric_limits<double>::quiet_NaN() : numbers[0];
}

//------------------------------------------------------------------------------
std::vector<double> vtkNPRLineDefinition::GetParameterValues(const char* name) const
{
  const Parameter* parameter = this->FindParameter(name);
  return parameter ? parameter->GetNumbers() : std::vector<double>();
}

//------------------------------------------------------------------------------
std::string vtkNPRLineDefinition::GetTextParameter(const char* name) const
{
  const Parameter* parameter = this->FindParameter(name);
  return parameter && parameter->Text ? *parameter->Text : std::string();
}

//------------------------------------------------------------------------------
bool vtkNPRLineDefinition::NeedsDerivatives() const
{
  const std::vector<RequiredArray> arrays = this->GetRequiredArrays();
  return !this->IsMaximum() &&
    std::any_of(arrays.begin(), arrays.end(),
      [](const RequiredArray& array)
      { return std::string(array.Name) == npr::names::CurvatureDerivatives; });
}

//------------------------------------------------------------------------------
const float* vtkNPRLineDefinition::GetDoubts(const npr::LineSurface& surface) const
{
  return surface.GetComponent(npr::names::DerivativeDoubt, 0);
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::EvaluateField(
  const npr::LineSurface&, const npr::LineView&, vtkIdType begin, vtkIdType end, float* field) const
{
  std::fill(field + begin, field + end, 1.0f);
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::BoundField(
  const npr::LineSurface&, vtkIdType begin, vtkIdType end, signed char* sign) const
{
  std::fill(sign + begin, sign + end, static_cast<signed char>(0));
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::EvaluateFieldAndAxes(const npr::LineSurface& surface,
  const npr::LineView& view, vtkIdType begin, vtkIdType end, float* field,
  npr::AxisPoint* points) const
{
  this->EvaluateField(surface, view, begin, end, field);
  for (vtkIdType i = begin; i < end; ++i)
  {
    points[i].Axis = { 0.0f, 0.0f, 0.0f };
    points[i].Bound = 1.0f;
  }
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::EvaluateSlopes(const npr::LineSurface&, const npr::LineView&,
  const Index*, const Index*, vtkIdType count, float* atFrom, float* atTo) const
{
  std::fill(atFrom, atFrom + count, 0.0f);
  std::fill(atTo, atTo + count, 0.0f);
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::EvaluateTest(const npr::LineSurface&, const npr::LineView&, const Index*,
  vtkIdType count, const float*, float* test) const
{
  std::fill(test, test + count, 1.0f);
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::EvaluateEdges(const npr::LineSurface&, const npr::LineView&,
  const npr::EdgeList&, vtkIdType begin, vtkIdType end, float* strength) const
{
  std::fill(strength, strength + (end - begin), 0.0f);
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::EvaluateTriangles(const npr::LineSurface&, const npr::LineView&,
  vtkIdType begin, vtkIdType end, signed char* values) const
{
  std::fill(values + begin, values + end, static_cast<signed char>(0));
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::CompareTriangles(const npr::LineSurface&, const npr::EdgeList&,
  vtkIdType begin, vtkIdType end, const signed char*, float* strength) const
{
  std::fill(strength, strength + (end - begin), 0.0f);
}

//------------------------------------------------------------------------------
void vtkNPRLineDefinition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->GetName() << "\n";
  os << indent << "Description: " << this->GetDescription() << "\n";
  os << indent << "ViewDependent: " << this->IsViewDependent() << "\n";
  for (const Parameter& parameter : this->Parameters)
  {
    os << indent << parameter.Name << ":";
    for (const double number : parameter.GetNumbers())
    {
      os << " " << number;
    }
    os << (parameter.Text ? " " + *parameter.Text : std::string()) << "\n";
  }
}
