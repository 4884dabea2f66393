// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprTestScene_h
#define nprTestScene_h

#include "vtkNPRIllustration.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPROffscreen.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace npr
{
/// One model in a window of 400x300 without a display.
struct TestScene
{
  explicit TestScene(vtkAlgorithmOutput* model)
  {
    this->Mapper->SetInputConnection(model);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(400, 300);
    this->Window->AddRenderer(this->Renderer);
    this->Illustration->SetRenderer(this->Renderer);
    this->Illustration->SetStyle(this->Style);
  }

  vtkSmartPointer<vtkImageData> Render()
  {
    this->Window->Render();
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(this->Window);
    grab->ReadFrontBufferOff();
    grab->ShouldRerenderOff();
    grab->Update();
    return grab->GetOutput();
  }

  // The window's class is settled before it is made.
  bool IsSetUp = vtkNPROffscreen::Setup();
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkNPRIllustrationStyle> Style;
  vtkNew<vtkNPRIllustration> Illustration;
};

/// How many pixels are darker than the limit, from 0 to 255, in all channels.
inline int CountDarkPixels(vtkImageData* image, int limit)
{
  const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer());
  const int channels = image->GetNumberOfScalarComponents();
  int count = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i, pixel += channels)
  {
    count += pixel[0] < limit && pixel[1] < limit && pixel[2] < limit;
  }
  return count;
}

/// The largest difference of any channel at any pixel.
inline int ComputeLargestDifference(vtkImageData* one, vtkImageData* other)
{
  const auto* a = static_cast<const unsigned char*>(one->GetScalarPointer());
  const auto* b = static_cast<const unsigned char*>(other->GetScalarPointer());
  const vtkIdType size = one->GetNumberOfPoints() * one->GetNumberOfScalarComponents();
  int largest = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    largest = std::max(largest, std::abs(int(a[i]) - int(b[i])));
  }
  return largest;
}
}

#endif
