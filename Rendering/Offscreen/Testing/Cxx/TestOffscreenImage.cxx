// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Each backend draws a sphere that covers the disc it must, at each size, without multisampling,
// and all backends draw the same picture.
#include "nprOffscreenTesting.h"

#include <algorithm>
#include <cstdlib>

using namespace npr::testing;

int TestOffscreenImage(int, char*[])
{
  bool ok = true;
  std::vector<std::vector<unsigned char>> images;
  for (const int backend : Backends())
  {
    ok &= Check(vtkNPROffscreen::Setup(backend), "Setup " + std::to_string(backend));
    const auto window = NewSphereWindow(200);
    ok &= Check(window->GetMultiSamples() == 0, "multisampling is off");
    window->Render();
    ok &= CoversDisc(window, 200);
    images.push_back(Pixels(window));

    for (const int size : { 320, 96, 200 })
    {
      window->SetSize(size, size);
      window->Render();
      ok &= CoversDisc(window, size);
    }
    ok &=
      Check(Pixels(window) == images.back(), "after resizing to and fro the picture is the same");

    // A window that was finalized starts anew.
    window->Finalize();
    window->Render();
    ok &= CoversDisc(window, 200);

    const std::string renderer = vtkNPROffscreen::GetGLRenderer(window);
    std::cout << window->GetClassName() << ": " << renderer << ", "
              << vtkNPROffscreen::GetGLVendor(window) << ", "
              << vtkNPROffscreen::GetGLVersion(window) << std::endl;
    ok &= Check(!renderer.empty() && !vtkNPROffscreen::GetGLVendor(window).empty() &&
        vtkNPROffscreen::GetGLVersion(window)[0] >= '3',
      "the driver says who it is");
  }
  for (std::size_t i = 1; i < images.size(); ++i)
  {
    int worst = 256;
    if (images[i].size() == images[0].size())
    {
      worst = 0;
      for (std::size_t j = 0; j < images[0].size(); ++j)
      {
        worst = std::max(worst, std::abs(images[i][j] - images[0][j]));
      }
    }
    std::cout << "greatest difference between backends: " << worst << std::endl;
    ok &= Check(worst <= 2, "the backends draw the same picture");
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
