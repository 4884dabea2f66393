// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprStrokeLayer_h
#define nprStrokeLayer_h

#include "nprVTKCompat.h"

#include <vtkNew.h>

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class StrokeLayer
 * @brief The two pictures that strokes are drawn with: the depth of what is drawn so far, and the
 * ink.
 *
 * The ink has one channel where all strokes have one colour, and the most of it stays. Where they
 * have several it has four, and a depth, so that the colour of the most stays.
 */
class StrokeLayer
{
public:
  StrokeLayer();
  ~StrokeLayer();

  /// Takes the depth of the bound draw framebuffer: its texture, if that is as large as the
  /// viewport, or a copy of what is within bounds in the viewport (resolving samples). Changes the
  /// bindings of framebuffers. False if that framebuffer has no depth.
  bool CaptureDepth(
    vtkOpenGLRenderWindow* window, const int viewport[4], const std::array<int, 4>& bounds);

  /// Binds the ink as the framebuffer to draw into, as large as the viewport, empty where the
  /// scissor lets it be.
  void BindInk(vtkOpenGLRenderWindow* window, int width, int height, bool colored);

  vtkTextureObject* GetDepth() { return this->IsCopied ? this->Depth : this->FoundDepth; }
  vtkTextureObject* GetInk() { return this->Ink; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool FindDepth(vtkOpenGLRenderWindow* window, unsigned int framebuffer, const int viewport[4]);

  bool IsCopied = true;
  vtkNew<vtkTextureObject> FoundDepth;
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkOpenGLFramebufferObject> DepthFramebuffer;
  unsigned int DepthFormat = 0;
  vtkNew<vtkTextureObject> Ink;
  vtkNew<vtkTextureObject> InkDepth;
  vtkNew<vtkOpenGLFramebufferObject> InkFramebuffer;
  bool InkColored = false;
};
}

#endif
