// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Each built-in style on the sample, and on a part with sharp edges, against its baseline; and
// ridges and valleys, which they draw when asked.
#include "nprImageComparison.h"
#include "nprTestScene.h"
#include "vtkNPRSampleSource.h"
#include "vtkNPRViewpoint.h"

#include <vtkCylinderSource.h>

#include <cstdlib>

int TestBuiltInStyles(int argc, char* argv[])
{
  vtkNew<vtkNPRSampleSource> sample;
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(24);
  const std::pair<const char*, vtkAlgorithm*> models[] = { { "sample", sample },
    { "cylinder", cylinder } };
  int result = EXIT_SUCCESS;
  for (const auto& [model, source] : models)
  {
    npr::TestScene scene(source->GetOutputPort());
    vtkNew<vtkNPRViewpoint> viewpoint;
    viewpoint->Apply(scene.Renderer);
    const auto compare = [&](const std::string& name)
    {
      scene.Illustration->Apply();
      scene.Window->Render();
      const std::string baseline = name + "-" + model;
      if (npr::CompareWithBaseline(scene.Window, baseline.c_str(), argc, argv) != EXIT_SUCCESS)
      {
        result = EXIT_FAILURE;
      }
    };
    for (const std::string& name : vtkNPRIllustrationStyle::GetBuiltInNames())
    {
      scene.Style->LoadBuiltIn(name);
      compare(name);
    }
    // Lines that a style describes, but only draws where they are asked for.
    scene.Style->LoadBuiltIn("ink");
    scene.Style->SelectLines({ "contours", "ridges", "valleys" });
    compare("ridges");
  }
  return result;
}
