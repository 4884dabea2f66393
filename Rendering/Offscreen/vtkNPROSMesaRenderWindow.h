// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPROSMesaRenderWindow
 * @brief A render window that draws in software, through OSMesa.
 *
 * OSMesa touches no display and no device. The library (libOSMesa.so.8) is loaded at run time; Mesa
 * 25.1 and later ship none.
 *
 * @sa vtkNPROffscreen vtkNPROffscreenRenderWindow
 */
#ifndef vtkNPROSMesaRenderWindow_h
#define vtkNPROSMesaRenderWindow_h

#include "vtkNPROffscreenRenderWindow.h"
#include "vtkNPRRenderingOffscreenModule.h" // for the export macro

class VTKNPRRENDERINGOFFSCREEN_EXPORT vtkNPROSMesaRenderWindow : public vtkNPROffscreenRenderWindow
{
public:
  static vtkNPROSMesaRenderWindow* New();
  vtkTypeMacro(vtkNPROSMesaRenderWindow, vtkNPROffscreenRenderWindow);

protected:
  vtkNPROSMesaRenderWindow() = default;
  ~vtkNPROSMesaRenderWindow() override = default;

#ifndef __VTK_WRAP__
  std::shared_ptr<npr::GLContext> NewContext(std::string& reason) override;
#endif

private:
  vtkNPROSMesaRenderWindow(const vtkNPROSMesaRenderWindow&) = delete;
  void operator=(const vtkNPROSMesaRenderWindow&) = delete;
};

#endif
