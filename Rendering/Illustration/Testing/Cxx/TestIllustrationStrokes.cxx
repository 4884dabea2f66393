// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The strokes of an illustration for a drawing on paper: those of all actors, in the world, cut
// where one actor hides another, and tapered at the ends of lines only. No pixel is drawn.
#include "nprArrayNames.h"
#include "nprTestScene.h"
#include "vtkNPRDrawingStyle.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
bool Check(bool good, const char* what)
{
  if (!good)
  {
    std::cerr << "FAILED: " << what << "\n";
  }
  return good;
}

struct Row
{
  double Visible = 0.0; // length along x
  double Hidden = 0.0;
  bool IsWholeAtCuts = true;
};

/// What there is of the edge of the long bar at a height, which is 10 wide and has its middle at 0.
Row Measure(vtkPolyData* strokes, double y, double z)
{
  Row row;
  vtkDataArray* const layers = strokes->GetCellData()->GetArray(npr::names::HidingLayers);
  vtkDataArray* const widths = strokes->GetPointData()->GetArray(npr::names::Width);
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < strokes->GetNumberOfLines(); ++line)
  {
    strokes->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      double point[3];
      strokes->GetPoint(ids->GetId(i), point);
      if (std::abs(point[1] - y) > 1e-3 || std::abs(point[2] - z) > 1e-3)
      {
        continue;
      }
      if (i > 0)
      {
        double before[3];
        strokes->GetPoint(ids->GetId(i - 1), before);
        const bool isAlong = std::abs(before[1] - y) < 1e-3 && std::abs(before[2] - z) < 1e-3;
        (layers->GetComponent(line, 0) == 0.0 ? row.Visible : row.Hidden) +=
          isAlong ? std::abs(point[0] - before[0]) : 0.0;
      }
      const double width = widths->GetComponent(ids->GetId(i), 0);
      row.IsWholeAtCuts = row.IsWholeAtCuts && (std::abs(point[0]) > 2.0 || width > 0.99);
    }
  }
  return row;
}
}

int TestIllustrationStrokes(int, char*[])
{
  // A long bar behind a cube, both from one unit cube by their actors' matrices.
  vtkNew<vtkCubeSource> cube;
  npr::TestScene scene(cube->GetOutputPort());
  scene.Actor->SetScale(10.0, 1.0, 1.0);
  vtkNew<vtkActor> front;
  front->SetMapper(scene.Mapper);
  front->SetScale(2.0, 3.0, 1.0);
  front->SetPosition(0.0, 0.0, 5.0);
  scene.Renderer->AddActor(front);
  vtkCamera* const camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 50.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(5.0);
  scene.Style->LoadString(R"({ "shading": { "style": "paper" }, "strokes": { "taper_length": 50 },
    "lines": [ { "type": "creases", "width": 3, "color": "#ff0000" },
               { "type": "creases", "width": 2 } ] })");

  bool good = true;
  vtkNew<vtkPolyData> strokes;
  vtkObject::GlobalWarningDisplayOff();
  good &= Check(!scene.Illustration->GetStrokes(strokes), "there are strokes before Apply()");
  vtkObject::GlobalWarningDisplayOn();
  good &= Check(scene.Illustration->Apply() && scene.Illustration->GetStrokes(strokes), "strokes");
  const Row row = Measure(strokes, 0.5, 0.5);
  // Two kinds of lines draw each edge.
  good &= Check(std::abs(row.Visible - 16.0) < 0.05, "the length beside the cube is visible");
  good &= Check(std::abs(row.Hidden - 4.0) < 0.05, "what the cube covers is hidden");
  good &= Check(
    strokes->GetPointData()->GetArray(npr::names::Width)->GetRange()[0] < 0.01, "lines taper");
  good &= Check(row.IsWholeAtCuts, "lines do not taper where they are cut");

  vtkNew<vtkNPRDrawingStyle> inks;
  scene.Style->GetDrawingStyle(inks, 200.0);
  good &= Check(std::abs(inks->GetWidth("creases") - 0.6) < 1e-9 &&
      std::abs(inks->GetWidth("creases 2") - 0.4) < 1e-9,
    "each kind of line has its own look on paper");

  front->VisibilityOff();
  good &= Check(scene.Illustration->GetStrokes(strokes) &&
      std::abs(Measure(strokes, 0.5, 0.5).Visible - 20.0) < 0.05,
    "what is not shown hides nothing");
  scene.Illustration->SetLineVisibility(1, false);
  good &= Check(scene.Illustration->GetStrokes(strokes) &&
      std::abs(Measure(strokes, 0.5, 0.5).Visible - 10.0) < 0.05,
    "lines that are not shown are no strokes");
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
