// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Windows that live at once, of the same backend and of different ones, draw in turn; each keeps
// its own textures and colours, also when another one's resources are freed in between.
#include "nprOffscreenTesting.h"

#include <vtkImageData.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPlaneSource.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <array>
#include <cstdlib>
#include <thread>

using namespace npr::testing;

namespace
{

using Color = std::array<unsigned char, 3>;

/** A window filled by a plane with a texture of one colour. */
vtkSmartPointer<vtkRenderWindow> NewTexturedWindow(const Color& color)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 8 * 8 * 3; ++i)
  {
    values[i] = color[static_cast<std::size_t>(i % 3)];
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  actor->GetProperty()->LightingOff();
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->GetActiveCamera()->SetParallelScale(0.25);
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetSize(32, 32);
  window->AddRenderer(renderer);
  return window;
}

bool ShowsOnly(vtkRenderWindow* window, const Color& color)
{
  const auto pixels = Pixels(window);
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    if (pixels[i] != color[i % 3])
    {
      return Check(false, std::string(window->GetClassName()) + " lost its texture");
    }
  }
  return Check(!pixels.empty(), "pixels are read");
}

} // namespace

int TestOffscreenSwitch(int, char*[])
{
  bool ok = true;
  std::vector<vtkSmartPointer<vtkRenderWindow>> windows;
  std::vector<Color> colors;
  for (int round = 0; round < 2; ++round)
  {
    for (const int backend : Backends())
    {
      ok &= Check(vtkNPROffscreen::Setup(backend), "Setup " + std::to_string(backend));
      colors.push_back({ static_cast<unsigned char>(40 * colors.size() + 30),
        static_cast<unsigned char>(200 - 50 * colors.size()), 77 });
      windows.push_back(NewTexturedWindow(colors.back()));
    }
  }
  for (int turn = 0; turn < 3; ++turn)
  {
    for (std::size_t i = 0; i < windows.size(); ++i)
    {
      windows[i]->Render();
      ok &= ShowsOnly(windows[i], colors[i]);
    }
    // Reading needs no new rendering, in whatever order.
    for (std::size_t i = windows.size(); i-- > 0;)
    {
      ok &= ShowsOnly(windows[i], colors[i]);
    }
  }

  // Freeing one window's resources leaves the thread to the window that had it.
  auto* last = vtkOpenGLRenderWindow::SafeDownCast(windows.back());
  last->MakeCurrent();
  vtkRenderer* other = FirstRenderer(windows.front());
  other->RemoveAllViewProps();
  ok &= Check(last->IsCurrent(), "freeing props of another window keeps the current context");
  windows.erase(windows.begin());
  colors.erase(colors.begin());
  ok &= Check(last->IsCurrent(), "deleting another window keeps the current context");
  for (auto& window : windows)
  {
    auto* openGL = vtkOpenGLRenderWindow::SafeDownCast(window);
    openGL->PushContext();
    ok &= Check(openGL->IsCurrent(), "PushContext makes current");
    openGL->PopContext();
    ok &= Check(last->IsCurrent(), "PopContext gives back what was current");
  }

  // A window may be drawn by another thread, one at a time.
  for (const int backend : Backends())
  {
    vtkNPROffscreen::Setup(backend);
    bool drawn = false;
    std::thread(
      [&drawn]
      {
        const auto window = NewSphereWindow(64);
        window->Render();
        drawn = CoversDisc(window, 64);
      })
      .join();
    ok &= drawn;
  }
  for (std::size_t i = 0; i < windows.size(); ++i)
  {
    windows[i]->Render();
    ok &= ShowsOnly(windows[i], colors[i]);
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
