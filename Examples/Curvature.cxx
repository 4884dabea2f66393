// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Curvature of a mesh by estimation, and of the same points exactly, from an implicit function.
#include <vtkNPRCurvatureTensor.h>
#include <vtkNPRImplicitCurvature.h>
#include <vtkNPRSurfacePreparation.h>

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphere.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(2.0);
  source->SetThetaResolution(64);
  source->SetPhiResolution(64);

  vtkNew<vtkNPRSurfacePreparation> preparation; // welds, triangulates, orients, splits creases
  preparation->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkNPRCurvatureTensor> estimate;
  estimate->SetInputConnection(preparation->GetOutputPort());
  estimate->OutputShapeIndexOn();
  estimate->Update();

  vtkNew<vtkSphere> sphere; // any vtkImplicitFunction that grows outwards
  sphere->SetRadius(2.0);
  vtkNew<vtkNPRImplicitCurvature> exact;
  exact->SetImplicitFunction(sphere);
  exact->SetInputConnection(preparation->GetOutputPort());
  exact->Update();

  // Convex is positive: 1 / radius.
  bool isRight = true;
  for (vtkPolyData* surface : { estimate->GetOutput(), exact->GetOutput() })
  {
    double range[2];
    surface->GetPointData()->GetArray("MeanCurvature")->GetRange(range);
    std::cout << "mean curvature from " << range[0] << " to " << range[1] << "\n";
    isRight = isRight && std::abs(range[0] - 0.5) < 0.01 && std::abs(range[1] - 0.5) < 0.01;
  }
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
