// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprOffscreenTesting.h
 * @brief The scene that the tests of this module draw, and how they look at the result.
 */
#ifndef nprOffscreenTesting_h
#define nprOffscreenTesting_h

#include "nprVTKCompat.h"
#include "vtkNPROffscreen.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace npr
{
namespace testing
{

/** The backends that must work wherever the tests run. */
inline std::vector<int> Backends()
{
#if NPR_VTK_AT_LEAST(9, 4)
  return { vtkNPROffscreen::EGL }; // newer systems have no OSMesa
#else
  return { vtkNPROffscreen::OSMESA, vtkNPROffscreen::EGL };
#endif
}

/** Prints what went wrong and returns whether all is well. */
inline bool Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << std::endl;
  }
  return condition;
}

/** A window of @a size x @a size pixels with a sphere whose diameter is half of that. */
inline vtkSmartPointer<vtkRenderWindow> NewSphereWindow(int size, int resolution = 128)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->GetActiveCamera()->SetParallelScale(1.0);
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetSize(size, size);
  window->AddRenderer(renderer);
  return window;
}

inline vtkRenderer* FirstRenderer(vtkRenderWindow* window)
{
  return window->GetRenderers()->GetFirstRenderer();
}

/** The window's pixels, three bytes each. */
inline std::vector<unsigned char> Pixels(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> array;
  const int* size = window->GetSize();
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, array);
  const unsigned char* data = array->GetPointer(0);
  return std::vector<unsigned char>(data, data + array->GetNumberOfValues());
}

/** How many pixels are not black. */
inline int Covered(const std::vector<unsigned char>& pixels)
{
  int covered = 0;
  for (std::size_t i = 0; i + 2 < pixels.size(); i += 3)
  {
    covered += pixels[i] || pixels[i + 1] || pixels[i + 2] ? 1 : 0;
  }
  return covered;
}

/** Whether the sphere of NewSphereWindow(size) covers the disc it must. */
inline bool CoversDisc(vtkRenderWindow* window, int size)
{
  const double pi = std::acos(-1.0);
  const double expected = pi * size * size / 16.0;
  const auto pixels = Pixels(window);
  const int covered = Covered(pixels);
  const bool sized = pixels.size() == static_cast<std::size_t>(3 * size * size);
  return Check(sized && std::abs(covered - expected) < 0.01 * expected,
    std::string(window->GetClassName()) + ": the sphere covers " + std::to_string(covered) +
      " pixels instead of " + std::to_string(expected));
}

} // namespace testing
} // namespace npr
#endif
