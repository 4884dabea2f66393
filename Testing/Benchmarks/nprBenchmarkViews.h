// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprBenchmarkViews.h
 * @brief The cameras that lines are measured for.
 */
#ifndef nprBenchmarkViews_h
#define nprBenchmarkViews_h

#include <vtkCamera.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace nprbench
{
using Views = std::vector<vtkSmartPointer<vtkCamera>>;

/// A camera on a circle around a surface, some way above its middle; the distance is in radii of
/// the sphere around its bounding box.
inline vtkSmartPointer<vtkCamera> MakeView(vtkPolyData* surface, double degrees, double distance)
{
  double bounds[6];
  surface->GetBounds(bounds);
  const Eigen::Vector3d low(bounds[0], bounds[2], bounds[4]);
  const Eigen::Vector3d high(bounds[1], bounds[3], bounds[5]);
  const Eigen::Vector3d middle = 0.5 * (low + high);
  constexpr double Radians = 3.14159265358979323846 / 180.0;
  const double elevation = 15.0 * Radians;
  const Eigen::Vector3d direction(std::cos(elevation) * std::sin(degrees * Radians),
    std::sin(elevation), std::cos(elevation) * std::cos(degrees * Radians));
  const double radius = 0.5 * (high - low).norm();
  const Eigen::Vector3d eye = middle + distance * radius * direction;
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(middle.x(), middle.y(), middle.z());
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(30.0);
  camera->SetClippingRange(0.01 * radius, (distance + 2.0) * radius);
  return camera;
}

/// All around, near, at a middle distance and far away in turn.
inline Views MakeViews(vtkPolyData* surface, int count)
{
  constexpr double Distances[] = { 1.2, 2.0, 4.0 };
  Views views;
  for (int i = 0; i < count; ++i)
  {
    views.push_back(MakeView(surface, 360.0 * i / count, Distances[i % 3]));
  }
  return views;
}
}

#endif
