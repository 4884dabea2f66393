// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRFeatureLines.h"

#include "nprArrayNames.h"
#include "nprGhostLevels.h"
#include "nprLineView.h"
#include "nprProgress.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRFeatureLinesInternals.h"
#include "vtkNPRLineDefinition.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include <Eigen/Core>

vtkStandardNewMacro(vtkNPRFeatureLines);
vtkCxxSetSmartPointerMacro(vtkNPRFeatureLines, Camera, vtkCamera);
vtkCxxSetSmartPointerMacro(vtkNPRFeatureLines, Matrix, vtkMatrix4x4);

namespace
{
Eigen::Matrix4d GetModelToWorld(vtkMatrix4x4* matrix)
{
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  if (matrix)
  {
    result = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(matrix->GetData());
  }
  return result;
}

// The names of the arrays of numbers, for a message.
std::string DescribeArrays(vtkDataSetAttributes* attributes, const std::string& kind)
{
  std::string names;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (array && array->GetName())
    {
      names += (names.empty() ? "" : ", ") + std::string(array->GetName());
    }
  }
  return names.empty() ? "it has no " + kind + " arrays of numbers."
                       : "its " + kind + " arrays are: " + names + ".";
}
}

//------------------------------------------------------------------------------
vtkNPRFeatureLines::vtkNPRFeatureLines() : Internal(new Internals) {}

//------------------------------------------------------------------------------
vtkNPRFeatureLines::~vtkNPRFeatureLines() = default;

//------------------------------------------------------------------------------
vtkCamera* vtkNPRFeatureLines::GetCamera() const
{
  return this->Camera;
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkNPRFeatureLines::GetMatrix() const
{
  return this->Matrix;
}

//------------------------------------------------------------------------------
void vtkNPRFeatureLines::AddDefinition(vtkNPRLineDefinition* definition)
{
  if (!definition)
  {
    vtkErrorMacro("AddDefinition was given no definition.");
    return;
  }
  this->Internal->Entries.emplace_back();
  this->Internal->Entries.back().Definition = definition;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkNPRLineDefinition* vtkNPRFeatureLines::AddDefinition(const char* name)
{
  auto definition = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(name));
  if (!definition)
  {
    std::string known;
    for (int i = 0; i < vtkNPRLineDefinition::GetNumberOfLineNames(); ++i)
    {
      known += std::string(i > 0 ? ", " : "") + vtkNPRLineDefinition::GetLineName(i);
    }
    vtkErrorMacro(
      "There are no lines named \"" << (name ? name : "") << "\"; there are: " << known << ".");
    return nullptr;
  }
  this->AddDefinition(definition);
  return definition;
}

//------------------------------------------------------------------------------
void vtkNPRFeatureLines::RemoveAllDefinitions()
{
  if (!this->Internal->Entries.empty())
  {
    this->Internal->Entries.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkNPRFeatureLines::GetNumberOfDefinitions() const
{
  return static_cast<int>(this->Internal->Entries.size());
}

//------------------------------------------------------------------------------
vtkNPRLineDefinition* vtkNPRFeatureLines::GetDefinition(int index) const
{
  return index < 0 || index >= this->GetNumberOfDefinitions()
    ? nullptr
    : this->Internal->Entries[index].Definition.Get();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkNPRFeatureLines::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Camera)
  {
    time = std::max(time, this->Camera->GetMTime());
  }
  if (this->Matrix)
  {
    time = std::max(time, this->Matrix->GetMTime());
  }
  for (const Internals::Entry& entry : this->Internal->Entries)
  {
    time = std::max(time, entry.Definition->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
// All that no view changes. False, after an error, when an array is missing.
bool vtkNPRFeatureLines::PrepareSurface(vtkPolyData* input)
{
  Internals& internal = *this->Internal;
  const Internals::StageTimer timer(internal, PREPARE);
  const bool isNew = !internal.Surface || internal.Input != input ||
    internal.InputMTime != input->GetMTime() || internal.LengthScale != this->LengthScale;
  if (isNew)
  {
    internal.SetSurface(input, this->LengthScale);
  }
  npr::LineSurface& surface = *internal.Surface;
  for (Internals::Entry& entry : internal.Entries)
  {
    const vtkNPRLineDefinition& definition = *entry.Definition;
    entry.Definition->BindInput(input);
    for (const auto& required : definition.GetRequiredArrays())
    {
      if (surface.LoadArray(input, required.Name, required.Components))
      {
        continue;
      }
      if (!required.Maker)
      {
        vtkErrorMacro("The lines \"" << definition.GetName() << "\" need a point array, but the "
                                     << "input has none named \"" << required.Name << "\"; "
                                     << DescribeArrays(input->GetPointData(), "point"));
      }
      else
      {
        vtkErrorMacro("The lines \"" << definition.GetName() << "\" need the point array \""
                                     << required.Name << "\" with " << required.Components
                                     << " component(s), which the input does not have. Put "
                                     << required.Maker
                                     << " before this filter, or let it do so itself by "
                                        "ComputeMissingArraysOn.");
      }
      internal.Surface.reset();
      return false;
    }
    const char* const regions = definition.GetRequiredCellArray();
    if (regions && !surface.LoadRegions(input, regions))
    {
      vtkErrorMacro("The lines \"" << definition.GetName() << "\" need the cell array \"" << regions
                                   << "\", which the input does not have. Name another one; "
                                   << DescribeArrays(input->GetCellData(), "cell"));
      internal.Surface.reset();
      return false;
    }
  }
  for (const Internals::Entry& entry : internal.Entries)
  {
    for (const auto& array : entry.Definition->GetSlopeArrays())
    {
      if (this->Interpolation == HERMITE)
      {
        surface.LoadArray(input, array.Name, array.Components);
      }
    }
  }
  // Normals of lines are welcome, but creases and boundaries do without.
  surface.LoadArray(input, npr::names::Normals, 3);
  internal.SetClusters(isNew);

  const npr::LineOptions options = this->GetOptions();
  const bool isStaticNew = options.UseSlopes != internal.Options.UseSlopes ||
    this->OutputSources != internal.OutputSources;
  internal.Options = options;
  internal.OutputSources = this->OutputSources;
  for (Internals::Entry& entry : internal.Entries)
  {
    if (entry.Extractor && entry.MTime == entry.Definition->GetMTime() && !isStaticNew)
    {
      continue;
    }
    const std::string error = entry.Definition->FindError(surface);
    if (!error.empty())
    {
      vtkErrorMacro("The lines \"" << entry.Definition->GetName() << "\": " << error << ".");
      internal.Surface.reset();
      return false;
    }
    if (entry.Definition->GetEdges() == vtkNPRLineDefinition::AllEdges)
    {
      surface.BuildInnerEdges();
    }
    if (entry.Definition->IsMaximum())
    {
      surface.BuildNeighbours();
    }
    entry.Extractor =
      std::make_unique<npr::LineExtractor>(surface, *internal.Clusters, *entry.Definition);
    entry.MTime = entry.Definition->GetMTime();
    entry.IsExtracted = false;
  }
  return true;
}

//------------------------------------------------------------------------------
npr::LineOptions vtkNPRFeatureLines::GetOptions() const
{
  npr::LineOptions options;
  options.Strategy = this->Strategy == FULL_TRAVERSAL ? npr::LineStrategy::Full
    : this->Strategy == RANDOM_SEEDS                  ? npr::LineStrategy::Random
                                                      : npr::LineStrategy::Hierarchical;
  options.UseSlopes = this->Interpolation == HERMITE;
  options.SeedShare = this->SeedShare;
  return options;
}

//------------------------------------------------------------------------------
const char* vtkNPRFeatureLines::GetStageName(int stage)
{
  static const std::array<const char*, NumberOfStages> names = { "prepare", "extract", "join",
    "place", "write" };
  return stage >= 0 && stage < NumberOfStages ? names[stage] : nullptr;
}

//------------------------------------------------------------------------------
double vtkNPRFeatureLines::GetStageSeconds(int stage) const
{
  return stage >= 0 && stage < NumberOfStages ? this->Internal->StageSeconds[stage] : 0.0;
}

//------------------------------------------------------------------------------
int vtkNPRFeatureLines::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The triangles around those of the piece, and as many more as definitions need.
  double rings = 1.0;
  for (const Internals::Entry& entry : this->Internal->Entries)
  {
    rings = std::max(rings, std::ceil(entry.Definition->GetReach()));
  }
  npr::RequestGhostLevels(inputVector[0]->GetInformationObject(0),
    outputVector->GetInformationObject(0), static_cast<int>(std::min(rings, 1000.0)));
  return 1;
}

//------------------------------------------------------------------------------
// The input, or if wanted what the curvature filter makes of it where arrays are missing.
vtkPolyData* vtkNPRFeatureLines::GetSurface(vtkPolyData* input)
{
  Internals& internal = *this->Internal;
  if (!this->ComputeMissingArrays)
  {
    return input;
  }
  const bool isMissing = std::any_of(internal.Entries.begin(), internal.Entries.end(),
    [input](const Internals::Entry& entry)
    {
      const auto required = entry.Definition->GetRequiredArrays();
      return std::any_of(required.begin(), required.end(),
        [input](const auto& array) { return !input->GetPointData()->HasArray(array.Name); });
    });
  if (!isMissing)
  {
    return input;
  }
  if (!internal.Curvature || internal.CurvatureInput != input ||
    internal.CurvatureInputMTime != input->GetMTime())
  {
    vtkNew<vtkNPRCurvatureTensor> curvature;
    vtkNew<vtkPolyData> surface;
    surface->ShallowCopy(input);
    curvature->SetInputData(surface);
    curvature->Update();
    internal.Curvature = curvature->GetOutput();
    internal.CurvatureInput = input;
    internal.CurvatureInputMTime = input->GetMTime();
  }
  return internal.Curvature;
}

//------------------------------------------------------------------------------
int vtkNPRFeatureLines::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  Internals& internal = *this->Internal;
  internal.StageSeconds.fill(0.0);
  if (internal.Entries.empty())
  {
    vtkErrorMacro("No lines to extract: call AddDefinition, for example with \"contours\".");
    return 0;
  }
  vtkNew<vtkStringArray> lineNames;
  lineNames->SetName(npr::names::LineTypeNames);
  bool needsCamera = this->MinimumLength > 0.0;
  for (const Internals::Entry& entry : internal.Entries)
  {
    lineNames->InsertNextValue(entry.Definition->GetName());
    needsCamera = needsCamera || entry.Definition->IsViewDependent();
  }
  output->GetFieldData()->AddArray(lineNames);
  if (needsCamera && !this->Camera)
  {
    vtkErrorMacro(
      "Lines that depend on the view, and MinimumLength, need a camera: call SetCamera.");
    return 0;
  }
  if (input->GetNumberOfPoints() == 0 || input->GetNumberOfPolys() == 0)
  {
    npr::LineOutput().Write(output);
    return 1;
  }
  if (!this->PrepareSurface(this->GetSurface(input)))
  {
    return 0;
  }
  this->UpdateProgress(0.5);

  const Eigen::Vector3d& origin = internal.Surface->GetMesh().GetOrigin();
  const Eigen::Matrix4d modelToWorld = GetModelToWorld(this->Matrix);
  npr::LineView view;
  std::unique_ptr<npr::LineRuler> ruler;
  if (this->Camera)
  {
    if (!npr::MakeLineView(this->Camera, modelToWorld, origin, view))
    {
      vtkErrorMacro(
        "The prop's matrix has no inverse, so the eye has no place in the model: give it a "
        "scale that is not 0.");
      return 0;
    }
    ruler = std::make_unique<npr::LineRuler>(this->Camera, modelToWorld, origin);
  }

  npr::LineOutput& lines = internal.Output;
  lines.Begin(origin,
    { this->MinimumLength, static_cast<float>(this->MinimumStrength), this->Hysteresis,
      ruler.get() });
  // First those that no view changes, so that they stay where they are.
  std::vector<Internals::Entry*> entries;
  for (const bool moves : { false, true })
  {
    for (Internals::Entry& entry : internal.Entries)
    {
      if (entry.Definition->IsViewDependent() == moves)
      {
        entries.push_back(&entry);
      }
    }
  }
  std::size_t done = 0;
  while (done < entries.size() && !npr::IsAborted(this))
  {
    const std::size_t first = done;
    done = std::min(first + internal.Benches.size(), entries.size());
    std::vector<Internals::Entry*> changed;
    std::copy_if(entries.begin() + first, entries.begin() + done, std::back_inserter(changed),
      [](const Internals::Entry* entry)
      { return entry->Definition->IsViewDependent() || !entry->IsExtracted; });
    internal.Extract(changed, view);
    internal.Add({ entries.begin() + first, entries.begin() + done }, changed);
    this->UpdateProgress(0.5 + 0.5 * static_cast<double>(done) / entries.size());
  }
  const Internals::StageTimer timer(internal, WRITE);
  lines.Write(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRFeatureLines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "Matrix: " << this->Matrix.Get() << "\n";
  os << indent << "LengthScale: " << this->LengthScale << "\n";
  os << indent << "MinimumLength: " << this->MinimumLength << "\n";
  os << indent << "MinimumStrength: " << this->MinimumStrength << "\n";
  os << indent << "Hysteresis: " << this->Hysteresis << "\n";
  os << indent << "Strategy: " << this->Strategy << "\n";
  os << indent << "SeedShare: " << this->SeedShare << "\n";
  os << indent << "Interpolation: " << this->Interpolation << "\n";
  os << indent << "ComputeMissingArrays: " << this->ComputeMissingArrays << "\n";
  os << indent << "OutputSources: " << this->OutputSources << "\n";
  os << indent << "Definitions: " << this->GetNumberOfDefinitions() << "\n";
  for (const Internals::Entry& entry : this->Internal->Entries)
  {
    entry.Definition->PrintSelf(os, indent.GetNextIndent());
  }
}
