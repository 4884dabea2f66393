uniform int nprPhongHalfway;

vec3 nprShade(NprSurface s)
{
  vec3 color = s.ambient;
  for (int i = 0; i < nprLightCount; ++i)
  {
    NprLight light = nprGetLight(i, s);
    float diffuse = max(dot(s.normal, light.direction), 0.0);
    float specular = nprPhongHalfway != 0 ? nprSpecularHalfway(s, light.direction)
                                          : nprSpecularReflection(s, light.direction);
    color += light.attenuation * light.color * (diffuse * s.diffuse + specular * s.specular);
  }
  return color;
}
