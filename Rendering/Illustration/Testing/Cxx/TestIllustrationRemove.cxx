// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Apply and Remove: the renderer and its actors come back as they were, to the last bit.
#include "nprTestScene.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTexture.h>

#include <cstdlib>
#include <iostream>

int TestIllustrationRemove(int, char*[])
{
  vtkNew<vtkSphereSource> sphere;
  npr::TestScene scene(sphere->GetOutputPort());
  scene.Actor->GetProperty()->SetColor(0.8, 0.3, 0.2);
  vtkNew<vtkTexture> texture;
  scene.Actor->SetTexture(texture);
  vtkNew<vtkLight> light;
  light->SetPosition(1.0, 2.0, 3.0);
  scene.Renderer->AddLight(light);
  scene.Renderer->SetBackground(0.1, 0.2, 0.3);
  scene.Renderer->ResetCamera();
  const auto before = scene.Render();

  for (const std::string& name : vtkNPRIllustrationStyle::GetBuiltInNames())
  {
    scene.Style->LoadBuiltIn(name);
    if (!scene.Illustration->Apply())
    {
      return EXIT_FAILURE;
    }
    const auto illustrated = scene.Render();
    if (npr::ComputeLargestDifference(before, illustrated) < 50)
    {
      std::cerr << "FAILED: the style " << name << " changes nothing\n";
      return EXIT_FAILURE;
    }
  }
  scene.Illustration->Remove();
  const auto after = scene.Render();
  if (npr::ComputeLargestDifference(before, after) != 0 ||
    scene.Actor->GetMapper() != scene.Mapper || scene.Actor->GetTexture() != texture ||
    scene.Renderer->GetActors()->GetNumberOfItems() != 1 ||
    scene.Renderer->GetLights()->GetNumberOfItems() != 1 || scene.Renderer->GetPass())
  {
    std::cerr << "FAILED: Remove() did not give back the renderer\n";
    return EXIT_FAILURE;
  }

  // One after the other, and taken off in the same order.
  {
    vtkNew<vtkNPRIllustration> first;
    vtkNew<vtkNPRIllustration> second;
    for (vtkNPRIllustration* illustration : { first.Get(), second.Get() })
    {
      illustration->SetRenderer(scene.Renderer);
      if (!illustration->Apply())
      {
        return EXIT_FAILURE;
      }
      scene.Render();
    }
    first->Remove();
    if (npr::ComputeLargestDifference(before, scene.Render()) < 50)
    {
      std::cerr << "FAILED: the second illustration went with the first\n";
      return EXIT_FAILURE;
    }
  }
  if (npr::ComputeLargestDifference(before, scene.Render()) != 0)
  {
    std::cerr << "FAILED: two illustrations did not give back the renderer\n";
    return EXIT_FAILURE;
  }

  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkNPRIllustration> alone;
  return alone->Apply() ? EXIT_FAILURE : EXIT_SUCCESS;
}
