// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRSceneStrokes.h"

#include "nprArrayNames.h"
#include "nprSceneActors.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRStrokeMapper.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkNPRSceneStrokes);

namespace
{
/// Lines of many sources as one set of strokes.
class StrokeCollector
{
public:
  StrokeCollector()
  {
    this->Points->SetDataTypeToDouble();
    this->Types->SetName(npr::names::LineType);
    this->Strength->SetName(npr::names::Strength);
    this->Names->SetName(npr::names::LineTypeNames);
  }

  /// The matrix takes the lines to the world; null: they are there.
  void Add(vtkPolyData* lines, vtkMatrix4x4* matrix)
  {
    if (!lines->GetPoints())
    {
      return;
    }
    vtkDataArray* const types = lines->GetCellData()->GetArray(npr::names::LineType);
    vtkDataArray* const strength = lines->GetPointData()->GetArray(npr::names::Strength);
    auto* const names = vtkStringArray::SafeDownCast(
      lines->GetFieldData()->GetAbstractArray(npr::names::LineTypeNames));
    const vtkIdType firstPoint = this->Points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    {
      double place[4] = { 0.0, 0.0, 0.0, 1.0 };
      lines->GetPoint(i, place);
      if (matrix)
      {
        matrix->MultiplyPoint(place, place);
      }
      this->Points->InsertNextPoint(place);
      this->Strength->InsertNextValue(
        strength ? static_cast<float>(strength->GetComponent(i, 0)) : 1.0f);
    }
    const vtkIdType firstCell = lines->GetNumberOfVerts();
    vtkNew<vtkIdList> ids;
    for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
    {
      lines->GetLines()->GetCellAtId(line, ids);
      this->Lines->InsertNextCell(static_cast<int>(ids->GetNumberOfIds()));
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        this->Lines->InsertCellPoint(firstPoint + ids->GetId(i));
      }
      const auto type =
        types ? static_cast<vtkIdType>(types->GetComponent(firstCell + line, 0)) : -1;
      const bool isNamed = names && type >= 0 && type < names->GetNumberOfValues();
      this->Types->InsertNextValue(this->FindType(isNamed ? names->GetValue(type) : "lines"));
    }
  }

  void GiveTo(vtkPolyData* strokes)
  {
    strokes->SetPoints(this->Points);
    strokes->SetLines(this->Lines);
    strokes->GetPointData()->AddArray(this->Strength);
    strokes->GetCellData()->AddArray(this->Types);
    strokes->GetFieldData()->AddArray(this->Names);
  }

private:
  int FindType(const std::string& name)
  {
    const vtkIdType found = this->Names->LookupValue(name);
    return static_cast<int>(found >= 0 ? found : this->Names->InsertNextValue(name));
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkIntArray> Types;
  vtkNew<vtkFloatArray> Strength;
  vtkNew<vtkStringArray> Names;
};
}

//------------------------------------------------------------------------------
vtkNPRSceneStrokes::vtkNPRSceneStrokes()
{
  this->SetNumberOfInputPorts(0);
}

vtkNPRSceneStrokes::~vtkNPRSceneStrokes() = default;

//------------------------------------------------------------------------------
void vtkNPRSceneStrokes::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != renderer)
  {
    this->Renderer = renderer;
    this->Modified();
  }
}

vtkRenderer* vtkNPRSceneStrokes::GetRenderer() const
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkNPRSceneStrokes::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Renderer)
  {
    time = std::max({ time, this->Renderer->GetMTime(), this->Renderer->GetViewProps()->GetMTime(),
      this->Renderer->GetActiveCamera()->GetMTime() });
    vtkPropCollection* const props = this->Renderer->GetViewProps();
    vtkCollectionSimpleIterator next;
    props->InitTraversal(next);
    while (vtkProp* const prop = props->GetNextProp(next))
    {
      time = std::max(time, prop->GetMTime());
    }
    npr::VisitActors(this->Renderer,
      [&time](vtkActor* actor, vtkMatrix4x4*) { time = std::max(time, actor->GetRedrawMTime()); });
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkNPRSceneStrokes::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->Renderer)
  {
    vtkErrorMacro("There is no renderer whose lines to take; give one to SetRenderer().");
    return 0;
  }
  StrokeCollector strokes;
  npr::VisitActors(this->Renderer,
    [&](vtkActor* actor, vtkMatrix4x4* matrix)
    {
      vtkMapper* const mapper = actor->GetMapper();
      mapper->Update();
      auto* const data = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
      if (data && mapper->IsA("vtkNPRStrokeMapper"))
      {
        strokes.Add(data, matrix);
      }
      else if (data && (data->GetNumberOfPolys() > 0 || data->GetNumberOfStrips() > 0))
      {
        vtkNew<vtkNPRSurfacePreparation> preparation;
        preparation->SetInputData(data);
        vtkNew<vtkNPRFeatureLines> edges;
        edges->SetInputConnection(preparation->GetOutputPort());
        edges->AddDefinition("contour-edges");
        edges->AddDefinition("creases");
        edges->AddDefinition("boundaries");
        edges->SetCamera(this->Renderer->GetActiveCamera());
        edges->SetMatrix(matrix);
        edges->ComputeMissingArraysOn();
        edges->Update();
        strokes.Add(edges->GetOutput(), matrix);
      }
    });
  strokes.GiveTo(vtkPolyData::GetData(outputVector));
  return 1;
}

//------------------------------------------------------------------------------
void vtkNPRSceneStrokes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
}
