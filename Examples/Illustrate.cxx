// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An illustration in a VTK program. Everything but the marked lines is plain VTK.
#include <vtkNPRIllustration.h>
#include <vtkNPRIllustrationStyle.h>
#include <vtkNPROffscreen.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

int main(int argc, char* argv[])
{
  vtkNPROffscreen::Setup(); // vtkNPR: where there is no display, windows that need none

  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0); // strokes are smooth without
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  renderer->ResetCamera();

  vtkNew<vtkNPRIllustrationStyle> style; // vtkNPR: how it looks
  style->LoadBuiltIn("technical");
  vtkNew<vtkNPRIllustration> illustration; // vtkNPR: put it on the renderer
  illustration->SetRenderer(renderer);
  illustration->SetStyle(style);
  illustration->Apply();

  window->Render(); // from now on the lines follow the camera by themselves

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "Illustrate.png");
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
