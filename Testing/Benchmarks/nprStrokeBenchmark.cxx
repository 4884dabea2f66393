// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What drawing strokes costs beside VTK's plain lines of the same width from the same data, in one
// run:
//   nprStrokeBenchmark [MODEL]
// A million points in strokes over the whole picture; and the contours and suggestive contours of
// the model. "Untested": without the test against depth. The empty picture is taken off. Processor:
// the time of all threads, which tells less of what else the machine does.
#include "nprBenchmarkCost.h"
#include "nprBenchmarkModel.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPROffscreen.h"
#include "vtkNPRStrokeMapper.h"
#include "vtkNPRSurfaceNormals.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace
{
constexpr double Width = 2.0;
constexpr int Rounds = 9;

/// Spirals on a sphere, of a thousand points each.
vtkSmartPointer<vtkPolyData> MakeSpirals(int count)
{
  constexpr int Points = 1000;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (int spiral = 0; spiral < count; ++spiral)
  {
    lines->InsertNextCell(Points);
    for (int i = 0; i < Points; ++i)
    {
      const double z = -1.0 + 2.0 * (i + 0.5) / Points;
      const double radius = std::sqrt(1.0 - z * z);
      const double angle = 6.283185307 * spiral / count + 3.0 * z;
      lines->InsertCellPoint(
        points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), z));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

class Scene
{
public:
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;

  Scene()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(820, 700);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(1, 1, 1);
  }

  vtkSmartPointer<vtkActor> Add(vtkPolyData* data, vtkPolyDataMapper* mapper)
  {
    mapper->SetInputData(data);
    mapper->SetScalarVisibility(false);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }

  void Compare(const char* what, vtkPolyData* data)
  {
    vtkNew<vtkNPRStrokeMapper> strokeMapper;
    strokeMapper->SetWidth(Width);
    vtkNew<vtkPolyDataMapper> lineMapper;
    const vtkSmartPointer<vtkActor> strokes = this->Add(data, strokeMapper);
    const vtkSmartPointer<vtkActor> lines = this->Add(data, lineMapper);
    for (vtkActor* actor : { strokes.Get(), lines.Get() })
    {
      actor->GetProperty()->SetColor(0, 0, 0);
      actor->GetProperty()->SetLineWidth(static_cast<float>(Width));
      actor->GetProperty()->LightingOff();
    }
    this->Renderer->ResetCamera();
    struct Case
    {
      bool Strokes;
      bool Lines;
      bool Tested;
      nprbench::Cost Least;
    };
    Case nothing = { false, false, true, {} };
    Case theirs = { false, true, true, {} };
    Case ours = { true, false, true, {} };
    Case untested = { true, false, false, {} };
    // In turn, so that what else the machine does falls on all of them.
    for (int round = 0; round < Rounds; ++round)
    {
      for (Case* which : { &nothing, &theirs, &ours, &untested })
      {
        strokes->SetVisibility(which->Strokes);
        lines->SetVisibility(which->Lines);
        strokeMapper->SetDepthTest(which->Tested);
        // A frame from another viewpoint; the data stay what they are.
        const nprbench::Cost cost = nprbench::Measure(1,
          [&]()
          {
            this->Renderer->GetActiveCamera()->Azimuth(1.0);
            this->Window->Render();
            this->Window->WaitForCompletion();
          });
        which->Least.Wall = std::min(which->Least.Wall, cost.Wall);
        which->Least.Processor = std::min(which->Least.Processor, cost.Processor);
      }
    }
    const auto print = [&](const char* clock, double nprbench::Cost::*time)
    {
      const auto get = [&](const Case& which)
      { return 1e3 * (which.Least.*time - nothing.Least.*time); };
      std::printf("%-20s %-10s %8lld %8.1f %8.1f %7.2f %9.1f %7.2f\n", what, clock,
        static_cast<long long>(data->GetNumberOfPoints()), get(theirs), get(ours),
        get(ours) / get(theirs), get(untested), get(untested) / get(theirs));
    };
    print("wall", &nprbench::Cost::Wall);
    print("processor", &nprbench::Cost::Processor);
    this->Renderer->RemoveActor(strokes);
    this->Renderer->RemoveActor(lines);
  }
};
}

int main(int argc, char* argv[])
{
  if (!vtkNPROffscreen::Setup())
  {
    return EXIT_FAILURE;
  }
  std::printf("milliseconds of a frame, 820x700, width %g\n", Width);
  std::printf("%-20s %-10s %8s %8s %8s %7s %9s %7s\n", "", "clock", "points", "VTK", "strokes",
    "ratio", "untested", "ratio");
  Scene spirals;
  spirals.Compare("spirals", MakeSpirals(1000));
  if (argc < 2)
  {
    return EXIT_SUCCESS;
  }

  const vtkSmartPointer<vtkPolyData> model = nprbench::ReadModel(argv[1]);
  if (!model)
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkNPRSurfaceNormals> normals;
  normals->SetInputData(model);
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetInputConnection(normals->GetOutputPort());
  Scene scene;
  vtkNew<vtkNPRFeatureLines> lines;
  lines->SetInputConnection(tensor->GetOutputPort());
  lines->AddDefinition("contours");
  lines->AddDefinition("suggestive");
  scene.Renderer->ResetCamera(model->GetBounds());
  lines->SetCamera(scene.Renderer->GetActiveCamera());
  lines->Update();
  scene.Compare("the model's lines", lines->GetOutput());
  return EXIT_SUCCESS;
}
