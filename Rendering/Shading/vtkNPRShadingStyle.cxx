// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRShadingStyle.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
vtkNPRShadingStyle::vtkNPRShadingStyle()
{
  this->CodeTime.Modified();
}

//------------------------------------------------------------------------------
vtkNPRShadingStyle::~vtkNPRShadingStyle() = default;

//------------------------------------------------------------------------------
void vtkNPRShadingStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const Parameter& parameter : this->Parameters)
  {
    os << indent << parameter.Name << ":";
    for (double value : parameter.Get())
    {
      os << " " << value;
    }
    os << "\n";
  }
}

//------------------------------------------------------------------------------
void vtkNPRShadingStyle::CodeModified()
{
  this->CodeTime.Modified();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkNPRShadingStyle::Activate(vtkOpenGLRenderWindow*) {}

//------------------------------------------------------------------------------
void vtkNPRShadingStyle::Deactivate() {}

//------------------------------------------------------------------------------
void vtkNPRShadingStyle::ReleaseGraphicsResources(vtkWindow*) {}

//------------------------------------------------------------------------------
void vtkNPRShadingStyle::DeclareParameter(Parameter parameter)
{
  this->Parameters.push_back(std::move(parameter));
}

//------------------------------------------------------------------------------
const vtkNPRShadingStyle::Parameter* vtkNPRShadingStyle::FindParameter(int index) const
{
  return index >= 0 && static_cast<std::size_t>(index) < this->Parameters.size()
    ? &this->Parameters[static_cast<std::size_t>(index)]
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkNPRShadingStyle::GetNumberOfParameters()
{
  return static_cast<int>(this->Parameters.size());
}

//------------------------------------------------------------------------------
const char* vtkNPRShadingStyle::GetParameterName(int index)
{
  const Parameter* parameter = this->FindParameter(index);
  return parameter ? parameter->Name.c_str() : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkNPRShadingStyle::GetParameterDescription(int index)
{
  const Parameter* parameter = this->FindParameter(index);
  return parameter ? parameter->Description.c_str() : nullptr;
}

//------------------------------------------------------------------------------
int vtkNPRShadingStyle::GetParameterSize(int index)
{
  const Parameter* parameter = this->FindParameter(index);
  return parameter ? parameter->Size : 0;
}

//------------------------------------------------------------------------------
void vtkNPRShadingStyle::GetParameterRange(int index, double range[2])
{
  if (const Parameter* parameter = this->FindParameter(index))
  {
    std::copy_n(parameter->Range, 2, range);
  }
}

//------------------------------------------------------------------------------
bool vtkNPRShadingStyle::SetParameter(const char* name, int numberOfValues, const double* values)
{
  if (!name || numberOfValues < 0 || (numberOfValues > 0 && !values))
  {
    return false;
  }
  return this->SetParameter(
    std::string(name), std::vector<double>(values, values + numberOfValues));
}

//------------------------------------------------------------------------------
bool vtkNPRShadingStyle::SetParameter(const std::string& name, const std::vector<double>& values)
{
  for (const Parameter& parameter : this->Parameters)
  {
    if (parameter.Name == name)
    {
      const bool fits = (parameter.Size == 0 ? values.size() <= std::size_t(MaximumSize)
                                             : values.size() == std::size_t(parameter.Size)) &&
        std::all_of(values.begin(), values.end(),
          [&](double value) {
            return std::isfinite(value) && value >= parameter.Range[0] &&
              value <= parameter.Range[1];
          });
      if (fits)
      {
        parameter.Set(values);
      }
      return fits;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::vector<double> vtkNPRShadingStyle::GetParameter(const std::string& name)
{
  for (const Parameter& parameter : this->Parameters)
  {
    if (parameter.Name == name)
    {
      return parameter.Get();
    }
  }
  return {};
}
