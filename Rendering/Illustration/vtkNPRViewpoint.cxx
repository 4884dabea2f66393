// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRViewpoint.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkNPRViewpoint);

namespace
{
struct NamedView
{
  const char* Name;
  double Azimuth;
  double Elevation;
};

constexpr NamedView Views[] = {
  { "front", 0.0, 0.0 },
  { "back", 180.0, 0.0 },
  { "left", -90.0, 0.0 },
  { "right", 90.0, 0.0 },
  { "top", 0.0, 90.0 },
  { "bottom", 0.0, -90.0 },
  { "three-quarter", 30.0, 20.0 },
};

/// The points of all visible actors, in the axes of a camera: x to the right, y up, z to the eye.
using PointList = std::vector<Eigen::Vector3d>;

/// Where the axis of the camera must stand to have the points between two half-planes that open
/// towards the scene with a slope, and how far the half-planes are apart at z = 0.
struct Wedge
{
  double Centre;
  double HalfWidth;

  Wedge(const PointList& points, int axis, double slope)
  {
    double low = -std::numeric_limits<double>::max();
    double high = low;
    for (const Eigen::Vector3d& point : points)
    {
      high = std::max(high, point[axis] + slope * point[2]);
      low = std::max(low, -point[axis] + slope * point[2]);
    }
    this->Centre = 0.5 * (high - low);
    this->HalfWidth = 0.5 * (high + low);
  }
};

/// Centres the axis that does not decide the distance: the slope is found at which the half-planes
/// meet at the eye.
double FindCentre(const PointList& points, int axis, double slope, double eye)
{
  constexpr int Iterations = 6;
  Wedge wedge(points, axis, slope);
  for (int i = 0; i < Iterations; ++i)
  {
    wedge = Wedge(points, axis, wedge.HalfWidth / eye);
  }
  return wedge.Centre;
}

void AddActor(vtkActor* actor, const Eigen::Matrix3d& axes, PointList& list)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper || !actor->GetVisibility() || !actor->GetUseBounds())
  {
    return;
  }
  mapper->Update();
  Eigen::Matrix4d matrix;
  vtkMatrix4x4* source = actor->GetMatrix();
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix(row, column) = source->GetElement(row, column);
    }
  }
  const auto add = [&](const Eigen::Vector3d& point)
  {
    const Eigen::Vector3d world = (matrix * point.homogeneous()).hnormalized();
    if (world.allFinite())
    {
      list.push_back(axes * world);
    }
  };
  if (vtkPointSet* points = vtkPointSet::SafeDownCast(mapper->GetInputDataObject(0, 0)))
  {
    Eigen::Vector3d point;
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      points->GetPoint(i, point.data());
      add(point);
    }
  }
  else if (const double* bounds = mapper->GetBounds();
           bounds && vtkMath::AreBoundsInitialized(bounds))
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      add({ bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + (corner >> 2)] });
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkNPRViewpoint::GetViewNames()
{
  std::vector<std::string> names;
  for (const NamedView& view : Views)
  {
    names.emplace_back(view.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
bool vtkNPRViewpoint::SetViewByName(const std::string& name)
{
  std::string names;
  for (const NamedView& view : Views)
  {
    if (name == view.Name)
    {
      this->SetAzimuth(view.Azimuth);
      this->SetElevation(view.Elevation);
      return true;
    }
    names += (names.empty() ? "" : ", ") + std::string(view.Name);
  }
  vtkErrorMacro(<< "unknown view '" << name << "'; the views are: " << names);
  return false;
}

//------------------------------------------------------------------------------
void vtkNPRViewpoint::Apply(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkErrorMacro("there is no renderer to point the camera of");
    return;
  }
  const double azimuth = vtkMath::RadiansFromDegrees(this->Azimuth);
  const double elevation = vtkMath::RadiansFromDegrees(this->Elevation);
  // With Y up; the other axes follow by turning the model's up axis to Y.
  const Eigen::Vector3d eye(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
    std::cos(azimuth) * std::cos(elevation));
  const Eigen::Vector3d up(-std::sin(azimuth) * std::sin(elevation), std::cos(elevation),
    -std::cos(azimuth) * std::sin(elevation));
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (this->UpAxis == 2)
  {
    axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  }
  else if (this->UpAxis == 0)
  {
    axes << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  }
  const Eigen::Vector3d position = axes * eye;
  const Eigen::Vector3d viewUp = axes * up;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(position.data());
  camera->SetViewUp(viewUp.data());
  camera->SetParallelProjection(this->ParallelProjection);
  this->Frame(renderer);
}

//------------------------------------------------------------------------------
void vtkNPRViewpoint::Frame(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkErrorMacro("there is no renderer to frame the actors of");
    return;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->OrthogonalizeViewUp();
  const Eigen::Vector3d back = -Eigen::Vector3d(camera->GetDirectionOfProjection());
  const Eigen::Vector3d right = Eigen::Vector3d(camera->GetViewUp()).cross(back).normalized();
  Eigen::Matrix3d axes;
  axes << right.transpose(), back.cross(right).transpose(), back.transpose();

  PointList points;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (vtkActor* actor = vtkActor::SafeDownCast(prop))
    {
      AddActor(actor, axes, points);
    }
  }
  if (points.empty())
  {
    return;
  }
  // About their middle, so that nothing is lost far from the origin.
  Eigen::Vector3d low = points.front();
  Eigen::Vector3d high = low;
  for (const Eigen::Vector3d& point : points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Eigen::Vector3d middle = 0.5 * (low + high);
  for (Eigen::Vector3d& point : points)
  {
    point -= middle;
  }
  const double front = high[2] - middle[2];
  // All points in one place are framed as something small that the coordinates can still tell.
  const double size = std::max((high - low).maxCoeff(), 1e-6 * (1e-6 + middle.norm()));

  const double aspect = renderer->GetTiledAspectRatio();
  const double inner = 1.0 - 2.0 * this->Margin;
  Eigen::Vector3d position(0.0, 0.0, front + size);
  if (camera->GetParallelProjection())
  {
    const double halfHeight = std::max(0.5 * (high[1] - low[1]), 0.5 * (high[0] - low[0]) / aspect);
    camera->SetParallelScale(std::max(halfHeight, 1e-3 * size) / inner);
  }
  else
  {
    const double slope =
      inner * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    const bool isHorizontal = camera->GetUseHorizontalViewAngle();
    const double slopeX = isHorizontal ? slope : slope * aspect;
    const double slopeY = isHorizontal ? slope / aspect : slope;
    const Wedge x(points, 0, slopeX);
    const Wedge y(points, 1, slopeY);
    const double eye =
      std::max({ x.HalfWidth / slopeX, y.HalfWidth / slopeY, front + 0.05 * size });
    position = { FindCentre(points, 0, slopeX, eye), FindCentre(points, 1, slopeY, eye), eye };
  }
  const Eigen::Vector3d eye = axes.transpose() * (middle + position);
  const Eigen::Vector3d focus =
    axes.transpose() * (middle + Eigen::Vector3d(position[0], position[1], 0.0));
  const Eigen::Vector3d up = axes.row(1);
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(up.data());
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void vtkNPRViewpoint::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Azimuth: " << this->Azimuth << "\n";
  os << indent << "Elevation: " << this->Elevation << "\n";
  os << indent << "UpAxis: " << this->UpAxis << "\n";
  os << indent << "ParallelProjection: " << this->ParallelProjection << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
}
