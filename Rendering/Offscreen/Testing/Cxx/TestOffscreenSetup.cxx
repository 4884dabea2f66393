// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Which backend is taken, who decides, what is reported, and which interactor stands in.
#include "nprOffscreenTesting.h"

#include <vtkGenericRenderWindowInteractor.h>
#include <vtkObject.h>
#include <vtkRenderWindowInteractor.h>
#include <vtksys/SystemTools.hxx>

#include <cstdlib>

using namespace npr::testing;

namespace
{

bool Contains(const std::string& text, const std::string& part)
{
  return Check(text.find(part) != std::string::npos, "'" + part + "' stands in: " + text);
}

/** Setup() that must fail and say why; its error is expected, so it is not shown. */
template<typename Argument>
bool Refuses(Argument argument, const std::string& message)
{
  const int before = vtkNPROffscreen::GetBackend();
  vtkObject::GlobalWarningDisplayOff();
  const bool done = vtkNPROffscreen::Setup(argument);
  vtkObject::GlobalWarningDisplayOn();
  return Check(!done, "Setup fails: " + message) &
    Contains(vtkNPROffscreen::GetErrorMessage(), message) &
    Check(vtkNPROffscreen::GetBackend() == before, "a failed Setup changes nothing");
}

void SetVariable(const std::string& value)
{
  vtksys::SystemTools::PutEnv("NPR_OFFSCREEN=" + value);
}

bool CheckTaken(int backend)
{
  int taken = 0;
  bool ok = Check(
    vtkNPROffscreen::GetBackend() == backend, "backend " + std::to_string(backend) + " is taken");
  for (const auto& row : vtkNPROffscreen::GetBackendReport())
  {
    std::cout << "  " << row.Name << (row.Taken ? " taken: " : " not taken: ") << row.Reason
              << std::endl;
    taken += row.Taken ? 1 : 0;
    ok &= Check(!row.Reason.empty(), row.Name + " has a reason");
  }
  return ok & Check(taken == 1, "one way is taken");
}

} // namespace

int TestOffscreenSetup(int, char*[])
{
  bool ok = true;
  ok &= Check(vtkNPROffscreen::GetBackend() == vtkNPROffscreen::AUTO, "nothing happens by itself");
  ok &= Contains(vtkNPROffscreen::GetBackendReason(2), "Setup has not been called");

  ok &= Refuses("opengl", "Unknown backend 'opengl'");
  ok &= Refuses(static_cast<const char*>(nullptr), "Unknown backend ''");
  ok &= Refuses(17, "Unknown backend 17");
  ok &= Refuses(-1, "Unknown backend -1");
  ok &= Refuses("native", "DISPLAY is not set");
  vtksys::SystemTools::PutEnv("DISPLAY=:4711");
  ok &= Refuses(vtkNPROffscreen::NATIVE, "no X server answers at DISPLAY=:4711");

  // AUTO looks at the display itself, not at the variable.
  ok &= Check(vtkNPROffscreen::Setup(), "Setup without a display");
  ok &=
    Check(vtkNPROffscreen::GetBackend() != vtkNPROffscreen::NATIVE, "a dead display is skipped");
  vtksys::SystemTools::UnPutEnv("DISPLAY");
  ok &= Check(vtkNPROffscreen::Setup("Auto"), "the name in any case");
  const int automatic = vtkNPROffscreen::GetBackend();
  ok &= CheckTaken(automatic);

  for (const int backend : Backends())
  {
    const std::string name = backend == vtkNPROffscreen::EGL ? "egl" : "osmesa";
    SetVariable(name);
    ok &= Check(vtkNPROffscreen::Setup(), "Setup by NPR_OFFSCREEN=" + name);
    std::cout << "NPR_OFFSCREEN=" << name << ": " << vtkNPROffscreen::GetWindowClassName()
              << std::endl;
    ok &= CheckTaken(backend);
#if NPR_VTK_AT_LEAST(9, 4)
    ok &=
      Check(vtkNPROffscreen::GetWindowClassName() == "vtkEGLRenderWindow", "the window's class");
#else
    ok &= Check(vtkNPROffscreen::GetWindowClassName() ==
        (backend == vtkNPROffscreen::EGL ? "vtkNPREGLRenderWindow" : "vtkNPROSMesaRenderWindow"),
      "the window's class");
#endif
    // Twice is as good as once.
    ok &= Check(vtkNPROffscreen::Setup(), "Setup again");
    ok &= CheckTaken(backend);

    const auto window = NewSphereWindow(64);
    vtkNew<vtkRenderWindowInteractor> interactor;
    ok &= Check(vtkGenericRenderWindowInteractor::SafeDownCast(interactor) != nullptr,
      "an interactor that needs no display");
    interactor->SetRenderWindow(window);
    interactor->Initialize();
    interactor->Start();
    ok &= CoversDisc(window, 64);
  }

  // What a program asks for by name is not changed by the variable, and AUTO is.
  SetVariable("auto");
  ok &= Check(
    vtkNPROffscreen::Setup() && vtkNPROffscreen::GetBackend() == automatic, "NPR_OFFSCREEN=auto");
  SetVariable("glide");
  ok &= Refuses(vtkNPROffscreen::AUTO, "NPR_OFFSCREEN has the unknown value 'glide'");
  ok &= Check(vtkNPROffscreen::Setup(vtkNPROffscreen::EGL), "an explicit backend");
  SetVariable("native");
  ok &= Refuses(vtkNPROffscreen::AUTO, "DISPLAY is not set");
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
