// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfacePipeline.h"

#include "nprLengthScale.h"
#include "nprStyleDocument.h"
#include "nprVisibleSides.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRSurfaceNormals.h"
#include "vtkNPRSurfaceOrder.h"
#include "vtkNPRSurfacePreparation.h"
#include "vtkNPRSurfaceRefinement.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCommand.h>
#include <vtkMath.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTimerLog.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
constexpr double EventsPerFilter = 3.0; // that Watch() observes
constexpr double SeamTolerance = 1e-6;  // of the length scale: the rounding of floats
constexpr double LeastRadius = 3.5;     // of jets, in mean edges
constexpr double RadiusOfSmoothing = 3.0;
// Of the longest edge: at eight thousandths of the picture's shorter side, arcs of up to 0.4 of it
// in radius are parted as finely as by length, while along the axis of a cylinder edges stay as
// they are.
constexpr double ChordError = 1.0 / 400.0;
constexpr double LeastQuality = 0.65; // between scans (0.75 to 0.9) and most CAD (0.3 to 0.55)

struct Tessellation
{
  double MeanEdge = 0.0;
  /// The triangles' mean of 4 sqrt(3) area / sum of the squared edges, by their areas: 1 where all
  /// have equal sides, 0 where all are slivers.
  double Quality = 0.0;
};

Tessellation MeasureTessellation(vtkPolyData* surface)
{
  Tessellation tessellation;
  double areas = 0.0;
  vtkIdType edges = 0;
  auto iterator = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* corners;
    iterator->GetCurrentCell(size, corners);
    if (size != 3)
    {
      continue;
    }
    double points[3][3];
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(corners[i], points[i]);
    }
    double squares = 0.0;
    for (int i = 0; i < 3; ++i, ++edges)
    {
      const double square = vtkMath::Distance2BetweenPoints(points[i], points[(i + 1) % 3]);
      tessellation.MeanEdge += std::sqrt(square);
      squares += square;
    }
    const double area = vtkTriangle::TriangleArea(points[0], points[1], points[2]);
    if (area > 0.0)
    {
      tessellation.Quality += area * (4.0 * std::sqrt(3.0) * area / squares);
      areas += area;
    }
  }
  tessellation.MeanEdge /= std::max<vtkIdType>(edges, 1);
  tessellation.Quality /= areas > 0.0 ? areas : 1.0;
  return tessellation;
}
}

//------------------------------------------------------------------------------
SurfacePipeline::SurfacePipeline()
{
  this->Normals->SetInputConnection(this->Preparation->GetOutputPort());
  this->Tensor->SetInputConnection(this->Normals->GetOutputPort());
  this->Refinement->SetInputConnection(this->Tensor->GetOutputPort());
  this->ShadedOrder->SetInputConnection(this->Refinement->GetOutputPort());
  this->RefinedNormals->SetInputConnection(this->Refinement->GetOutputPort());
  this->Lines->SetInputConnection(this->RefinedNormals->GetOutputPort());
  // What no line asks for.
  this->Tensor->OutputMeanCurvatureOff();
  this->Tensor->OutputGaussianCurvatureOff();
  this->Tensor->OutputUnknownCurvatureOff();
  // What only the refinement asks for, and that once: a third of the memory of a large scan.
  for (vtkAlgorithm* const filter : { static_cast<vtkAlgorithm*>(this->Preparation.Get()),
         static_cast<vtkAlgorithm*>(this->Normals.Get()),
         static_cast<vtkAlgorithm*>(this->Tensor.Get()) })
  {
    filter->ReleaseDataFlagOn();
  }
  this->Watch(this->Preparation, "prepare");
  this->Watch(this->Normals, "prepare");
  this->Watch(this->Tensor, "curvature");
  this->Watch(this->Refinement, "prepare");
  this->Watch(this->ShadedOrder, "prepare");
  this->Watch(this->RefinedNormals, "prepare");
  this->Watch(this->Lines, "lines");
}

SurfacePipeline::~SurfacePipeline()
{
  // Who keeps the mapper of the surface keeps the filters.
  for (const auto& [filter, tag] : this->Observers)
  {
    filter->RemoveObserver(tag);
  }
}

//------------------------------------------------------------------------------
void SurfacePipeline::SetInputConnection(vtkAlgorithmOutput* surface)
{
  this->Preparation->SetInputConnection(surface);
}

//------------------------------------------------------------------------------
void SurfacePipeline::Tune(const GeometryStyle& geometry, double unit, bool refine)
{
  this->Preparation->SetCreaseAngle(geometry.CreaseAngle);
  this->Preparation->SetWeldTolerance(0.0);
  this->Preparation->Update();
  if (this->Preparation->GetNumberOfBoundaryEdges() > 0)
  {
    // Perhaps a seam whose two sides were computed in two ways; looking for that takes longer.
    this->Preparation->SetWeldTolerance(SeamTolerance);
    this->Preparation->Update();
  }
  const double scale = this->GetLengthScale();
  const double unitOfScale = scale > 0.0 ? unit / scale : 0.0;
  const Tessellation tessellation = MeasureTessellation(this->Preparation->GetOutput());
  // Where triangles are slivers, as those of CAD programs, whose points are exact but stand only
  // where the surface bends, a fit to the points around mixes faces that have nothing in common.
  this->Tensor->SetEstimator(!geometry.Estimator.empty()
      ? vtkNPRCurvatureTensor::FindEstimator(geometry.Estimator.c_str())
      : tessellation.Quality < LeastQuality ? vtkNPRCurvatureTensor::PER_FACE
                                            : vtkNPRCurvatureTensor::JETS);
  // What is a detail, and what is noise, is a matter of the page, as for the smoothing.
  const double details = RadiusOfSmoothing * geometry.Smoothing * unit;
  this->Tensor->SetNeighbourhoodRadius(
    details > LeastRadius * tessellation.MeanEdge ? details / tessellation.MeanEdge : LeastRadius);
  this->Tensor->SetSmoothingRadius(geometry.Smoothing * unitOfScale);
  this->Refinement->SetMaximumEdgeLength(geometry.Refinement * unitOfScale);
  this->Refinement->SetMaximumChordError(ChordError * geometry.Refinement * unitOfScale);
  const bool refined = refine && geometry.Refinement * unitOfScale > 0.0;
  this->Refinement->SetNumberOfLevels(refined ? -1 : 0);

  this->Faceted = !refine && tessellation.MeanEdge > geometry.Refinement * unit;
  if (this->Faceted)
  {
    // Each facet is a patch of its own, so contours run along the edges between them.
    this->Preparation->SetCreaseAngle(0.0);
  }
}

//------------------------------------------------------------------------------
vtkAlgorithmOutput* SurfacePipeline::GetSurfacePort()
{
  return this->Refinement->GetOutputPort();
}

//------------------------------------------------------------------------------
vtkAlgorithmOutput* SurfacePipeline::GetShadedPort()
{
  return this->ShadedOrder->GetOutputPort();
}

//------------------------------------------------------------------------------
double SurfacePipeline::GetLengthScale()
{
  return npr::GetLengthScale(this->Preparation->GetOutput());
}

//------------------------------------------------------------------------------
bool SurfacePipeline::ShowsOnlyFronts()
{
  this->Refinement->Update();
  vtkPolyData* const surface = this->Refinement->GetOutput();
  if (this->TimeOfFronts != surface->GetMTime())
  {
    this->TimeOfFronts = surface->GetMTime();
    this->OnlyFronts =
      this->Preparation->GetNumberOfBoundaryEdges() == 0 && npr::ShowsOnlyFronts(surface);
  }
  return this->OnlyFronts;
}

//------------------------------------------------------------------------------
void SurfacePipeline::SkipCurvature()
{
  this->Refinement->SetInputConnection(this->Normals->GetOutputPort());
}

//------------------------------------------------------------------------------
void SurfacePipeline::Update()
{
  if (this->Refinement->GetInputAlgorithm() == this->Tensor.Get())
  {
    this->RefinedNormals->Update();
  }
  else
  {
    this->Refinement->Update();
  }
}

//------------------------------------------------------------------------------
double SurfacePipeline::GetSeconds(const std::string& stage) const
{
  const auto found = this->Seconds.find(stage);
  return found == this->Seconds.end() ? 0.0 : found->second;
}

//------------------------------------------------------------------------------
void SurfacePipeline::Watch(vtkAlgorithm* filter, const std::string& stage)
{
  this->Stages[filter] = stage;
  const auto observe = [&](unsigned long event, auto method)
  { this->Observers.emplace_back(filter, filter->AddObserver(event, this, method)); };
  observe(vtkCommand::StartEvent, &SurfacePipeline::OnStart);
  observe(vtkCommand::EndEvent, &SurfacePipeline::OnEnd);
  observe(vtkCommand::ProgressEvent, &SurfacePipeline::OnProgress);
}

//------------------------------------------------------------------------------
void SurfacePipeline::OnStart(vtkObject*, unsigned long, void*)
{
  this->StartTime = vtkTimerLog::GetUniversalTime();
}

//------------------------------------------------------------------------------
void SurfacePipeline::OnEnd(vtkObject* filter, unsigned long, void*)
{
  this->Seconds[this->Stages[filter]] += vtkTimerLog::GetUniversalTime() - this->StartTime;
}

//------------------------------------------------------------------------------
void SurfacePipeline::OnProgress(vtkObject* filter, unsigned long, void* data)
{
  if (this->Progress && data)
  {
    const auto place = std::find_if(this->Observers.begin(), this->Observers.end(),
      [&](const auto& observer) { return observer.first.Get() == filter; });
    const auto before = static_cast<double>(place - this->Observers.begin());
    this->Progress(
      (before + EventsPerFilter * *static_cast<double*>(data)) / this->Observers.size());
  }
}
}
