// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The lines of a scene: of strokes as they are, of other actors by their edges, where they are
// shown.
#include "nprArrayNames.h"
#include "nprChecks.h"
#include "vtkNPRSceneStrokes.h"
#include "vtkNPRStrokeMapper.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkLineSource.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>

#include <cmath>
#include <map>
#include <string>

namespace
{
/// The length of the lines of each type.
std::map<std::string, double> MeasureTypes(vtkPolyData* strokes)
{
  std::map<std::string, double> lengths;
  auto* const names = vtkStringArray::SafeDownCast(
    strokes->GetFieldData()->GetAbstractArray(npr::names::LineTypeNames));
  vtkDataArray* const types = strokes->GetCellData()->GetArray(npr::names::LineType);
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < strokes->GetNumberOfLines(); ++line)
  {
    strokes->GetCellPoints(line, ids);
    double& length = lengths[names->GetValue(static_cast<vtkIdType>(types->GetComponent(line, 0)))];
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      double a[3], b[3];
      strokes->GetPoint(ids->GetId(i - 1), a);
      strokes->GetPoint(ids->GetId(i), b);
      length += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
    }
  }
  return lengths;
}
}

int TestSceneStrokes(int, char*[])
{
  nprtest::Checks check;
  vtkNew<vtkRenderer> renderer;
  renderer->GetActiveCamera()->SetPosition(3, 4, 20);
  vtkNew<vtkNPRSceneStrokes> strokes;
  vtkNew<vtkCallbackCommand> onError;
  bool refused = false;
  onError->SetClientData(&refused);
  onError->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { *static_cast<bool*>(client) = true; });
  strokes->AddObserver(vtkCommand::ErrorEvent, onError);
  strokes->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, onError);
  strokes->Update();
  check(refused, "no renderer is an error");
  strokes->SetRenderer(renderer);
  strokes->Update();
  check(strokes->GetOutput()->GetNumberOfLines() == 0, "an empty scene has no lines");

  // A cube of size 2, moved within an assembly that is moved, too.
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkPolyDataMapper> cubeMapper;
  cubeMapper->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkActor> cubeActor;
  cubeActor->SetMapper(cubeMapper);
  cubeActor->SetScale(2.0);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(cubeActor);
  assembly->SetPosition(5, 0, 0);
  renderer->AddViewProp(assembly);
  strokes->Update();
  vtkPolyData* const output = strokes->GetOutput();
  std::map<std::string, double> lengths = MeasureTypes(output);
  check(std::abs(lengths["creases"] - 24) < 1e-5, "a cube has twelve creases", lengths["creases"]);
  check(lengths["contour-edges"] > 11, "and an outline", lengths["contour-edges"]);
  double bounds[6];
  output->GetBounds(bounds);
  check(std::abs(bounds[0] - 4) < 1e-5 && std::abs(bounds[1] - 6) < 1e-5 &&
      std::abs(bounds[2] + 1) < 1e-5 && std::abs(bounds[3] - 1) < 1e-5,
    "they are where the assembly shows it");

  // Strokes of ours come as they are, and what is not shown does not come.
  vtkNew<vtkLineSource> line;
  line->SetPoint1(0, 0, 0);
  line->SetPoint2(0, 3, 0);
  vtkNew<vtkNPRStrokeMapper> strokeMapper;
  strokeMapper->SetInputConnection(line->GetOutputPort());
  vtkNew<vtkActor> strokeActor;
  strokeActor->SetMapper(strokeMapper);
  renderer->AddActor(strokeActor);
  vtkNew<vtkActor> hiddenActor;
  hiddenActor->SetMapper(cubeMapper);
  hiddenActor->VisibilityOff();
  renderer->AddActor(hiddenActor);
  strokes->Update();
  lengths = MeasureTypes(output);
  check(std::abs(lengths["lines"] - 3) < 1e-6, "strokes are taken as they are", lengths["lines"]);
  check(std::abs(lengths["creases"] - 24) < 1e-5, "hidden actors have no lines");

  // It follows what changes, and runs only then.
  const vtkMTimeType time = output->GetMTime();
  strokes->Update();
  check(output->GetMTime() == time, "nothing changed");
  strokeActor->SetScale(2.0);
  strokes->Update();
  check(std::abs(MeasureTypes(output)["lines"] - 6) < 1e-6, "it follows an actor");
  line->SetPoint2(0, 4, 0);
  strokes->Update();
  check(std::abs(MeasureTypes(output)["lines"] - 8) < 1e-6, "it follows an actor's data");
  const double outline = MeasureTypes(output)["contour-edges"];
  renderer->GetActiveCamera()->SetPosition(5, 0, 20);
  renderer->GetActiveCamera()->SetFocalPoint(5, 0, 0);
  strokes->Update();
  check(MeasureTypes(output)["contour-edges"] < outline - 0.5, "it follows the camera");
  return check.GetResult();
}
