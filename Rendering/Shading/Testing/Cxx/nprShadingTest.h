// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprShadingTest.h
 * @brief What the tests of shading share: a window, its pixels, and checks that say what failed.
 */
#ifndef nprShadingTest_h
#define nprShadingTest_h

#include "vtkNPROffscreen.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace npr
{
namespace testing
{
using Vector = std::array<double, 3>;

inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector Unit(const Vector& a)
{
  const double length = std::sqrt(Dot(a, a));
  return { a[0] / length, a[1] / length, a[2] / length };
}

struct Image
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Bytes; // RGB, from the lower left

  std::array<int, 3> At(int x, int y) const
  {
    const unsigned char* p = &this->Bytes[3 * (static_cast<size_t>(y) * this->Width + x)];
    return { p[0], p[1], p[2] };
  }

  std::set<std::array<int, 3>> Colors() const
  {
    std::set<std::array<int, 3>> colors;
    for (int y = 0; y < this->Height; ++y)
    {
      for (int x = 0; x < this->Width; ++x)
      {
        colors.insert(this->At(x, y));
      }
    }
    return colors;
  }
};

inline double MeanDifference(const Image& a, const Image& b)
{
  double sum = 0.0;
  for (size_t i = 0; i < a.Bytes.size(); ++i)
  {
    sum += std::abs(int(a.Bytes[i]) - int(b.Bytes[i]));
  }
  return sum / static_cast<double>(a.Bytes.size());
}

/// Sets up drawing without a display, and collects failures.
struct Checker
{
  int Failures = 0;
  std::string Folder = ".";

  Checker(int argc, char* argv[])
  {
    (*this)(vtkNPROffscreen::Setup(), vtkNPROffscreen::GetErrorMessage());
    for (int i = 1; i + 1 < argc; ++i)
    {
      if (!std::strcmp(argv[i], "-T"))
      {
        this->Folder = argv[i + 1];
      }
    }
  }

  void operator()(bool good, const std::string& what)
  {
    if (!good)
    {
      std::cerr << "FAILED: " << what << "\n";
      ++this->Failures;
    }
  }

  int Result() const { return this->Failures ? EXIT_FAILURE : EXIT_SUCCESS; }
};

/// A renderer in a window of its own. The camera looks along -z from (0, 0, 4).
struct Stage
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;

  explicit Stage(int size = 200)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(size, size);
    this->Window->AddRenderer(this->Renderer);
    this->Clear();
  }

  /// Back to an empty stage.
  void Clear()
  {
    this->Renderer->SetPass(nullptr);
    this->Renderer->RemoveAllViewProps();
    this->Renderer->RemoveAllLights();
    this->Renderer->SetUseDepthPeeling(0);
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    vtkNew<vtkCamera> camera;
    camera->SetPosition(0, 0, 4);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(0, 1, 0);
    camera->SetViewAngle(30);
    camera->SetParallelScale(1.1);
    camera->SetClippingRange(1, 10);
    this->Renderer->SetActiveCamera(camera);
  }

  vtkActor* Add(vtkAlgorithmOutput* surface)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(surface);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }

  vtkActor* AddSphere(int resolution = 200)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(resolution);
    sphere->SetPhiResolution(resolution);
    return this->Add(sphere->GetOutputPort());
  }

  /// A light that shines from the direction given.
  vtkLight* AddLight(double x, double y, double z)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(x, y, z);
    light->SetFocalPoint(0, 0, 0);
    this->Renderer->AddLight(light);
    return light;
  }

  Image Render(const std::string& file = std::string())
  {
    this->Window->Render();
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(this->Window);
    grab->SetInputBufferTypeToRGB();
    grab->ReadFrontBufferOff();
    grab->ShouldRerenderOff();
    grab->Update();
    vtkImageData* data = grab->GetOutput();
    Image image;
    image.Width = data->GetDimensions()[0];
    image.Height = data->GetDimensions()[1];
    const auto* bytes = static_cast<unsigned char*>(data->GetScalarPointer());
    image.Bytes.assign(bytes, bytes + size_t(3) * image.Width * image.Height);
    if (!file.empty())
    {
      vtkNew<vtkPNGWriter> writer;
      writer->SetFileName(file.c_str());
      writer->SetInputData(data);
      writer->Write();
    }
    return image;
  }
};

/// Catches an object's errors and warnings instead of printing them.
class MessageCatcher : public vtkCommand
{
public:
  static MessageCatcher* New() { return new MessageCatcher; }
  void Execute(vtkObject*, unsigned long event, void* data) override
  {
    (event == vtkCommand::ErrorEvent ? this->Errors : this->Warnings)
      .push_back(static_cast<const char*>(data));
  }
  void Watch(vtkObject* object)
  {
    object->AddObserver(vtkCommand::ErrorEvent, this);
    object->AddObserver(vtkCommand::WarningEvent, this);
  }
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};
}
}

#endif
