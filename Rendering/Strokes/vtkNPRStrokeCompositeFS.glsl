//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lays the ink of one mapper over the picture.

//VTK::Output::Dec

in vec2 texCoord;

uniform sampler2D nprInkTexture;
uniform int nprColored; // whether the ink has colours of its own
uniform vec3 nprColor;
uniform float nprOpacity;
uniform int nprOrderIndependent; // whether VTK's order-independent translucent pass collects colour

void main()
{
  vec4 layer = texture(nprInkTexture, texCoord);
  float ink = nprOpacity * (nprColored != 0 ? layer.a : layer.r);
  vec3 color = nprColored != 0 ? layer.rgb : nprColor;
  if (ink <= 0.0)
  {
    discard;
  }
  // That pass takes the mean of all colours, weighted by their opacity: for a stroke over other
  // translucent things to come out as "over", its weight must grow as it covers them.
  float weight = nprOrderIndependent != 0 ? 1.0 / max(1.0 - ink, 1.0 / 1024.0) : 1.0;
  gl_FragData[0] = vec4(weight * ink * color, ink);
  gl_FragData[1] = vec4(weight * ink);
}
