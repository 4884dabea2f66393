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
int vtkNPRShadingStyle::GetNumberOfParameters()
{
  return static_cast<int>(this->Parameters.size());
}

//------------------------------------------------------------------------------
const char* vtkNPRShadingStyle::GetParameterName(int index)
{
  return this->Parameters.at(index).Name.c_str();
}

//------------------------------------------------------------------------------
const char* vtkNPRShadingStyle::GetParameterDescription(int index)
{
  return this->Parameters.at(index).Description.c_str();
}

//------------------------------------------------------------------------------
int vtkNPRShadingStyle::GetParameterSize(int index)
{
  return this->Parameters.at(index).Size;
}

//------------------------------------------------------------------------------
void vtkNPRShadingStyle::GetParameterRange(int index, double range[2])
{
  std::copy_n(this->Parameters.at(index).Range, 2, range);
}

//------------------------------------------------------------------------------
bool vtkNPRShadingStyle::SetParameter(const char* name, int numberOfValues, const double* values)
{
  return this->SetParameter(
    std::string(name ? name : ""), std::vector<double>(values, values + numberOfValues));
}

//------------------------------------------------------------------------------
bool vtkNPRShadingStyle::SetParameter(const std::string& name, const std::vector<double>& values)
{
  for (const Parameter& parameter : this->Parameters)
  {
    if (parameter.Name == name)
    {
      const bool fits = (parameter.Size == 0 || values.size() == std::size_t(parameter.Size)) &&
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
