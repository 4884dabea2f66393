// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays and precision survive the preparation; progress runs to its end, and can be ended.
#include "nprAnalyticSurfaces.h"
#include "nprManifoldChecks.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <string>

using namespace nprtest;

namespace
{
using Points = std::vector<std::array<double, 3>>;

//------------------------------------------------------------------------------
void TestArrays(Checks& check)
{
  // A book of three sheets and a loose point, far from the origin, in both precisions, with arrays
  // that can not go through a double.
  const double far = 1e8;
  const std::int64_t big = (std::int64_t(1) << 53) + 1;
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const double offset = type == VTK_FLOAT ? 0.0 : far;
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    points->InsertNextPoint(offset, 9.0, 9.0);
    const Points corners = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 }, { -1, -1, 0 } };
    for (const auto& p : corners)
    {
      points->InsertNextPoint(offset + p[0] / 1024.0, p[1] / 1024.0, p[2] / 1024.0);
    }
    auto mesh = MakeMesh({}, { { 1, 2, 3 }, { 1, 2, 4 }, { 2, 1, 5 } });
    mesh->SetPoints(points);
    vtkNew<vtkStringArray> names;
    names->SetName("Names");
    vtkNew<vtkTypeInt64Array> numbers;
    numbers->SetName("Numbers");
    vtkNew<vtkFloatArray> normals;
    normals->SetName("MyNormals");
    normals->SetNumberOfComponents(3);
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetName("MyTCoords");
    coordinates->SetNumberOfComponents(2);
    for (int i = 0; i < 6; ++i)
    {
      names->InsertNextValue("point " + std::to_string(i));
      numbers->InsertNextValue(big + i);
      normals->InsertNextTuple3(0.0, 0.0, i);
      coordinates->InsertNextTuple2(0.5, i);
    }
    vtkPointData* const data = mesh->GetPointData();
    data->AddArray(names);
    data->SetScalars(numbers);
    data->SetNormals(normals);
    data->SetTCoords(coordinates);
    vtkNew<vtkStringArray> cellNames;
    cellNames->SetName("CellNames");
    vtkNew<vtkTypeInt64Array> cellNumbers;
    cellNumbers->SetName("CellNumbers");
    for (int i = 0; i < 3; ++i)
    {
      cellNames->InsertNextValue("cell " + std::to_string(i));
      cellNumbers->InsertNextValue(big + i);
    }
    mesh->GetCellData()->AddArray(cellNames);
    mesh->GetCellData()->SetScalars(cellNumbers);

    vtkNew<vtkNPRSurfacePreparation> preparation;
    preparation->SetInputData(mesh);
    preparation->Update();
    vtkPolyData* const output = preparation->GetOutput();
    check(output->GetNumberOfPoints() == 9 && preparation->GetNumberOfUnusedPoints() == 1,
      "split and left out");
    check(output->GetPoints()->GetDataType() == type, "points keep their type");
    vtkPointData* const kept = output->GetPointData();
    auto* outNames = vtkStringArray::SafeDownCast(kept->GetAbstractArray("Names"));
    auto* outNumbers = vtkTypeInt64Array::SafeDownCast(kept->GetScalars());
    check(kept->GetNormals() && std::string(kept->GetNormals()->GetName()) == "MyNormals" &&
        kept->GetTCoords() && std::string(kept->GetTCoords()->GetName()) == "MyTCoords",
      "what was active still is");
    if (check(outNames && outNumbers, "arrays keep their types"))
    {
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        const auto source = static_cast<int>(outNumbers->GetValue(i) - big);
        check(outNames->GetValue(i) == "point " + std::to_string(source) && source > 0 &&
            kept->GetNormals()->GetComponent(i, 2) == source,
          "values go together");
        double in[3];
        double out[3];
        mesh->GetPoint(source, in);
        output->GetPoint(i, out);
        check(in[0] == out[0] && in[1] == out[1] && in[2] == out[2], "no digit is lost");
      }
    }
    auto* outCells =
      vtkStringArray::SafeDownCast(output->GetCellData()->GetAbstractArray("CellNames"));
    auto* cellScalars = vtkTypeInt64Array::SafeDownCast(output->GetCellData()->GetScalars());
    check(outCells && cellScalars && outCells->GetValue(2) == "cell 2" &&
        cellScalars->GetValue(2) == big + 2,
      "cell arrays, too");
  }
}

//------------------------------------------------------------------------------
void TestProgressAndAbort(Checks& check)
{
  struct Log
  {
    std::vector<double> Values;
    bool Abort = false;
  } log;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&log);
  observer->SetCallback(
    [](vtkObject* filter, unsigned long, void* client, void* data)
    {
      auto* const seen = static_cast<Log*>(client);
      seen->Values.push_back(*static_cast<double*>(data));
      if (seen->Abort && seen->Values.back() > 0.3)
      {
        static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
      }
    });
  AnalyticSurface torus = MakeTorus(1.0, 0.4, 40, 20);
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputData(torus.Mesh);
  preparation->AddObserver(vtkCommand::ProgressEvent, observer);
  preparation->Update();
  check(std::is_sorted(log.Values.begin(), log.Values.end()) && log.Values.size() > 6 &&
      log.Values.back() == 1.0,
    "progress runs once, to the end");
  log.Abort = true;
  preparation->Modified();
  preparation->Update();
  check(preparation->GetOutput()->GetNumberOfPoints() == 0 &&
      preparation->GetOutput()->GetNumberOfCells() == 0,
    "an aborted preparation gives nothing");
  log.Abort = false;
  preparation->Modified();
  preparation->Update();
  check(preparation->GetOutput()->GetNumberOfPoints() == 800, "and can be done again");
}
}

int TestSurfacePreparationData(int, char*[])
{
  Checks check;
  TestArrays(check);
  TestProgressAndAbort(check);
  return check.GetResult();
}
