//VTK::System::Dec
//NPR::Variant::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fills the capsule around one segment: the area of the pixel that it covers, times the visibility
// of the nearest point of the axis. Fragments of one cross-section share that point, so
// a stroke is hidden across its whole width or not at all.

//VTK::Output::Dec

flat in vec4 nprAxisVSOut;
flat in float nprSizeVSOut;
flat in vec2 nprDepthVSOut;
flat in vec4 nprInkVSOut;
flat in float nprHiddenVSOut;
in vec2 nprPlaceVSOut;
#ifdef NPR_COLORED
flat in vec4 nprStartColorVSOut;
flat in vec4 nprEndColorVSOut;
#endif

#ifdef NPR_PICKED
flat in vec4 nprCellVSOut;
uniform int nprPickedPart; // of the cell's number: 1 its low bytes, 2 the high one; 0: the colour
uniform vec3 nprPickedColor;
#endif

uniform int nprDepthTest;
uniform sampler2D nprDepthTexture;
uniform vec2 nprViewportSize;      // pixels
uniform vec4 nprDepthProjection;   // rows 2 and 3, columns 2 and 3 of the projection matrix
uniform float nprPixelScale;       // size of a pixel at clip coordinate w = 1, world units
uniform float nprTolerance;        // pixels
uniform float nprModelSize;        // world units
uniform float nprVisibilityRadius; // pixels
uniform int nprUseHidingLayers;
uniform float nprHiddenOpacity;

const vec2 Ring[8] = vec2[8](vec2(1.0, 0.0), vec2(0.0, 1.0), vec2(-1.0, 0.0), vec2(0.0, -1.0),
  vec2(0.7071, 0.7071), vec2(-0.7071, 0.7071), vec2(-0.7071, -0.7071), vec2(0.7071, -0.7071));

// Distance from the plane of the eye, from a depth in normalised device coordinates; for any
// projection. And back.
float viewDepth(float z)
{
  return (z * nprDepthProjection.w - nprDepthProjection.y) /
    (z * nprDepthProjection.z - nprDepthProjection.x);
}
float deviceDepth(float depth)
{
  return (nprDepthProjection.y - nprDepthProjection.x * depth) /
    (nprDepthProjection.w - nprDepthProjection.z * depth);
}

float surface(vec2 pixel)
{
  ivec2 texel = ivec2(clamp(floor(pixel), vec2(0.0), nprViewportSize - 1.0));
  return texelFetch(nprDepthTexture, texel, 0).r;
}

// How visible the axis is at a pixel (window coordinates) and depth. The farthest surface of the
// neighbourhood decides: a contour lies on the edge of its own surface, so the surface at one pixel
// would hide half of it.
float visibility(vec2 pixel, float z)
{
  float depth = viewDepth(z);
  float pixelSize = abs(nprDepthProjection.w - nprDepthProjection.z * depth) * nprPixelScale;
  float tolerance = nprTolerance * pixelSize + 1e-4 * nprModelSize; // the latter: rounding
  float nearest = depth - tolerance;
  if (nprDepthProjection.z != 0.0)
  {
    nearest = max(nearest, 1e-3 * depth); // in front of the eye
  }
  float limit = 0.5 * deviceDepth(nearest) + 0.5;

  // The four pixels around the axis: the plane of a flat surface is never nearer than all of them.
  float farthest =
    max(max(surface(pixel + vec2(-0.5, -0.5)), surface(pixel + vec2(0.5, -0.5))),
      max(surface(pixel + vec2(-0.5, 0.5)), surface(pixel + vec2(0.5, 0.5))));
  if (farthest >= limit)
  {
    return 1.0;
  }
  // Within a distance r of its edge a surface with the radius of curvature R rises by sqrt(2 r R):
  // what is nearer than that is another surface, whose surroundings don't count.
  if (depth - viewDepth(2.0 * farthest - 1.0) >
    max(2.0 * tolerance, sqrt(2.0 * nprVisibilityRadius * pixelSize * nprModelSize)))
  {
    return 0.0;
  }
  for (int i = 0; i < 16; ++i)
  {
    vec2 offset = (i < 8 ? 0.5 : 1.0) * nprVisibilityRadius * Ring[i & 7];
    farthest = max(farthest, surface(pixel + offset));
  }
  return 1.0 - smoothstep(tolerance, 1.5 * tolerance, depth - viewDepth(2.0 * farthest - 1.0));
}

// Area of the unit pixel within `distance` of its centre along a direction (a half-plane). The
// pixel's shadow on that direction is a trapezoid; this is its integral.
float halfPlaneCoverage(float distance, vec2 direction)
{
  float a = max(abs(direction.x), abs(direction.y));
  float b = min(abs(direction.x), abs(direction.y));
  float x = abs(distance);
  float rest = max(0.5 * (a + b) - x, 0.0);
  float area = x <= 0.5 * (a - b) ? x / a : 0.5 - rest * rest / max(2.0 * a * b, 1e-6);
  return 0.5 + sign(distance) * area;
}

// The share of a pixel that a strip covers, by the distance from its middle across a direction.
float stripCoverage(float across, float radius, vec2 direction)
{
  float distance = abs(across);
  float covered = halfPlaneCoverage(radius - distance, direction);
  // Only strokes thinner than a pixel's diagonal have both edges in one.
  return radius < 0.7072 ? covered - halfPlaneCoverage(-radius - distance, direction) : covered;
}

//NPR::Styled::Dec

void main()
{
  vec2 axis = nprAxisVSOut.zw;
  float along = clamp(nprPlaceVSOut.x, 0.0, nprSizeVSOut);
  vec2 away = vec2(nprPlaceVSOut.x - along, nprPlaceVSOut.y);
  float distance = length(away);
  float t = along / max(nprSizeVSOut, 1e-6);
  float radius = mix(nprInkVSOut.x, nprInkVSOut.z, t);
#ifndef NPR_STYLED
  if (distance >= radius + 0.71)
  {
    discard;
  }
#endif
  // The direction vanishes on the axis itself; there any across it will do.
  away = distance > 1e-3 ? away / distance : vec2(0.0, 1.0);
  vec2 direction = vec2(away.x * axis.x - away.y * axis.y, away.x * axis.y + away.y * axis.x);
  float coverage = stripCoverage(distance, radius, direction);
  float opacity = mix(nprInkVSOut.y, nprInkVSOut.w, t);
  float visible = nprUseHidingLayers != 0 ? 1.0 - nprHiddenVSOut : 1.0;
#ifndef NPR_UNTESTED
  // Software renderers pay for this also where the condition is false.
  if (nprDepthTest != 0)
  {
    visible *=
      visibility(nprAxisVSOut.xy + along * axis, mix(nprDepthVSOut.x, nprDepthVSOut.y, t));
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
