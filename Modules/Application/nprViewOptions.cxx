// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprViewOptions.h"

#include "nprReporter.h"
#include "vtkNPRModelImporter.h"
#include "vtkNPRViewpoint.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace npr
{
namespace
{
/// Exactly as many finite numbers as asked for, separated by commas.
std::vector<double> ParseNumbers(
  const std::string& option, const std::string& text, std::size_t count, const char* form)
{
  std::vector<double> numbers;
  std::stringstream stream(text);
  std::string part;
  bool good = !text.empty() && text.back() != ',';
  while (good && std::getline(stream, part, ','))
  {
    char* end = nullptr;
    numbers.push_back(std::strtod(part.c_str(), &end));
    good = !part.empty() && *end == '\0' && std::isfinite(numbers.back());
  }
  if (!good || numbers.size() != count)
  {
    throw CommandError(UsageError, option + " '" + text + "': write " + form);
  }
  return numbers;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// CAD programs and medical images have Z up; most scans and scene formats have Y up.
int UsualUpAxis(const ModelOptions& models)
{
  for (const std::string& file : models.Files)
  {
    std::string name = file;
    std::transform(
      name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    for (const char* extension : { ".stl", ".nii", ".nii.gz" })
    {
      if (EndsWith(name, extension))
      {
        return 2;
      }
    }
  }
  return 1;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> SplitList(const std::string& text)
{
  std::vector<std::string> parts;
  std::stringstream stream(text);
  std::string part;
  while (std::getline(stream, part, ','))
  {
    if (!part.empty())
    {
      parts.push_back(part);
    }
  }
  return parts;
}

//------------------------------------------------------------------------------
CLI::Option* ModelOptions::AddTo(CLI::App& command)
{
  command.add_option("--iso", this->IsoValue, "The value of the surface to take from a volume");
  command
    .add_option("--volume-smoothing", this->VolumeSmoothing,
      "How far a volume is smoothed before the surface is taken, in voxels; 0 for not at all")
    ->check(CLI::Range(0.0, 10.0))
    ->capture_default_str();
  return command
    .add_option("MODEL", this->Files, "Model files; npr info --formats lists what is read")
    ->required();
}

//------------------------------------------------------------------------------
void ModelOptions::Import(vtkRenderer* renderer, Reporter& reporter) const
{
  for (const std::string& file : this->Files)
  {
    vtkNew<vtkNPRModelImporter> importer;
    reporter.Watch(importer, "reading " + file);
    importer->SetFileName(file.c_str());
    if (this->IsoValue)
    {
      importer->SetIsoValue(*this->IsoValue);
    }
    importer->SetVolumeSmoothing(this->VolumeSmoothing);
    const bool good = importer->ImportInto(renderer);
    reporter.ClearProgress();
    reporter.DropVTKErrors();
    if (!good)
    {
      throw CommandError(InputError, importer->GetErrorMessage());
    }
    if (importer->GetWarnings()[0] != '\0')
    {
      reporter.Warn(importer->GetWarnings());
    }
  }
}

//------------------------------------------------------------------------------
void ViewOptions::AddTo(CLI::App& command)
{
  command.add_option("--size", this->Size, "Size of the image in pixels, WxH")
    ->capture_default_str();
  command
    .add_option("--view", this->View,
      "front, back, left, right, top, bottom, three-quarter, or AZIMUTH,ELEVATION in degrees")
    ->capture_default_str();
  command.add_option("--projection", this->Projection, "perspective or parallel")
    ->check(CLI::IsMember({ "perspective", "parallel" }))
    ->capture_default_str();
  command.add_option("--eye", this->Eye, "Place of the viewer, X,Y,Z; instead of --view");
  command.add_option("--target", this->Target, "Point to look at, X,Y,Z; default: the middle")
    ->needs("--eye");
  command.add_option("--up", this->Up,
    "Which way is up: x, y, z, or with --eye a vector X,Y,Z; default: z for STL and NIfTI, else y");
}

//------------------------------------------------------------------------------
std::array<int, 2> ViewOptions::GetSize() const
{
  int width = 0;
  int height = 0;
  char rest = '\0';
  if (std::sscanf(this->Size.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 ||
    height < 1 || width > 16384 || height > 16384)
  {
    throw CommandError(
      UsageError, "--size '" + this->Size + "': write WIDTHxHEIGHT, each from 1 to 16384");
  }
  return { width, height };
}

//------------------------------------------------------------------------------
void ViewOptions::Apply(vtkRenderer* renderer, const ModelOptions& models) const
{
  vtkNew<vtkNPRViewpoint> viewpoint;
  viewpoint->SetParallelProjection(this->Projection == "parallel");
  const std::string axes = "xyz";
  const bool namedUp = this->Up.size() == 1 && axes.find(this->Up) != std::string::npos;
  const int upAxis = namedUp ? static_cast<int>(axes.find(this->Up)) : UsualUpAxis(models);
  viewpoint->SetUpAxis(upAxis);

  if (this->Eye.empty())
  {
    if (!this->Up.empty() && !namedUp)
    {
      throw CommandError(UsageError, "--up '" + this->Up + "': without --eye, write x, y or z");
    }
    const std::vector<std::string> names = vtkNPRViewpoint::GetViewNames();
    if (std::find(names.begin(), names.end(), this->View) != names.end())
    {
      viewpoint->SetViewByName(this->View);
    }
    else
    {
      const std::vector<double> angles = ParseNumbers("--view", this->View, 2,
        "front, back, left, right, top, bottom, three-quarter, or AZIMUTH,ELEVATION in degrees");
      viewpoint->SetAzimuth(angles[0]);
      viewpoint->SetElevation(angles[1]);
    }
    viewpoint->Apply(renderer);
    return;
  }

  const std::vector<double> eye = ParseNumbers("--eye", this->Eye, 3, "X,Y,Z");
  std::vector<double> up(3, 0.0);
  up[upAxis] = 1.0;
  if (!this->Up.empty() && !namedUp)
  {
    up = ParseNumbers("--up", this->Up, 3, "x, y, z, or X,Y,Z");
  }
  std::vector<double> target(3, 0.0);
  if (this->Target.empty())
  {
    double bounds[6];
    renderer->ComputeVisiblePropBounds(bounds);
    for (int i = 0; i < 3; ++i)
    {
      target[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    }
  }
  else
  {
    target = ParseNumbers("--target", this->Target, 3, "X,Y,Z");
  }
  double direction[3], side[3];
  vtkMath::Subtract(target.data(), eye.data(), direction);
  vtkMath::Cross(direction, up.data(), side);
  if (vtkMath::Norm(direction) == 0.0 ||
    vtkMath::Norm(side) <= 1e-9 * vtkMath::Norm(direction) * vtkMath::Norm(up.data()))
  {
    throw CommandError(
      UsageError, "--eye and --target must differ, and --up must not point along the view");
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(target.data());
  camera->SetViewUp(up.data());
  if (viewpoint->GetParallelProjection())
  {
    // As large as the same viewer would see it in perspective.
    camera->ParallelProjectionOn();
    camera->SetParallelScale(vtkMath::Norm(direction) *
      std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())));
  }
  renderer->ResetCameraClippingRange();
}
}
