// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// A program of somebody who has installed vtkNPR: the ink drawing of a tetrahedron, off screen.
#include <vtkNPRIllustration.h>
#include <vtkNPRIllustrationStyle.h>
#include <vtkNPROffscreen.h>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNPROffscreen::Setup();

  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 0.0, 1.0);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 2, 1 });
  triangles->InsertNextCell({ 0, 1, 3 });
  triangles->InsertNextCell({ 0, 3, 2 });
  triangles->InsertNextCell({ 1, 2, 3 });
  vtkNew<vtkPolyData> tetrahedron;
  tetrahedron->SetPoints(points);
  tetrahedron->SetPolys(triangles);

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(tetrahedron);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(160, 120);
  window->AddRenderer(renderer);
  renderer->ResetCamera();

  vtkNew<vtkNPRIllustrationStyle> style;
  style->LoadBuiltIn("ink");
  vtkNew<vtkNPRIllustration> illustration;
  illustration->SetRenderer(renderer);
  illustration->SetStyle(style);
  illustration->Apply();
  window->Render();

  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, 159, 119, 0, pixels);
  int dark = 0;
  int light = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    dark += pixels->GetTypedComponent(i, 1) < 80;
    light += pixels->GetTypedComponent(i, 1) > 240;
  }
  std::cout << window->GetClassName() << ": " << dark << " dark and " << light
            << " light pixels of " << pixels->GetNumberOfTuples() << "\n";
  return dark > 100 && light > 10000 ? EXIT_SUCCESS : EXIT_FAILURE;
}
