// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What the tests of strokes share: lines of points, a picture of them, and its ink in numbers.
#ifndef nprStrokeTesting_h
#define nprStrokeTesting_h

#include "vtkNPRStrokeMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <array>
#include <cmath>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

namespace nprtest
{
inline int Failures = 0;

inline void Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++Failures;
  }
}

using Point = std::array<double, 3>;
using Line = std::vector<Point>;

inline vtkSmartPointer<vtkPolyData> MakeLines(const std::vector<Line>& lines)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Line& line : lines)
  {
    vtkNew<vtkIdList> ids;
    for (const Point& point : line)
    {
      ids->InsertNextId(points->InsertNextPoint(point.data()));
    }
    cells->InsertNextCell(ids);
  }
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

inline const double Pi = vtkMath::Pi();

inline void Expect(double value, double expected, double relative, const std::string& what)
{
  Check(std::abs(value - expected) <= relative * std::abs(expected),
    what + ": " + std::to_string(value) + " instead of " + std::to_string(expected));
}

inline vtkNPRStrokeMapper* GetMapper(vtkActor* actor)
{
  return vtkNPRStrokeMapper::SafeDownCast(actor->GetMapper());
}

inline Line MakeCircle(int segments, double x, double y, double radius)
{
  Line circle;
  for (int i = 0; i <= segments; ++i)
  {
    const double angle = 2 * Pi * (i % segments) / segments;
    circle.push_back({ x + radius * std::cos(angle), y + radius * std::sin(angle), 0 });
  }
  return circle;
}

inline Line MakeStraight(double x0, double x1, double y, int segments)
{
  Line line;
  for (int i = 0; i <= segments; ++i)
  {
    line.push_back({ x0 + (x1 - x0) * i / segments, y, 0 });
  }
  return line;
}

/// A white picture in which world coordinates are pixels (parallel projection, z towards the eye).
class Picture
{
public:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkUnsignedCharArray> Pixels;
  int Width;
  int Height;

  Picture(int width, int height) : Width(width), Height(height)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(1, 1, 1);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * height);
    camera->SetFocalPoint(0.5 * width, 0.5 * height, 0);
    camera->SetPosition(0.5 * width, 0.5 * height, 1000);
    camera->SetClippingRange(1, 2000);
  }

  vtkSmartPointer<vtkActor> AddStrokes(vtkPolyData* lines, double width)
  {
    vtkNew<vtkNPRStrokeMapper> mapper;
    mapper->SetInputData(lines);
    mapper->SetWidth(width);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0, 0, 0);
    this->Renderer->AddActor(actor);
    return actor;
  }

  void Render()
  {
    this->Window->Render();
    this->Window->GetRGBACharPixelData(0, 0, this->Width - 1, this->Height - 1, 1, this->Pixels);
  }

  int GetRed(int x, int y) const
  {
    return this->Pixels->GetValue(4 * (static_cast<vtkIdType>(y) * this->Width + x));
  }

  /// Darkness of a pixel on white, [0, 1].
  double GetInk(int x, int y) const { return 1.0 - this->GetRed(x, y) / 255.0; }

  /// Sum of the ink in [x0, x1) x [y0, y1).
  double GetInk(int x0, int y0, int x1, int y1) const
  {
    double sum = 0;
    for (int y = y0; y < y1; ++y)
    {
      for (int x = x0; x < x1; ++x)
      {
        sum += this->GetInk(x, y);
      }
    }
    return sum;
  }

  double GetInk() const { return this->GetInk(0, 0, this->Width, this->Height); }

  /// Writes the last picture for people to look at.
  void Write(int argc, char* argv[], const std::string& name)
  {
    std::string folder;
    for (int i = 1; i + 1 < argc; ++i)
    {
      if (std::strcmp(argv[i], "-T") == 0)
      {
        folder = argv[i + 1];
      }
    }
    if (folder.empty())
    {
      return;
    }
    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput(this->Window);
    image->SetInputBufferTypeToRGB();
    image->ReadFrontBufferOff();
    image->ShouldRerenderOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(image->GetOutputPort());
    writer->SetFileName((folder + "/" + name + ".png").c_str());
    writer->Write();
  }
};
}

#endif
