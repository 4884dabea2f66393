// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprGLContext.h"

#ifdef NPR_OFFSCREEN_EGL
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <sstream>
#include <vector>
#endif

namespace npr
{

#ifdef NPR_OFFSCREEN_EGL

namespace
{

/** Whether @a name is one of the blank-separated words of @a extensions (which may be null). */
bool HasWord(const char* extensions, const std::string& name)
{
  std::istringstream words(extensions ? extensions : "");
  for (std::string word; words >> word;)
  {
    if (word == name)
    {
      return true;
    }
  }
  return false;
}

template<typename Function>
Function Load(const char* name)
{
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

std::string ErrorCode()
{
  std::ostringstream text;
  text << " (EGL error 0x" << std::hex << eglGetError() << ")";
  return text.str();
}

class EGLContextHolder : public GLContext
{
public:
  EGLContextHolder(EGLDisplay display, EGLContext context) : Display(display), Context(context) {}

  ~EGLContextHolder() override
  {
    if (this->IsCurrent())
    {
      ReleaseEGL();
    }
    eglDestroyContext(this->Display, this->Context);
  }

  bool MakeCurrent() override
  {
    ReleaseOSMesa();
    ReleaseGLX();
    eglBindAPI(EGL_OPENGL_API);
    return eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, this->Context) == EGL_TRUE;
  }

  bool IsCurrent() const override { return eglGetCurrentContext() == this->Context; }

protected:
  void* GetProcAddress(const char* name) const override
  {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
  }

private:
  EGLDisplay Display;
  EGLContext Context;
};

/** Initializes the display if need be and creates a context on it. */
std::shared_ptr<GLContext> NewContextOn(EGLDisplay display, std::string& reason)
{
  // A display that is initialized already answers true again. It is never terminated: that would
  // end every other window's context, too.
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
  {
    reason = "the EGL display can not be initialized" + ErrorCode();
    return nullptr;
  }
  const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
  for (const char* needed :
    { "EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context", "EGL_KHR_create_context" })
  {
    if (!HasWord(extensions, needed))
    {
      reason = std::string("the EGL display lacks ") + needed;
      return nullptr;
    }
  }
  const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION_KHR, 3, EGL_CONTEXT_MINOR_VERSION_KHR, 2,
    EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR, EGL_NONE };
  eglBindAPI(EGL_OPENGL_API);
  EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT)
  {
    reason = "no core profile of OpenGL 3.2 or later" + ErrorCode();
    return nullptr;
  }
  return std::make_shared<EGLContextHolder>(display, context);
}

/** Whether the driver behind a new context computes on the CPU. */
bool IsSoftware(GLContext& context)
{
  const auto restore = CaptureCurrentContext();
  const std::string renderer = context.MakeCurrent() ? context.Describe().Renderer : "llvmpipe";
  restore();
  for (const char* software : { "llvmpipe", "softpipe", "swrast", "Software Rasterizer" })
  {
    if (renderer.find(software) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

/** The first device that computes on a GPU, or no display and the reason. */
EGLDisplay FindGPU(const char* extensions, std::string& reason)
{
  const auto getDisplay = Load<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  const auto queryDevices = Load<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto queryString = Load<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  if (!HasWord(extensions, "EGL_EXT_platform_device") || !getDisplay || !queryDevices ||
    !queryString)
  {
    reason = "EGL can not enumerate devices (EGL_EXT_platform_device is missing)";
    return EGL_NO_DISPLAY;
  }
  EGLint count = 0;
  queryDevices(0, nullptr, &count);
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  queryDevices(count, devices.data(), &count);
  reason = "EGL knows no GPU among its " + std::to_string(count) + " device(s)";
  for (EGLDeviceEXT device : devices)
  {
    if (HasWord(queryString(device, EGL_EXTENSIONS), "EGL_MESA_device_software"))
    {
      continue;
    }
    EGLDisplay display = getDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    std::string why;
    const auto context = NewContextOn(display, why);
    if (context && !IsSoftware(*context))
    {
      return display;
    }
    reason = "an EGL device was found, but " + (context ? "it renders in software" : why);
  }
  return EGL_NO_DISPLAY;
}

/** Mesa's platform that needs neither a display server nor a device. */
EGLDisplay FindSurfaceless(const char* extensions, std::string& reason)
{
  const auto getDisplay = Load<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (!HasWord(extensions, "EGL_MESA_platform_surfaceless") || !getDisplay)
  {
    reason = "EGL lacks Mesa's surfaceless platform (Debian package libegl-mesa0)";
    return EGL_NO_DISPLAY;
  }
  return getDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

struct FoundDisplay
{
  EGLDisplay Display = EGL_NO_DISPLAY;
  std::string Reason;
};

FoundDisplay Find(EGLKind kind)
{
  FoundDisplay found;
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  found.Display = kind == EGLKind::GPU ? FindGPU(extensions, found.Reason)
                                       : FindSurfaceless(extensions, found.Reason);
  return found;
}

} // namespace

std::shared_ptr<GLContext> NewEGLContext(EGLKind kind, std::string& reason)
{
  // Looking for a GPU creates a context; the machine's devices are looked at once.
  static const FoundDisplay gpu = Find(EGLKind::GPU);
  static const FoundDisplay software = Find(EGLKind::Software);
  const FoundDisplay& found = kind == EGLKind::GPU ? gpu : software;
  if (found.Display == EGL_NO_DISPLAY)
  {
    reason = found.Reason;
    return nullptr;
  }
  return NewContextOn(found.Display, reason);
}

std::function<void()> CaptureEGL()
{
  EGLContext context = eglGetCurrentContext();
  if (context == EGL_NO_CONTEXT)
  {
    return {};
  }
  return [context, api = eglQueryAPI(), display = eglGetCurrentDisplay(),
           draw = eglGetCurrentSurface(EGL_DRAW), read = eglGetCurrentSurface(EGL_READ)]
  {
    ReleaseCurrentContext();
    eglBindAPI(api);
    eglMakeCurrent(display, draw, read, context);
  };
}

void ReleaseEGL()
{
  if (eglGetCurrentContext() != EGL_NO_CONTEXT)
  {
    eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
}

#else

std::shared_ptr<GLContext> NewEGLContext(EGLKind, std::string& reason)
{
  reason = "vtkNPR was built without EGL (Debian package libegl-dev)";
  return nullptr;
}

std::function<void()> CaptureEGL()
{
  return {};
}

void ReleaseEGL() {}

#endif

} // namespace npr
