// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Back faces are left out where they can not be seen, and only there.
#include "nprTestScene.h"
#include "nprVisibleSides.h"

#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkCylinderSource.h>
#include <vtkParametricBohemianDome.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricKlein.h>
#include <vtkParametricTorus.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkReverseSense.h>
#include <vtkSphereSource.h>
#include <vtkTriangleFilter.h>

#include <cstdlib>
#include <functional>
#include <iostream>

namespace
{
int Failures = 0;

void Check(bool good, const std::string& what)
{
  if (!good)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++Failures;
  }
}

bool ShowsOnlyFronts(vtkAlgorithmOutput* surface)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(surface);
  triangles->Update();
  return npr::ShowsOnlyFronts(triangles->GetOutput());
}

bool ShowsOnlyFronts(vtkParametricFunction* function)
{
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(function);
  return ShowsOnlyFronts(source->GetOutputPort());
}

void TestSurfaces()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  Check(ShowsOnlyFronts(sphere->GetOutputPort()), "a sphere shows backs");
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputConnection(sphere->GetOutputPort());
  Check(!ShowsOnlyFronts(reversed->GetOutputPort()), "a sphere turned inside out shows fronts");
  vtkNew<vtkSphereSource> other;
  other->SetCenter(0.4, 0.1, 0.2);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputConnection(sphere->GetOutputPort());
  both->AddInputConnection(other->GetOutputPort());
  Check(ShowsOnlyFronts(both->GetOutputPort()), "spheres that overlap show backs");
  sphere->SetEndPhi(160.0);
  Check(!ShowsOnlyFronts(sphere->GetOutputPort()), "a sphere with a hole shows fronts alone");

  vtkNew<vtkParametricKlein> klein;
  Check(!ShowsOnlyFronts(klein), "Klein's bottle shows fronts alone");
  vtkNew<vtkParametricBohemianDome> dome;
  Check(!ShowsOnlyFronts(dome), "a dome that crosses itself shows fronts alone");
  vtkNew<vtkPolyData> nothing;
  Check(!npr::ShowsOnlyFronts(nothing), "nothing shows fronts");
}

void TestPictures()
{
  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  npr::TestScene scene(source->GetOutputPort());
  scene.Style->LoadBuiltIn("toon");
  vtkCamera* const camera = scene.Renderer->GetActiveCamera();
  scene.Renderer->ResetCamera();
  camera->Elevation(-50.0);
  scene.Renderer->ResetCameraClippingRange();
  scene.Illustration->Apply();
  const auto render = [&](bool culled, const std::string& what)
  {
    const auto image = scene.Render();
    Check((scene.Actor->GetProperty()->GetBackfaceCulling() != 0) == culled, what);
    return image;
  };

  const auto first = render(true, "the back of a torus is drawn");
  vtkNew<vtkPlane> plane; // far away
  plane->SetOrigin(0.0, 0.0, -100.0);
  scene.Mapper->AddClippingPlane(plane);
  scene.Illustration->Apply();
  const auto whole = render(false, "what is clipped shows no backs");
  Check(npr::ComputeLargestDifference(first, whole) <= 1, "without backs the picture is another");
  scene.Mapper->RemoveAllClippingPlanes();
  scene.Illustration->Apply();

  vtkNew<vtkCamera> outside;
  outside->DeepCopy(camera);
  const std::pair<const char*, std::function<void(bool)>> changes[] = {
    { "opacity", [&](bool on) { scene.Actor->GetProperty()->SetOpacity(on ? 0.5 : 1.0); } },
    { "mirror", [&](bool on) { scene.Actor->SetScale(on ? -1.0 : 1.0, 1.0, 1.0); } },
    { "camera in the hole",
      [&](bool on)
      {
        camera->DeepCopy(outside);
        if (on)
        {
          camera->SetPosition(0.0, 0.0, 0.0);
          camera->SetFocalPoint(1.0, 0.0, 0.0);
          camera->SetViewUp(0.0, 0.0, 1.0);
          scene.Renderer->ResetCameraClippingRange();
        }
      } },
    { "near plane",
      [&](bool on)
      {
        camera->DeepCopy(outside);
        camera->SetClippingRange(
          camera->GetClippingRange()[0] + (on ? 2.5 : 0.0), camera->GetClippingRange()[1]);
      } },
    { "hole",
      [&](bool on)
      {
        torus->SetMaximumU(on ? 5.0 : 2.0 * vtkMath::Pi());
        torus->SetJoinU(!on);
      } },
  };
  for (const auto& [what, change] : changes)
  {
    change(true);
    render(false, std::string("backs are not drawn with ") + what);
    change(false);
    const auto image = render(true, std::string("backs are still drawn after ") + what);
    Check(npr::ComputeLargestDifference(first, image) == 0,
      std::string("the picture does not come back after ") + what);
  }

  scene.Illustration->Remove();
  Check(!scene.Actor->GetProperty()->GetBackfaceCulling(), "the user's property was changed");
}
}

int TestIllustrationSides(int, char*[])
{
  TestSurfaces();
  TestPictures();
  return Failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
