// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether surfaces hide an axis, for both shaders: segments of one piece need it but once.

uniform int nprDepthTest;
uniform sampler2D nprDepthTexture;
uniform vec2 nprViewportSize;      // pixels
uniform float nprVisibilityRadius; // pixels
uniform int nprVisibilitySamples;  // 17; a constant would have the loop unrolled, and run to its end

// Of a segment, about two pixels long each.
float countPieces(float size)
{
  return max(floor(0.5 * size + 0.5), 1.0);
}

float surface(vec2 pixel)
{
  ivec2 texel = ivec2(clamp(floor(pixel), vec2(0.0), nprViewportSize - 1.0));
  return texelFetch(nprDepthTexture, texel, 0).r;
}

// Depth of the farthest surface at the four pixels around a point.
float surfaceAround(vec2 pixel)
{
#ifdef GL_ARB_texture_gather
  vec4 surfaces = textureGather(nprDepthTexture, floor(pixel + 0.5) / nprViewportSize);
#else
  vec4 surfaces = vec4(surface(pixel + vec2(-0.5, -0.5)), surface(pixel + vec2(0.5, -0.5)),
    surface(pixel + vec2(-0.5, 0.5)), surface(pixel + vec2(0.5, 0.5)));
#endif
  return max(max(surfaces.x, surfaces.y), max(surfaces.z, surfaces.w));
}

// How visible the axis is at a pixel (window coordinates). The farthest surface of the
// neighbourhood decides: a contour lies on the edge of its own surface, so the surface at one pixel
// would hide half of it. `limits`: see the vertex shader.
float visibility(vec2 pixel, vec3 limits)
{
  // The pixels around the axis first: the plane of a flat surface is never nearer than all of them.
  // What is visible there, and what another surface hides, needs no more; then two rings of eight.
  float farthest = 0.0;
  vec2 offset = vec2(0.0);
  for (int i = 0; i < nprVisibilitySamples; ++i)
  {
    farthest = max(farthest, surfaceAround(pixel + offset));
    if (farthest >= limits.x || farthest < limits.z)
    {
      break;
    }
    offset = i == 0 ? vec2(nprVisibilityRadius - 0.5, 0.0)
                    : 0.70711 * vec2(offset.x - offset.y, offset.x + offset.y);
    offset *= i == 8 ? 0.5 : 1.0;
  }
  return farthest >= limits.x ? 1.0 : smoothstep(limits.y, limits.x, farthest);
}
