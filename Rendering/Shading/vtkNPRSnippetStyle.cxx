// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSnippetStyle.h"

#include <vtkObjectFactory.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <cctype>
#include <cmath>

vtkStandardNewMacro(vtkNPRSnippetStyle);

namespace
{
const char* const Types[] = { "float", "vec2", "vec3", "vec4" };

bool IsIdentifier(const std::string& name)
{
  return !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0])) &&
    name.rfind("gl_", 0) != 0 &&
    std::all_of(name.begin(), name.end(),
      [](unsigned char c) { return c == '_' || (c < 128 && std::isalnum(c)); });
}
}

//------------------------------------------------------------------------------
vtkNPRSnippetStyle::vtkNPRSnippetStyle() : Code("vec3 nprShade(NprSurface s) { return s.diffuse; }")
{
}

//------------------------------------------------------------------------------
vtkNPRSnippetStyle::~vtkNPRSnippetStyle() = default;

//------------------------------------------------------------------------------
void vtkNPRSnippetStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Code:\n" << this->Code << "\n";
  for (const auto& uniform : this->Uniforms)
  {
    os << indent << uniform.first << ":";
    for (double value : uniform.second)
    {
      os << " " << value;
    }
    os << "\n";
  }
}

//------------------------------------------------------------------------------
std::string vtkNPRSnippetStyle::GetCode()
{
  std::string code;
  for (const auto& uniform : this->Uniforms)
  {
    code +=
      std::string("uniform ") + Types[uniform.second.size() - 1] + " " + uniform.first + ";\n";
  }
  return code + "#line 0\n" + this->Code;
}

//------------------------------------------------------------------------------
void vtkNPRSnippetStyle::SetCode(const std::string& code)
{
  if (this->Code != code)
  {
    this->Code = code;
    this->CodeModified();
  }
}

//------------------------------------------------------------------------------
void vtkNPRSnippetStyle::SetUniform(const std::string& name, const std::vector<double>& values)
{
  if (!IsIdentifier(name) || values.empty() || values.size() > 4 ||
    !std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
  {
    vtkErrorMacro("The uniform '" << name << "' is not set: it needs a GLSL identifier as its name "
                                  << "and one to four finite values.");
    return;
  }
  const auto place = this->Uniforms.find(name);
  if (place != this->Uniforms.end() && place->second == values)
  {
    return;
  }
  const bool sameType = place != this->Uniforms.end() && place->second.size() == values.size();
  this->Uniforms[name] = values;
  if (sameType)
  {
    this->Modified();
  }
  else
  {
    this->CodeModified();
  }
}

//------------------------------------------------------------------------------
void vtkNPRSnippetStyle::SetUniform(const std::string& name, double x)
{
  this->SetUniform(name, std::vector<double>{ x });
}

//------------------------------------------------------------------------------
void vtkNPRSnippetStyle::SetUniform(const std::string& name, double x, double y)
{
  this->SetUniform(name, std::vector<double>{ x, y });
}

//------------------------------------------------------------------------------
void vtkNPRSnippetStyle::SetUniform(const std::string& name, double x, double y, double z)
{
  this->SetUniform(name, std::vector<double>{ x, y, z });
}

//------------------------------------------------------------------------------
void vtkNPRSnippetStyle::SetUniform(const std::string& name, double x, double y, double z, double w)
{
  this->SetUniform(name, std::vector<double>{ x, y, z, w });
}

//------------------------------------------------------------------------------
void vtkNPRSnippetStyle::RemoveUniform(const std::string& name)
{
  if (this->Uniforms.erase(name) > 0)
  {
    this->CodeModified();
  }
}

//------------------------------------------------------------------------------
void vtkNPRSnippetStyle::RemoveAllUniforms()
{
  if (!this->Uniforms.empty())
  {
    this->Uniforms.clear();
    this->CodeModified();
  }
}

//------------------------------------------------------------------------------
void vtkNPRSnippetStyle::SetUniforms(vtkShaderProgram* program)
{
  for (const auto& uniform : this->Uniforms)
  {
    const std::vector<float> values(uniform.second.begin(), uniform.second.end());
    const char* name = uniform.first.c_str();
    switch (values.size())
    {
      case 1:
        program->SetUniformf(name, values[0]);
        break;
      case 2:
        program->SetUniform2f(name, values.data());
        break;
      case 3:
        program->SetUniform3f(name, values.data());
        break;
      default:
        program->SetUniform4f(name, values.data());
        break;
    }
  }
}
