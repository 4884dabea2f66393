// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRIsoLines.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkNPRIsoLines);

namespace
{
constexpr double DefaultLevels = 10.0;
constexpr double MostComponents = 1.0e6;
}

//------------------------------------------------------------------------------
vtkNPRIsoLines::vtkNPRIsoLines() : Superclass(DefaultLevels)
{
  this->AddTextParameter("array", "the name of the point array", this->Array);
  this->AddParameter("component", "which component of the array, from 0 on; -1 for its magnitude",
    this->Component, -1.0, MostComponents);
  this->AddParameter("values", "levels given one by one, instead of levels and spacing",
    this->Values, VTK_DOUBLE_MIN, VTK_DOUBLE_MAX);
}

//------------------------------------------------------------------------------
void vtkNPRIsoLines::SetValues(const std::vector<double>& values)
{
  if (!this->SetParameter("values", values))
  {
    vtkErrorMacro("Levels must be numbers, and " << AnyNumber << " at most.");
  }
}

//------------------------------------------------------------------------------
std::vector<vtkNPRLineDefinition::RequiredArray> vtkNPRIsoLines::GetRequiredArrays() const
{
  return { { this->Array.c_str(), AnyComponents, nullptr } };
}

//------------------------------------------------------------------------------
std::string vtkNPRIsoLines::FindError(const npr::LineSurface& surface) const
{
  const int components = surface.GetNumberOfComponents(this->Array.c_str());
  return this->Component >= components
    ? "the point array \"" + this->Array + "\" has " + std::to_string(components) +
      " component(s), so component can be from -1 to " + std::to_string(components - 1)
    : this->Superclass::FindError(surface);
}

//------------------------------------------------------------------------------
std::vector<float> vtkNPRIsoLines::GetLevels(const npr::LineSurface& surface) const
{
  if (this->Values.empty())
  {
    return this->Superclass::GetLevels(surface);
  }
  std::vector<float> levels(this->Values.begin(), this->Values.end());
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

//------------------------------------------------------------------------------
void vtkNPRIsoLines::EvaluateField(const npr::LineSurface& surface, const npr::LineView&,
  vtkIdType begin, vtkIdType end, float* field) const
{
  const char* name = this->Array.c_str();
  const int components = surface.GetNumberOfComponents(name);
  const int component = components == 1 ? 0 : static_cast<int>(this->Component);
  if (component >= 0)
  {
    std::copy_n(surface.GetComponent(name, component) + begin, end - begin, field + begin);
    return;
  }
  std::fill(field + begin, field + end, 0.0f);
  for (int c = 0; c < components; ++c)
  {
    const float* values = surface.GetComponent(name, c);
    for (vtkIdType i = begin; i < end; ++i)
    {
      field[i] = std::hypot(field[i], values[i]);
    }
  }
}
