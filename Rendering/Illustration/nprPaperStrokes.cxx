// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPaperStrokes.h"

#include "nprActorIllustration.h"
#include "nprArrayNames.h"
#include "nprLineStrokes.h"
#include "nprPageScale.h"
#include "vtkNPRLineSelection.h"
#include "vtkNPRStrokeVisibility.h"

#include <vtkActor.h>
#include <vtkAlgorithmOutput.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTimerLog.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>

namespace npr
{
namespace
{
// Thousandths of the image's shorter side: about as wide as lines are, so that shorter gaps and
// pieces are no lines, but dirt.
constexpr double ShortestPart = 2.0;

vtkSmartPointer<vtkPolyData> MoveToWorld(vtkPolyData* lines, vtkMatrix4x4* matrix)
{
  if (matrix->IsIdentity())
  {
    return lines;
  }
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  vtkNew<vtkTransformPolyDataFilter> toWorld;
  toWorld->SetTransform(transform);
  toWorld->SetInputData(lines);
  toWorld->Update();
  return toWorld->GetOutput();
}

void SetTypes(vtkPolyData* lines, int type)
{
  vtkNew<vtkIntArray> types;
  types->SetName(names::LineType);
  types->SetNumberOfValues(lines->GetNumberOfCells());
  types->FillValue(type);
  lines->GetCellData()->AddArray(types);
}

void SetNames(vtkPolyData* lines, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  array->SetName(names::LineTypeNames);
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  lines->GetFieldData()->AddArray(array);
}

/// What is appended keeps only the arrays that all have.
void CompleteFactors(const std::vector<vtkSmartPointer<vtkPolyData>>& all, const char* name)
{
  const auto has = [name](vtkPolyData* strokes) { return strokes->GetPointData()->HasArray(name); };
  if (std::any_of(all.begin(), all.end(), has))
  {
    for (vtkPolyData* const strokes : all)
    {
      if (!has(strokes))
      {
        vtkNew<vtkFloatArray> factors;
        factors->SetName(name);
        factors->SetNumberOfValues(strokes->GetNumberOfPoints());
        factors->FillValue(1.0f);
        strokes->GetPointData()->AddArray(factors);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PaperStrokes::GatherLines(
  const Actors& actors, std::vector<Group>& groups)
{
  vtkNew<vtkAppendPolyData> append;
  for (const auto& actor : actors)
  {
    int type = -1;
    for (LineStrokes& strokes : actor->GetStrokes())
    {
      ++type;
      vtkPolyData* const chosen =
        actor->IsShown() && strokes.IsVisible ? strokes.GetLines() : nullptr;
      if (chosen && chosen->GetNumberOfLines() > 0)
      {
        vtkNew<vtkPolyData> lines;
        lines->ShallowCopy(chosen);
        SetTypes(lines, static_cast<int>(groups.size()));
        groups.push_back({ &strokes, type });
        append->AddInputData(MoveToWorld(lines, actor->GetActor()->GetMatrix()));
      }
    }
  }
  if (groups.empty())
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  append->Update();
  return append->GetOutput();
}

//------------------------------------------------------------------------------
void PaperStrokes::SetSurfaces(const Actors& actors)
{
  std::vector<vtkSmartPointer<vtkAlgorithmOutput>> surfaces;
  for (const auto& actor : actors)
  {
    if (actor->IsShown())
    {
      surfaces.emplace_back(actor->GetPipeline().GetSurfacePort());
    }
  }
  if (surfaces != this->Surfaces)
  {
    this->Surfaces = surfaces;
    this->Visibility->RemoveAllSurfaces();
    for (const auto& actor : actors)
    {
      if (actor->IsShown())
      {
        this->Visibility->AddSurfaceConnection(
          actor->GetPipeline().GetSurfacePort(), actor->GetActor()->GetMatrix());
      }
    }
  }
}

//------------------------------------------------------------------------------
void PaperStrokes::DrawParts(vtkPolyData* parts, const std::vector<Group>& groups,
  const PageScale& scale, vtkRenderer* renderer, vtkPolyData* strokes)
{
  std::vector<vtkSmartPointer<vtkPolyData>> all;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    vtkNew<vtkNPRLineSelection> selection;
    selection->SetInputData(parts);
    selection->SetLineIndex(static_cast<int>(i));
    selection->Update();
    all.push_back(
      groups[i].Strokes->MakeStrokes(selection->GetOutput(), scale, renderer->GetActiveCamera()));
    SetTypes(all.back(), groups[i].Type);
  }
  CompleteFactors(all, names::Width);
  CompleteFactors(all, names::Opacity);
  vtkNew<vtkAppendPolyData> append;
  for (vtkPolyData* const one : all)
  {
    append->AddInputData(one);
  }
  if (!all.empty())
  {
    append->Update();
    strokes->ShallowCopy(append->GetOutput());
  }
}

//------------------------------------------------------------------------------
void PaperStrokes::Make(const Actors& actors, vtkRenderer* renderer,
  const std::vector<std::string>& names, int maximumLayers, vtkPolyData* strokes)
{
  strokes->Initialize();
  const PageScale scale = PageScale::Of(renderer);
  for (const auto& actor : actors)
  {
    actor->Follow(scale);
  }
  std::vector<Group> groups;
  const vtkSmartPointer<vtkPolyData> lines = this->GatherLines(actors, groups);
  if (!groups.empty())
  {
    const double start = vtkTimerLog::GetUniversalTime();
    this->SetSurfaces(actors);
    this->Visibility->SetInputData(lines);
    this->Visibility->SetCamera(renderer->GetActiveCamera());
    this->Visibility->SetViewportHeight(renderer->GetSize()[1]);
    this->Visibility->SetMinimumLength(ShortestPart * scale.PixelsPerUnit);
    this->Visibility->SetMaximumLayers(maximumLayers);
    this->Visibility->Update();
    const double middle = vtkTimerLog::GetUniversalTime();
    this->VisibilitySeconds += middle - start;

    // The numbers of groups are no types.
    vtkNew<vtkPolyData> parts;
    parts->ShallowCopy(this->Visibility->GetOutput());
    SetNames(parts, std::vector<std::string>(groups.size()));
    this->DrawParts(parts, groups, scale, renderer, strokes);
    this->StrokesSeconds += vtkTimerLog::GetUniversalTime() - middle;
  }
  SetNames(strokes, names);
}
}
