// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Outlines without extraction in an illustration: each kind on shaded surfaces and on paper, what
// their keys do, that they follow the window's size, and that nothing of them stays.
#include "nprTestScene.h"

#include <vtkCommand.h>
#include <vtkRenderStepsPass.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
bool Good = true;

void Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    Good = false;
  }
}

std::string MakeStyle(const std::string& shading, const std::string& outline)
{
  return R"({"shading": {"style": ")" + shading +
    R"(", "color": "white", "ambient": 1, "diffuse": 0}, "outline": {)" + outline + "}}";
}
}

int TestIllustrationOutlines(int, char*[])
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  npr::TestScene scene(sphere->GetOutputPort());
  scene.Renderer->SetBackground(0.1, 0.2, 0.3);
  scene.Renderer->ResetCamera();
  const auto before = scene.Render();
  const auto draw = [&](const std::string& shading, const std::string& outline)
  {
    Check(scene.Style->LoadString(MakeStyle(shading, outline)), "refused: " + outline);
    Check(scene.Illustration->Apply(), "Apply");
    return npr::CountDarkPixels(scene.Render(), 128);
  };

  const std::vector<std::string> kinds = vtkNPRIllustrationStyle::GetOutlineNames();
  for (const std::string shading : { "phong", "paper" })
  {
    for (int kind = 0; kind < static_cast<int>(kinds.size()); ++kind)
    {
      const std::string name = shading + ", " + kinds[kind];
      const int dark = draw(shading, R"("width": 4, "kind": ")" + kinds[kind] + "\"");
      Check(scene.Style->GetOutline() == kind, "the kind that is read: " + name);
      Check(kind == 0 ? dark == 0 : dark > 500 && dark < 4000,
        name + ": " + std::to_string(dark) + " dark pixels");
      scene.Illustration->Remove();
      Check(
        npr::ComputeLargestDifference(before, scene.Render()) == 0, "something is left: " + name);
    }
  }

  // Twice the width is about twice the ink; so is twice the window, of which each line is a share.
  for (const std::string kind : { "back-faces", "image-edges" })
  {
    const std::string key = R"("kind": ")" + kind + "\"";
    const int thin = draw("phong", key + R"(, "width": 5)");
    const int wide = draw("phong", key + R"(, "width": 10)");
    Check(wide > 1.7 * thin && wide < 2.3 * thin, "the width of " + kind);
    scene.Window->SetSize(1600, 1200);
    const int large = npr::CountDarkPixels(scene.Render(), 128);
    // In windows below 600 pixels lines stay as wide as there.
    Check(large > 7.0 * wide && large < 9.0 * wide, "the width after resizing, " + kind);
    scene.Window->SetSize(400, 300);
  }
  const std::string grazing = R"("kind": "grazing", "grazing_softness": 0, "grazing_threshold": )";
  Check(draw("phong", grazing + "0.5") > 2 * draw("phong", grazing + "0.2"), "the threshold");

  const std::string edges = R"("kind": "image-edges", "color": "black", "object_edges": )";
  Check(draw("phong", edges + R"(true, "depth_threshold": 0.01, "normal_threshold": 60)") > 500,
    "all keys of edges of the image");
  Check(draw("phong", edges + R"(false, "normal_threshold": 180)") > 500, "without object edges");
  Check(draw("phong", R"("kind": "back-faces", "color": "white")") == 0, "the colour");

  scene.Style->SetOutline(99);
  Check(scene.Style->GetOutline() == vtkNPRIllustrationStyle::ImageEdges, "a kind out of range");

  // A renderer with a pass of its own has no place for edges of the image, and says so.
  scene.Illustration->Remove();
  vtkNew<vtkRenderStepsPass> own;
  scene.Renderer->SetPass(own);
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Illustration->AddObserver(vtkCommand::WarningEvent, observer);
  Check(draw("phong", R"("kind": "image-edges")") == 0, "edges with a pass of one's own");
  Check(observer->GetWarning(), "no warning of a pass of one's own");
  Check(draw("phong", R"("kind": "back-faces")") > 500, "back faces with a pass of one's own");
  scene.Illustration->Remove();
  Check(scene.Renderer->GetPass() == own, "the renderer's own pass is lost");
  return Good ? EXIT_SUCCESS : EXIT_FAILURE;
}
