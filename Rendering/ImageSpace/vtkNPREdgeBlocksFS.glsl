//VTK::System::Dec
//VTK::Output::Dec
// Which blocks of pixels have lines in them, so that the others need not be searched.

in vec2 texCoord; // over the blocks
uniform sampler2D nprEdges; // lines, as vtkNPREdgeFitFS.glsl has them
uniform ivec2 nprSize;

const int Block = 8; // pixels, as in vtkNPREdgeInkFS.glsl

void main()
{
  ivec2 low = Block * ivec2(texCoord * vec2((nprSize + Block - 1) / Block));
  ivec2 high = min(low + Block, nprSize);
  float found = 0.0;
  for (int y = low.y; y < high.y; ++y)
  {
    for (int x = low.x; x < high.x; ++x)
    {
      vec4 line = texelFetch(nprEdges, ivec2(x, y), 0);
      found = max(found, max(line.r, line.b));
    }
  }
  gl_FragData[0] = vec4(found > 0.0 ? 1.0 : 0.0);
}
