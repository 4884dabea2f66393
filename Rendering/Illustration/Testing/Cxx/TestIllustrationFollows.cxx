// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// After Apply(), Render() alone keeps an illustration current: after the camera, the actor or its
// data have changed it shows the same as an illustration made anew.
#include "nprImageComparison.h"
#include "nprTestScene.h"

#include <vtkCamera.h>
#include <vtkCylinderSource.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>

#include <cstdlib>
#include <functional>
#include <iostream>

int TestIllustrationFollows(int, char*[])
{
  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  npr::TestScene scene(source->GetOutputPort());
  scene.Style->LoadBuiltIn("ink");
  scene.Renderer->ResetCamera();
  scene.Illustration->Apply();
  auto last = scene.Render();
  if (npr::CountDarkPixels(last, 100) < 500)
  {
    std::cerr << "FAILED: no lines to begin with\n";
    return EXIT_FAILURE;
  }

  const std::pair<const char*, std::function<void()>> changes[] = {
    { "camera turned", [&]() { scene.Renderer->GetActiveCamera()->Elevation(-50.0); } },
    { "actor turned", [&]() { scene.Actor->RotateY(35.0); } },
    { "actor moved and scaled",
      [&]()
      {
        scene.Actor->SetPosition(0.3, 0.1, 0.0);
        scene.Actor->SetScale(0.8, 0.8, 0.8);
      } },
    { "data changed", [&]() { torus->SetCrossSectionRadius(0.3); } },
    { "camera replaced",
      [&]()
      {
        vtkNew<vtkCamera> camera;
        camera->DeepCopy(scene.Renderer->GetActiveCamera());
        camera->Azimuth(20.0);
        scene.Renderer->SetActiveCamera(camera);
      } },
    { "input replaced",
      [&]()
      {
        vtkNew<vtkCylinderSource> cylinder;
        cylinder->SetResolution(32);
        scene.Mapper->SetInputConnection(cylinder->GetOutputPort());
      } },
  };
  for (const auto& [what, change] : changes)
  {
    change();
    const auto followed = scene.Render();
    scene.Illustration->Apply();
    const auto anew = scene.Render();
    if (npr::ComputeLargestDifference(followed, last) < 100)
    {
      std::cerr << "FAILED: " << what << ": nothing moved\n";
      return EXIT_FAILURE;
    }
    // Splines are sampled and details chosen for the view at Apply(), so not to the last bit.
    npr::ImageLimits limits;
    limits.LocalSSIM = 0.0;
    const npr::ImageComparison comparison = npr::CompareImages(anew, followed, limits);
    if (!comparison.Passes())
    {
      std::cerr << "FAILED: " << what << ": not as one made anew\n" << comparison.Report();
      return EXIT_FAILURE;
    }
    last = anew;
  }

  const auto draw = [&scene](bool contours, bool others)
  {
    for (int type = 0; type < 10; ++type)
    {
      scene.Illustration->SetLineVisibility(type, type == 0 ? contours : others);
    }
    return npr::CountDarkPixels(scene.Render(), 100);
  };
  const int none = draw(false, false);
  const int contours = draw(true, false);
  const int all = draw(true, true);
  if (none != 0 || contours == 0 || contours >= all)
  {
    std::cerr << "FAILED: kinds of lines are not shown and hidden: " << none << ", " << contours
              << ", " << all << "\n";
    return EXIT_FAILURE;
  }

  scene.Actor->VisibilityOff();
  if (npr::CountDarkPixels(scene.Render(), 250) != 0)
  {
    std::cerr << "FAILED: the lines of an invisible actor are drawn\n";
    return EXIT_FAILURE;
  }
  scene.Actor->VisibilityOn();
  scene.Renderer->RemoveActor(scene.Actor);
  if (npr::CountDarkPixels(scene.Render(), 250) != 0)
  {
    std::cerr << "FAILED: the lines of a removed actor are drawn\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
