uniform vec4 nprOutlineProjection; // elements 00, 11, 22 and 23 of the matrix
uniform vec3 nprOutlineSize;       // of the viewport and of the outline's width, pixels; 0: no outline

// Where a vertex of an enlarged back face is: pushed along its normal, as far as it shows, and back
// by four times as much, so that back faces that are seen themselves stay behind what they belong to.
vec4 nprPush(vec4 place, vec3 normal)
{
  if (nprOutlineSize.z <= 0.0)
  {
    return place;
  }
  bool parallel = nprParallelProjection != 0;
  vec2 along = nprOutlineProjection.xy * normal.xy;
  if (!parallel)
  {
    along = along * place.w + place.xy * normal.z;
  }
  along *= nprOutlineSize.xy;
  along *= inversesqrt(max(dot(along, along), 1e-20));
  place.xy += 2.0 * nprOutlineSize.z * place.w * along / nprOutlineSize.xy;

  float back = 8.0 * nprOutlineSize.z / (nprOutlineProjection.y * nprOutlineSize.y);
  if (parallel)
  {
    place.z -= nprOutlineProjection.z * back;
  }
  else
  {
    float range = place.w * (1.0 + back);
    place.z = place.w * (nprOutlineProjection.w - nprOutlineProjection.z * range) / range;
  }
  return place;
}
