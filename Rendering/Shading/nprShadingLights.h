// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprShadingLights_h
#define nprShadingLights_h

#include "vtkNPRShadingPass.h"

class vtkLight;
class vtkTransform;

namespace npr
{
/// A renderer's lights in view coordinates, as vtkNPRShadingFS.glsl declares them.
struct ShadingLights
{
  static constexpr int Maximum = vtkNPRShadingPass::MaximumNumberOfLights;
  int Count = 0;
  int Kind = 1; ///< as vtkNPRShadingFS.glsl says
  bool TooMany = false;
  float Color[Maximum][3];
  float Axis[Maximum][3];
  float Position[Maximum][4];
  float Attenuation[Maximum][3];
  float Cone[Maximum][2];

  explicit ShadingLights(vtkRenderer* renderer);

private:
  void Append(vtkLight* light, vtkTransform* view);
};
}

#endif
