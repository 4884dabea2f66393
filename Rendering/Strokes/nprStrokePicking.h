// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokePicking_h
#define nprStrokePicking_h

#include "nprVTKCompat.h"

#include <vtkNew.h>
#include <vtkWeakPointer.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class StrokePicking
 * @brief The depth of all surfaces while a selector draws.
 *
 * Selectors draw actors in any order, but strokes must know all that hides them. So the surfaces
 * are drawn for their depth alone, once in a selection, when the first of its passes comes to
 * strokes.
 */
class StrokePicking
{
public:
  StrokePicking();
  ~StrokePicking();

  /// Brings the depth up to date; changes neither bindings nor the viewport.
  void DrawDepth(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, int width, int height);

  /// Whether the depth of surfaces is drawn now, which strokes have no part in.
  static bool IsDrawingDepth();

  vtkTextureObject* GetDepth() { return this->Depth; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkWeakPointer<vtkRenderer> Renderer;
};
}

#endif
