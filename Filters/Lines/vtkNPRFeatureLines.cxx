// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRFeatureLines.h"

#include "nprArrayNames.h"
#include "nprGhostLevels.h"
#include "nprLengthScale.h"
#include "nprLineView.h"
#include "nprProgress.h"
#include "vtkNPRFeatureLinesInternals.h"
#include "vtkNPRLineDefinition.h"

#include <vtkCamera.h>
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
void vtkNPRFeatureLines::AddQuantity(const char* name)
{
  if (!name || !*name)
  {
    vtkErrorMacro("AddQuantity was given no name.");
    return;
  }
  const auto& own = npr::LineOutput::GetOwnArrays();
  if (std::find(own.begin(), own.end(), std::string(name)) != own.end())
  {
    vtkErrorMacro("Lines have an array \"" << name << "\" of their own; they can not carry "
                                           << "another one of that name.");
    return;
  }
  this->Internal->Quantities.emplace_back(name);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkNPRFeatureLines::RemoveAllQuantities()
{
  if (!this->Internal->Quantities.empty())
  {
    this->Internal->Quantities.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkNPRFeatureLines::GetNumberOfQuantities() const
{
  return static_cast<int>(this->Internal->Quantities.size());
}

//------------------------------------------------------------------------------
const char* vtkNPRFeatureLines::GetQuantity(int index) const
{
  return index < 0 || index >= this->GetNumberOfQuantities()
    ? nullptr
    : this->Internal->Quantities[index].GetName().c_str();
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
npr::LineOptions vtkNPRFeatureLines::GetOptions() const
{
  npr::LineOptions options;
  options.Strategy = this->Strategy == FULL_TRAVERSAL ? npr::LineStrategy::Full
    : this->Strategy == RANDOM_SEEDS                  ? npr::LineStrategy::Random
                                                      : npr::LineStrategy::Hierarchical;
  options.UseSlopes = this->Interpolation == HERMITE;
  options.KeepsDoubtful = this->KeepDoubtful;
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
  for (const npr::LineQuantity& quantity : internal.Quantities)
  {
    needsCamera = needsCamera || quantity.IsViewDependent();
  }
  output->GetFieldData()->AddArray(lineNames);
  if (needsCamera && !this->Camera)
  {
    vtkErrorMacro("Lines and quantities that depend on the view, and MinimumLength, need a camera: "
                  "call SetCamera.");
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
  lines.WriteQuantities(*internal.Surface, view, internal.Quantities, output);
  npr::SetLengthScale(output, internal.Surface->GetLengthScale());
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
  os << indent << "KeepDoubtful: " << this->KeepDoubtful << "\n";
  os << indent << "ComputeMissingArrays: " << this->ComputeMissingArrays << "\n";
  os << indent << "OutputSources: " << this->OutputSources << "\n";
  os << indent << "Definitions: " << this->GetNumberOfDefinitions() << "\n";
  for (const Internals::Entry& entry : this->Internal->Entries)
  {
    entry.Definition->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "Quantities:";
  for (const npr::LineQuantity& quantity : this->Internal->Quantities)
  {
    os << " " << quantity.GetName();
  }
  os << "\n";
}
