// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRGoochStyle.h"

#include "vtkNPRGoochFS.h"

#include <vtkObjectFactory.h>
#include <vtkShaderProgram.h>

vtkStandardNewMacro(vtkNPRGoochStyle);

//------------------------------------------------------------------------------
vtkNPRGoochStyle::vtkNPRGoochStyle()
{
  using Values = std::vector<double>;
  this->DeclareParameter({ "cool_color", "Colour away from the light", 3, { 0.0, 1.0 },
    [this](const Values& v) { this->SetCoolColor(v[0], v[1], v[2]); },
    [this] { return Values(this->CoolColor, this->CoolColor + 3); } });
  this->DeclareParameter({ "warm_color", "Colour towards the light", 3, { 0.0, 1.0 },
    [this](const Values& v) { this->SetWarmColor(v[0], v[1], v[2]); },
    [this] { return Values(this->WarmColor, this->WarmColor + 3); } });
  this->DeclareParameter({ "alpha", "Part of the material's colour in the cool side", 1,
    { 0.0, 1.0 }, [this](const Values& v) { this->SetAlpha(v[0]); },
    [this] { return Values{ this->Alpha }; } });
  this->DeclareParameter(
    { "beta", "Part of the material's colour in the warm side", 1, { 0.0, 1.0 },
      [this](const Values& v) { this->SetBeta(v[0]); }, [this] { return Values{ this->Beta }; } });
}

//------------------------------------------------------------------------------
std::string vtkNPRGoochStyle::GetCode()
{
  return vtkNPRGoochFS;
}

//------------------------------------------------------------------------------
void vtkNPRGoochStyle::SetUniforms(vtkShaderProgram* program)
{
  program->SetUniform3f("nprGoochCoolColor", this->CoolColor);
  program->SetUniform3f("nprGoochWarmColor", this->WarmColor);
  program->SetUniformf("nprGoochAlpha", static_cast<float>(this->Alpha));
  program->SetUniformf("nprGoochBeta", static_cast<float>(this->Beta));
}
