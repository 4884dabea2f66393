//VTK::System::Dec
//VTK::Output::Dec
// Lines of a width around what vtkNPREdgeFitFS.glsl found.

in vec2 texCoord; // over the viewport
uniform sampler2D nprLines;
uniform sampler2D nprBlocks; // as vtkNPREdgeBlocksFS.glsl has them
uniform ivec2 nprSize;
uniform float nprWidth;
uniform vec4 nprInk;

float nprDistance(vec2 from, vec2 to)
{
  vec2 along = to - from;
  return length(from - along * clamp(dot(from, along) / dot(along, along), -1.0, 0.0));
}

vec2 nprOffsets(vec2 code)
{
  return (code * 255.0 - 1.0) / 254.0 - 0.5;
}

const int Block = 8; // pixels

bool nprHasLines(ivec2 low, ivec2 high)
{
  for (int y = low.y / Block; y <= high.y / Block; ++y)
  {
    for (int x = low.x / Block; x <= high.x / Block; ++x)
    {
      if (texelFetch(nprBlocks, ivec2(x, y), 0).r > 0.5)
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
  float radius = 0.5 * max(nprWidth, 1.0) + 0.5;
  ivec2 low = max(pixel - int(radius + 1.0), ivec2(0));
  ivec2 high = min(pixel + int(radius + 0.5), nprSize - 1);
  if (!nprHasLines(low, high))
  {
    discard;
  }
  float nearest = radius;
  for (int y = low.y; y <= high.y; ++y)
  {
    for (int x = low.x; x <= high.x; ++x)
    {
      vec4 line = texelFetch(nprLines, ivec2(x, y), 0);
      vec2 corner = vec2(ivec2(x, y) - pixel) + 0.5; // upper right of that pixel
      if (line.r > 0.0)
      {
        vec2 offset = corner.y + nprOffsets(line.rg);
        nearest = min(nearest,
          nprDistance(vec2(corner.x - 1.0, offset.x), vec2(corner.x, offset.y)));
      }
      if (line.b > 0.0)
      {
        vec2 offset = corner.x + nprOffsets(line.ba);
        nearest = min(nearest,
          nprDistance(vec2(offset.x, corner.y - 1.0), vec2(offset.y, corner.y)));
      }
    }
  }
  float coverage = clamp(radius - nearest, 0.0, 1.0) * min(nprWidth, 1.0);
  if (coverage <= 0.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(nprInk.rgb, nprInk.a * coverage);
}
