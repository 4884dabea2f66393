// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprCurveEvaluation_h
#define nprCurveEvaluation_h

#include "nprVTKCompat.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
VTK_ABI_NAMESPACE_END

namespace npr
{
struct StrokeCurves;

/**
 * Evaluates curves on the graphics processor, by transform feedback: once for all frames that draw
 * them, and whatever draws records draws curves, too.
 *
 * @param records becomes a StrokeRecord for each point, without ArcLength
 * @param colors becomes a colour for each point, four floats, if the control points have colours
 * @returns whether the shaders compiled
 */
bool EvaluateCurves(const StrokeCurves& curves, vtkOpenGLRenderWindow* window,
  vtkOpenGLBufferObject* records, vtkOpenGLBufferObject* colors);
}

#endif
