// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What strokes are drawn with: opacities, colours, media, on pages and posters.
#include "nprStrokeTesting.h"
#include "vtkNPROffscreen.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkLookupTable.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using nprtest::Check;
using nprtest::Expect;
using nprtest::GetMapper;
using nprtest::MakeCircle;
using nprtest::MakeLines;
using nprtest::MakeStraight;
using nprtest::Pi;
using nprtest::Picture;

namespace
{
void TestOpacities()
{
  vtkSmartPointer<vtkPolyData> line = MakeLines({ MakeStraight(20, 120, 30, 10) });
  vtkNew<vtkFloatArray> opacity;
  opacity->SetName("Opacity");
  for (int i = 0; i <= 10; ++i)
  {
    opacity->InsertNextValue(0.4f);
  }
  line->GetPointData()->AddArray(opacity);
  Picture picture(140, 60);
  vtkSmartPointer<vtkActor> actor = picture.AddStrokes(line, 10);
  const auto measure = [&]()
  {
    picture.Render();
    return picture.GetInk(40, 0, 100, 60) / 600;
  };
  Expect(measure(), 0.4, 0.02, "an array of opacities");
  GetMapper(actor)->SetCapToButt();
  Expect(measure(), 0.4, 0.02, "with other caps");
  GetMapper(actor)->SetPaperGrain(1);
  Expect(measure(), 0.4, 0.25, "as a share of the paper's tooth");
  GetMapper(actor)->UseOpacityArrayOff();
  GetMapper(actor)->SetPaperGrain(0);
  Expect(measure(), 1, 0.01, "switched off");
}

// Scalars of points and of cells, by VTK's usual lookup; the colour of the most ink stays.
void TestColors(int argc, char* argv[])
{
  vtkSmartPointer<vtkPolyData> lines = MakeLines(
    { MakeStraight(20, 180, 40, 16), MakeCircle(64, 100, 90, 30), MakeStraight(20, 180, 90, 1) });
  vtkNew<vtkFloatArray> heat;
  heat->SetName("Heat");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    heat->InsertNextValue(static_cast<float>(lines->GetPoint(i)[0]));
  }
  lines->GetPointData()->SetScalars(heat);
  vtkNew<vtkIntArray> kinds;
  kinds->SetName("Kind");
  kinds->InsertNextValue(0);
  kinds->InsertNextValue(1);
  kinds->InsertNextValue(1);
  lines->GetCellData()->SetScalars(kinds);
  Picture picture(200, 140);
  vtkSmartPointer<vtkActor> actor = picture.AddStrokes(lines, 10);
  vtkNPRStrokeMapper* mapper = GetMapper(actor);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i)
  {
    table->SetTableValue(i, i / 255.0, 0.0, 1.0 - i / 255.0, 1.0);
  }
  mapper->ScalarVisibilityOn();
  mapper->SetLookupTable(table);
  mapper->SetScalarRange(20, 180);
  const auto expect = [&](int x, int y, int red, int green, int blue, const char* what)
  {
    const unsigned char* pixel = picture.Pixels->GetPointer(4 * (y * 200 + x));
    const int worst =
      std::max({ std::abs(pixel[0] - red), std::abs(pixel[1] - green), std::abs(pixel[2] - blue) });
    Check(worst <= 4, std::string(what) + " at " + std::to_string(x) + ", " + std::to_string(y));
  };
  for (bool styled : { false, true })
  {
    mapper->SetCap(styled ? vtkNPRStrokeMapper::BUTT_CAP : vtkNPRStrokeMapper::ROUND_CAP);
    mapper->SetScalarModeToUsePointData();
    mapper->SetScalarRange(20, 180);
    picture.Render();
    picture.Write(argc, argv, styled ? "StrokeColors" : "StrokeColorsPlain");
    for (int x = 30; x < 170; x += 10)
    {
      const int red = static_cast<int>(255 * (x + 0.5 - 20) / 160);
      expect(x, 40, red, 0, 255 - red, "a colour of points");
    }
    expect(70, 90, 80, 0, 175, "a colour of the circle");
    expect(100, 5, 255, 255, 255, "paper");
    actor->GetProperty()->SetOpacity(0.5);
    picture.Render();
    expect(100, 40, 191, 127, 191, "translucent");
    actor->GetProperty()->SetOpacity(1);
    mapper->SetScalarModeToUseCellData();
    mapper->SetScalarRange(0, 1);
    picture.Render();
    expect(100, 40, 0, 0, 255, "a colour of a cell");
    expect(70, 90, 255, 0, 0, "of a crossing");
    mapper->ScalarVisibilityOff();
    picture.Render();
    expect(100, 40, 0, 0, 0, "the colour of the actor");
    mapper->ScalarVisibilityOn();
  }
}

std::vector<unsigned char> GetReds(vtkRenderWindow* window, int scale)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetScale(scale);
  grab->ReadFrontBufferOff();
  grab->Update();
  vtkImageData* image = grab->GetOutput();
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  std::vector<unsigned char> reds;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    reds.push_back(pixels[i * image->GetNumberOfScalarComponents()]);
  }
  return reds;
}

void TestMedia(int argc, char* argv[])
{
  const char* names[] = { "ink", "pencil", "charcoal", "brush" };
  std::vector<unsigned char> last;
  for (int medium = vtkNPRStrokeMapper::INK; medium <= vtkNPRStrokeMapper::BRUSH; ++medium)
  {
    const std::string name = names[medium];
    const auto add = [&](Picture& picture)
    {
      vtkSmartPointer<vtkActor> actor = picture.AddStrokes(
        MakeLines({ MakeCircle(300, 100, 100, 70), MakeStraight(20, 180, 90, 1) }), 9);
      vtkNPRStrokeMapper* mapper = GetMapper(actor);
      mapper->SetMedium(medium);
      mapper->SetPaperGrain(0.8);
      mapper->DepthTestOff();
      return mapper;
    };
    Picture picture(200, 200);
    vtkNPRStrokeMapper* mapper = add(picture);
    picture.Render();
    picture.Write(argc, argv, "StrokeMedium-" + name);
    const double area = 9 * (2 * Pi * 70 + 160);
    Check(picture.GetInk() > 0.35 * area && picture.GetInk() <= 1.02 * area, "enough ink: " + name);
    const std::vector<unsigned char> one = GetReds(picture.Window, 1);
    Check(one == GetReds(picture.Window, 1), "the same again: " + name);
    Check(one != last, "as no other: " + name);
    last = one;
    if (medium != vtkNPRStrokeMapper::INK)
    {
      mapper->SetSeed(7);
      Check(one != GetReds(picture.Window, 1), "another seed: " + name);
    }
    // A poster in four tiles is one page; strokes are as wide, and twice as long.
    Picture tiles(100, 100);
    add(tiles);
    tiles.Renderer->GetActiveCamera()->SetParallelScale(100);
    tiles.Renderer->GetActiveCamera()->SetFocalPoint(100, 100, 0);
    tiles.Renderer->GetActiveCamera()->SetPosition(100, 100, 1000);
    const std::vector<unsigned char> poster = GetReds(tiles.Window, 2);
    int worst = 0;
    for (std::size_t i = 0; i < poster.size(); ++i)
    {
      worst = std::max(worst, std::abs(int(poster[i]) - int(one[i])));
    }
    Check(poster.size() == one.size() && worst <= 3,
      "a poster is one page: " + name + " " + std::to_string(worst));
  }
}
}

int TestStrokeMedia(int argc, char* argv[])
{
  vtkNPROffscreen::Setup();
  TestOpacities();
  TestColors(argc, argv);
  TestMedia(argc, argv);
  return nprtest::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
