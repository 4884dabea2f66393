// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprHiddenStrokes.h
 * @brief Strokes and surfaces made by hand, and what vtkNPRStrokeVisibility says of them.
 */
#ifndef nprHiddenStrokes_h
#define nprHiddenStrokes_h

#include "nprArrayNames.h"
#include "nprChecks.h"
#include "vtkNPRStrokeVisibility.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Dense>

#include <cmath>
#include <string>
#include <vector>

namespace nprtest
{
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;
using Data = vtkSmartPointer<vtkPolyData>;

inline void AddPolyline(vtkPolyData* data, const Points& line)
{
  if (!data->GetPoints())
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    data->SetPoints(points);
    data->SetLines(vtkNew<vtkCellArray>());
  }
  vtkNew<vtkIdList> ids;
  for (const Vector3d& point : line)
  {
    ids->InsertNextId(data->GetPoints()->InsertNextPoint(point.data()));
  }
  data->GetLines()->InsertNextCell(ids);
}

inline Data MakePolylines(const std::vector<Points>& lines)
{
  auto data = Data::New();
  for (const Points& line : lines)
  {
    AddPolyline(data, line);
  }
  return data;
}

/// Polygons over points, each with three corners or more.
inline Data MakePolygons(const Points& corners, const std::vector<std::vector<vtkIdType>>& cells)
{
  auto data = Data::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3d& corner : corners)
  {
    points->InsertNextPoint(corner.data());
  }
  data->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  for (const std::vector<vtkIdType>& cell : cells)
  {
    polygons->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  data->SetPolys(polygons);
  return data;
}

/// A rectangle across z.
inline Data MakeSheet(double halfWidth, double halfHeight, double z)
{
  return MakePolygons({ { -halfWidth, -halfHeight, z }, { halfWidth, -halfHeight, z },
                        { halfWidth, halfHeight, z }, { -halfWidth, halfHeight, z } },
    { { 0, 1, 2 }, { 0, 2, 3 } });
}

inline Points GetBoxCorners(const Vector3d& halfSizes)
{
  Points corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.emplace_back(
      Vector3d(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0).cwiseProduct(halfSizes));
  }
  return corners;
}

/// A closed box around the origin, as quadrilaterals.
inline Data MakeBox(const Vector3d& halfSizes)
{
  return MakePolygons(GetBoxCorners(halfSizes),
    { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
      { 1, 3, 7, 5 } });
}

/// Looks at the origin; \p parallel sees 4 units high.
inline vtkSmartPointer<vtkCamera> MakeCamera(const Vector3d& eye, bool parallel = true)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  const Vector3d direction = eye.normalized();
  const Vector3d up = std::abs(direction.y()) < 0.9 ? Vector3d::UnitY() : Vector3d::UnitX();
  camera->SetViewUp(up.x(), up.y(), up.z());
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(2.0);
  return camera;
}

using Filter = vtkSmartPointer<vtkNPRStrokeVisibility>;
inline Filter MakeFilter(vtkPolyData* strokes, const std::vector<Data>& surfaces, vtkCamera* camera)
{
  auto filter = Filter::New();
  filter->SetInputData(strokes);
  for (const Data& surface : surfaces)
  {
    filter->AddSurfaceData(surface);
  }
  filter->SetCamera(camera);
  return filter;
}

struct Part
{
  int Layers;
  Points Line;
  std::vector<double> ArcLengths;

  double GetLength() const
  {
    double length = 0.0;
    for (std::size_t i = 1; i < this->Line.size(); ++i)
    {
      length += (this->Line[i] - this->Line[i - 1]).norm();
    }
    return length;
  }
};
using Parts = std::vector<Part>;

inline Parts GetParts(vtkNPRStrokeVisibility* filter)
{
  filter->Update();
  vtkPolyData* const output = filter->GetOutput();
  vtkDataArray* const layers = output->GetCellData()->GetArray(npr::names::HidingLayers);
  vtkDataArray* const arcs = output->GetPointData()->GetArray(npr::names::ArcLength);
  Parts parts;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
  {
    output->GetLines()->GetCellAtId(line, ids);
    Part part;
    part.Layers = static_cast<int>(layers->GetComponent(line, 0));
    for (const vtkIdType id : *ids)
    {
      part.Line.emplace_back();
      output->GetPoint(id, part.Line.back().data());
      part.ArcLengths.push_back(arcs->GetComponent(id, 0));
    }
    parts.push_back(part);
  }
  return parts;
}

/// The layers of the parts, such as "0 1 0".
inline std::string GetLayers(const Parts& parts)
{
  std::string layers;
  for (const Part& part : parts)
  {
    layers += (layers.empty() ? "" : " ") + std::to_string(part.Layers);
  }
  return layers;
}

/// Whether the layers are these, and the cuts between the parts have these values of a coordinate.
inline bool AreParts(const Parts& parts, const std::string& layers, int axis,
  const std::vector<double>& cuts, double tolerance)
{
  bool isRight = GetLayers(parts) == layers && parts.size() == cuts.size() + 1;
  for (std::size_t i = 0; isRight && i < cuts.size(); ++i)
  {
    isRight = std::abs(parts[i].Line.back()[axis] - cuts[i]) <= tolerance &&
      parts[i].Line.back() == parts[i + 1].Line.front();
  }
  if (!isRight)
  {
    std::cerr << "parts " << GetLayers(parts) << ", cut at";
    for (const Part& part : parts)
    {
      std::cerr << " " << part.Line.back()[axis];
    }
    std::cerr << "\n";
  }
  return isRight;
}

/// Updates a filter and returns the errors that it told, one after another.
inline std::string GetErrors(vtkAlgorithm* filter)
{
  std::string errors;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&errors);
  command->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
    { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
  const unsigned long tag = filter->AddObserver(vtkCommand::ErrorEvent, command);
  const unsigned long pipelineTag =
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, command);
  filter->Update();
  filter->RemoveObserver(tag);
  filter->GetExecutive()->RemoveObserver(pipelineTag);
  return errors;
}
}

#endif
