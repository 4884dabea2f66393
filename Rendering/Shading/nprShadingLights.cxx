// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprShadingLights.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMath.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>

namespace npr
{
//------------------------------------------------------------------------------
ShadingLights::ShadingLights(vtkRenderer* renderer)
{
  vtkTransform* view = renderer->GetActiveCamera()->GetModelViewTransformObject();
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    if (this->Count == Maximum)
    {
      this->TooMany = true;
      return;
    }
    this->Append(light, view);
  }
}

//------------------------------------------------------------------------------
void ShadingLights::Append(vtkLight* light, vtkTransform* view)
{
  const int i = this->Count++;
  double position[3];
  double focalPoint[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(focalPoint);
  double axis[3];
  vtkMath::Subtract(focalPoint, position, axis);
  vtkMath::Normalize(axis);
  view->TransformVector(axis, axis);
  view->TransformPoint(position, position);

  const bool positional = light->GetPositional() != 0;
  const bool simple = this->Count == 1 && light->LightTypeIsHeadlight();
  this->Kind = std::max(this->Kind, positional ? 3 : simple ? 1 : 2);
  const bool spot = positional && light->GetConeAngle() < 90.0;
  for (int c = 0; c < 3; ++c)
  {
    this->Color[i][c] = static_cast<float>(light->GetDiffuseColor()[c] * light->GetIntensity());
    this->Axis[i][c] = static_cast<float>(axis[c]);
    this->Position[i][c] = static_cast<float>(position[c]);
    this->Attenuation[i][c] = static_cast<float>(light->GetAttenuationValues()[c]);
  }
  this->Position[i][3] = positional ? 1.0f : 0.0f;
  this->Cone[i][0] =
    spot ? static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle()))) : -2.0f;
  this->Cone[i][1] = static_cast<float>(light->GetExponent());
}
}
