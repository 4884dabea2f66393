// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSnippetStyle
 * @brief A shading style whose GLSL and parameters are given at run time.
 *
 * The code defines `vec3 nprShade(NprSurface s)` as vtkNPRShadingStyle describes; each parameter
 * that SetUniform() names is declared for it, as float, vec2, vec3 or vec4 by its number of values.
 *
 * ```
 * style->SetUniform("rim", 0.2, 0.4, 0.9);
 * style->SetCode("vec3 nprShade(NprSurface s)"
 *                "{ return s.diffuse + rim * pow(1.0 - dot(s.normal, s.view), 3.0); }");
 * ```
 *
 * Code with an error is reported by the shading pass with the compiler's message, lines counted in
 * the code from 1, and VTK's own shading is drawn until the code or its parameters change.
 *
 * @sa vtkNPRShadingPass
 */
#ifndef vtkNPRSnippetStyle_h
#define vtkNPRSnippetStyle_h

#include "vtkNPRShadingStyle.h"

#include <map> // for the uniforms

class VTKNPRRENDERINGSHADING_EXPORT vtkNPRSnippetStyle : public vtkNPRShadingStyle
{
public:
  static vtkNPRSnippetStyle* New();
  vtkTypeMacro(vtkNPRSnippetStyle, vtkNPRShadingStyle);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  std::string GetCode() override;
  void SetUniforms(vtkShaderProgram* program) override;

  /**
   * The definition of nprShade and of the functions it calls, in GLSL 1.50. Default: the surface's
   * diffuse colour, unlit.
   */
  void SetCode(const std::string& code);

  /// @name Uniforms
  /// Parameters of the code, one to four values each, of any finite value. Only a new name or
  /// another number of values makes shaders be built anew. A name is a GLSL identifier: letters,
  /// digits and _, not beginning with a digit or gl_; nothing else is accepted.
  ///@{
  void SetUniform(const std::string& name, double x);
  void SetUniform(const std::string& name, double x, double y);
  void SetUniform(const std::string& name, double x, double y, double z);
  void SetUniform(const std::string& name, double x, double y, double z, double w);
  void RemoveUniform(const std::string& name);
  void RemoveAllUniforms();
#ifndef __VTK_WRAP__
  void SetUniform(const std::string& name, const std::vector<double>& values);
#endif
  ///@}

protected:
  vtkNPRSnippetStyle();
  ~vtkNPRSnippetStyle() override;

private:
  vtkNPRSnippetStyle(const vtkNPRSnippetStyle&) = delete;
  void operator=(const vtkNPRSnippetStyle&) = delete;

  std::string Code;
  std::map<std::string, std::vector<double>> Uniforms;
};

#endif
