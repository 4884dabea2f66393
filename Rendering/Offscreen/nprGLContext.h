// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprGLContext.h
 * @brief OpenGL contexts without a window, and how to switch between them.
 *
 * A context here has no surface to draw on: VTK draws to framebuffer objects of its own. Three
 * interfaces may own the current context of a thread: EGL, OSMesa, and GLX (VTK's X11 window). The
 * libraries of EGL and GLX refuse to make a context current while another interface holds one, so
 * who takes over releases the others first; the functions below do that for all three.
 *
 * Private to this module, and free of VTK.
 */
#ifndef nprGLContext_h
#define nprGLContext_h

#include <functional>
#include <memory>
#include <string>

namespace npr
{

/** What the driver says about itself; empty strings when it says nothing. */
struct GLDescription
{
  std::string Vendor;
  std::string Renderer;
  std::string Version;
};

/** One OpenGL context (core profile, 3.2 or later); destroying it releases it first. */
class GLContext : public std::enable_shared_from_this<GLContext>
{
public:
  GLContext() = default;
  GLContext(const GLContext&) = delete;
  GLContext& operator=(const GLContext&) = delete;
  virtual ~GLContext() = default;

  /** Makes the context current in this thread, and releases whatever was; false if that failed. */
  virtual bool MakeCurrent() = 0;
  virtual bool IsCurrent() const = 0;

  /** Asks the driver; the context must be current. */
  GLDescription Describe() const;

protected:
  virtual void* GetProcAddress(const char* name) const = 0;
};

/** Creates an OSMesa context; null, and @a reason, if there can be none. */
std::shared_ptr<GLContext> NewOSMesaContext(std::string& reason);

/** Which EGL display to draw with. */
enum class EGLKind
{
  GPU,     // the first device that is not a software renderer
  Software // Mesa's surfaceless platform
};
/** Creates an EGL context; null, and @a reason, if there can be none. */
std::shared_ptr<GLContext> NewEGLContext(EGLKind kind, std::string& reason);

/** Whether an X display answers and speaks GLX; @a reason says why not, or which display does. */
bool HasXDisplay(std::string& reason);

/**
 * Remembers which context is current in this thread. Calling the result makes it current again; if
 * it has been destroyed meanwhile, or if there was none, nothing is current afterwards.
 */
std::function<void()> CaptureCurrentContext();

/** Leaves this thread without a current context. */
void ReleaseCurrentContext();

/** One interface's part of the two functions above; an empty function means: not the owner. */
std::function<void()> CaptureOSMesa();
std::function<void()> CaptureEGL();
std::function<void()> CaptureGLX();
void ReleaseOSMesa();
void ReleaseEGL();
void ReleaseGLX();

} // namespace npr
#endif
