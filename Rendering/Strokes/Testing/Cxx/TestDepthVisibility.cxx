// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes cut by the depth buffer where surfaces hide them, whose cuts are known.
#include "nprArrayNames.h"
#include "nprStrokeTesting.h"
#include "vtkNPRDepthVisibility.h"
#include "vtkNPROffscreen.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>

#include <algorithm>
#include <cstdlib>

namespace
{
using namespace nprtest;

constexpr double Pixel = 0.02; // of the world, where the focal point is

/// A surface in the left or right half of a window of 400x200.
struct Scene
{
  explicit Scene(vtkAlgorithmOutput* surface, bool parallel = true, bool right = false)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(surface);
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetViewport(right ? 0.5 : 0.0, 0.0, right ? 1.0 : 0.5, 1.0);
    vtkCamera* const camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 10.0);
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(2.0);
    camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(0.2)));
    camera->SetClippingRange(1.0, 30.0);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(400, 200);
    this->Window->AddRenderer(this->Renderer);
    this->Filter->SetRenderer(this->Renderer);
  }

  vtkPolyData* Label(const std::vector<Line>& lines)
  {
    this->Window->Render();
    this->Filter->SetInputData(MakeLines(lines));
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  bool IsSetUp = vtkNPROffscreen::Setup(); // before the window is made
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkNPRDepthVisibility> Filter;
};

/// Whether the parts have these layers, and begin and end at these x.
void CheckParts(vtkPolyData* parts, const std::vector<int>& layers, const std::vector<double>& cuts,
  double tolerance, const std::string& what)
{
  vtkDataArray* const found = parts->GetCellData()->GetArray(npr::names::HidingLayers);
  Check(found && parts->GetNumberOfLines() == static_cast<vtkIdType>(layers.size()),
    what + ": " + std::to_string(parts->GetNumberOfLines()) + " parts");
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0;
       i < std::min(parts->GetNumberOfLines(), static_cast<vtkIdType>(layers.size())); ++i)
  {
    Check(found->GetComponent(i, 0) == layers[i], what + ": layers of part " + std::to_string(i));
    parts->GetLines()->GetCellAtId(i, ids);
    for (const int end : { 0, 1 })
    {
      const double x = parts->GetPoint(ids->GetId(end ? ids->GetNumberOfIds() - 1 : 0))[0];
      Check(std::abs(x - cuts[i + end]) <= tolerance,
        what + ": cut at " + std::to_string(x) + " instead of " + std::to_string(cuts[i + end]));
    }
  }
}

void TestSheet(bool parallel)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(1.0);
  cube->SetYLength(1.0);
  cube->SetZLength(0.1);
  Scene scene(cube->GetOutputPort(), parallel);
  const std::string what = parallel ? "parallel" : "perspective";
  // In perspective the line is 12 from the eye, and the front of the sheet 9.95.
  const double half = parallel ? 0.5 : 0.5 * 12.0 / 9.95;
  CheckParts(scene.Label({ { { -1.5, 0.1, -2.0 }, { 1.5, 0.1, -2.0 } } }), { 0, 1, 0 },
    { -1.5, -half, half, 1.5 }, 1.5 * Pixel, what + ", behind a sheet");
  CheckParts(scene.Label({ { { -1.5, 0.1, 1.0 }, { 1.5, 0.1, 1.0 } } }), { 0 }, { -1.5, 1.5 }, 0.0,
    what + ", before it");
  CheckParts(scene.Label({ { { -0.5, 0.5, 0.05 }, { 0.5, 0.5, 0.05 } } }), { 0 }, { -0.5, 0.5 },
    0.0, what + ", along its edge");
  CheckParts(scene.Label({ { { -0.4, 0.1, 0.05 }, { 0.4, 0.1, 0.05 } } }), { 0 }, { -0.4, 0.4 },
    0.0, what + ", on it");
  const double near = 0.05 - 0.5 * Pixel;
  CheckParts(scene.Label({ { { -0.4, 0.1, near }, { 0.4, 0.1, near } } }), { 0 }, { -0.4, 0.4 },
    0.0, what + ", half a pixel behind its front");
  const double deep = 0.05 - 10.0 * Pixel;
  CheckParts(scene.Label({ { { -0.4, 0.1, deep }, { 0.4, 0.1, deep } } }), { 1 }, { -0.4, 0.4 },
    0.0, what + ", ten pixels behind its front");
  // What can not be seen is left out.
  CheckParts(scene.Label({ { { 1.5, 0.1, 0.0 }, { 3.0, 0.1, 0.0 } } }), { 0 }, { 1.5, 2.0 }, Pixel,
    what + ", out of the picture");
  Check(scene.Label({ { { 0.0, 0.1, 11.0 }, { 1.0, 0.1, 12.0 } } })->GetNumberOfLines() == 0,
    what + ", behind the eye");
}

void TestContour()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(128);
  sphere->SetPhiResolution(128);
  Scene scene(sphere->GetOutputPort());
  Line equator;
  for (int i = 0; i <= 256; ++i)
  {
    const double angle = 2.0 * Pi * i / 256;
    equator.push_back({ std::cos(angle), std::sin(angle), 0.0 });
  }
  equator.back() = equator.front();
  vtkPolyData* parts = scene.Label({ equator });
  CheckParts(parts, { 0 }, { 1.0, 1.0 }, 1e-6, "a sphere does not hide its contour");
  // Half of a circle through the poles is in front, half behind.
  Line meridian;
  for (int i = 0; i <= 64; ++i)
  {
    const double angle = Pi * i / 64;
    meridian.push_back({ std::cos(angle), 0.1, -0.99 * std::sin(angle) });
  }
  parts = scene.Label({ meridian });
  Check(parts->GetNumberOfLines() <= 3 && parts->GetNumberOfLines() >= 1,
    "lines on the back: " + std::to_string(parts->GetNumberOfLines()));
  const auto getLayers = [parts](vtkIdType part)
  { return parts->GetCellData()->GetArray(npr::names::HidingLayers)->GetComponent(part, 0); };
  Check(getLayers(parts->GetNumberOfLines() / 2) == 1.0, "what is behind is hidden");

  // Another picture is a change, without a word.
  scene.Actor->VisibilityOff();
  scene.Window->Render();
  scene.Filter->Update();
  Check(parts->GetNumberOfLines() == 1 && getLayers(0) == 0.0, "the new picture");
}

void TestViewports()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetZLength(0.1);
  Scene left(cube->GetOutputPort());
  Scene right(cube->GetOutputPort(), true, true);
  right.Window->RemoveRenderer(right.Renderer);
  left.Window->AddRenderer(right.Renderer);
  right.Actor->SetPosition(0.5, 0.0, 0.0);
  left.Window->Render();
  for (Scene* const scene : { &left, &right })
  {
    const double middle = scene == &left ? 0.0 : 0.5;
    vtkNew<vtkMatrix4x4> matrix; // moves the stroke by 1
    matrix->SetElement(0, 3, 1.0);
    scene->Filter->SetStrokeMatrix(matrix);
    scene->Filter->SetInputData(MakeLines({ { { -2.5, 0.1, -2.0 }, { 0.5, 0.1, -2.0 } } }));
    scene->Filter->Update();
    CheckParts(scene->Filter->GetOutput(), { 0, 1, 0 }, { -2.5, middle - 1.5, middle - 0.5, 0.5 },
      1.5 * Pixel, scene == &left ? "the left viewport" : "the right viewport");
  }
}

void TestErrors()
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkNPRDepthVisibility> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputData(MakeLines({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } }));
  filter->Update();
  Check(observer->GetErrorMessage().find("SetRenderer") != std::string::npos, "no renderer");

  vtkNew<vtkCubeSource> cube;
  Scene scene(cube->GetOutputPort());
  const double nan = std::nan("");
  vtkPolyData* parts = scene.Label({ { { -1.5, 0.0, 1.0 }, { 0.0, nan, 1.0 }, { 1.5, 0.0, 1.0 } },
    { { 0.0, 0.0, 1.0 } }, { { 1.0, 0.0, 1.0 }, { 1.0, 0.0, 1.0 } } });
  Check(parts->GetNumberOfLines() <= 1, "what is no line");
}
}

int TestDepthVisibility(int, char*[])
{
  TestSheet(true);
  TestSheet(false);
  TestContour();
  TestViewports();
  TestErrors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
