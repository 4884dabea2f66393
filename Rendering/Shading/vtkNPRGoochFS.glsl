uniform vec3 nprGoochCoolColor;
uniform vec3 nprGoochWarmColor;
uniform float nprGoochAlpha;
uniform float nprGoochBeta;

// Several lights: the mean of what each gives alone, weighted by how bright they are. What reaches
// the surface of a light by its attenuation is warm, the rest is cool.
vec3 nprShade(NprSurface s)
{
  float total = 0.0;
  float warmth = 0.0;
  vec3 highlight = vec3(0.0);
  for (int i = 0; i < nprLightCount; ++i)
  {
    NprLight light = nprGetLight(i, s);
    float weight = dot(light.color, vec3(0.2126, 0.7152, 0.0722));
    total += weight;
    warmth += weight * light.attenuation * 0.5 * (1.0 + dot(s.normal, light.direction));
    highlight += light.attenuation * nprSpecularReflection(s, light.direction) * light.color;
  }
  vec3 cool = nprGoochCoolColor + nprGoochAlpha * s.diffuse;
  vec3 warm = nprGoochWarmColor + nprGoochBeta * s.diffuse;
  return mix(cool, warm, warmth / max(total, 1e-6)) + highlight * s.specular;
}
