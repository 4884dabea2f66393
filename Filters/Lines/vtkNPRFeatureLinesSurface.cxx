// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What no view changes: the surface, with the arrays that lines need.
#include "vtkNPRFeatureLines.h"

#include "nprArrayNames.h"
#include "nprViewQuantities.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRFeatureLinesInternals.h"
#include "vtkNPRLineDefinition.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace
{
// Whether filters of ours made the array for lines, so that no user would name it.
bool IsOurs(const std::string& name)
{
  using namespace npr::names;
  const auto ours = { WeldedPointIds, ChordError, CurvatureTensor, PrincipalCurvature1,
    PrincipalCurvature2, PrincipalDirection1, PrincipalDirection2, CurvatureDerivatives,
    DerivativeDoubt, BorderPoints, UnknownCurvature };
  return name.rfind(ScaleNormalsPrefix, 0) == 0 ||
    std::find(ours.begin(), ours.end(), name) != ours.end();
}

// The names of the arrays of numbers that a user may mean, for a message.
std::string DescribeArrays(vtkDataSetAttributes* attributes, const std::string& kind)
{
  std::string names;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (array && array->GetName() && !IsOurs(array->GetName()))
    {
      names += (names.empty() ? "" : ", ") + std::string(array->GetName());
    }
  }
  return names.empty() ? "the surface brings no " + kind + " arrays of numbers."
                       : "its " + kind + " arrays are: " + names + ".";
}

// How to name another array, of lines that have a parameter for it.
std::string ExplainArray(const vtkNPRLineDefinition& definition)
{
  return definition.GetParameterSize("array") == 0
    ? "; name one by their parameter array (npr: --set " + std::string(definition.GetName()) +
      ".array=NAME)"
    : std::string();
}

std::string Quote(const std::string& kind, const std::string& name)
{
  return kind + " \"" + name + "\"";
}

// Empty, or what a user of these lines or this quantity is to know of an array that is missing.
std::string LoadArrays(npr::LineSurface& surface, vtkPolyData* input, const std::string& user,
  const std::vector<vtkNPRLineDefinition::RequiredArray>& arrays, const std::string& hint = {})
{
  for (const auto& required : arrays)
  {
    if (surface.LoadArray(input, required.Name, required.Components))
    {
      continue;
    }
    const std::string name = required.Name;
    if (!required.Maker)
    {
      return user + ": a point array is needed" +
        (name.empty() ? "" : ", but the input has none named \"" + name + "\"") + hint + "; " +
        DescribeArrays(input->GetPointData(), "point");
    }
    return user + ": the input has no point array \"" + name + "\" with " +
      std::to_string(required.Components) + " component(s). Put " + required.Maker +
      " before this filter, or let it do so itself by ComputeMissingArraysOn.";
  }
  return std::string();
}
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
    const std::string missing = LoadArrays(surface, input, Quote("The lines", definition.GetName()),
      definition.GetRequiredArrays(), ExplainArray(definition));
    if (!missing.empty())
    {
      vtkErrorMacro(<< missing);
      internal.Surface.reset();
      return false;
    }
    const char* const regions = definition.GetRequiredCellArray();
    if (regions && !surface.LoadRegions(input, regions))
    {
      vtkErrorMacro("The lines \"" << definition.GetName() << "\" need the cell array \"" << regions
                                   << "\", which the input does not have"
                                   << ExplainArray(definition) << "; "
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
  for (const npr::LineQuantity& quantity : internal.Quantities)
  {
    const std::string missing = LoadArrays(surface, input,
      Quote("The quantity", quantity.GetName()), quantity.GetRequiredArrays(),
      " (the quantities of all surfaces are " + npr::DescribeViewQuantities() + ")");
    if (!missing.empty())
    {
      vtkErrorMacro(<< missing);
      internal.Surface.reset();
      return false;
    }
  }
  // Normals of lines are welcome, but creases and boundaries do without.
  surface.LoadArray(input, npr::names::Normals, 3);
  if (surface.HasArray(npr::names::CurvatureDerivatives) ||
    std::any_of(internal.Entries.begin(), internal.Entries.end(),
      [](const Internals::Entry& entry) { return entry.Definition->NeedsDerivatives(); }))
  {
    surface.LoadArray(input, npr::names::DerivativeDoubt, 1);
  }
  internal.SetClusters(isNew);

  const npr::LineOptions options = this->GetOptions();
  const bool isStaticNew = options.UseSlopes != internal.Options.UseSlopes ||
    options.KeepsDoubtful != internal.Options.KeepsDoubtful ||
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
    entry.Definition->PrepareSurface(surface);
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
// The input, or if wanted what the curvature filter makes of it where arrays are missing.
vtkPolyData* vtkNPRFeatureLines::GetSurface(vtkPolyData* input)
{
  Internals& internal = *this->Internal;
  if (!this->ComputeMissingArrays)
  {
    return input;
  }
  const auto lacks = [input](const std::vector<vtkNPRLineDefinition::RequiredArray>& required)
  {
    return std::any_of(required.begin(), required.end(),
      [input](const auto& array) { return !input->GetPointData()->HasArray(array.Name); });
  };
  const bool isMissing = std::any_of(internal.Entries.begin(), internal.Entries.end(),
                           [&](const Internals::Entry& entry)
                           { return lacks(entry.Definition->GetRequiredArrays()); }) ||
    std::any_of(internal.Quantities.begin(), internal.Quantities.end(),
      [&](const npr::LineQuantity& quantity) { return lacks(quantity.GetRequiredArrays()); });
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
