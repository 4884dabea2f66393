// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The filters one by one: from a surface to its lines, and to strokes in a renderer.
#include <vtkNPRCurvatureTensor.h>
#include <vtkNPRFeatureLines.h>
#include <vtkNPROffscreen.h>
#include <vtkNPRSampleSource.h>
#include <vtkNPRSplineStrokes.h>
#include <vtkNPRStrokeMapper.h>
#include <vtkNPRSurfaceNormals.h>
#include <vtkNPRSurfacePreparation.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

int main(int argc, char* argv[])
{
  vtkNPROffscreen::Setup();
  vtkNew<vtkRenderer> renderer;

  // Independent of the view: computed once.
  vtkNew<vtkNPRSampleSource> sample;
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputConnection(sample->GetOutputPort());
  vtkNew<vtkNPRSurfaceNormals> normals;
  normals->SetInputConnection(preparation->GetOutputPort());
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetInputConnection(normals->GetOutputPort());

  // For each view: chained lines, then smooth strokes.
  vtkNew<vtkNPRFeatureLines> lines;
  lines->SetInputConnection(tensor->GetOutputPort());
  lines->AddDefinition("contours");
  lines->AddDefinition("suggestive");
  lines->SetCamera(renderer->GetActiveCamera());
  vtkNew<vtkNPRSplineStrokes> strokes;
  strokes->SetInputConnection(lines->GetOutputPort());

  // White paper that hides what is behind, and black strokes on it.
  vtkNew<vtkPolyDataMapper> paperMapper;
  paperMapper->SetInputConnection(tensor->GetOutputPort());
  vtkNew<vtkActor> paper;
  paper->SetMapper(paperMapper);
  paper->GetProperty()->LightingOff();
  vtkNew<vtkNPRStrokeMapper> strokeMapper;
  strokeMapper->SetInputConnection(strokes->GetOutputPort());
  strokeMapper->SetWidth(2.0);
  vtkNew<vtkActor> ink;
  ink->SetMapper(strokeMapper);
  ink->GetProperty()->SetColor(0.0, 0.0, 0.0);

  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(paper);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  renderer->ResetCamera();
  renderer->AddActor(ink);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "FeatureLines.png");
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
