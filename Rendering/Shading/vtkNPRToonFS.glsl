// A ramp is n equal steps over [0, 1]; the first and the last go on beyond the ends.
uniform sampler2D nprToonDiffuseRamp;
uniform sampler2D nprToonSpecularRamp;
uniform float nprToonSmoothing; // pixels

// The ramp's mean over the smoothing width around x, which changes so much to the next pixels. The
// mean is taken over one border at most, so over no more than a step.
vec3 nprToonTone(sampler2D ramp, float x, vec2 change)
{
  int last = textureSize(ramp, 0).x - 1;
  float steps = float(last + 1);
  float width = clamp(nprToonSmoothing * length(change) * steps, 1e-6, 1.0);
  float end = x * steps + 0.5 * width;
  int border = int(floor(end));
  vec3 tone = texelFetch(ramp, ivec2(clamp(border, 0, last), 0), 0).rgb;
  vec3 before = texelFetch(ramp, ivec2(clamp(border - 1, 0, last), 0), 0).rgb;
  return mix(before, tone, clamp((end - float(border)) / width, 0.0, 1.0));
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
