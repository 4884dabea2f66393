// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPREGLRenderWindow
 * @brief A render window that draws through EGL, on a GPU where there is one.
 *
 * The first EGL device that is no software renderer is taken; without one, Mesa's surfaceless
 * platform, which draws in software (llvmpipe).
 *
 * @sa vtkNPROffscreen vtkNPROffscreenRenderWindow
 */
#ifndef vtkNPREGLRenderWindow_h
#define vtkNPREGLRenderWindow_h

#include "vtkNPROffscreenRenderWindow.h"
#include "vtkNPRRenderingOffscreenModule.h" // for the export macro

class VTKNPRRENDERINGOFFSCREEN_EXPORT vtkNPREGLRenderWindow : public vtkNPROffscreenRenderWindow
{
public:
  static vtkNPREGLRenderWindow* New();
  vtkTypeMacro(vtkNPREGLRenderWindow, vtkNPROffscreenRenderWindow);

protected:
  vtkNPREGLRenderWindow() = default;
  ~vtkNPREGLRenderWindow() override = default;

#ifndef __VTK_WRAP__
  std::shared_ptr<npr::GLContext> NewContext(std::string& reason) override;
#endif

private:
  vtkNPREGLRenderWindow(const vtkNPREGLRenderWindow&) = delete;
  void operator=(const vtkNPREGLRenderWindow&) = delete;
};

#endif
