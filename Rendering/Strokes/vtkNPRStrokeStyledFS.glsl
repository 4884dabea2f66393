// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What strokes have beyond round joins and caps: other joins and caps, dashes, and media on paper.
// A segment then ends where its neighbour begins, so that each pixel has one place along and across
// the stroke. Neighbours whose turn has a cosine above NPR_COSINE_OF_CORNER are always mitred.

flat in vec4 nprNeighboursVSOut;
flat in vec4 nprLengthsVSOut;
flat in int nprStrokeVSOut;

uniform int nprCap;          // 0 round, 1 butt
uniform int nprJoin;         // 0 round, 1 bevel, 2 mitre
uniform float nprMitreLimit; // of the mitre's length, widths
uniform vec2 nprDashes;      // on and off, pixels or units of dashes; no gaps without off
uniform vec2 nprHiddenDashes;
uniform int nprMedium;       // 0 ink, 1 pencil, 2 charcoal, 3 brush
uniform float nprPaperGrain; // how much of the paper's tooth stays white, 0 to 1
uniform float nprGrainSize;  // pixels
uniform vec2 nprPageOrigin;  // of the viewport on the page, pixels
uniform int nprSeed;

// The share of the pixel that belongs to this segment at one of its ends. `place` is beyond the end
// and to the left of that, as is the direction into the neighbour.
float endCoverage(vec2 place, vec2 next, float radius, vec2 outwards)
{
  vec2 left = vec2(-outwards.y, outwards.x);
  float strip = stripCoverage(place.y, radius, left);
  if (next == vec2(0.0))
  {
    if (nprCap == 1)
    {
      return strip * halfPlaneCoverage(-place.x, outwards);
    }
    float distance = length(place);
    vec2 away = distance > 1e-3 ? place / distance : vec2(0.0, 1.0);
    return place.x <= 0.0 ? strip
                          : stripCoverage(distance, radius, away.x * outwards + away.y * left);
  }
  if (place.x <= 0.0)
  {
    return strip;
  }
  // Where the neighbour is, it covers what it covers: there is no edge between them.
  if (dot(place, next) > 0.01)
  {
    return 0.0;
  }
  vec2 nextOutwards = next.x * outwards + next.y * left;
  float nextAcross = next.x * place.y - next.y * place.x;
  float cosineOfHalf = sqrt(max(0.5 + 0.5 * next.x, 0.0));
  if (next.x > NPR_COSINE_OF_CORNER || (nprJoin == 2 && cosineOfHalf * nprMitreLimit >= 1.0))
  {
    return min(strip, stripCoverage(nextAcross, radius, vec2(-nextOutwards.y, nextOutwards.x)));
  }
  float distance = length(place);
  vec2 away = distance > 1e-3 ? place / distance : vec2(0.0, 1.0);
  float coverage = stripCoverage(distance, radius, away.x * outwards + away.y * left);
  if (nprJoin != 0)
  {
    // The chord between the outer corners of both.
    vec2 outer = (next.y > 0.0 ? -1.0 : 1.0) * vec2(-next.y, 1.0 + next.x);
    outer = dot(outer, outer) > 1e-6 ? normalize(outer) : vec2(1.0, 0.0);
    coverage = min(coverage, halfPlaneCoverage(radius * cosineOfHalf - dot(place, outer),
      outer.x * outwards + outer.y * left));
  }
  return coverage;
}

// The share of a pixel in a dash. `at` is along the stroke in units of dashes, `scale` the
// pixels of one.
float dashCoverage(vec2 dashes, float at, float scale, float across, float radius)
{
  float period = dashes.x + dashes.y;
  if (dashes.y <= 0.0 || period <= 0.0)
  {
    return 1.0;
  }
  float place = at - period * floor(at / period);
  // From the nearest dash, pixels: negative in one.
  float outside = place < dashes.x ? -min(place, dashes.x - place)
                                   : min(place - dashes.x, period - place);
  outside *= scale;
  float covered = clamp(0.5 - outside, 0.0, 1.0);
  if (nprCap == 0)
  {
    covered =
      outside > 0.0 ? clamp(0.5 + radius - length(vec2(outside, across)), 0.0, 1.0) : 1.0;
  }
  // A pattern too fine for pixels becomes a tone.
  return mix(dashes.x / period, covered, clamp(0.5 * scale * period - 0.5, 0.0, 1.0));
}

// The hash of nprLatticeNoise.h.
uint hash(uint x)
{
  x ^= x >> 16;
  x *= 0x85ebca6bu;
  x ^= x >> 13;
  x *= 0xc2b2ae35u;
  x ^= x >> 16;
  return x;
}

float latticeValue(ivec2 place, uint seed)
{
  return float(hash(uint(place.x) + hash(uint(place.y) + hash(seed))) >> 8) / 16777216.0;
}

// Smooth noise in [0, 1).
float noise(vec2 x, uint seed)
{
  ivec2 place = ivec2(floor(x));
  vec2 t = fract(x);
  t = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
  return mix(
    mix(latticeValue(place, seed), latticeValue(place + ivec2(1, 0), seed), t.x),
    mix(latticeValue(place + ivec2(0, 1), seed), latticeValue(place + ivec2(1, 1), seed), t.x),
    t.y);
}

// The height of the paper's tooth, about evenly spread over [0, 1]. Octaves are turned against each
// other, so that the lattice is not seen; those too fine for pixels are left out.
float tooth(vec2 pixel)
{
  vec2 x = pixel / nprGrainSize;
  vec3 weights =
    vec3(0.5, 0.3, 0.2) * vec3(1.0, smoothstep(0.5, 1.5, nprGrainSize * vec2(0.5, 0.27)));
  float height = weights.x * noise(x, 11u) +
    weights.y * noise(mat2(1.6, 1.2, -1.2, 1.6) * x, 12u) +
    weights.z * noise(mat2(1.7, -3.3, 3.3, 1.7) * x, 13u);
  return smoothstep(0.2, 0.8, height / dot(weights, vec3(1.0)));
}

// What a tool that is pressed so hard leaves on the paper. `place`: along the stroke in pixels, and
// across it from -1 to 1.
float deposit(vec2 place, float radius, float pressure)
{
  uint seed = hash(uint(nprStrokeVSOut) + hash(uint(nprSeed)));
  float size = nprGrainSize;
  float edge = min(abs(place.y), 1.0);
  float softness = 0.25; // of the edges of what the tooth of the paper takes
  if (nprMedium == 1)
  {
    // The hand presses unevenly, and a round point least at its edges.
    pressure *= 0.8 + 0.2 * noise(vec2(place.x / (22.0 * size), 0.5), seed);
    pressure *= 1.0 - 0.4 * edge * edge;
    softness = 0.6;
  }
  else if (nprMedium == 2)
  {
    float crumbs = noise(vec2(place.x, place.y * radius) / (0.9 * size), seed + 1u);
    pressure *= 0.75 + 0.25 * noise(vec2(place.x / (14.0 * size), 0.5), seed);
    pressure *= 1.0 - smoothstep(0.35, 1.0, edge + 0.5 * (crumbs - 0.5));
  }
  else if (nprMedium == 3)
  {
    // Bristles, which part where the brush runs dry; a thin stroke shows none, or only coarse ones.
    float fine = 0.3 * smoothstep(5.0, 12.0, radius);
    float bristles = (1.0 - fine) * noise(vec2(place.x / (70.0 * size), 4.0 + 2.5 * place.y), seed) +
      fine * noise(vec2(place.x / (30.0 * size), 9.0 + 6.0 * place.y), seed + 1u);
    float dry = smoothstep(0.55, 0.9, noise(vec2(place.x / (60.0 * size), 0.5), seed + 2u)) *
      smoothstep(2.0, 5.0, radius);
    float gap = 1.1 - 0.55 * dry;
    float blur = 0.02 + 0.9 / max(radius, 1.0); // over a pixel
    pressure *= 1.0 - smoothstep(gap - blur, gap + blur, bristles);
  }
  float limit = 1.0 - pressure;
  float taken =
    smoothstep(limit - softness, limit + softness, tooth(gl_FragCoord.xy + nprPageOrigin));
  return mix(pressure, taken * smoothstep(0.0, 0.1, pressure), nprPaperGrain);
}
