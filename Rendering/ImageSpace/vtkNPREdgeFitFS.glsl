//VTK::System::Dec
//VTK::Output::Dec
// Where the true line runs that the edges between pixels are the steps of, as morphological
// antialiasing finds it (Reshetov 2009): a run of edges goes from the middle of the step at its one
// end to the middle of the step at its other. Red and green: how far the line is from the edge
// above the pixel, at that edge's left and right end; blue and alpha: from the edge at the right,
// at its lower and upper end. 0: there is no line; else [1/255, 1] stands for [-0.5, 0.5].

in vec2 texCoord; // over the viewport
uniform sampler2D nprEdges;
uniform ivec2 nprSize;

// Longer runs are straight in the middle.
const int MaximumReach = 32;
// Shorter pieces that are joined to nothing are noise.
const float ShortestPiece = 3.0;

// An edge along an axis (x: the edge above the pixel; y: the edge at its right).
bool nprIsAlong(ivec2 axis, ivec2 pixel)
{
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, nprSize)))
  {
    return false;
  }
  vec2 edges = texelFetch(nprEdges, pixel, 0).rg;
  return dot(edges, vec2(axis.yx)) > 0.5;
}

struct End
{
  float reach;  // from the middle of the edge
  float offset; // -0.5, 0 or 0.5
  bool isLoose;
  bool isMinor; // what it is joined to runs on the other way
};

End nprFindEnd(ivec2 pixel, ivec2 axis, int way)
{
  ivec2 across = axis.yx;
  End end;
  end.offset = 0.0;
  end.isLoose = false;
  end.isMinor = false;
  for (int i = 0; i < MaximumReach; ++i)
  {
    ivec2 last = pixel + way * i * axis;
    if (!nprIsAlong(axis, last + way * axis))
    {
      ivec2 corner = way > 0 ? last : last - axis;
      bool up = nprIsAlong(across, corner + across);
      bool down = nprIsAlong(across, corner);
      end.reach = float(i) + 0.5;
      end.offset = up == down ? 0.0 : up ? 0.5 : -0.5;
      end.isLoose = !up && !down;
      end.isMinor = (up && nprIsAlong(across, corner + 2 * across)) ||
        (down && nprIsAlong(across, corner - across));
      return end;
    }
  }
  end.reach = float(MaximumReach);
  return end;
}

float nprOffset(End low, End high, float place)
{
  float u = (place + low.reach) / (low.reach + high.reach);
  return u < 0.5 ? low.offset * (1.0 - 2.0 * u) : high.offset * (2.0 * u - 1.0);
}

vec2 nprFit(ivec2 pixel, ivec2 axis)
{
  if (!nprIsAlong(axis, pixel))
  {
    return vec2(0.0);
  }
  End low = nprFindEnd(pixel, axis, -1);
  End high = nprFindEnd(pixel, axis, 1);
  float size = low.reach + high.reach;
  // The steps of a line that runs the other way are no pieces of it.
  if ((size < 1.5 && (low.isMinor || high.isMinor)) ||
    (size < ShortestPiece + 0.5 && low.isLoose && high.isLoose))
  {
    return vec2(0.0);
  }
  return (1.0 + 254.0 * (0.5 + vec2(nprOffset(low, high, -0.5), nprOffset(low, high, 0.5)))) / 255.0;
}

void main()
{
  ivec2 pixel = ivec2(texCoord * vec2(nprSize));
  gl_FragData[0] = vec4(nprFit(pixel, ivec2(1, 0)), nprFit(pixel, ivec2(0, 1)));
}
