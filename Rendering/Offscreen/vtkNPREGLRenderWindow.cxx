// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPREGLRenderWindow.h"

#include "nprGLContext.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkNPREGLRenderWindow);

//------------------------------------------------------------------------------
std::shared_ptr<npr::GLContext> vtkNPREGLRenderWindow::NewContext(std::string& reason)
{
  if (auto context = npr::NewEGLContext(npr::EGLKind::GPU, reason))
  {
    return context;
  }
  std::string softwareReason;
  auto context = npr::NewEGLContext(npr::EGLKind::Software, softwareReason);
  if (!context)
  {
    reason += "; " + softwareReason;
  }
  return context;
}
