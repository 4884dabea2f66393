// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCurvatureOptions.h"

#include "nprArrayNames.h"
#include "nprReporter.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace npr
{
namespace
{
constexpr double SeamTolerance = 1e-6; // of the length scale: the rounding of floats

/// Empty for a radius that can be taken, else why not. What is no number passes no comparison.
std::string CheckRadius(const std::string& text)
{
  char* end = nullptr;
  const double radius = std::strtod(text.c_str(), &end);
  const bool isNumber = !text.empty() && *end == '\0';
  return isNumber && (radius == 0.0 || (radius >= 1.5 && radius <= 40.0))
    ? ""
    : "'" + text + "' is neither 0 nor a number from 1.5 to 40";
}
}

//------------------------------------------------------------------------------
CurvatureOptions::CurvatureOptions()
{
  vtkNew<vtkNPRCurvatureTensor> usual;
  this->Estimator = vtkNPRCurvatureTensor::GetEstimatorName(usual->GetEstimator());
}

//------------------------------------------------------------------------------
void CurvatureOptions::AddTo(CLI::App& command)
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++i)
  {
    names.emplace_back(vtkNPRCurvatureTensor::GetEstimatorName(i));
  }
  command.add_option("--estimator", this->Estimator, "How curvature is estimated")
    ->check(CLI::IsMember(names))
    ->capture_default_str();
  command
    .add_option("--radius", this->Radius,
      "How far the estimate looks, in mean edges, 1.5 to 40; 0 chooses by the noise of the "
      "surface. per-face ignores it: always one ring")
    ->check(CheckRadius, "0 or 1.5 to 40")
    ->capture_default_str();
  command
    .add_option("--smoothing", this->Smoothing,
      "Smooth the curvature over this distance, as a fraction of the model's length scale")
    ->check(CLI::Range(0.0, 1.0))
    ->capture_default_str();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> CurvatureOptions::Compute(
  vtkNPRSurfacePreparation* preparation, vtkPolyData* model, Reporter& reporter) const
{
  reporter.BeginStage("prepare");
  Prepare(preparation, model, reporter);
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(preparation->GetOutput());
  surface->GetPointData()->SetNormals(nullptr);
  surface->GetPointData()->RemoveArray(names::Normals);
  // Of the estimate that a file of ours was written with.
  surface->GetFieldData()->RemoveArray(names::NeighbourhoodRadius);

  reporter.BeginStage("curvature");
  vtkNew<vtkNPRCurvatureTensor> tensor;
  reporter.Watch(tensor, "estimating");
  tensor->SetInputData(surface);
  tensor->SetEstimator(vtkNPRCurvatureTensor::FindEstimator(this->Estimator.c_str()));
  tensor->SetNeighbourhoodRadius(this->Radius);
  tensor->SetSmoothingRadius(this->Smoothing);
  tensor->OutputShapeIndexOn();
  tensor->OutputCurvednessOn();
  tensor->OutputPointAreaOn();
  tensor->Update();
  reporter.EndStage();
  reporter.ClearProgress();
  reporter.ThrowOnVTKError(InputError);
  return tensor->GetOutput();
}

//------------------------------------------------------------------------------
void CurvatureOptions::Print(vtkPolyData* surface) const
{
  std::printf("%-14s %s", "estimator", this->Estimator.c_str());
  vtkDataArray* radius = surface->GetFieldData()->GetArray(names::NeighbourhoodRadius);
  if (radius && radius->GetNumberOfTuples() > 0)
  {
    std::printf(", over %.3g mean edges", radius->GetTuple1(0));
  }
  if (this->Smoothing > 0.0)
  {
    std::printf(", smoothed over %g of the length scale", this->Smoothing);
  }
  std::printf("\n");
}

//------------------------------------------------------------------------------
void Prepare(vtkNPRSurfacePreparation* preparation, vtkPolyData* model, Reporter& reporter)
{
  reporter.Watch(preparation, "preparing");
  preparation->SetInputData(model);
  preparation->Update();
  if (preparation->GetNumberOfBoundaryEdges() > 0)
  {
    // Looking for points that are nearly in one place takes longer.
    preparation->SetWeldTolerance(SeamTolerance);
    preparation->Update();
  }
  reporter.ClearProgress();
  reporter.ThrowOnVTKError(InputError);
}
}
