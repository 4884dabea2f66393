// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprRenderJob.h"

#include "nprImageFile.h"
#include "nprReporter.h"
#include "vtkNPRIllustration.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPROffscreen.h"

#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

namespace npr
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderWindow> MakeWindow(Reporter& reporter, const std::array<int, 2>& size)
{
  // Which class New() gives is settled by Setup().
  const bool good = vtkNPROffscreen::Setup();
  reporter.DropVTKErrors();
  if (!good)
  {
    throw CommandError(RenderError, vtkNPROffscreen::GetErrorMessage());
  }
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(4);
  window->SetSize(size[0], size[1]);
  return window;
}

//------------------------------------------------------------------------------
RenderJob::RenderJob(Reporter& reporter, const std::array<int, 2>& size)
  : Output(reporter), Window(MakeWindow(reporter, size))
{
  this->Window->AddRenderer(this->Renderer);
  this->Illustration->SetRenderer(this->Renderer);
  reporter.Watch(this->Illustration, "preparing");
}

RenderJob::~RenderJob() = default;

//------------------------------------------------------------------------------
void RenderJob::Run(vtkNPRIllustrationStyle* style, const std::string& file, bool transparent)
{
  this->Illustration->SetStyle(style);
  this->Window->SetAlphaBitPlanes(transparent);
  this->Renderer->SetBackgroundAlpha(transparent ? 0.0 : 1.0);
  this->Illustration->Apply();
  this->Output.ThrowOnVTKError(InputError);
  this->Output.StartClock();
  this->Window->Render();
  this->Output.ThrowOnVTKError(RenderError);
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Window);
  grab->SetInputBufferType(transparent ? VTK_RGBA : VTK_RGB);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  this->Output.ThrowOnVTKError(RenderError);
  // The lines are extracted while the first image is drawn.
  double seconds = this->Output.StopClock();
  for (const char* stage : { "prepare", "curvature", "lines" })
  {
    this->Output.AddStage(stage, this->Illustration->GetStageSeconds(stage));
  }
  this->Output.AddStage("draw", seconds - this->Illustration->GetStageSeconds("lines"));
  this->Output.BeginStage("write");
  WriteImage(grab->GetOutput(), file);
  this->Output.EndStage();
}
}
