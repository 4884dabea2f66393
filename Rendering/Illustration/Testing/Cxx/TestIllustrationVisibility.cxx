// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What hides the strokes of an illustration on screen, by the depth buffer as by the surfaces: a
// long bar behind things that are moved, made translucent, cut, added and taken away.
#include "nprTestScene.h"

#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkPlane.h>
#include <vtkPropPicker.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
int failures = 0;

void Check(bool good, const std::string& what)
{
  if (!good)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++failures;
  }
}

constexpr double PixelsPerUnit = 30.0; // of the world, in a window of 400x300

/// Dark pixels of the bar's edges (at y = -0.5, 0.5, or both: 0) around a place along it.
int CountInk(vtkImageData* image, double x, double y = 0.0)
{
  const int* size = image->GetDimensions();
  const double unit = PixelsPerUnit * size[1] / 300.0;
  int ink = 0;
  for (int row = 0; row < size[1]; ++row)
  {
    const double high = (row + 0.5 - 0.5 * size[1]) / unit;
    for (int column = 0; column < size[0]; ++column)
    {
      const double across = (column + 0.5 - 0.5 * size[0]) / unit;
      const bool isThere =
        std::abs(across - x) < 0.7 && (y == 0.0 ? std::abs(high) < 0.8 : std::abs(high - y) < 0.3);
      ink += isThere && image->GetScalarComponentAsDouble(column, row, 0, 0) < 100.0;
    }
  }
  return ink;
}

/// The bar, 10 long, and a cube in front of its middle.
struct Scene : npr::TestScene
{
  explicit Scene(vtkCubeSource* cube, double far = 0.0) : npr::TestScene(cube->GetOutputPort())
  {
    this->Actor->SetScale(10.0, 1.0, 1.0);
    this->Actor->SetPosition(far, 0.0, 0.0);
    this->FrontMapper->SetInputConnection(cube->GetOutputPort());
    this->Front->SetMapper(this->FrontMapper);
    this->Front->SetScale(2.0, 3.0, 1.0);
    this->Front->SetPosition(far, 0.0, 5.0);
    this->Renderer->AddActor(this->Front);
    vtkCamera* const camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(far, 0.0, 50.0);
    camera->SetFocalPoint(far, 0.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * 300.0 / PixelsPerUnit);
    this->Renderer->ResetCameraClippingRange();
    this->Style->LoadString(R"({ "background": "#ffffff", "strokes": {},
      "shading": { "style": "phong", "color": "#ffffff", "ambient": 1, "diffuse": 0, "specular": 0 },
      "lines": [ { "type": "creases", "width": 4, "color": "#000000" } ] })");
  }

  bool IsHiddenAt(double x, double y = 0.0) { return CountInk(this->Render(), x, y) == 0; }

  vtkNew<vtkPolyDataMapper> FrontMapper;
  vtkNew<vtkActor> Front;
};

void TestActors(vtkCubeSource* cube, int visibility)
{
  Scene scene(cube);
  scene.Illustration->SetStrokeVisibility(visibility);
  scene.Illustration->Apply();
  const std::string by = visibility == vtkNPRIllustration::EXACT ? "exact: " : "depth buffer: ";
  Check(CountInk(scene.Render(), 3.0) > 100, by + "lines are drawn");
  Check(scene.IsHiddenAt(0.0), by + "the cube hides the bar");
  scene.Front->SetPosition(3.0, 0.0, 5.0);
  Check(scene.IsHiddenAt(3.0) && !scene.IsHiddenAt(0.0), by + "also where it has been moved to");
  scene.Front->GetProperty()->SetOpacity(0.5);
  Check(!scene.IsHiddenAt(3.0), by + "what is translucent hides nothing");
  scene.Actor->GetProperty()->SetOpacity(0.5);
  Check(!scene.IsHiddenAt(3.0), by + "nor where all is");
  scene.Actor->GetProperty()->SetOpacity(1.0);
  scene.Front->GetProperty()->SetOpacity(1.0);
  Check(scene.IsHiddenAt(3.0), by + "what is opaque again hides again");
  scene.Front->VisibilityOff();
  Check(!scene.IsHiddenAt(3.0), by + "what is not shown hides nothing");
  scene.Front->VisibilityOn();

  vtkNew<vtkActor> other; // without illustration
  other->SetMapper(scene.Mapper);
  other->SetScale(2.0, 3.0, 1.0);
  other->SetPosition(0.0, 0.0, 5.0);
  scene.Renderer->AddActor(other);
  Check(scene.IsHiddenAt(0.0), by + "an actor that came later hides, too");
  scene.Renderer->RemoveActor(other);
  Check(!scene.IsHiddenAt(0.0), by + "an actor that is gone does not");
  other->SetPosition(0.0, 0.0, 0.0);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(other);
  assembly->SetPosition(0.0, 0.0, 5.0);
  scene.Renderer->AddActor(assembly);
  Check(scene.IsHiddenAt(0.0), by + "a part of an assembly hides");
  assembly->SetPosition(-3.0, 0.0, 5.0);
  Check(scene.IsHiddenAt(-3.0) && !scene.IsHiddenAt(0.0), by + "and is followed");
}

void TestClippingPlanes(vtkCubeSource* cube, int visibility)
{
  Scene scene(cube);
  vtkNew<vtkPlane> plane; // keeps what is above the middle
  plane->SetNormal(0.0, 1.0, 0.0);
  scene.FrontMapper->AddClippingPlane(plane);
  scene.Illustration->SetStrokeVisibility(visibility);
  scene.Illustration->Apply();
  Check(scene.IsHiddenAt(0.0, 0.5), "what clipping planes leave hides");
  Check(!scene.IsHiddenAt(0.0, -0.5), "what they cut away does not");
  plane->SetNormal(0.0, -1.0, 0.0);
  Check(!scene.IsHiddenAt(0.0, 0.5) && scene.IsHiddenAt(0.0, -0.5), "planes are followed");
}

vtkMTimeType GetTimeOfStrokes(vtkRenderer* renderer)
{
  vtkActorCollection* const actors = renderer->GetActors();
  vtkCollectionSimpleIterator next;
  actors->InitTraversal(next);
  vtkMTimeType time = 0;
  while (vtkActor* const actor = actors->GetNextActor(next))
  {
    if (actor->GetMapper()->IsA("vtkNPRStrokeMapper"))
    {
      time = std::max(time, actor->GetMapper()->GetInputDataObject(0, 0)->GetMTime());
    }
  }
  return time;
}

void TestWindow(vtkCubeSource* cube)
{
  Scene scene(cube);
  vtkCamera* const camera = scene.Renderer->GetActiveCamera();
  Check(scene.Illustration->GetStrokeVisibility() == vtkNPRIllustration::EXACT, "the default");
  scene.Illustration->Apply();
  const vtkSmartPointer<vtkImageData> image = scene.Render();
  const vtkMTimeType made = GetTimeOfStrokes(scene.Renderer);
  scene.Render();
  Check(GetTimeOfStrokes(scene.Renderer) == made, "nothing is done twice for one view");

  const auto seconds = [&scene]() { return scene.Illustration->GetStageSeconds("visibility"); };
  double before = seconds();
  Check(before > 0.0, "the time that it takes is told");
  scene.Window->SetDesiredUpdateRate(15.0);
  camera->Elevation(1.0);
  Check(
    scene.IsHiddenAt(0.0) && seconds() == before, "the depth buffer serves while one interacts");
  scene.Window->SetDesiredUpdateRate(0.0001);
  camera->Elevation(-1.0);
  Check(npr::ComputeLargestDifference(scene.Render(), image) < 10 && seconds() > before,
    "and the surfaces do afterwards");

  vtkNew<vtkWindowToImageFilter> tiles;
  tiles->SetInput(scene.Window);
  tiles->SetScale(2);
  tiles->Update();
  Check(CountInk(tiles->GetOutput(), 0.0) == 0 && CountInk(tiles->GetOutput(), 3.0) > 200,
    "a picture in tiles");

  vtkNew<vtkPropPicker> picker;
  Check(picker->Pick(200.0, 150.0, 0.0, scene.Renderer) && picker->GetActor() == scene.Front,
    "the actor is picked, not its strokes");

  // As far away as coordinates of the world have no digits left in single precision.
  Scene far(cube, 1e7 + 0.37);
  far.Illustration->Apply();
  Check(npr::ComputeLargestDifference(far.Render(), image) < 60, "far from the origin");
}

void TestViewports(vtkCubeSource* cube)
{
  Scene left(cube);
  Scene right(cube);
  left.Window->SetSize(800, 300);
  left.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  right.Window->RemoveRenderer(right.Renderer);
  right.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  left.Window->AddRenderer(right.Renderer);
  right.Front->SetPosition(3.0, 0.0, 5.0);
  left.Illustration->Apply();
  right.Illustration->Apply();
  const vtkSmartPointer<vtkImageData> image = left.Render();
  const double middle = 200.0 / PixelsPerUnit;
  Check(CountInk(image, -middle) == 0 && CountInk(image, -middle + 3.0) > 100, "the left viewport");
  Check(CountInk(image, middle) > 100 && CountInk(image, middle + 3.0) == 0, "the right viewport");
}
}

int TestIllustrationVisibility(int, char*[])
{
  vtkNew<vtkCubeSource> cube;
  for (const int visibility : { vtkNPRIllustration::DEPTH_BUFFER, vtkNPRIllustration::EXACT })
  {
    TestActors(cube, visibility);
    TestClippingPlanes(cube, visibility);
  }
  TestWindow(cube);
  TestViewports(cube);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
