// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// A program of somebody who has installed vtkNPR: a filter, and a kernel with Eigen in its header.
#include <nprArrayNames.h>
#include <nprTriangleMesh.h>
#include <vtkNPRCurvatureTensor.h>
#include <vtkNPRSurfaceNormals.h>

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

int main()
{
  constexpr double radius = 2.0;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  vtkNew<vtkNPRSurfaceNormals> normals;
  normals->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkNPRCurvatureTensor> curvature;
  curvature->SetInputConnection(normals->GetOutputPort());
  curvature->Update();

  vtkPolyData* surface = curvature->GetOutput();
  vtkDataArray* kappa = surface->GetPointData()->GetArray(npr::names::PrincipalCurvature1);
  if (!kappa || kappa->GetNumberOfTuples() == 0)
  {
    std::cerr << "The filter gave no curvature\n";
    return EXIT_FAILURE;
  }
  double range[2];
  kappa->GetRange(range);

  const npr::TriangleMesh mesh(surface);
  double area = 0.0;
  for (npr::TriangleMesh::Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    area += 0.5 * mesh.GetAreaNormal(t).norm();
  }

  const double expectedArea = 4.0 * 3.14159265 * radius * radius;
  std::cout << "curvature " << range[0] << " to " << range[1] << ", a sphere's is " << 1.0 / radius
            << "; area " << area << ", a sphere's is " << expectedArea << "\n";
  const bool good = std::abs(range[0] * radius - 1.0) < 0.05 &&
    std::abs(range[1] * radius - 1.0) < 0.05 && std::abs(area / expectedArea - 1.0) < 0.01;
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
