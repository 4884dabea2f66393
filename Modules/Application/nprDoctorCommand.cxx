// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprReporter.h"
#include "vtkNPROffscreen.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSMPTools.h>
#include <vtkVersion.h>

#include <CLI/CLI.hpp>

#include <cstdio>

namespace npr
{
namespace
{
void PrintLine(const char* what, const std::string& value)
{
  std::printf("%-14s %s\n", what, value.c_str());
}

void Diagnose(Reporter& reporter)
{
  PrintLine("vtkNPR", NPR_VERSION);
  PrintLine("VTK", vtkVersion::GetVTKVersion());
  PrintLine("threads",
    std::string(vtkSMPTools::GetBackend()) + ", " +
      std::to_string(vtkSMPTools::GetEstimatedNumberOfThreads()));
  PrintLine("OpenVDB", NPR_HAS_OPENVDB ? "built in" : "not built in (NPR_USE_OPENVDB is off)");
  PrintLine("Embree", NPR_HAS_EMBREE ? "built in" : "not built in (NPR_USE_EMBREE is off)");
  PrintLine("Python", NPR_HAS_PYTHON ? "built" : "not built (NPR_WRAP_PYTHON is off)");

  const bool good = vtkNPROffscreen::Setup();
  reporter.DropVTKErrors();
  for (const vtkNPROffscreen::BackendReport& backend : vtkNPROffscreen::GetBackendReport())
  {
    PrintLine(backend.Name.c_str(), (backend.Taken ? "taken: " : "not taken: ") + backend.Reason);
  }
  if (!good)
  {
    throw CommandError(RenderError, vtkNPROffscreen::GetErrorMessage());
  }

  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->SetOffScreenRendering(1);
  window->SetSize(16, 16);
  window->AddRenderer(renderer);
  window->Render();
  reporter.ThrowOnVTKError(RenderError);
  PrintLine("window", window->GetClassName());
  PrintLine("GL vendor", vtkNPROffscreen::GetGLVendor(window));
  PrintLine("GL renderer", vtkNPROffscreen::GetGLRenderer(window));
  PrintLine("GL version", vtkNPROffscreen::GetGLVersion(window));
}
}

//------------------------------------------------------------------------------
void AddDoctorCommand(CLI::App& program, Reporter& reporter)
{
  CLI::App* command = program.add_subcommand(
    "doctor", "Say what this machine draws with, and why; NPR_OFFSCREEN chooses the backend");
  command->footer("NPR_OFFSCREEN is native, egl (a GPU where there is one), osmesa or "
                  "auto.\nExample: NPR_OFFSCREEN=egl npr doctor");
  command->callback([&reporter]() { Diagnose(reporter); });
}
}
