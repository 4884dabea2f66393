// What every shading style can use; vtkNPRShadingPass puts it before the style's own code.
// All vectors are in view coordinates.

struct NprSurface
{
  vec3 position;
  vec3 normal;   // unit, on the side that the viewer sees
  vec3 view;     // unit, from the surface to the eye
  vec3 ambient;  // the material's colours times their coefficients, vertex colours
  vec3 diffuse;  // and mapped scalars included
  vec3 specular;
  float power;   // the specular power
  float opacity;
  vec3 positionStep[2]; // changes to the next pixel at the right and above, for nprNeighbour
  vec3 normalStep[2];
};

struct NprLight
{
  vec3 direction;    // unit, from the surface to the light
  vec3 color;        // colour times intensity
  float attenuation; // by distance and cone, in [0, 1]
};

// How many lights there are and of which kind is known when the shader is built, as VTK does it:
// NPR_LIGHT_COUNT, and NPR_LIGHT_KIND 1 for one headlight, 2 for directional lights, 3 for any.
const int nprLightCount = NPR_LIGHT_COUNT;
uniform vec3 nprLightColor[NPR_LIGHT_COUNT];
#if NPR_LIGHT_KIND > 1
uniform vec3 nprLightAxis[NPR_LIGHT_COUNT]; // unit, the way that the light shines
#endif
#if NPR_LIGHT_KIND > 2
uniform vec4 nprLightPosition[NPR_LIGHT_COUNT];    // w: 1 for a light at a place, 0 for a directional one
uniform vec3 nprLightAttenuation[NPR_LIGHT_COUNT]; // constant, linear, quadratic
uniform vec2 nprLightCone[NPR_LIGHT_COUNT];        // cosine of the cone's angle (-2: no cone), exponent
#endif
uniform int nprParallelProjection;

vec3 nprToEye(vec3 position)
{
  return nprParallelProjection != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-position);
}

// The surface one pixel to the right (axis 0) or above (axis 1), by its tangent plane. Styles take
// differences to it instead of dFdx and dFdy: these are undefined where a fragment may have
// returned before, as with depth peeling.
NprSurface nprNeighbour(NprSurface s, int axis)
{
  s.position += s.positionStep[axis];
  s.normal = normalize(s.normal + s.normalStep[axis]);
  s.view = nprToEye(s.position);
  return s;
}

// Unit vector from a place to light i.
vec3 nprToLight(int i, vec3 position)
{
#if NPR_LIGHT_KIND > 2
  if (nprLightPosition[i].w > 0.5)
  {
    vec3 toLight = nprLightPosition[i].xyz - position;
    return toLight * inversesqrt(max(dot(toLight, toLight), 1e-20));
  }
#endif
#if NPR_LIGHT_KIND > 1
  return -nprLightAxis[i];
#else
  return vec3(0.0, 0.0, 1.0);
#endif
}

#if NPR_LIGHT_KIND > 2
// The cosine to the axis of spot light i.
float nprConeCosine(int i, vec3 position)
{
  return -dot(nprToLight(i, position), nprLightAxis[i]);
}

// How much of a light at a place reaches the surface.
float nprAttenuation(int i, NprSurface s)
{
  float range = distance(nprLightPosition[i].xyz, s.position);
  vec3 a = nprLightAttenuation[i];
  float attenuation = min(1.0, 1.0 / max(a.x + range * (a.y + range * a.z), 1e-6));
  if (nprLightCone[i].x > -1.5)
  {
    // The rim of the cone is as wide as a pixel, so that it is not jagged.
    float inside = nprConeCosine(i, s.position);
    float rim = length(vec2(nprConeCosine(i, s.position + s.positionStep[0]) - inside,
      nprConeCosine(i, s.position + s.positionStep[1]) - inside));
    attenuation *= clamp((inside - nprLightCone[i].x) / max(rim, 1e-7) + 0.5, 0.0, 1.0) *
      pow(max(inside, 1e-5), nprLightCone[i].y);
  }
  return attenuation;
}
#endif

// Light i in [0, nprLightCount), as it reaches the surface.
NprLight nprGetLight(int i, NprSurface s)
{
  NprLight light;
  light.direction = nprToLight(i, s.position);
  light.color = nprLightColor[i];
  light.attenuation = 1.0;
#if NPR_LIGHT_KIND > 2
  if (nprLightPosition[i].w > 0.5)
  {
    light.attenuation = nprAttenuation(i, s);
  }
#endif
  return light;
}

// (r.v)^power with r the reflection of the direction to the light; 0 where the light is behind.
float nprSpecularReflection(NprSurface s, vec3 direction)
{
  float lit = step(1e-6, dot(s.normal, direction));
  return lit * pow(max(dot(reflect(-direction, s.normal), s.view), 1e-5), s.power);
}

// (n.h)^power with h half way between light and eye; 0 where the light is behind.
float nprSpecularHalfway(NprSurface s, vec3 direction)
{
  float lit = step(1e-6, dot(s.normal, direction));
  vec3 h = direction + s.view;
  return lit * pow(max(dot(s.normal, h) * inversesqrt(max(dot(h, h), 1e-12)), 1e-5), s.power);
}
