// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprPaperStrokes.h"

#include "nprActorIllustration.h"
#include "nprArrayNames.h"
#include "nprLineStrokes.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>

namespace npr
{
namespace
{
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
void CollectStrokes(const std::vector<std::unique_ptr<ActorIllustration>>& actors,
  const std::vector<std::string>& lineNames, vtkPolyData* strokes)
{
  strokes->Initialize();
  std::vector<vtkSmartPointer<vtkPolyData>> all;
  for (const auto& actor : actors)
  {
    int type = -1;
    for (LineStrokes& line : actor->GetStrokes())
    {
      ++type;
      vtkPolyData* const made =
        actor->IsShown() && line.IsVisible ? line.GetPartStrokes() : nullptr;
      if (made && made->GetNumberOfLines() > 0)
      {
        all.push_back(vtkSmartPointer<vtkPolyData>::New());
        all.back()->ShallowCopy(made);
        vtkNew<vtkIntArray> types; // those of the parts are numbers of their own
        types->SetName(names::LineType);
        types->SetNumberOfValues(made->GetNumberOfCells());
        types->FillValue(type);
        all.back()->GetCellData()->AddArray(types);
      }
    }
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
  vtkNew<vtkStringArray> types;
  types->SetName(names::LineTypeNames);
  for (const std::string& name : lineNames)
  {
    types->InsertNextValue(name);
  }
  strokes->GetFieldData()->AddArray(types);
}
}
