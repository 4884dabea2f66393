// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprDepthPicture_h
#define nprDepthPicture_h

#include "vtkNPRDepthVisibility.h"
#include "vtkNPROffscreen.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cstdio>
#include <cstdlib>

namespace nprbench
{
/// Surfaces in a window, and what their depths hide.
class DepthPicture
{
public:
  explicit DepthPicture(int height)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(2 * height, height);
    this->Window->AddRenderer(this->Renderer);
    this->Filter->SetRenderer(this->Renderer);
  }

  void AddSurface(vtkPolyData* surface, vtkMatrix4x4* matrix)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetUserMatrix(matrix);
    this->Renderer->AddActor(actor);
  }

  void Render(vtkCamera* camera)
  {
    this->Renderer->SetActiveCamera(camera);
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
    this->Window->WaitForCompletion();
  }

  vtkNPRDepthVisibility* GetFilter() { return this->Filter; }

private:
  static vtkSmartPointer<vtkRenderWindow> MakeWindow()
  {
    // Which class New() gives is settled by Setup().
    if (!vtkNPROffscreen::Setup())
    {
      std::fprintf(stderr, "%s\n", vtkNPROffscreen::GetErrorMessage().c_str());
      std::exit(EXIT_FAILURE);
    }
    return vtkSmartPointer<vtkRenderWindow>::New();
  }

  vtkSmartPointer<vtkRenderWindow> Window = MakeWindow();
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkNPRDepthVisibility> Filter;
};
}

#endif
