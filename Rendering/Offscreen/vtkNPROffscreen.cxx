// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPROffscreen.h"

#include "nprGLContext.h"
#include "nprVTKCompat.h"

#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkVersion.h>
#include <vtksys/SystemTools.hxx>

#if !NPR_VTK_AT_LEAST(9, 4)
#include "vtkNPREGLRenderWindow.h"
#include "vtkNPROSMesaRenderWindow.h"
#endif

#include <array>

namespace
{

constexpr const char* Environment = "NPR_OFFSCREEN";

/** A way to a picture. */
struct Way
{
  const char* Name; ///< begins with the backend's
  int Backend;
  /** Tries it; in words what was found, or why it does not work. */
  bool (*Works)(std::string& reason);
};

/** Creates a context and asks its driver who it is; a context that can do that can draw. */
bool Try(const std::shared_ptr<npr::GLContext>& context, std::string& reason)
{
  if (!context)
  {
    return false;
  }
  const auto restore = npr::CaptureCurrentContext();
  const bool works = context->MakeCurrent();
  const npr::GLDescription found = works ? context->Describe() : npr::GLDescription();
  restore();
  reason = works ? found.Renderer + ", OpenGL " + found.Version
                 : "the driver refused to make a context current";
  return works;
}

// The order is that of AUTO; the class's comment says why.
const std::array<Way, 4> Ways = { {
  { "native", vtkNPROffscreen::NATIVE, npr::HasXDisplay },
  { "egl (GPU)", vtkNPROffscreen::EGL,
    [](std::string& reason)
    { return Try(npr::NewEGLContext(npr::EGLKind::GPU, reason), reason); } },
  { "osmesa", vtkNPROffscreen::OSMESA,
    [](std::string& reason) { return Try(npr::NewOSMesaContext(reason), reason); } },
  { "egl (software)", vtkNPROffscreen::EGL,
    [](std::string& reason)
    { return Try(npr::NewEGLContext(npr::EGLKind::Software, reason), reason); } },
} };

/** What Setup() left behind. */
struct State
{
  int Asked = vtkNPROffscreen::AUTO;
  std::string AskedBy; // in words, for the report
  int Taken = -1;      // an index of Ways
  std::string Error;
};
State& GetState()
{
  static State state;
  return state;
}

const char* BackendName(int backend)
{
  static const std::array<const char*, 4> names = { { "auto", "native", "egl", "osmesa" } };
  return backend >= 0 && backend < static_cast<int>(names.size())
    ? names[static_cast<std::size_t>(backend)]
    : nullptr;
}

std::string KnownBackends()
{
  std::string names;
  for (int backend = 0; BackendName(backend); ++backend)
  {
    names += (names.empty() ? "" : ", ") + std::string(BackendName(backend));
  }
  return names;
}

int ParseBackend(const std::string& name)
{
  const std::string lower = vtksys::SystemTools::LowerCase(name);
  for (int backend = 0; BackendName(backend); ++backend)
  {
    if (lower == BackendName(backend))
    {
      return backend;
    }
  }
  return -1;
}

bool Fail(const std::string& message)
{
  GetState().Error = message;
  vtkErrorWithObjectMacro(nullptr, << message);
  return false;
}

/** Our entries in VTK's list of object factories. All are disabled until Setup() chooses. */
class vtkNPROffscreenFactory : public vtkObjectFactory
{
public:
  static vtkNPROffscreenFactory* New();
  vtkTypeMacro(vtkNPROffscreenFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "vtkNPR render windows without a display"; }

private:
  vtkNPROffscreenFactory();
};
vtkStandardNewMacro(vtkNPROffscreenFactory);

VTK_CREATE_CREATE_FUNCTION(vtkGenericRenderWindowInteractor)
#if !NPR_VTK_AT_LEAST(9, 4)
VTK_CREATE_CREATE_FUNCTION(vtkNPREGLRenderWindow)
VTK_CREATE_CREATE_FUNCTION(vtkNPROSMesaRenderWindow)
#endif

vtkNPROffscreenFactory::vtkNPROffscreenFactory()
{
  this->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
    "needs no display", 0, vtkObjectFactoryCreatevtkGenericRenderWindowInteractor);
#if !NPR_VTK_AT_LEAST(9, 4)
  this->RegisterOverride("vtkRenderWindow", "vtkNPREGLRenderWindow", "EGL", 0,
    vtkObjectFactoryCreatevtkNPREGLRenderWindow);
  this->RegisterOverride("vtkRenderWindow", "vtkNPROSMesaRenderWindow", "OSMesa", 0,
    vtkObjectFactoryCreatevtkNPROSMesaRenderWindow);
#endif
}

/** Lets only @a ours answer for @a base, or everybody but us if @a ours is null. */
void Override(const char* base, const char* ours, vtkObjectFactory* factory)
{
  // Factories are asked in the order of their registration, and VTK's X11 entry comes before ours.
  vtkObjectFactory::SetAllEnableFlags(ours ? 0 : 1, base);
  factory->Disable(base);
  if (ours)
  {
    factory->SetEnableFlag(1, base, ours);
  }
}

void TakeBackend(int backend)
{
  static vtkSmartPointer<vtkNPROffscreenFactory> factory;
  if (!factory)
  {
    factory = vtkSmartPointer<vtkNPROffscreenFactory>::New();
    vtkObjectFactory::RegisterFactory(factory);
  }
  const bool native = backend == vtkNPROffscreen::NATIVE;
  Override(
    "vtkRenderWindowInteractor", native ? nullptr : "vtkGenericRenderWindowInteractor", factory);
#if NPR_VTK_AT_LEAST(9, 4)
  // VTK has the classes itself and reads this variable whenever a window is made.
  vtksys::SystemTools::PutEnv(std::string("VTK_DEFAULT_OPENGL_WINDOW=") +
    (native                               ? "vtkXOpenGLRenderWindow"
        : backend == vtkNPROffscreen::EGL ? "vtkEGLRenderWindow"
                                          : "vtkOSOpenGLRenderWindow"));
#else
  Override("vtkRenderWindow",
    native                              ? nullptr
      : backend == vtkNPROffscreen::EGL ? "vtkNPREGLRenderWindow"
                                        : "vtkNPROSMesaRenderWindow",
    factory);
  // An X11 window can not take over a thread where one of our contexts is current.
  npr::ReleaseCurrentContext();
#endif
}

/** A line of vtkOpenGLRenderWindow::ReportCapabilities, which knows each version's GL loader. */
std::string Capability(vtkRenderWindow* window, const std::string& label)
{
  auto* openGLWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!openGLWindow)
  {
    vtkErrorWithObjectMacro(
      window, << "No OpenGL render window was given: there is no driver to ask.");
    return {};
  }
  openGLWindow->Initialize();
  openGLWindow->MakeCurrent();
  if (!openGLWindow->IsCurrent())
  {
    return {}; // the window has said why
  }
  const std::string report = openGLWindow->ReportCapabilities();
  const std::size_t begin = report.find(label);
  if (begin == std::string::npos)
  {
    return {};
  }
  const std::size_t end = report.find('\n', begin);
  const std::string line = report.substr(begin + label.size(), end - begin - label.size());
  const std::size_t first = line.find_first_not_of(' ');
  return first == std::string::npos ? std::string() : line.substr(first);
}

bool IsWay(int index)
{
  return index >= 0 && index < static_cast<int>(Ways.size());
}

} // namespace

vtkStandardNewMacro(vtkNPROffscreen);

//------------------------------------------------------------------------------
bool vtkNPROffscreen::Setup(const char* name)
{
  const int backend = ParseBackend(name ? name : "");
  if (backend < 0)
  {
    return Fail(std::string("Unknown backend '") + (name ? name : "") + "'. Choose one of " +
      KnownBackends() + ".");
  }
  return Setup(backend);
}

//------------------------------------------------------------------------------
bool vtkNPROffscreen::Setup(int backend)
{
  if (!BackendName(backend))
  {
    return Fail("Unknown backend " + std::to_string(backend) +
      ". Choose one of AUTO, NATIVE, EGL, OSMESA of vtkNPROffscreen.");
  }
  std::string askedBy = "Setup asked for ";
  std::string value;
  if (backend == AUTO && vtksys::SystemTools::GetEnv(Environment, value) && !value.empty())
  {
    backend = ParseBackend(value);
    if (backend < 0)
    {
      return Fail(std::string("The environment variable ") + Environment +
        " has the unknown value '" + value + "'. Set it to one of " + KnownBackends() +
        ", or unset it.");
    }
    askedBy = std::string("the environment variable ") + Environment + " asks for ";
  }
  askedBy += BackendName(backend);

  std::string reasons;
  for (std::size_t i = 0; i < Ways.size(); ++i)
  {
    if (backend != AUTO && Ways[i].Backend != backend)
    {
      continue;
    }
    std::string reason;
    if (Ways[i].Works(reason))
    {
      TakeBackend(Ways[i].Backend);
      GetState() = { backend, askedBy, static_cast<int>(i), {} };
      return true;
    }
    reasons += std::string("\n  ") + Ways[i].Name + ": " + reason;
  }
  return Fail("Nothing can be drawn here, though " + askedBy + ":" + reasons);
}

//------------------------------------------------------------------------------
int vtkNPROffscreen::GetBackend()
{
  const int taken = GetState().Taken;
  return taken < 0 ? AUTO : Ways[static_cast<std::size_t>(taken)].Backend;
}

//------------------------------------------------------------------------------
std::string vtkNPROffscreen::GetWindowClassName()
{
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  return window ? window->GetClassName() : "";
}

//------------------------------------------------------------------------------
std::string vtkNPROffscreen::GetErrorMessage()
{
  return GetState().Error;
}

//------------------------------------------------------------------------------
int vtkNPROffscreen::GetNumberOfBackends()
{
  return static_cast<int>(Ways.size());
}

//------------------------------------------------------------------------------
const char* vtkNPROffscreen::GetBackendName(int index)
{
  return IsWay(index) ? Ways[static_cast<std::size_t>(index)].Name : nullptr;
}

//------------------------------------------------------------------------------
bool vtkNPROffscreen::GetBackendTaken(int index)
{
  return IsWay(index) && GetState().Taken == index;
}

//------------------------------------------------------------------------------
std::string vtkNPROffscreen::GetBackendReason(int index)
{
  if (!IsWay(index))
  {
    return {};
  }
  const Way& way = Ways[static_cast<std::size_t>(index)];
  const State& state = GetState();
  std::string found;
  const bool works = way.Works(found);
  if (index == state.Taken)
  {
    return state.AskedBy + "; " + found;
  }
  if (!works)
  {
    return "does not work here: " + found;
  }
  if (state.Taken < 0)
  {
    return "would work: " + found + "; Setup has not been called";
  }
  const bool asked = state.Asked == AUTO || state.Asked == way.Backend;
  return "would work: " + found + "; " +
    (asked ? std::string(GetBackendName(state.Taken)) + " comes first" : state.AskedBy);
}

//------------------------------------------------------------------------------
std::vector<vtkNPROffscreen::BackendReport> vtkNPROffscreen::GetBackendReport()
{
  std::vector<BackendReport> report;
  for (int i = 0; i < GetNumberOfBackends(); ++i)
  {
    report.push_back({ GetBackendName(i), GetBackendTaken(i), GetBackendReason(i) });
  }
  return report;
}

//------------------------------------------------------------------------------
std::string vtkNPROffscreen::GetGLVendor(vtkRenderWindow* window)
{
  return Capability(window, "OpenGL vendor string:");
}

//------------------------------------------------------------------------------
std::string vtkNPROffscreen::GetGLRenderer(vtkRenderWindow* window)
{
  return Capability(window, "OpenGL renderer string:");
}

//------------------------------------------------------------------------------
std::string vtkNPROffscreen::GetGLVersion(vtkRenderWindow* window)
{
  return Capability(window, "OpenGL version string:");
}

//------------------------------------------------------------------------------
void vtkNPROffscreen::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Backend: " << BackendName(GetBackend()) << "\n";
}
