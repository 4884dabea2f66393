//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fills the capsule around one segment: the area of the pixel that it covers, times the visibility
// of the nearest point of the axis. Fragments of one cross-section share that point, so
// a stroke is hidden across its whole width or not at all.

//VTK::Output::Dec

flat in vec4 nprAxisVSOut;
flat in vec2 nprDepthVSOut;
flat in vec4 nprInkVSOut;

uniform int nprDepthTest;
uniform sampler2D nprDepthTexture;
uniform vec2 nprViewportSize;      // pixels
uniform vec4 nprDepthProjection;   // rows 2 and 3, columns 2 and 3 of the projection matrix
uniform float nprPixelScale;       // size of a pixel at clip coordinate w = 1, world units
uniform vec2 nprTolerance;         // pixels, world units
uniform float nprVisibilityRadius; // pixels
uniform float nprHiddenOpacity;

// Distance from the plane of the eye, from a depth in normalised device coordinates; for any
// projection.
float viewDepth(float z)
{
  return (z * nprDepthProjection.w - nprDepthProjection.y) /
    (z * nprDepthProjection.z - nprDepthProjection.x);
}

// 1 where the surface around the pixel is not in front of the axis, with the farthest surface of
// the neighbourhood deciding: a contour lies on the edge of its own surface, so the surface alone
// would hide half of it.
float visibility(vec2 pixel, float z)
{
  float depth = viewDepth(z);
  float pixelSize = abs(nprDepthProjection.w - nprDepthProjection.z * depth) * nprPixelScale;
  float tolerance = nprTolerance.x * pixelSize + nprTolerance.y;
  float farthest = -1e30;
  for (int i = 0; i < 17; ++i)
  {
    // The centre, eight pixels around it, eight at the radius.
    vec2 offset = vec2(0.0);
    if (i > 0)
    {
      float angle = 0.78539816 * float(i - 1);
      offset = (i < 9 ? 1.0 : nprVisibilityRadius) * vec2(cos(angle), sin(angle));
    }
    ivec2 texel = ivec2(clamp(floor(pixel + offset), vec2(0.0), nprViewportSize - 1.0));
    float surface = texelFetch(nprDepthTexture, texel, 0).r;
    if (surface >= 1.0)
    {
      return 1.0;
    }
    farthest = max(farthest, viewDepth(2.0 * surface - 1.0));
    if (depth <= farthest + tolerance)
    {
      return 1.0;
    }
  }
  return 1.0 - smoothstep(tolerance, 1.5 * tolerance, depth - farthest);
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

void main()
{
  vec2 start = nprAxisVSOut.xy;
  vec2 axis = nprAxisVSOut.zw - start;
  float size = length(axis);
  float t =
    clamp(dot(gl_FragCoord.xy - start, axis) / max(size * size, 1e-12), 0.0, 1.0);
  vec2 nearest = start + t * axis;
  vec2 across = gl_FragCoord.xy - nearest;
  float distance = length(across);
  float radius = mix(nprInkVSOut.x, nprInkVSOut.z, t);
  // The direction vanishes on the axis itself; there the axis has it.
  vec2 direction = distance > 1e-3 ? across / distance
    : size > 1e-3                  ? vec2(-axis.y, axis.x) / size
                                   : vec2(1.0, 0.0);
  float coverage = halfPlaneCoverage(radius - distance, direction) -
    halfPlaneCoverage(-radius - distance, direction);
  float opacity = coverage * mix(nprInkVSOut.y, nprInkVSOut.w, t);
  if (opacity <= 0.0)
  {
    discard;
  }
  if (nprDepthTest != 0)
  {
    opacity *=
      mix(nprHiddenOpacity, 1.0, visibility(nearest, mix(nprDepthVSOut.x, nprDepthVSOut.y, t)));
  }
  gl_FragData[0] = vec4(opacity);
}
