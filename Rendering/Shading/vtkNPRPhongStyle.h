// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRPhongStyle
 * @brief Phong's illumination, evaluated at each fragment.
 *
 * Ka + sum over the lights of f(d) I (Kd max(n.l, 0) + Ks max(r.v, 0)^s), B. T. Phong, Illumination
 * for Computer Generated Pictures, CACM 1975; or with (n.h)^s, J. Blinn, Models of Light Reflection
 * for Computer Synthesized Pictures, SIGGRAPH 1977.
 *
 * With several lights, or one that is not a headlight, this is what VTK itself draws. For a single
 * headlight VTK takes (n.z)^s, to which HalfwayVector comes close.
 *
 * @sa vtkNPRShadingPass
 */
#ifndef vtkNPRPhongStyle_h
#define vtkNPRPhongStyle_h

#include "vtkNPRShadingStyle.h"

class VTKNPRRENDERINGSHADING_EXPORT vtkNPRPhongStyle : public vtkNPRShadingStyle
{
public:
  static vtkNPRPhongStyle* New();
  vtkTypeMacro(vtkNPRPhongStyle, vtkNPRShadingStyle);

  std::string GetCode() override;
  void SetUniforms(vtkShaderProgram* program) override;

  /// @name HalfwayVector
  /// Highlights by the vector half way between light and eye instead of the reflected light:
  /// rounder at grazing angles, and wider for the same specular power. Default: off.
  ///@{
  vtkSetMacro(HalfwayVector, bool);
  vtkGetMacro(HalfwayVector, bool);
  vtkBooleanMacro(HalfwayVector, bool);
  ///@}

protected:
  vtkNPRPhongStyle();
  ~vtkNPRPhongStyle() override = default;

private:
  vtkNPRPhongStyle(const vtkNPRPhongStyle&) = delete;
  void operator=(const vtkNPRPhongStyle&) = delete;

  bool HalfwayVector = false;
};

#endif
