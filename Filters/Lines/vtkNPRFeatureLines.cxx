// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRFeatureLines.h"

#include "nprArrayNames.h"
#include "nprLineChains.h"
#include "nprLineExtractor.h"
#include "nprLineSurface.h"
#include "nprLineView.h"
#include "vtkNPRLineDefinition.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
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

// Collects the chains of all definitions.
class Output
{
public:
  explicit Output(const Eigen::Vector3d& origin) : Origin(origin)
  {
    this->Points->SetDataTypeToDouble();
    this->Normals->SetName(npr::names::Normals);
    this->Normals->SetNumberOfComponents(3);
    this->Strength->SetName(npr::names::Strength);
    this->LineType->SetName(npr::names::LineType);
    this->LineLevel->SetName(npr::names::LineLevel);
  }

  void AddChain(const npr::LineChains& chains, std::size_t chain, int type, float level)
  {
    const std::size_t first = chains.Offsets[chain];
    const std::size_t last = chains.Offsets[chain + 1];
    const vtkIdType start = this->Points->GetNumberOfPoints();
    this->Lines->InsertNextCell(static_cast<int>(last - first + (chains.Closed[chain] ? 1 : 0)));
    for (std::size_t i = first; i < last; ++i)
    {
      const npr::LineVertex& vertex = chains.Vertices[i];
      const Eigen::Vector3d position = this->Origin + vertex.Position;
      this->Lines->InsertCellPoint(this->Points->InsertNextPoint(position.data()));
      this->Normals->InsertNextTypedTuple(vertex.Normal.data());
      this->Strength->InsertNextValue(vertex.Strength);
    }
    if (chains.Closed[chain])
    {
      this->Lines->InsertCellPoint(start);
    }
    this->LineType->InsertNextValue(type);
    this->LineLevel->InsertNextValue(level);
  }

  void Finish(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    output->SetLines(this->Lines);
    output->GetPointData()->SetNormals(this->Normals);
    output->GetPointData()->AddArray(this->Strength);
    output->GetCellData()->AddArray(this->LineType);
    output->GetCellData()->AddArray(this->LineLevel);
  }

private:
  const Eigen::Vector3d Origin;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkFloatArray> Strength;
  vtkNew<vtkIntArray> LineType;
  vtkNew<vtkFloatArray> LineLevel;
};
}

// The definitions, and what is kept from view to view.
class vtkNPRFeatureLines::Internals
{
public:
  struct Entry
  {
    vtkSmartPointer<vtkNPRLineDefinition> Definition;
    vtkMTimeType MTime = 0; // the definition's, when the rest was made
    std::unique_ptr<npr::LineExtractor> Extractor;
    std::vector<float> Levels;
    std::vector<npr::LineChains> Chains; // for each level, where no view changes them
    std::vector<npr::LineChains> Extract(
      const npr::LineView& view, const Eigen::Vector3d& origin) const
    {
      std::vector<npr::LineChains> chains;
      for (const float level : this->Levels)
      {
        chains.push_back(npr::JoinSegments(this->Extractor->Extract(view, level), origin));
      }
      return chains;
    }
  };
  std::vector<Entry> Entries;

  std::unique_ptr<npr::LineSurface> Surface;
  vtkSmartPointer<vtkPolyData> Input; // kept, so that no other can have its address
  vtkMTimeType InputMTime = 0;
  double LengthScale = 0.0;
};

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
  if (!internal.Surface || internal.Input != input || internal.InputMTime != input->GetMTime() ||
    internal.LengthScale != this->LengthScale)
  {
    for (Internals::Entry& entry : internal.Entries)
    {
      entry.Extractor.reset();
    }
    internal.Surface = std::make_unique<npr::LineSurface>(input, this->LengthScale);
    internal.Input = input;
    internal.InputMTime = input->GetMTime();
    internal.LengthScale = this->LengthScale;
  }
  npr::LineSurface& surface = *internal.Surface;

  for (Internals::Entry& entry : internal.Entries)
  {
    const vtkNPRLineDefinition& definition = *entry.Definition;
    for (const auto& required : definition.GetRequiredArrays())
    {
      if (!surface.LoadArray(input, required.Name, required.Components))
      {
        vtkErrorMacro("The lines \"" << definition.GetName() << "\" need the point array \""
                                     << required.Name << "\" with " << required.Components
                                     << " component(s), which the input does not have. Put "
                                     << required.Maker << " before this filter.");
        return false;
      }
    }
  }
  // Normals of lines are welcome, but creases and boundaries do without.
  surface.LoadArray(input, npr::names::Normals, 3);

  for (Internals::Entry& entry : internal.Entries)
  {
    if (entry.Extractor && entry.MTime == entry.Definition->GetMTime())
    {
      continue;
    }
    if (entry.Definition->GetEdges() == vtkNPRLineDefinition::AllEdges)
    {
      surface.BuildInnerEdges();
    }
    entry.Extractor = std::make_unique<npr::LineExtractor>(surface, *entry.Definition);
    entry.MTime = entry.Definition->GetMTime();
    entry.Levels = entry.Definition->HasField() ? entry.Definition->GetLevels(surface)
                                                : std::vector<float>{ 0.0f };
    if (!entry.Definition->IsViewDependent())
    {
      entry.Chains = entry.Extract(npr::LineView(), surface.GetMesh().GetOrigin());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkNPRFeatureLines::IsWanted(
  const npr::LineChains& chains, std::size_t chain, const npr::LineRuler* ruler) const
{
  const std::size_t first = chains.Offsets[chain];
  const std::size_t last = chains.Offsets[chain + 1];
  float strength = 0.0f;
  double length = 0.0;
  for (std::size_t v = first; v < last; ++v)
  {
    strength = std::max(strength, chains.Vertices[v].Strength);
    const std::size_t next = v + 1 < last ? v + 1 : chains.Closed[chain] ? first : v;
    if (this->MinimumLength > 0.0)
    {
      length += ruler->Measure(chains.Vertices[v].Position, chains.Vertices[next].Position);
    }
  }
  return strength >= static_cast<float>(this->MinimumStrength) && length >= this->MinimumLength;
}

//------------------------------------------------------------------------------
int vtkNPRFeatureLines::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  Internals& internal = *this->Internal;
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
    Output(Eigen::Vector3d::Zero()).Finish(output);
    return 1;
  }
  if (!this->PrepareSurface(input))
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

  Output lines(origin);
  for (std::size_t i = 0; i < internal.Entries.size(); ++i)
  {
#if NPR_VTK_AT_LEAST(9, 3)
    const bool aborted = this->CheckAbort();
#else
    const bool aborted = this->GetAbortExecute() != 0;
#endif
    if (aborted)
    {
      break;
    }
    const Internals::Entry& entry = internal.Entries[i];
    std::vector<npr::LineChains> made;
    if (entry.Definition->IsViewDependent())
    {
      made = entry.Extract(view, origin);
    }
    const std::vector<npr::LineChains>& levels =
      entry.Definition->IsViewDependent() ? made : entry.Chains;
    for (std::size_t level = 0; level < levels.size(); ++level)
    {
      const npr::LineChains& chains = levels[level];
      for (std::size_t chain = 0; chain < chains.GetNumberOfChains(); ++chain)
      {
        if (this->IsWanted(chains, chain, ruler.get()))
        {
          lines.AddChain(chains, chain, static_cast<int>(i), entry.Levels[level]);
        }
      }
    }
    this->UpdateProgress(0.5 + 0.5 * static_cast<double>(i + 1) / internal.Entries.size());
  }
  lines.Finish(output);
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
  os << indent << "Definitions: " << this->GetNumberOfDefinitions() << "\n";
  for (const Internals::Entry& entry : this->Internal->Entries)
  {
    entry.Definition->PrintSelf(os, indent.GetNextIndent());
  }
}
