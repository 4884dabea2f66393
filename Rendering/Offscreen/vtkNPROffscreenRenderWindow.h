// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPROffscreenRenderWindow
 * @brief What render windows without a display have in common.
 *
 * The window owns an OpenGL context that has no surface; VTK draws to its own framebuffers, from
 * which vtkWindowToImageFilter and the Get*PixelData methods read as usual. The context is created
 * when it is first needed. Multisampling is off (SetMultiSamples(0)), because its result differs
 * between drivers; everything else behaves as in vtkRenderWindow. Any number of windows may live at
 * once, of different backends, too; each must be used from one thread at a time.
 *
 * Windows of VTK's X11 class can not draw in turn with these: see vtkNPROffscreen::Setup.
 *
 * Built for VTK before 9.4 only. From 9.4 on VTK has such windows itself.
 *
 * @sa vtkNPROffscreen vtkNPREGLRenderWindow vtkNPROSMesaRenderWindow
 */
#ifndef vtkNPROffscreenRenderWindow_h
#define vtkNPROffscreenRenderWindow_h

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkNPRRenderingOffscreenModule.h" // for the export macro

#include <memory> // for std::unique_ptr, std::shared_ptr
#include <string> // for std::string

namespace npr
{
class GLContext;
}

class VTKNPRRENDERINGOFFSCREEN_EXPORT vtkNPROffscreenRenderWindow
  : public vtkGenericOpenGLRenderWindow
{
public:
  vtkTypeMacro(vtkNPROffscreenRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Creates the context and brings OpenGL into VTK's state; done by the first Render(), too. */
  void Initialize() override;

  /** Frees what was drawn with and the context; a later Render() starts anew. */
  void Finalize() override;

  /** Makes this window's context current in the calling thread; an error if there can be none. */
  void MakeCurrent() override;
  bool IsCurrent() override;

  ///@{
  /** Makes the context current, and gives the thread back to whichever was current before. */
  void PushContext() override;
  void PopContext() override;
  ///@}

  /** 1 if the backend gives a context of OpenGL 3.2 or later, else 0. */
  int SupportsOpenGL() override;

  void OpenGLInit() override;
  void OpenGLInitContext() override;

protected:
  vtkNPROffscreenRenderWindow();
  ~vtkNPROffscreenRenderWindow() override;

#ifndef __VTK_WRAP__
  /** Creates the backend's context, or null and the reason. */
  virtual std::shared_ptr<npr::GLContext> NewContext(std::string& reason) = 0;
#endif

private:
  vtkNPROffscreenRenderWindow(const vtkNPROffscreenRenderWindow&) = delete;
  void operator=(const vtkNPROffscreenRenderWindow&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
