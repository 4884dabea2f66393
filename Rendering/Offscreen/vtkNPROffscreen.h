// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPROffscreen
 * @brief Chooses what plain vtkRenderWindow::New() gives: a window on a display, or one without.
 *
 * Debian's VTK 9.1 draws through X11 only. After `vtkNPROffscreen::Setup()` rendering works on a
 * machine without a display, too, in C++ and in Python:
 *
 *     vtkNPROffscreen::Setup();
 *     vtkNew<vtkRenderWindow> window;
 *
 * AUTO takes the first of these that works:
 *  1. the display, if an X server answers and speaks GLX: who has a screen expects a window on it;
 *  2. EGL on a GPU, which is the fastest;
 *  3. OSMesa, in software: it opens no device and depends on no display server or driver setup;
 *  4. EGL's surfaceless platform, in software too, but through the EGL drivers installed.
 *
 * The environment variable NPR_OFFSCREEN (native, egl, osmesa or auto) replaces AUTO; a backend
 * that a program asks for by name is not changed by it.
 *
 * Where windows need no display, vtkRenderWindowInteractor::New() gives a
 * vtkGenericRenderWindowInteractor: the X11 one crashes in Initialize() without a display.
 *
 * Nothing happens when the library is loaded; only Setup() changes VTK's object factories, and
 * only for windows made afterwards. Call it from one thread, at the start of a program.
 *
 * @sa vtkNPREGLRenderWindow vtkNPROSMesaRenderWindow
 */
#ifndef vtkNPROffscreen_h
#define vtkNPROffscreen_h

#include "vtkNPRRenderingOffscreenModule.h" // for the export macro
#include "vtkObject.h"

#include <string> // for std::string
#include <vector> // for std::vector

#include "nprVTKCompat.h" // for VTK_ABI_NAMESPACE_BEGIN

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
VTK_ABI_NAMESPACE_END

class VTKNPRRENDERINGOFFSCREEN_EXPORT vtkNPROffscreen : public vtkObject
{
public:
  static vtkNPROffscreen* New();
  vtkTypeMacro(vtkNPROffscreen, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What can be asked for. */
  enum Backend
  {
    AUTO = 0,
    NATIVE = 1,
    EGL = 2,
    OSMESA = 3
  };

  ///@{
  /**
   * Chooses the backend for windows made from now on. The name may be written in any case.
   * Returns false, with an error, if the backend is unknown or does not work here; what was set up
   * before then stays. May be called again, with another backend, too; windows that exist live on,
   * and EGL and OSMesa windows may draw in turn. Only with windows on an X display they can not:
   * GLX ends the program with BadAccess when its window draws, or is deleted, while the thread
   * holds another context. So Finalize() and delete X windows before you go on without a display,
   * or call Setup(NATIVE), which releases the thread, before you go back to them.
   */
  static bool Setup(int backend = AUTO);
  static bool Setup(const char* backend);
  ///@}

  /** The backend taken (NATIVE, EGL or OSMESA), or AUTO before Setup() succeeded. */
  static int GetBackend();

  /** The class that vtkRenderWindow::New() gives now, such as "vtkNPROSMesaRenderWindow". */
  static std::string GetWindowClassName();

  /** Why the last Setup() failed; empty if it did not. */
  static std::string GetErrorMessage();

  ///@{
  /**
   * The four ways to a picture, in the order in which AUTO tries them: "native", "egl (GPU)",
   * "osmesa", "egl (software)". The first word is the backend's name, as Setup() and NPR_OFFSCREEN
   * take it; "egl" is a GPU where there is one. For each: whether it was taken, and why, or why
   * not. Each is tried when it is asked about, so these calls can take some tenths of a second.
   */
  static int GetNumberOfBackends();
  static const char* GetBackendName(int index);
  static bool GetBackendTaken(int index);
  static std::string GetBackendReason(int index);
  ///@}

#ifndef __VTK_WRAP__
  /** One row of the report. */
  struct BackendReport
  {
    std::string Name;
    bool Taken;
    std::string Reason;
  };
  /** The same as one list. */
  static std::vector<BackendReport> GetBackendReport();
#endif

  ///@{
  /** What the driver behind a window says about itself; initializes the window if need be. */
  static std::string GetGLVendor(vtkRenderWindow* window);
  static std::string GetGLRenderer(vtkRenderWindow* window);
  static std::string GetGLVersion(vtkRenderWindow* window);
  ///@}

protected:
  vtkNPROffscreen() = default;
  ~vtkNPROffscreen() override = default;

private:
  vtkNPROffscreen(const vtkNPROffscreen&) = delete;
  void operator=(const vtkNPROffscreen&) = delete;
};

#endif
