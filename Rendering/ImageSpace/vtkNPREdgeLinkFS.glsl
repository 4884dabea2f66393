//VTK::System::Dec
//VTK::Output::Dec
// Which weak edges go on where strong ones end, so that a line is not broken where it sinks below
// the threshold for a while (hysteresis, Canny 1986). Only within an object: next to where it ends,
// surfaces bend away.

in vec2 texCoord; // over the viewport
uniform sampler2D nprEdges; // as vtkNPREdgeDetectFS.glsl has them
uniform ivec2 nprSize;

const int Reach = 6;

bool nprHasStrong(ivec2 pixel)
{
  ivec2 low = max(pixel - Reach, ivec2(0));
  ivec2 high = min(pixel + Reach, nprSize - 1);
  for (int y = low.y; y <= high.y; ++y)
  {
    for (int x = low.x; x <= high.x; ++x)
    {
      if (any(lessThan(abs(texelFetch(nprEdges, ivec2(x, y), 0).rg - 0.75), vec2(0.125))))
      {
        return true;
      }
    }
  }
  return false;
}

void main()
{
  ivec2 pixel = ivec2(texCoord * vec2(nprSize));
  vec2 edges = texelFetch(nprEdges, pixel, 0).rg;
  bvec2 isWeak = lessThan(abs(edges - 0.25), vec2(0.125));
  if (any(isWeak))
  {
    vec2 strong = step(0.5, edges);
    edges = nprHasStrong(pixel) ? max(strong, vec2(isWeak)) : strong;
  }
  gl_FragData[0] = vec4(edges, 0.0, 1.0);
}
