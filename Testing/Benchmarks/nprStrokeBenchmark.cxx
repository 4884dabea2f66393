// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What drawing strokes costs beside VTK's plain lines of the same width from the same data, in one
// run:
//   nprStrokeBenchmark [MODEL]
// A million points in strokes over the whole picture; and the contours and suggestive contours of
// the model. "Untested": without the test against depth. The empty picture is taken off. Processor:
// the time of all threads, which tells less of what else the machine does.
// Then Catmull-Rom splines over the same and over fewer points: by vtkNPRSplineStrokes, and by the
// mapper's SplineType; while the points move, so that each frame makes all of them anew, and while
// only the camera does.
#include "nprBenchmarkCost.h"
#include "nprBenchmarkModel.h"
#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPROffscreen.h"
#include "vtkNPRSplineStrokes.h"
#include "vtkNPRStrokeMapper.h"
#include "vtkNPRSurfaceNormals.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkMath.h>
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

/// Spirals on a sphere, of so many points each.
vtkSmartPointer<vtkPolyData> MakeSpirals(int count, int size)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (int spiral = 0; spiral < count; ++spiral)
  {
    lines->InsertNextCell(size);
    for (int i = 0; i < size; ++i)
    {
      const double z = -1.0 + 2.0 * (i + 0.5) / size;
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
        this->MeasureFrame(which->Least);
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

  void CompareCurves(const char* what, vtkPolyData* data)
  {
    vtkNew<vtkNPRSplineStrokes> splines;
    splines->SetInputData(data);
    vtkNew<vtkNPRStrokeMapper> ofSplines;
    vtkNew<vtkNPRStrokeMapper> curves;
    const vtkSmartPointer<vtkActor> theirs = this->Add(data, ofSplines);
    const vtkSmartPointer<vtkActor> ours = this->Add(data, curves);
    ofSplines->SetInputConnection(splines->GetOutputPort());
    curves->SetSplineTypeToCatmullRom();
    this->Renderer->ResetCamera();
    // The mapper's SplineChordError where a pixel is smallest on the lines.
    vtkCamera* const camera = this->Renderer->GetActiveCamera();
    const double pixel = 2.0 * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())) *
      (camera->GetDistance() - 0.5 * data->GetLength()) / this->Window->GetSize()[1];
    splines->SetMaximumChordError(curves->GetSplineChordError() * pixel);
    nprbench::Cost nothing;
    nprbench::Cost least[2][2]; // whether points move; whether by the mapper
    for (int round = 0; round < Rounds; ++round)
    {
      for (const bool moves : { false, true })
      {
        for (const bool byMapper : { false, true })
        {
          theirs->SetVisibility(!byMapper);
          ours->SetVisibility(byMapper);
          if (!moves)
          {
            this->Window->Render(); // the points had moved before
          }
          this->MeasureFrame(least[moves][byMapper], moves ? data : nullptr);
        }
      }
      theirs->VisibilityOff();
      ours->VisibilityOff();
      this->MeasureFrame(nothing);
    }
    for (const bool moves : { true, false })
    {
      const auto get = [&](double nprbench::Cost::*time, bool byMapper)
      { return 1e3 * (least[moves][byMapper].*time - nothing.*time); };
      const auto print = [&](const char* clock, double nprbench::Cost::*time)
      {
        std::printf("%-20s %-7s %-10s %8lld %8lld %8.1f %8.1f %7.2f\n", what,
          moves ? "moving" : "still", clock, static_cast<long long>(data->GetNumberOfPoints()),
          static_cast<long long>(splines->GetOutput()->GetNumberOfPoints()), get(time, false),
          get(time, true), get(time, true) / get(time, false));
      };
      print("wall", &nprbench::Cost::Wall);
      print("processor", &nprbench::Cost::Processor);
    }
    this->Renderer->RemoveActor(theirs);
    this->Renderer->RemoveActor(ours);
  }

private:
  /// A frame from another viewpoint; the data stay what they are, or they are said to have changed.
  void MeasureFrame(nprbench::Cost& least, vtkPolyData* moved = nullptr)
  {
    const nprbench::Cost cost = nprbench::Measure(1,
      [&]()
      {
        if (moved)
        {
          moved->GetPoints()->Modified();
          moved->Modified();
        }
        this->Renderer->GetActiveCamera()->Azimuth(1.0);
        this->Window->Render();
        this->Window->WaitForCompletion();
      });
    least.Wall = std::min(least.Wall, cost.Wall);
    least.Processor = std::min(least.Processor, cost.Processor);
  }
};

void PrintCurvesHeader()
{
  std::printf("\ncurves: milliseconds of a frame beyond an empty one\n");
  std::printf("%-20s %-7s %-10s %8s %8s %8s %8s %7s\n", "", "", "clock", "points", "sampled",
    "filter", "mapper", "ratio");
}

void CompareSpirals(Scene& scene)
{
  scene.CompareCurves("spirals", MakeSpirals(1000, 1000));
  scene.CompareCurves("coarse spirals", MakeSpirals(1000, 20));
}
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
  spirals.Compare("spirals", MakeSpirals(1000, 1000));
  if (argc < 2)
  {
    PrintCurvesHeader();
    CompareSpirals(spirals);
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
  PrintCurvesHeader();
  CompareSpirals(spirals);
  scene.CompareCurves("the model's lines", lines->GetOutput());
  return EXIT_SUCCESS;
}
