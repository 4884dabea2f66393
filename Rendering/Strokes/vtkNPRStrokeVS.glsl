//VTK::System::Dec
//NPR::Variant::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Six vertices are one segment of a stroke: the two triangles of the quad around the capsule that
// the fragment shader fills. The segment's ends are fetched by the number of the vertex, for software
// renderers draw small instances slowly. Everything after the clipping is in pixels of the viewport.

// Two texels a point: position (model coordinates, relative to the origin of the buffer) and width;
// strength, opacity, arc length, and a sum of what it is on its stroke (npr::StrokeKind).
uniform samplerBuffer nprRecords;
const int Drawn = 1;
const int HasBefore = 2;
const int HasAfter = 4;
const int Hidden = 8;
const int StrokeNumber = 16;

uniform mat4 nprMCDCMatrix;
uniform int nprNumberOfClippingPlanes;
uniform vec4 nprClippingPlanes[6];     // in the coordinates of the records; what is positive stays
uniform vec2 nprViewportSize;          // pixels
uniform float nprWidth;                // pixels, or world units where the next is not 0
uniform float nprWorldPixel;           // size of a pixel at clip coordinate w = 1, world units
uniform int nprUseWidths;              // whether the points' widths multiply nprWidth
uniform int nprUseOpacities;           // whether the points have opacities
uniform float nprMinimumWidthFactor;   // of the width at strength 0
uniform float nprMinimumOpacityFactor; // of the opacity at strength 0
uniform float nprGuard;                // pixels around the viewport that ink may come from

flat out vec4 nprAxisVSOut;    // the first end, pixels; the unit direction to the other
flat out float nprSizeVSOut;   // distance of the ends, pixels
flat out vec2 nprDepthVSOut;   // both ends, normalised device coordinates
flat out vec4 nprInkVSOut;     // both ends: radius in pixels, opacity
flat out float nprHiddenVSOut; // 1 where HidingLayers says so
out vec2 nprPlaceVSOut;        // from the first end along and across the axis, pixels

#ifdef NPR_COLORED
uniform samplerBuffer nprColors; // of the points
flat out vec4 nprStartColorVSOut;
flat out vec4 nprEndColorVSOut;
#endif

#ifdef NPR_PICKED
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

// The direction to a neighbour's far end, along a direction and to its left.
vec2 neighbour(vec4 clip, vec2 from, vec2 axis)
{
  vec2 way = (0.5 * clip.xy / clip.w + 0.5) * nprViewportSize - from;
  float size = length(way);
  // Where it can not be seen, the stroke goes straight on.
  way = clip.w > 0.0 && size > 1e-3 ? way / size : axis;
  return vec2(dot(way, axis), axis.x * way.y - axis.y * way.x);
}

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
  int segment = gl_VertexID / 6;
  int corner = gl_VertexID - 6 * segment;
  corner = corner < 3 ? corner : 6 - corner; // 0 1 2, 3 2 1
  vec4 startPlace = texelFetch(nprRecords, 2 * segment);
  vec4 startMore = texelFetch(nprRecords, 2 * segment + 1);
  vec4 endPlace = texelFetch(nprRecords, 2 * segment + 2);
  vec4 endMore = texelFetch(nprRecords, 2 * segment + 3);
  int startKind = int(startMore.w);
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
  nprSizeVSOut = 0.0;
  nprPlaceVSOut = vec2(0.0);
  nprDepthVSOut = vec2(0.0);
  nprInkVSOut = vec4(0.0);
  nprHiddenVSOut = 0.0;
#ifdef NPR_COLORED
  nprStartColorVSOut = nprEndColorVSOut = vec4(0.0);
#endif
#ifdef NPR_PICKED
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
  vec2 beyond = vec2(extent);
#ifdef NPR_STYLED
  if ((startKind & HasBefore) != 0 && range.x == 0.0)
  {
    vec4 before = nprMCDCMatrix * vec4(texelFetch(nprRecords, 2 * segment - 2).xyz, 1.0);
    nprNeighboursVSOut.xy = neighbour(before, pixelA, -axis);
  }
  if ((int(endMore.w) & HasAfter) != 0 && range.y == 1.0)
  {
    vec4 after = nprMCDCMatrix * vec4(texelFetch(nprRecords, 2 * segment + 4).xyz, 1.0);
    nprNeighboursVSOut.zw = neighbour(after, pixelB, axis);
  }
  beyond = vec2(
    reachBeyond(nprNeighboursVSOut.xy, inkA.x), reachBeyond(nprNeighboursVSOut.zw, inkB.x));
  vec2 pageLengths = vec2(
    texelFetch(nprPageLengths, segment).r, texelFetch(nprPageLengths, segment + 1).r);
  pageLengths = mix(pageLengths.xx, pageLengths.yy, range);
  nprLengthsVSOut = vec4(pageLengths,
    nprDashScale > 0.0 ? nprDashScale * mix(startMore.zz, endMore.zz, range) : pageLengths);
  nprStrokeVSOut = startKind / StrokeNumber;
#endif
#ifdef NPR_COLORED
  vec4 startColor = texelFetch(nprColors, segment);
  vec4 endColor = texelFetch(nprColors, segment + 1);
  nprStartColorVSOut = mix(startColor, endColor, range.x);
  nprEndColorVSOut = mix(startColor, endColor, range.y);
#endif
#ifdef NPR_PICKED
  nprCellVSOut = texelFetch(nprCells, segment);
#endif
  nprHiddenVSOut = (startKind & Hidden) != 0 ? 1.0 : 0.0;
  vec2 side = vec2((corner & 1) == 0 ? -1.0 : 1.0, (corner & 2) == 0 ? -1.0 : 1.0);
  float along = side.x < 0.0 ? -beyond.x : beyond.y;
  vec2 position = (side.x < 0.0 ? pixelA : pixelB) + along * axis +
    extent * side.y * vec2(-axis.y, axis.x);

  nprAxisVSOut = vec4(pixelA, axis);
  nprSizeVSOut = size;
  nprPlaceVSOut = vec2(side.x < 0.0 ? along : size + along, side.y * extent);
  nprDepthVSOut = vec2(a.z / a.w, b.z / b.w);
  nprInkVSOut = vec4(inkA, inkB);
  gl_Position = vec4(2.0 * position / nprViewportSize - 1.0, 0.0, 1.0);
}
