//VTK::System::Dec
#extension GL_ARB_texture_gather : enable
//NPR::Variant::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Four vertices are one segment of a stroke: the quad around the capsule that the fragment shader
// fills. The segment's ends are fetched by the number of the vertex, for software
// renderers draw small instances slowly. Everything after the clipping is in pixels of the viewport.

// Two texels a point: position (model coordinates, relative to the origin of the buffer) and width;
// strength, opacity, arc length, and a sum of what it is on its stroke (npr::StrokeKind).
uniform samplerBuffer nprRecords;
const int Drawn = 1;
const int HasBefore = 2;
const int HasAfter = 4;
const int Hidden = 8;
const int Steep = 16;
const int StrokeNumber = 32;

uniform mat4 nprMCDCMatrix;
uniform int nprNumberOfClippingPlanes;
uniform vec4 nprClippingPlanes[6];     // in the coordinates of the records; what is positive stays
uniform float nprWidth;                // pixels, or world units where the next is not 0
uniform float nprWorldPixel;           // size of a pixel at clip coordinate w = 1, world units
uniform int nprUseWidths;              // whether the points' widths multiply nprWidth
uniform int nprUseOpacities;           // whether the points have opacities
uniform float nprMinimumWidthFactor;   // of the width at strength 0
uniform float nprMinimumOpacityFactor; // of the opacity at strength 0
uniform float nprGuard;                // pixels around the viewport that ink may come from

flat out vec4 nprAxisVSOut;    // the first end, pixels; the unit direction to the other
flat out vec2 nprSizeVSOut;    // distance of the ends, pixels; its inverse
flat out vec4 nprInkVSOut;     // both ends: radius in pixels, opacity
flat out float nprVisibleVSOut; // as far as it is known here
out vec2 nprPlaceVSOut;        // from the first end along and across the axis, pixels

#ifndef NPR_UNTESTED
uniform vec4 nprDepthProjection; // rows 2 and 3, columns 2 and 3 of the projection matrix
uniform float nprPixelScale;     // size of a pixel at clip coordinate w = 1, world units
uniform float nprTolerance;      // pixels
uniform float nprModelSize;      // world units

flat out vec3 nprStartLimitsVSOut; // of both ends, see depthLimits()
flat out vec3 nprEndLimitsVSOut;
#endif

//NPR::Hiding::Dec
uniform int nprUseHidingLayers;
uniform float nprHiddenOpacity;

#ifdef NPR_COLORED
uniform samplerBuffer nprColors; // of the points
flat out vec4 nprStartColorVSOut;
flat out vec4 nprEndColorVSOut;
#endif

#ifdef NPR_PICKED
flat out vec2 nprDepthVSOut; // both ends, normalised device coordinates
uniform samplerBuffer nprCells; // numbers of the segments' cells, by bytes
flat out vec4 nprCellVSOut;
#endif

#ifdef NPR_STYLED
uniform samplerBuffer nprPageLengths; // of the points along their strokes, pixels
uniform float nprDashScale;  // from arc lengths to the unit of dashes; 0 where that is a pixel
uniform int nprCap;          // 1: strokes end straight
uniform float nprMitreReach; // how far a corner goes beyond its point at most, half widths

flat out vec4 nprNeighboursVSOut; // directions into the segments before and after, out of this one
                                  // and to the left of that; 0 where the stroke ends
flat out vec4 nprLengthsVSOut;    // both ends along the stroke: pixels, units of dashes
flat out int nprStrokeVSOut;      // number of the stroke

// How far beyond its end a segment has ink, pixels, by the direction into its neighbour.
float reachBeyond(vec2 next, float radius)
{
  if (next == vec2(0.0))
  {
    return 0.71 + (nprCap == 1 ? 0.0 : radius);
  }
  return next.x > NPR_COSINE_OF_CORNER ? 1.0 + 0.2 * radius : 0.71 + nprMitreReach * radius;
}
#endif

// Where the direction of a neighbour can not be told.
#ifdef NPR_STYLED
const vec2 Untold = vec2(1.0, 0.0); // the stroke goes straight on
#else
const vec2 Untold = vec2(0.0); // a round cap covers every join
#endif

// The direction to a neighbour's far end, along a direction and to its left; and how far it is.
vec3 neighbour(vec4 clip, vec2 from, vec2 axis)
{
  vec2 way = (0.5 * clip.xy / clip.w + 0.5) * nprViewportSize - from;
  float size = length(way);
  way /= max(size, 1e-3);
  return clip.w > 0.0 && size > 1e-3
    ? vec3(dot(way, axis), axis.x * way.y - axis.y * way.x, size) : vec3(Untold, 0.0);
}

// How far beyond its end a segment is drawn at a distance to the left, pixels. Where the stroke
// goes on, turns little, and the cut does not pass the other end of the shorter segment (`size`),
// each segment has the part of the joint that is nearer to it; with a little over, for the edges of
// both are rounded each in its own way. Not where a wide or dark end reaches beyond the points of a
// thin or faint neighbour.
float cut(int kind, vec2 next, float left, float size)
{
  float beyond = -left * next.y / (1.0 + next.x);
  return (kind & Steep) == 0 && next.x > 0.0 && abs(beyond) < size ? beyond + 0.1 : abs(left);
}

// Keeps the part [range.x, range.y] of the segment on the positive side of a plane.
void clip(float start, float end, inout vec2 range)
{
  if (start < 0.0 && end < 0.0)
  {
    range = vec2(1.0, 0.0);
  }
  else if (start < 0.0)
  {
    range.x = max(range.x, start / (start - end));
  }
  else if (end < 0.0)
  {
    range.y = min(range.y, start / (start - end));
  }
}

#ifndef NPR_UNTESTED
// Distance from the plane of the eye, from a depth in normalised device coordinates; for any
// projection.
float viewDepth(float z)
{
  return (z * nprDepthProjection.w - nprDepthProjection.y) /
    (z * nprDepthProjection.z - nprDepthProjection.x);
}

// Depth in the depth buffer of what is so far in front of a point.
float depthBufferBefore(float depth, float distance)
{
  float nearer = depth - distance;
  if (nprDepthProjection.z != 0.0)
  {
    nearer = max(nearer, 1e-3 * depth); // in front of the eye
  }
  return 0.5 * (nprDepthProjection.y - nprDepthProjection.x * nearer) /
    (nprDepthProjection.w - nprDepthProjection.z * nearer) + 0.5;
}

// From where on surfaces hide a point, in the depth buffer: those farther than x do not, those
// nearer than y wholly, and those nearer than z also where there is no surface beside them.
vec3 depthLimits(float z)
{
  float depth = viewDepth(z);
  float pixelSize = abs(nprDepthProjection.w - nprDepthProjection.z * depth) * nprPixelScale;
  float tolerance = nprTolerance * pixelSize + 1e-4 * nprModelSize; // the latter: rounding
  // Within a distance r of its edge a surface with the radius of curvature R rises by sqrt(2 r R):
  // what is nearer than that is another surface, whose surroundings don't count.
  float rise = sqrt(2.0 * nprVisibilityRadius * pixelSize * nprModelSize);
  return vec3(depthBufferBefore(depth, tolerance), depthBufferBefore(depth, 1.5 * tolerance),
    depthBufferBefore(depth, max(2.0 * tolerance, rise)));
}
#endif

// Radius and opacity.
vec2 ink(float recordWidth, vec2 strengthAndOpacity)
{
  float strength = clamp(strengthAndOpacity.x, 0.0, 1.0);
  float width = nprWidth * mix(nprMinimumWidthFactor, 1.0, strength);
  if (nprUseWidths != 0)
  {
    width *= recordWidth;
  }
  float opacity = nprUseOpacities != 0 ? strengthAndOpacity.y : 1.0;
  return vec2(0.5 * width, opacity * mix(nprMinimumOpacityFactor, 1.0, strength));
}

void main()
{
  int segment = gl_VertexID / 4;
  int corner = gl_VertexID - 4 * segment;
  vec4 startPlace = texelFetch(nprRecords, 2 * segment);
  vec4 startMore = texelFetch(nprRecords, 2 * segment + 1);
  vec4 endPlace = texelFetch(nprRecords, 2 * segment + 2);
  vec4 endMore = texelFetch(nprRecords, 2 * segment + 3);
  int startKind = int(startMore.w);
  int endKind = int(endMore.w);
  vec4 start = nprMCDCMatrix * vec4(startPlace.xyz, 1.0);
  vec4 end = nprMCDCMatrix * vec4(endPlace.xyz, 1.0);
  vec2 reach = 1.0 + 2.0 * nprGuard / nprViewportSize;
  vec2 range = vec2(0.0, 1.0);
  for (int i = 0; i < nprNumberOfClippingPlanes; ++i)
  {
    clip(dot(nprClippingPlanes[i], vec4(startPlace.xyz, 1.0)),
      dot(nprClippingPlanes[i], vec4(endPlace.xyz, 1.0)), range);
  }
  clip(start.w + start.z, end.w + end.z, range);
  clip(start.w - start.z, end.w - end.z, range);
  clip(reach.x * start.w + start.x, reach.x * end.w + end.x, range);
  clip(reach.x * start.w - start.x, reach.x * end.w - end.x, range);
  clip(reach.y * start.w + start.y, reach.y * end.w + end.y, range);
  clip(reach.y * start.w - start.y, reach.y * end.w - end.y, range);

  nprAxisVSOut = vec4(0.0);
  nprSizeVSOut = vec2(0.0);
  nprPlaceVSOut = vec2(0.0);
  nprInkVSOut = vec4(0.0);
  nprVisibleVSOut = 0.0;
#ifdef NPR_COLORED
  nprStartColorVSOut = nprEndColorVSOut = vec4(0.0);
#endif
#ifndef NPR_UNTESTED
  nprStartLimitsVSOut = nprEndLimitsVSOut = vec3(0.0);
#endif
#ifdef NPR_PICKED
  nprDepthVSOut = vec2(0.0);
  nprCellVSOut = vec4(0.0);
#endif
#ifdef NPR_STYLED
  nprNeighboursVSOut = vec4(0.0);
  nprLengthsVSOut = vec4(0.0);
  nprStrokeVSOut = 0;
#endif
  // No area. Beyond the picture it would have to be clipped, and software renderers then send all
  // triangles around it the slow way.
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
  if ((startKind & Drawn) == 0 || range.x > range.y)
  {
    return;
  }

  vec4 a = mix(start, end, range.x);
  vec4 b = mix(start, end, range.y);
  if (a.w <= 0.0 || b.w <= 0.0)
  {
    return;
  }
  vec2 startInk = ink(startPlace.w, startMore.xy);
  vec2 endInk = ink(endPlace.w, endMore.xy);
  vec2 inkA = mix(startInk, endInk, range.x);
  vec2 inkB = mix(startInk, endInk, range.y);
  if (nprWorldPixel > 0.0)
  {
    inkA.x /= a.w * nprWorldPixel;
    inkB.x /= b.w * nprWorldPixel;
  }
  vec2 pixelA = (0.5 * a.xy / a.w + 0.5) * nprViewportSize;
  vec2 pixelB = (0.5 * b.xy / b.w + 0.5) * nprViewportSize;

  float extent = max(inkA.x, inkB.x) + 0.71; // and half a pixel's diagonal
  vec2 axis = pixelB - pixelA;
  float size = length(axis);
  axis = size > 1e-6 ? axis / size : vec2(1.0, 0.0);
  nprVisibleVSOut = nprUseHidingLayers != 0 && (startKind & Hidden) != 0 ? 0.0 : 1.0;
#ifndef NPR_UNTESTED
  nprStartLimitsVSOut = depthLimits(a.z / a.w);
  nprEndLimitsVSOut = depthLimits(b.z / b.w);
  if (nprDepthTest != 0 && countPieces(size) == 1.0)
  {
    nprVisibleVSOut *= visibility(
      0.5 * (pixelA + pixelB), 0.5 * (nprStartLimitsVSOut + nprEndLimitsVSOut));
    // All surfaces are far enough, for the fragments.
    nprStartLimitsVSOut = nprEndLimitsVSOut = vec3(0.0, -1.0, -2.0);
  }
#endif
  if (nprVisibleVSOut == 0.0 && nprHiddenOpacity == 0.0)
  {
    return;
  }
  vec3 nextToA = vec3(0.0);
  vec3 nextToB = vec3(0.0);
  if ((startKind & HasBefore) != 0 && range.x == 0.0)
  {
    vec4 before = nprMCDCMatrix * vec4(texelFetch(nprRecords, 2 * segment - 2).xyz, 1.0);
    nextToA = neighbour(before, pixelA, -axis);
  }
  if ((endKind & HasAfter) != 0 && range.y == 1.0)
  {
    vec4 after = nprMCDCMatrix * vec4(texelFetch(nprRecords, 2 * segment + 4).xyz, 1.0);
    nextToB = neighbour(after, pixelB, axis);
  }
  vec2 side = vec2((corner & 1) == 0 ? -1.0 : 1.0, (corner & 2) == 0 ? -1.0 : 1.0);
  float left = side.y * extent;
#ifdef NPR_STYLED
  nprNeighboursVSOut = vec4(nextToA.xy, nextToB.xy);
  vec2 beyond = vec2(reachBeyond(nextToA.xy, inkA.x), reachBeyond(nextToB.xy, inkB.x));
  vec2 pageLengths = vec2(
    texelFetch(nprPageLengths, segment).r, texelFetch(nprPageLengths, segment + 1).r);
  pageLengths = mix(pageLengths.xx, pageLengths.yy, range);
  nprLengthsVSOut = vec4(pageLengths,
    nprDashScale > 0.0 ? nprDashScale * mix(startMore.zz, endMore.zz, range) : pageLengths);
  nprStrokeVSOut = startKind / StrokeNumber;
#else
  vec2 beyond = vec2(cut(startKind, nextToA.xy, -left, min(size, nextToA.z)),
    cut(endKind, nextToB.xy, left, min(size, nextToB.z)));
#endif
#ifdef NPR_COLORED
  vec4 startColor = texelFetch(nprColors, segment);
  vec4 endColor = texelFetch(nprColors, segment + 1);
  nprStartColorVSOut = mix(startColor, endColor, range.x);
  nprEndColorVSOut = mix(startColor, endColor, range.y);
#endif
#ifdef NPR_PICKED
  nprDepthVSOut = vec2(a.z / a.w, b.z / b.w);
  nprCellVSOut = texelFetch(nprCells, segment);
#endif
  float along = side.x < 0.0 ? -beyond.x : beyond.y;
  vec2 position = (side.x < 0.0 ? pixelA : pixelB) + along * axis +
    left * vec2(-axis.y, axis.x);

  nprAxisVSOut = vec4(pixelA, axis);
  nprSizeVSOut = vec2(size, 1.0 / max(size, 1e-6));
  nprPlaceVSOut = vec2(side.x < 0.0 ? along : size + along, left);
  nprInkVSOut = vec4(inkA, inkB);
  gl_Position = vec4(2.0 * position / nprViewportSize - 1.0, 0.0, 1.0);
}
