// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPROSMesaRenderWindow.h"

#include "nprGLContext.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPROSMesaRenderWindow);

//------------------------------------------------------------------------------
std::shared_ptr<npr::GLContext> vtkNPROSMesaRenderWindow::NewContext(std::string& reason)
{
  return npr::NewOSMesaContext(reason);
}
