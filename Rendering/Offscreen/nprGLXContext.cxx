// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprGLContext.h"

#include <cstdlib>

#ifdef NPR_OFFSCREEN_GLX
#include <GL/glx.h>
#include <X11/Xlib.h>
#endif

namespace npr
{

#ifdef NPR_OFFSCREEN_GLX

bool HasXDisplay(std::string& reason)
{
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    reason = "the environment variable DISPLAY is not set";
    return false;
  }
  // The variable alone is no evidence: it often outlives the server it names.
  Display* display = XOpenDisplay(nullptr);
  if (!display)
  {
    reason = std::string("no X server answers at DISPLAY=") + name;
    return false;
  }
  int errorBase = 0;
  int eventBase = 0;
  const bool speaksGLX = glXQueryExtension(display, &errorBase, &eventBase);
  XCloseDisplay(display);
  reason = std::string("the X server at DISPLAY=") + name +
    (speaksGLX ? " answers" : " has no GLX extension");
  return speaksGLX;
}

std::function<void()> CaptureGLX()
{
  GLXContext context = glXGetCurrentContext();
  if (!context)
  {
    return {};
  }
  return [context, display = glXGetCurrentDisplay(), draw = glXGetCurrentDrawable(),
           read = glXGetCurrentReadDrawable()]
  {
    ReleaseCurrentContext();
    glXMakeContextCurrent(display, draw, read, context);
  };
}

void ReleaseGLX()
{
  if (glXGetCurrentContext())
  {
    glXMakeContextCurrent(glXGetCurrentDisplay(), 0, 0, nullptr);
  }
}

#else

bool HasXDisplay(std::string& reason)
{
  reason = "vtkNPR was built without X11 and GLX";
  return false;
}

std::function<void()> CaptureGLX()
{
  return {};
}

void ReleaseGLX() {}

#endif

} // namespace npr
