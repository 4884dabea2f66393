// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Framing is tight and centred: seen from anywhere, the outermost points lie on the margin.
#include "vtkNPROffscreen.h"
#include "vtkNPRViewpoint.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
/// The ranges of x and y of the cone's points in normalised device coordinates.
void ComputeExtent(vtkActor* actor, vtkPolyData* cone, vtkRenderer* renderer, double extent[2][2])
{
  vtkNew<vtkMatrix4x4> matrix;
  vtkMatrix4x4::Multiply4x4(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
                              renderer->GetTiledAspectRatio(), -1.0, 1.0),
    actor->GetMatrix(), matrix);
  for (int axis = 0; axis < 2; ++axis)
  {
    extent[axis][0] = 10.0;
    extent[axis][1] = -10.0;
  }
  for (vtkIdType i = 0; i < cone->GetNumberOfPoints(); ++i)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    cone->GetPoint(i, point);
    matrix->MultiplyPoint(point, point);
    for (int axis = 0; axis < 2; ++axis)
    {
      extent[axis][0] = std::min(extent[axis][0], point[axis] / point[3]);
      extent[axis][1] = std::max(extent[axis][1], point[axis] / point[3]);
    }
  }
}
}

int TestViewpoint(int, char*[])
{
  vtkNPROffscreen::Setup();
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(24);
  cone->SetHeight(1.5);
  cone->SetCenter(100.0, -20.0, 3.0);
  cone->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->RotateX(20.0);
  actor->SetScale(0.01, 0.02, 0.01);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->AddRenderer(renderer);

  bool good = true;
  vtkNew<vtkNPRViewpoint> viewpoint;
  viewpoint->SetMargin(0.1);
  for (int width : { 300, 100 })
  {
    window->SetSize(width, 200);
    for (bool parallel : { false, true })
    {
      viewpoint->SetParallelProjection(parallel);
      for (int up = 0; up < 3; ++up)
      {
        viewpoint->SetUpAxis(up);
        for (const std::string& name : vtkNPRViewpoint::GetViewNames())
        {
          viewpoint->SetViewByName(name);
          viewpoint->Apply(renderer);
          double extent[2][2];
          ComputeExtent(actor, cone->GetOutput(), renderer, extent);
          const double fill = std::max(extent[0][1], extent[1][1]);
          const double centre =
            std::max(std::abs(extent[0][0] + extent[0][1]), std::abs(extent[1][0] + extent[1][1]));
          if (std::abs(fill - 0.8) > 1e-5 || centre > 1e-5)
          {
            std::cerr << "FAILED: " << name << ", up " << up << ", parallel " << parallel
                      << ": fills " << fill << " instead of 0.8, off the centre by " << centre
                      << "\n";
            good = false;
          }
        }
      }
    }
  }

  // What the names promise: the front view looks along -Z with Y up, and along +Y with Z up.
  const double expected[3][3] = { { 0, 0, -1 }, { 0, 0, -1 }, { 0, 1, 0 } };
  for (int up = 0; up < 3; ++up)
  {
    viewpoint->SetUpAxis(up);
    viewpoint->SetViewByName("front");
    viewpoint->Apply(renderer);
    const double* direction = renderer->GetActiveCamera()->GetDirectionOfProjection();
    const double* viewUp = renderer->GetActiveCamera()->GetViewUp();
    if (vtkMath::Distance2BetweenPoints(direction, expected[up]) > 1e-12 || viewUp[up] < 0.999)
    {
      std::cerr << "FAILED: front view with axis " << up << " up\n";
      good = false;
    }
  }

  vtkNew<vtkRenderer> empty;
  window->AddRenderer(empty);
  viewpoint->Apply(empty);
  vtkObject::GlobalWarningDisplayOff();
  good = good && !viewpoint->SetViewByName("sideways");
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
