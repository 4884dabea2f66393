// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprEdgeBuffers_h
#define nprEdgeBuffers_h

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkTextureObject.h>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace npr
{
/**
 * @class EdgeBuffers
 * @brief The images between a scene and its edges.
 *
 * What surfaces are seen at each pixel is written while the scene is drawn, as a second colour of
 * whichever framebuffer it is drawn to.
 */
class EdgeBuffers
{
public:
  /// Makes the images of a viewport (x, y, width, height) and has what is drawn from now on write
  /// its second colour. False where the framebuffer has no place for one.
  bool BeginSurfaces(vtkOpenGLRenderWindow* window, const int viewport[4]);

  /// What has no second colour must not be drawn while it is on.
  void EnableSurfaces(bool enabled);

  /// The framebuffer as it was before.
  void EndSurfaces();

  /// @name Edges and the lines through them
  /// Pixels of a block's side, as in the shaders.
  static constexpr int BlockSize = 8;

  /// Binds a framebuffer for them; the caller restores the bindings.
  ///@{
  void BindEdges();
  void BindLinked();
  void BindLines();
  void BindBlocks();
  ///@}

  vtkTextureObject* GetSurfaces() { return this->Surfaces; }
  vtkTextureObject* GetEdges() { return this->Edges; }
  vtkTextureObject* GetLinked() { return this->Linked; }
  vtkTextureObject* GetLines() { return this->Lines; }
  vtkTextureObject* GetBlocks() { return this->Blocks; }

  /// Of the surfaces; 0 without multisampling.
  int GetSamples() const { return this->Samples; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Allocate(vtkOpenGLRenderWindow* window, const int viewport[4], int samples);

  vtkNew<vtkTextureObject> Surfaces; // covers the framebuffer up to the viewport's upper right
  vtkNew<vtkTextureObject> Edges;    // these cover the viewport
  vtkNew<vtkTextureObject> Linked;
  vtkNew<vtkTextureObject> Lines;
  vtkNew<vtkTextureObject> Blocks; // this a texel for each block of them
  vtkNew<vtkOpenGLFramebufferObject> EdgeFramebuffer;
  vtkNew<vtkOpenGLFramebufferObject> LinkedFramebuffer;
  vtkNew<vtkOpenGLFramebufferObject> LineFramebuffer;
  vtkNew<vtkOpenGLFramebufferObject> BlockFramebuffer;
  int Viewport[4] = { 0, 0, 0, 0 };
  int Samples = -1;
  unsigned int FirstBuffer = 0;
};
}

#endif
