// A ramp of n equal steps over [0, 1] comes as its integral at the n + 1 ends of the steps, so that
// its mean over the width of a pixel is one difference: tone borders are smooth at any resolution.
uniform sampler2D nprToonDiffuseRamp;
uniform sampler2D nprToonSpecularRamp;
uniform float nprToonSmoothing; // pixels

// The integral from 0 to x; the first and the last step go on beyond the ends.
vec3 nprToonIntegral(sampler2D ramp, float x)
{
  int steps = textureSize(ramp, 0).x - 1;
  float place = x * float(steps);
  int i = clamp(int(floor(place)), 0, steps - 1);
  vec3 begin = texelFetch(ramp, ivec2(i, 0), 0).rgb;
  vec3 end = texelFetch(ramp, ivec2(i + 1, 0), 0).rgb;
  return begin + (place - float(i)) * (end - begin);
}

// The tone at x, whose values at the next pixels are x + step.
vec3 nprToonTone(sampler2D ramp, float x, vec2 step)
{
  float width = min(nprToonSmoothing * length(step), 1.0);
  if (width < 1e-4)
  {
    int steps = textureSize(ramp, 0).x - 1;
    int i = clamp(int(floor(x * float(steps))), 0, steps - 1);
    return float(steps) *
      (texelFetch(ramp, ivec2(i + 1, 0), 0).rgb - texelFetch(ramp, ivec2(i, 0), 0).rgb);
  }
  return (nprToonIntegral(ramp, x + 0.5 * width) - nprToonIntegral(ramp, x - 0.5 * width)) / width;
}

// The two arguments of the ramps: n.l and (n.h)^s.
vec2 nprToonPlace(int i, NprSurface s)
{
  vec3 toLight = nprToLight(i, s.position);
  return vec2(dot(s.normal, toLight), nprSpecularHalfway(s, toLight));
}

vec3 nprShade(NprSurface s)
{
  NprSurface right = nprNeighbour(s, 0);
  NprSurface above = nprNeighbour(s, 1);
  vec3 color = s.ambient;
  for (int i = 0; i < nprLightCount; ++i)
  {
    NprLight light = nprGetLight(i, s);
    vec2 place = nprToonPlace(i, s);
    vec2 toRight = nprToonPlace(i, right) - place;
    vec2 toAbove = nprToonPlace(i, above) - place;
    vec3 diffuse = nprToonTone(nprToonDiffuseRamp, place.x, vec2(toRight.x, toAbove.x));
    vec3 specular = nprToonTone(nprToonSpecularRamp, place.y, vec2(toRight.y, toAbove.y));
    color += light.attenuation * light.color * (diffuse * s.diffuse + specular * s.specular);
  }
  return color;
}
