// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprViewOptions.h"

#include "nprReporter.h"
#include "nprTriangleArea.h"
#include "vtkNPRModelImporter.h"
#include "vtkNPRSampleSource.h"
#include "vtkNPRViewpoint.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
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

std::array<double, 3> MakeAxis(int axis)
{
  std::array<double, 3> vector = { 0.0, 0.0, 0.0 };
  vector[axis] = 1.0;
  return vector;
}

std::array<double, 3> ParsePoint(
  const std::string& option, const std::string& text, const char* form = "X,Y,Z")
{
  const std::vector<double> numbers = ParseNumbers(option, text, 3, form);
  return { numbers[0], numbers[1], numbers[2] };
}

void CheckDirections(const std::array<double, 3>& eye, const std::array<double, 3>& target,
  const std::optional<std::array<double, 3>>& up)
{
  double direction[3];
  vtkMath::Subtract(target.data(), eye.data(), direction);
  if (vtkMath::Norm(direction) == 0.0)
  {
    throw CommandError(UsageError, "--eye and --target must differ");
  }
  if (!up)
  {
    return;
  }
  double side[3];
  vtkMath::Cross(direction, up->data(), side);
  if (vtkMath::Norm(side) <= 1e-9 * vtkMath::Norm(direction) * vtkMath::Norm(up->data()))
  {
    throw CommandError(
      UsageError, "--up must not point along the view from --eye to --target; turn one of them");
  }
}

void ApplyEye(vtkRenderer* renderer, const ViewSpecification& view, const std::array<double, 3>& up)
{
  const std::array<double, 3>& eye = *view.Eye;
  std::array<double, 3> target;
  if (view.Target)
  {
    target = *view.Target;
  }
  else
  {
    double bounds[6];
    renderer->ComputeVisiblePropBounds(bounds);
    for (int i = 0; i < 3; ++i)
    {
      target[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    }
  }
  CheckDirections(eye, target, up);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(target.data());
  camera->SetViewUp(up.data());
  if (view.IsParallel)
  {
    // As large as the same viewer would see it in perspective.
    camera->ParallelProjectionOn();
    camera->SetParallelScale(
      camera->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())));
  }
  renderer->ResetCameraClippingRange();
}
}

//------------------------------------------------------------------------------
void AddSample(vtkRenderer* renderer)
{
  vtkNew<vtkNPRSampleSource> sample;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sample->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
std::vector<std::string> SplitList(const std::string& text)
{
  std::vector<std::string> parts;
  std::stringstream stream(text);
  std::string part;
  while (std::getline(stream, part, ','))
  {
    const std::size_t first = part.find_first_not_of(" \t");
    if (first != std::string::npos)
    {
      parts.push_back(part.substr(first, part.find_last_not_of(" \t") - first + 1));
    }
  }
  return parts;
}

//------------------------------------------------------------------------------
void ModelOptions::AddReadingTo(CLI::App& command)
{
  command.add_option("--iso", this->IsoValue, "The value of the surface to take from a volume");
  command
    .add_option("--volume-smoothing", this->VolumeSmoothing,
      "How far a volume is smoothed before the surface is taken, in voxels; 0 for not at all")
    ->check(CLI::Range(0.0, 10.0))
    ->capture_default_str();
}

//------------------------------------------------------------------------------
CLI::Option* ModelOptions::AddTo(CLI::App& command)
{
  this->AddReadingTo(command);
  return command
    .add_option("MODEL", this->Files, "Model files; npr info --formats lists what is read")
    ->required();
}

//------------------------------------------------------------------------------
void ModelOptions::AddWithSampleTo(CLI::App& command, const std::string& description)
{
  this->AddTo(command)->required(false);
  command.add_flag("--sample", this->Sample, description);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkNPRModelImporter> ModelOptions::Read(
  const std::string& file, Reporter& reporter) const
{
  auto importer = vtkSmartPointer<vtkNPRModelImporter>::New();
  reporter.Watch(importer, "reading " + file);
  importer->SetFileName(file.c_str());
  if (this->IsoValue)
  {
    importer->SetIsoValue(*this->IsoValue);
  }
  importer->SetVolumeSmoothing(this->VolumeSmoothing);
  const bool good = importer->Read();
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
  return importer;
}

//------------------------------------------------------------------------------
void ModelOptions::Import(vtkRenderer* renderer, Reporter& reporter) const
{
  if (this->Sample)
  {
    AddSample(renderer);
  }
  for (const std::string& file : this->Files)
  {
    const auto importer = this->Read(file, reporter);
    vtkNew<vtkPolyData> surface;
    importer->GetSurface(surface);
    CheckArea(file, surface);
    importer->ImportInto(renderer);
  }
}

//------------------------------------------------------------------------------
void CheckArea(const std::string& file, vtkPolyData* surface)
{
  if (!HasArea(surface))
  {
    throw CommandError(InputError,
      file + ": none of its " + std::to_string(surface->GetNumberOfCells()) +
        " polygons has an area, so there is nothing to draw; export it again (npr info says what "
        "is in it)");
  }
}

//------------------------------------------------------------------------------
int ModelOptions::GetUpAxis() const
{
  constexpr int usual = 1;
  std::optional<int> common;
  for (const std::string& file : this->Files)
  {
    vtkNew<vtkNPRModelImporter> importer; // knows it by the name alone
    importer->SetFileName(file.c_str());
    if (common.value_or(importer->GetUpAxis()) != importer->GetUpAxis())
    {
      return usual;
    }
    common = importer->GetUpAxis();
  }
  return common.value_or(usual);
}

//------------------------------------------------------------------------------
double ModelOptions::GetFrontAzimuth() const
{
  if (this->Files.empty())
  {
    return 0.0;
  }
  vtkNew<vtkNPRModelImporter> importer;
  importer->SetFileName(this->Files.front().c_str());
  return importer->GetFrontAzimuth();
}

//------------------------------------------------------------------------------
void ViewOptions::AddTo(CLI::App& command)
{
  command.add_option("--size", this->Size, "Size of the image in pixels, WxH")
    ->capture_default_str();
  this->GivenView =
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
    "Which way is up, also for the heights of topographic lines: x, y, z, or with --eye a vector "
    "X,Y,Z; default: z if all models are STL, NIfTI, NRRD or MetaImage, else y");
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
ViewSpecification ViewOptions::Parse() const
{
  ViewSpecification view;
  view.IsParallel = this->Projection == "parallel";
  const std::string axes = "xyz";
  if (this->Up.size() == 1 && axes.find(this->Up) != std::string::npos)
  {
    view.UpAxis = static_cast<int>(axes.find(this->Up));
  }
  else if (!this->Up.empty() && this->Eye.empty())
  {
    throw CommandError(UsageError, "--up '" + this->Up + "': without --eye, write x, y or z");
  }
  else if (!this->Up.empty())
  {
    view.Up = ParsePoint("--up", this->Up, "x, y, z, or X,Y,Z");
  }

  if (this->Eye.empty())
  {
    const std::vector<std::string> names = vtkNPRViewpoint::GetViewNames();
    if (std::find(names.begin(), names.end(), this->View) != names.end())
    {
      view.Name = this->View;
    }
    else
    {
      const std::vector<double> angles = ParseNumbers("--view", this->View, 2,
        "front, back, left, right, top, bottom, three-quarter, or AZIMUTH,ELEVATION in degrees");
      view.Azimuth = angles[0];
      view.Elevation = angles[1];
    }
    return view;
  }

  if (this->GivenView && this->GivenView->count() > 0)
  {
    throw CommandError(UsageError,
      "--view and --eye both say where the viewer stands; leave out one of them (--target says "
      "where someone at --eye looks)");
  }
  view.Eye = ParsePoint("--eye", this->Eye);
  if (view.UpAxis)
  {
    view.Up = MakeAxis(*view.UpAxis);
  }
  if (view.Up && vtkMath::Norm(view.Up->data()) == 0.0)
  {
    throw CommandError(UsageError, "--up '" + this->Up + "': write a vector that is not zero");
  }
  if (!this->Target.empty())
  {
    view.Target = ParsePoint("--target", this->Target);
    CheckDirections(*view.Eye, *view.Target, view.Up);
  }
  return view;
}

//------------------------------------------------------------------------------
std::array<double, 3> ViewOptions::GetUp(const ModelOptions& models) const
{
  const ViewSpecification view = this->Parse();
  return view.Up.value_or(MakeAxis(view.UpAxis.value_or(models.GetUpAxis())));
}

//------------------------------------------------------------------------------
void ViewOptions::Apply(vtkRenderer* renderer, const ModelOptions& models) const
{
  const ViewSpecification view = this->Parse();
  if (view.Eye)
  {
    ApplyEye(renderer, view, this->GetUp(models));
    return;
  }
  vtkNew<vtkNPRViewpoint> viewpoint;
  viewpoint->SetParallelProjection(view.IsParallel);
  viewpoint->SetUpAxis(view.UpAxis.value_or(models.GetUpAxis()));
  if (view.Name.empty())
  {
    viewpoint->SetAzimuth(view.Azimuth);
    viewpoint->SetElevation(view.Elevation);
  }
  else
  {
    viewpoint->SetViewByName(view.Name);
  }
  viewpoint->SetAzimuth(viewpoint->GetAzimuth() + models.GetFrontAzimuth());
  viewpoint->Apply(renderer);
}
}
