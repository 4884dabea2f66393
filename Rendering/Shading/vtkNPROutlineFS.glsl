// Outlines without extraction; which is known when the shader is built: NPR_OUTLINE is a
// vtkNPRShadingPass::OutlineKind.
uniform vec3 nprOutlineColor;

#if NPR_OUTLINE == 1
uniform int nprOutlineTurn; // 1 while enlarged back faces are drawn

vec3 nprOutline(NprSurface s, vec3 color)
{
  return nprOutlineTurn != 0 ? nprOutlineColor : color;
}
#elif NPR_OUTLINE == 2
uniform float nprOutlineThreshold;
uniform float nprOutlineSoftness;

vec3 nprOutline(NprSurface s, vec3 color)
{
  float facing = dot(s.normal, s.view);
  NprSurface right = nprNeighbour(s, 0);
  NprSurface above = nprNeighbour(s, 1);
  // Never narrower than a pixel, so that the border is not jagged.
  float change = length(
    vec2(dot(right.normal, right.view) - facing, dot(above.normal, above.view) - facing));
  float width = max(max(nprOutlineSoftness, change), 1e-6);
  float surface = clamp((facing - nprOutlineThreshold) / width + 0.5, 0.0, 1.0);
  return mix(nprOutlineColor, color, surface);
}
#endif
