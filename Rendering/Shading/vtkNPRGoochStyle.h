// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRGoochStyle
 * @brief Cool to warm shading of technical illustration.
 *
 * A. Gooch, B. Gooch, P. Shirley, E. Cohen, A Non-Photorealistic Lighting Model for Automatic
 * Technical Illustration, SIGGRAPH 1998. With l to the light: cool = CoolColor + Alpha Kd, warm =
 * WarmColor + Beta Kd, and the surface goes from cool to warm by (1 + n.l) / 2: warm where it faces
 * the light. Highlights are Phong's. The material's ambient colour is not used.
 *
 * Several lights: the mean of what each gives alone, weighted by brightness; where a point or spot
 * light does not reach, it counts as cool.
 *
 * @sa vtkNPRShadingPass
 */
#ifndef vtkNPRGoochStyle_h
#define vtkNPRGoochStyle_h

#include "vtkNPRShadingStyle.h"

class VTKNPRRENDERINGSHADING_EXPORT vtkNPRGoochStyle : public vtkNPRShadingStyle
{
public:
  static vtkNPRGoochStyle* New();
  vtkTypeMacro(vtkNPRGoochStyle, vtkNPRShadingStyle);

  std::string GetCode() override;
  void SetUniforms(vtkShaderProgram* program) override;

  /// @name CoolColor, WarmColor
  /// Colours (red, green, blue, from 0 to 1) of the sides away from and towards the light, before
  /// the material's part. Default: (0, 0, 0.55) and (0.3, 0.3, 0).
  ///@{
  vtkSetVector3Macro(CoolColor, double);
  vtkGetVector3Macro(CoolColor, double);
  vtkSetVector3Macro(WarmColor, double);
  vtkGetVector3Macro(WarmColor, double);
  ///@}

  /// @name Alpha, Beta
  /// How much of the material's diffuse colour is in the cool and in the warm side, from 0 to 1.
  /// Default: 0.25 and 0.5.
  ///@{
  vtkSetClampMacro(Alpha, double, 0.0, 1.0);
  vtkGetMacro(Alpha, double);
  vtkSetClampMacro(Beta, double, 0.0, 1.0);
  vtkGetMacro(Beta, double);
  ///@}

protected:
  vtkNPRGoochStyle();
  ~vtkNPRGoochStyle() override = default;

private:
  vtkNPRGoochStyle(const vtkNPRGoochStyle&) = delete;
  void operator=(const vtkNPRGoochStyle&) = delete;

  double CoolColor[3] = { 0.0, 0.0, 0.55 };
  double WarmColor[3] = { 0.3, 0.3, 0.0 };
  double Alpha = 0.25;
  double Beta = 0.5;
};

#endif
