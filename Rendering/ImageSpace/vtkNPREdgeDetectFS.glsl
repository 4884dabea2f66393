//VTK::Output::Dec
// Between which pixels there is an edge: red towards the pixel at the right, green towards the one
// above. 1 for one between objects, 0.75 for one within, 0.25 for one that is weaker than the
// thresholds, but not much.

// Of each pixel: its normal by stereographic projection, its distance along the view direction, and
// its object (0: none; negative: one without normals).
in vec2 texCoord; // over the viewport
uniform NPR_SURFACE_SAMPLER nprSurfaces;
uniform ivec2 nprOrigin; // of the viewport
uniform ivec2 nprSize;
uniform vec4 nprRay; // scale and shift from normalised device coordinates to the view at distance 1
uniform int nprParallelProjection;
uniform float nprViewDistance;     // that a parallel projection stands for
uniform float nprDepthThreshold;   // share of the distance
uniform float nprNormalCosine;     // of the least angle
uniform int nprObjectEdges;

struct Surface
{
  vec3 position;
  vec3 normal;
  float range;
  float object;
};

Surface nprFetch(ivec2 pixel)
{
  // Of several samples the first stands for the pixel.
  vec4 texel = texelFetch(nprSurfaces, pixel + nprOrigin, 0);
  vec2 place = (2.0 * (vec2(pixel) + 0.5) / vec2(nprSize) - 1.0) * nprRay.xy + nprRay.zw;
  Surface s;
  s.range = texel.z;
  s.object = texel.w;
  s.position = vec3(nprParallelProjection != 0 ? place : place * texel.z, -texel.z);
  float square = dot(texel.xy, texel.xy);
  s.normal = vec3(2.0 * texel.xy, 1.0 - square) / (1.0 + square);
  return s;
}

// Factor 1: by the thresholds; a smaller one: by as much lower ones.
bool nprIsEdge(Surface a, Surface b, float factor)
{
  if (a.object == 0.0 || b.object == 0.0)
  {
    return a.object != b.object;
  }
  if (nprObjectEdges != 0 && abs(a.object) != abs(b.object))
  {
    return true;
  }
  if (a.object < 0.0 || b.object < 0.0)
  {
    return false;
  }
  // How far one is from the plane of the other: a plain difference of depths would find edges
  // wherever a surface is seen nearly edge-on.
  vec3 between = b.position - a.position;
  float gap = max(abs(dot(a.normal, between)), abs(dot(b.normal, between)));
  float range = nprParallelProjection != 0 ? nprViewDistance : min(a.range, b.range);
  // The cosine of the smaller angle, as for small ones.
  float cosine = 1.0 - factor * factor * (1.0 - nprNormalCosine);
  return gap > factor * nprDepthThreshold * range || dot(a.normal, b.normal) < cosine;
}

// Within an object, what is but a pixel wide is noise: both pixels must differ from what is beyond
// the other, too.
bool nprIsLastingEdge(Surface before, Surface here, Surface next, Surface beyond, float factor)
{
  return nprIsEdge(here, next, factor) && nprIsEdge(before, next, factor) &&
    nprIsEdge(here, beyond, factor);
}

const float Weak = 0.5;

float nprStrength(ivec2 pixel, ivec2 toNext)
{
  if (any(greaterThanEqual(pixel + toNext, nprSize)))
  {
    return 0.0;
  }
  Surface here = nprFetch(pixel);
  Surface next = nprFetch(pixel + toNext);
  if (!nprIsEdge(here, next, Weak))
  {
    return 0.0;
  }
  if (here.object == 0.0 || next.object == 0.0 ||
    (nprObjectEdges != 0 && abs(here.object) != abs(next.object)))
  {
    return 1.0;
  }
  Surface before = nprFetch(max(pixel - toNext, ivec2(0)));
  Surface beyond = nprFetch(min(pixel + 2 * toNext, nprSize - 1));
  return nprIsLastingEdge(before, here, next, beyond, 1.0) ? 0.75
    : nprIsLastingEdge(before, here, next, beyond, Weak)   ? 0.25
                                                           : 0.0;
}

void main()
{
  ivec2 pixel = ivec2(texCoord * vec2(nprSize));
  gl_FragData[0] = vec4(nprStrength(pixel, ivec2(1, 0)), nprStrength(pixel, ivec2(0, 1)), 0.0, 1.0);
}
