// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRPhongStyle.h"

#include "vtkNPRPhongFS.h"

#include <vtkObjectFactory.h>
#include <vtkShaderProgram.h>

vtkStandardNewMacro(vtkNPRPhongStyle);

//------------------------------------------------------------------------------
vtkNPRPhongStyle::vtkNPRPhongStyle()
{
  this->DeclareParameter(
    { "halfway_vector", "Highlights by the vector half way between light and eye: 0 or 1", 1,
      { 0.0, 1.0 }, [this](const std::vector<double>& v) { this->SetHalfwayVector(v[0] != 0.0); },
      [this] { return std::vector<double>{ this->HalfwayVector ? 1.0 : 0.0 }; } });
}

//------------------------------------------------------------------------------
std::string vtkNPRPhongStyle::GetCode()
{
  return vtkNPRPhongFS;
}

//------------------------------------------------------------------------------
void vtkNPRPhongStyle::SetUniforms(vtkShaderProgram* program)
{
  program->SetUniformi("nprPhongHalfway", this->HalfwayVector);
}
