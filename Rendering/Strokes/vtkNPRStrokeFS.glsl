//VTK::System::Dec
#extension GL_ARB_texture_gather : enable
//NPR::Variant::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fills the capsule around one segment: the area of the pixel that it covers, times the visibility
// of the nearest point of the axis. Fragments of one cross-section share that point, so
// a stroke is hidden across its whole width or not at all.

//VTK::Output::Dec

flat in vec4 nprAxisVSOut;
flat in vec2 nprSizeVSOut;
flat in vec4 nprInkVSOut;
flat in float nprVisibleVSOut;
in vec2 nprPlaceVSOut;
#ifndef NPR_UNTESTED
flat in vec3 nprStartLimitsVSOut;
flat in vec3 nprEndLimitsVSOut;
#endif
#ifdef NPR_COLORED
flat in vec4 nprStartColorVSOut;
flat in vec4 nprEndColorVSOut;
#endif

#ifdef NPR_PICKED
flat in vec2 nprDepthVSOut;
flat in vec4 nprCellVSOut;
uniform int nprPickedPart; // of the cell's number: 1 its low bytes, 2 the high one; 0: the colour
uniform vec3 nprPickedColor;
#endif

uniform float nprHiddenOpacity;

//NPR::Hiding::Dec

// The shadow of the unit pixel on a direction is a trapezoid: half the width of its base, half that
// of its top, the height, and the slope of its sides.
vec4 pixelShadow(vec2 direction)
{
  float a = max(abs(direction.x), abs(direction.y));
  float b = min(abs(direction.x), abs(direction.y));
  float height = 1.0 / a;
  return vec4(0.5 * (a + b), 0.5 * (a - b), height, height / max(b, 1e-6));
}

// Its area up to a distance from its middle: that of the pixel within a half-plane.
float shadowCoverage(float distance, vec4 shadow)
{
  float x = abs(distance);
  float rest = max(shadow.x - x, 0.0);
  float area = x <= shadow.y ? x * shadow.z : 0.5 - 0.5 * rest * rest * shadow.w;
  return 0.5 + sign(distance) * area;
}

float halfPlaneCoverage(float distance, vec2 direction)
{
  return shadowCoverage(distance, pixelShadow(direction));
}

// The share of a pixel that a strip covers, by the distance from its middle across a direction.
float stripCoverage(float across, float radius, vec2 direction)
{
  vec4 shadow = pixelShadow(direction);
  return shadowCoverage(radius - across, shadow) - shadowCoverage(-radius - across, shadow);
}

//NPR::Styled::Dec

void main()
{
  vec2 axis = nprAxisVSOut.zw;
  float along = clamp(nprPlaceVSOut.x, 0.0, nprSizeVSOut.x);
  vec2 away = vec2(nprPlaceVSOut.x - along, nprPlaceVSOut.y);
  float distance = length(away);
  float t = along * nprSizeVSOut.y;
  float radius = mix(nprInkVSOut.x, nprInkVSOut.z, t);
  // The direction vanishes on the axis itself; there any across it will do.
  away = distance > 1e-3 ? away / distance : vec2(0.0, 1.0);
  vec2 direction = vec2(away.x * axis.x - away.y * axis.y, away.x * axis.y + away.y * axis.x);
  float coverage = stripCoverage(distance, radius, direction);
  float opacity = mix(nprInkVSOut.y, nprInkVSOut.w, t);
  float visible = nprVisibleVSOut;
#ifndef NPR_UNTESTED
  // Software renderers pay for this also where the condition is false.
  if (nprDepthTest != 0)
  {
    // Where surfaces hide it is found for pieces of two pixels: less would be specks.
    float pieces = countPieces(nprSizeVSOut.x);
    float middle = (min(floor(t * pieces), pieces - 1.0) + 0.5) / pieces;
    visible *= visibility(nprAxisVSOut.xy + middle * nprSizeVSOut.x * axis,
      mix(nprStartLimitsVSOut, nprEndLimitsVSOut, middle));
  }
#endif
  float shown = mix(nprHiddenOpacity, 1.0, visible);
  float undashed = shown;
//NPR::Styled::Impl
#ifdef NPR_PICKED
  // What is half covered is in the stroke; of one thinner than a pixel, what has half of it.
  if (coverage <= 0.0 || coverage < 0.99 * min(0.5, radius) || 
    opacity * undashed < 0.02 || shown < 0.5 * undashed)
  {
    discard;
  }
  vec3 cell = nprPickedPart == 1 ? nprCellVSOut.rgb : vec3(nprCellVSOut.a, 0.0, 0.0);
  gl_FragData[0] = vec4(nprPickedPart == 0 ? nprPickedColor : cell, 1.0);
  // Pickers ask the depth buffer where things are. In front of what is drawn there later.
  vec2 pixel = nprAxisVSOut.xy + nprPlaceVSOut.x * axis + nprPlaceVSOut.y * vec2(-axis.y, axis.x);
  gl_FragDepth = min(
    0.5 * mix(nprDepthVSOut.x, nprDepthVSOut.y, t) + 0.5, surface(pixel) - 1e-6);
#else
  float ink = coverage * opacity * shown;
#ifdef NPR_COLORED
  // The colour of the most ink stays, by the depth test.
  vec4 color = mix(nprStartColorVSOut, nprEndColorVSOut, t);
  gl_FragData[0] = vec4(color.rgb, ink * color.a);
  gl_FragDepth = 1.0 - ink * color.a;
#else
  gl_FragData[0] = vec4(ink);
#endif
#endif
}
