// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprGLContext.h"

#ifdef NPR_OFFSCREEN_OSMESA
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>
#include <atomic>
#endif

namespace npr
{

#ifdef NPR_OFFSCREEN_OSMESA

namespace
{

// VTK and GLEW call OpenGL through libglvnd, whose libGLdispatch sends each call to the table that
// is current in the thread. OSMesa knows nothing of libglvnd, so we do for it what libEGL and
// libGLX do for their drivers. libGLdispatch has no public header; these are the parts of its ABI
// (version 1) that are needed, as its sources document them.
// Source: https://gitlab.freedesktop.org/glvnd/libglvnd, src/GLdispatch/GLdispatch.h
constexpr int DispatchABI = 1;
struct DispatchTable;
struct DispatchThreadState
{
  int Tag;                                       // which interface owns the state
  void (*ThreadDestroyed)(DispatchThreadState*); // may be null
  void* Private;                                 // libGLdispatch's own
};
// 0 is GLX (GLEW would then call glXQueryVersion without a display, and crash) and 1 is EGL.
constexpr int OSMesaTag = 0x4f53;

// VTK draws to its own framebuffers; OSMesa asks for a buffer all the same.
constexpr int BufferSize = 16;

/** A function of a library that is loaded at run time. */
template<typename Signature>
void LoadSymbol(void* library, const char* name, Signature*& function, std::string& error)
{
  function = reinterpret_cast<Signature*>(dlsym(library, name));
  if (!function && error.empty())
  {
    error = std::string("the function ") + name + " is missing in the installed library";
  }
}

/** The functions of libOSMesa and libGLdispatch, loaded once; Error says what is missing. */
struct Libraries
{
  decltype(OSMesaCreateContextAttribs)* CreateContextAttribs = nullptr;
  decltype(OSMesaDestroyContext)* DestroyContext = nullptr;
  decltype(OSMesaMakeCurrent)* MesaMakeCurrent = nullptr;
  decltype(OSMesaGetProcAddress)* GetProcAddress = nullptr;

  int (*DispatchGetABIVersion)() = nullptr;
  void (*DispatchInit)() = nullptr;
  int (*DispatchNewVendorID)() = nullptr;
  DispatchTable* (*DispatchCreateTable)(void* (*)(const char*, void*), void*) = nullptr;
  unsigned char (*DispatchMakeCurrent)(
    DispatchThreadState*, DispatchTable*, int, const void*) = nullptr;
  void (*DispatchLoseCurrent)() = nullptr;
  DispatchThreadState* (*DispatchGetThreadState)() = nullptr;

  DispatchTable* Table = nullptr;
  int Vendor = 0;
  std::string Error;

  static const Libraries& Get()
  {
    static const Libraries libraries;
    return libraries;
  }

private:
  Libraries()
  {
    // RTLD_LOCAL keeps OSMesa's own gl functions out of everybody's way.
    void* osmesa = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (!osmesa)
    {
      this->Error = "libOSMesa.so.8 can not be loaded (Debian package libosmesa6; Mesa 25.1 and "
                    "later have none)";
      return;
    }
    void* dispatch = dlopen("libGLdispatch.so.0", RTLD_NOW | RTLD_LOCAL);
    if (!dispatch)
    {
      this->Error = "libGLdispatch.so.0 can not be loaded (Debian package libglvnd0)";
      return;
    }
    LoadSymbol(osmesa, "OSMesaCreateContextAttribs", this->CreateContextAttribs, this->Error);
    LoadSymbol(osmesa, "OSMesaDestroyContext", this->DestroyContext, this->Error);
    LoadSymbol(osmesa, "OSMesaMakeCurrent", this->MesaMakeCurrent, this->Error);
    LoadSymbol(osmesa, "OSMesaGetProcAddress", this->GetProcAddress, this->Error);
    LoadSymbol(dispatch, "__glDispatchGetABIVersion", this->DispatchGetABIVersion, this->Error);
    LoadSymbol(dispatch, "__glDispatchInit", this->DispatchInit, this->Error);
    LoadSymbol(dispatch, "__glDispatchNewVendorID", this->DispatchNewVendorID, this->Error);
    LoadSymbol(dispatch, "__glDispatchCreateTable", this->DispatchCreateTable, this->Error);
    LoadSymbol(dispatch, "__glDispatchMakeCurrent", this->DispatchMakeCurrent, this->Error);
    LoadSymbol(dispatch, "__glDispatchLoseCurrent", this->DispatchLoseCurrent, this->Error);
    LoadSymbol(
      dispatch, "__glDispatchGetCurrentThreadState", this->DispatchGetThreadState, this->Error);
    if (!this->Error.empty())
    {
      return;
    }
    if (this->DispatchGetABIVersion() != DispatchABI)
    {
      this->Error = "libGLdispatch has another ABI than OSMesa's routing was written for";
      return;
    }
    this->DispatchInit();
    this->Vendor = this->DispatchNewVendorID();
    const auto getProcAddress = [](const char* name, void* get) {
      return reinterpret_cast<void*>(reinterpret_cast<decltype(OSMesaGetProcAddress)*>(get)(name));
    };
    this->Table =
      this->DispatchCreateTable(getProcAddress, reinterpret_cast<void*>(this->GetProcAddress));
  }
};

// Until there is an OSMesa context its library need not be loaded to know that none is current.
std::atomic<bool> AnyContext{ false };

class OSMesaContextHolder : public GLContext
{
public:
  explicit OSMesaContextHolder(OSMesaContext context) : Context(context) {}

  ~OSMesaContextHolder() override
  {
    if (this->IsCurrent())
    {
      ReleaseOSMesa();
    }
    Libraries::Get().DestroyContext(this->Context);
  }

  bool MakeCurrent() override
  {
    const Libraries& libraries = Libraries::Get();
    ReleaseCurrentContext();
    if (!libraries.MesaMakeCurrent(
          this->Context, this->Buffer.data(), OSMesaUnsignedByte, BufferSize, BufferSize))
    {
      return false;
    }
    if (!libraries.DispatchMakeCurrent(&this->State, libraries.Table, libraries.Vendor, nullptr))
    {
      libraries.MesaMakeCurrent(nullptr, nullptr, OSMesaUnsignedByte, 0, 0);
      return false;
    }
    return true;
  }

  bool IsCurrent() const override { return Current() == this; }

  /** The context of this kind that is current in this thread, or null. */
  static OSMesaContextHolder* Current()
  {
    DispatchThreadState* state = AnyContext ? Libraries::Get().DispatchGetThreadState() : nullptr;
    return state && state->Tag == OSMesaTag ? static_cast<OwnedState*>(state)->Owner : nullptr;
  }

protected:
  void* GetProcAddress(const char* name) const override
  {
    return reinterpret_cast<void*>(Libraries::Get().GetProcAddress(name));
  }

private:
  static constexpr unsigned int OSMesaUnsignedByte = 0x1401; // GL_UNSIGNED_BYTE

  struct OwnedState : DispatchThreadState
  {
    OSMesaContextHolder* Owner;
  };

  OSMesaContext Context;
  OwnedState State{ { OSMesaTag, nullptr, nullptr }, this };
  std::array<unsigned char, 4 * BufferSize * BufferSize> Buffer{};
};

} // namespace

std::shared_ptr<GLContext> NewOSMesaContext(std::string& reason)
{
  const Libraries& libraries = Libraries::Get();
  if (!libraries.Error.empty())
  {
    reason = libraries.Error;
    return nullptr;
  }
  const int attributes[] = { OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE,
    OSMESA_CORE_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 2, 0 };
  OSMesaContext context = libraries.CreateContextAttribs(attributes, nullptr);
  if (!context)
  {
    reason = "OSMesa offers no core profile of OpenGL 3.2 or later";
    return nullptr;
  }
  AnyContext = true;
  return std::make_shared<OSMesaContextHolder>(context);
}

std::function<void()> CaptureOSMesa()
{
  OSMesaContextHolder* current = OSMesaContextHolder::Current();
  if (!current)
  {
    return {};
  }
  return [captured = current->weak_from_this()]
  {
    const auto context = captured.lock();
    if (!context || !context->MakeCurrent())
    {
      ReleaseCurrentContext();
    }
  };
}

void ReleaseOSMesa()
{
  if (OSMesaContextHolder::Current())
  {
    const Libraries& libraries = Libraries::Get();
    libraries.MesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    libraries.DispatchLoseCurrent();
  }
}

#else

std::shared_ptr<GLContext> NewOSMesaContext(std::string& reason)
{
  reason = "vtkNPR was built without OSMesa (Debian package libosmesa6-dev)";
  return nullptr;
}

std::function<void()> CaptureOSMesa()
{
  return {};
}

void ReleaseOSMesa() {}

#endif

} // namespace npr
