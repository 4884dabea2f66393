//VTK::System::Dec
//NPR::Variant::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Evaluates one point of a curve; what it writes is captured, and nothing is drawn.

in vec3 nprCurvePoint; // npr::CurvePoint: the span's first control point, t, kind

uniform samplerBuffer nprControls; // npr::StrokeRecord: two texels a point; or one with its colour
uniform mat4 nprBasis;             // column k: the four points' weights in the coefficient of t^k

#ifdef NPR_COLORED
out vec4 nprColorVSOut;
#else
out vec4 nprPlaceVSOut;
out vec4 nprMoreVSOut;
#endif

void main()
{
  int first = int(nprCurvePoint.x + 0.5);
  float t = nprCurvePoint.y;
#ifdef NPR_COLORED
  nprColorVSOut = mix(texelFetch(nprControls, first), texelFetch(nprControls, first + 1), t);
#else
  vec4 weights = nprBasis * vec4(1.0, t, t * t, t * t * t);
  vec4 start = texelFetch(nprControls, 2 * first);
  vec4 end = texelFetch(nprControls, 2 * first + 2);
  vec3 place = weights.x * texelFetch(nprControls, 2 * first - 2).xyz + weights.y * start.xyz +
    weights.z * end.xyz + weights.w * texelFetch(nprControls, 2 * first + 4).xyz;
  nprPlaceVSOut = vec4(place, mix(start.w, end.w, t));
  nprMoreVSOut = mix(
    texelFetch(nprControls, 2 * first + 1), texelFetch(nprControls, 2 * first + 3), t);
  nprMoreVSOut.w = nprCurvePoint.z;
#endif
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
