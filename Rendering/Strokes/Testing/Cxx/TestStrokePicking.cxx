// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes are picked where they are drawn: each pixel of a selection is held against the picture.
#include "nprStrokeTesting.h"
#include "vtkNPROffscreen.h"

#include <vtkCellData.h>
#include <vtkCellPicker.h>
#include <vtkHardwareSelector.h>
#include <vtkIntArray.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropPicker.h>

#include <cmath>
#include <cstdlib>

using nprtest::Check;
using nprtest::GetMapper;
using nprtest::MakeLines;
using nprtest::Picture;

namespace
{
constexpr int Size = 100;

/// Lines of which the first is cell 1: a vertex comes before them.
vtkSmartPointer<vtkPolyData> MakeCells(const std::vector<nprtest::Line>& of)
{
  vtkSmartPointer<vtkPolyData> lines = MakeLines(of);
  vtkNew<vtkCellArray> vertex;
  vertex->InsertNextCell({ 0 });
  lines->SetVerts(vertex);
  return lines;
}

vtkSmartPointer<vtkPolyData> MakeTwo()
{
  return MakeCells(
    { { { 5, 30.3, 0 }, { 50, 36, 0 }, { 95, 30, 0 } }, { { 8, 90, 0 }, { 92, 55.5, 0 } } });
}

vtkSmartPointer<vtkActor> MakeSquare(double z)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(30, 10, z);
  plane->SetPoint1(60, 10, z);
  plane->SetPoint2(30, 95, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(1, 1, 1); // so that all that is dark is ink
  return actor;
}

/// How many pixels of the strokes are picked; and each where the picture, which is [x0, x0 + Size)
/// x [y0, y0 + Size) of the window, has ink of that cell.
int CheckPicks(Picture& picture, vtkRenderer* renderer, vtkActor* strokes, int x0, int y0,
  const std::string& what, double leastInk = 0.5, double either = 0.05)
{
  picture.Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(x0, y0, x0 + Size - 1, y0 + Size - 1);
  Check(selector->CaptureBuffers(), what + ": the window can select");
  int wrong = 0, wrongCells = 0, picked = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const unsigned int place[2] = { static_cast<unsigned int>(x0 + x),
        static_cast<unsigned int>(y0 + y) };
      const vtkHardwareSelector::PixelInformation pixel = selector->GetPixelInformation(place);
      const bool isPicked = pixel.Valid && pixel.Prop == strokes;
      const double ink = picture.GetInk(x0 + x, y0 + y);
      // What is just in it or just not may be either.
      wrong += std::abs(ink - leastInk) > either && isPicked != (ink > leastInk);
      wrongCells += isPicked && pixel.AttributeID != (y < 45 ? 1 : 2);
      picked += isPicked;
    }
  }
  Check(wrong == 0,
    what +
      ": pixels that are picked but not drawn, or drawn but not picked: " + std::to_string(wrong));
  Check(wrongCells == 0, what + ": pixels of the wrong cell: " + std::to_string(wrongCells));
  Check(picked > 0, what + ": something is picked");
  return picked;
}

// In front of a square and behind it, drawn before it and after it.
void TestVisibility()
{
  int all = 0;
  for (double z : { -10.0, 10.0 })
  {
    for (bool squareFirst : { true, false })
    {
      Picture picture(Size, Size);
      if (squareFirst)
      {
        picture.Renderer->AddActor(MakeSquare(z));
      }
      vtkSmartPointer<vtkActor> strokes = picture.AddStrokes(MakeTwo(), 9);
      if (!squareFirst)
      {
        picture.Renderer->AddActor(MakeSquare(z));
      }
      const int picked = CheckPicks(picture, picture.Renderer, strokes, 0, 0,
        "square at " + std::to_string(z) + ", first " + std::to_string(squareFirst));
      all = z < 0 ? picked : all;
      Check(z < 0 || picked < 0.8 * all, "the square hides its part");
    }
  }
}

void TestStyles()
{
  Picture picture(Size, Size);
  vtkSmartPointer<vtkPolyData> lines = MakeTwo();
  vtkSmartPointer<vtkActor> strokes = picture.AddStrokes(lines, 6);
  const auto check = [&](const std::string& what, double leastInk = 0.5, double either = 0.05)
  { return CheckPicks(picture, picture.Renderer, strokes, 0, 0, what, leastInk, either); };
  const int full = check("round");
  GetMapper(strokes)->SetJoinToMitre();
  GetMapper(strokes)->SetCapToButt();
  Check(check("styled") < full, "butt caps are shorter");
  GetMapper(strokes)->SetDashes(12, 12);
  Check(check("dashed", 0.5, 0.25) < 0.6 * full, "gaps are not picked");
  GetMapper(strokes)->SetDashes(0, 0);

  vtkNew<vtkIntArray> layers;
  layers->SetName("HidingLayers");
  for (int layer : { 0, 1, 0 })
  {
    layers->InsertNextValue(layer);
  }
  lines->GetCellData()->AddArray(layers);
  GetMapper(strokes)->UseHidingLayersOn();
  Check(check("hidden by an array") < 0.6 * full, "one of two is hidden");
  GetMapper(strokes)->SetHiddenOpacity(0.6);
  Check(check("shown though hidden", 0.4, 0.12) > 0.9 * full * 90 / 100, "both are drawn");
}

// Strokes thinner than a pixel are lighter, but can be picked along all of their length.
void TestThin()
{
  Picture picture(Size, Size);
  vtkSmartPointer<vtkActor> strokes =
    picture.AddStrokes(MakeCells({ { { 10, 30.5, 0 }, { 90, 30.5, 0 } } }), 0.4);
  const int picked = CheckPicks(picture, picture.Renderer, strokes, 0, 0, "thin", 0.2);
  Check(std::abs(picked - 80) <= 2, "as long as it is: " + std::to_string(picked));
}

// One mapper in four viewports: each is picked alone.
void TestViewports()
{
  Picture picture(2 * Size, 2 * Size);
  picture.Window->RemoveRenderer(picture.Renderer);
  vtkNew<vtkNPRStrokeMapper> mapper;
  mapper->SetInputData(MakeTwo());
  mapper->SetWidth(9);
  vtkNew<vtkActor> strokes;
  strokes->SetMapper(mapper);
  strokes->GetProperty()->SetColor(0, 0, 0);
  Picture alone(Size, Size);
  std::vector<vtkSmartPointer<vtkRenderer>> renderers;
  for (int i = 0; i < 4; ++i)
  {
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetViewport(0.5 * (i % 2), 0.5 * (i / 2), 0.5 + 0.5 * (i % 2), 0.5 + 0.5 * (i / 2));
    renderer->SetBackground(1, 1, 1);
    renderer->SetActiveCamera(alone.Renderer->GetActiveCamera());
    renderer->AddActor(strokes);
    renderer->AddActor(MakeSquare(i % 2 == 0 ? 10 : -10));
    picture.Window->AddRenderer(renderer);
    renderers.push_back(renderer);
  }
  for (int i = 0; i < 4; ++i)
  {
    CheckPicks(picture, renderers[i], strokes, Size * (i % 2), Size * (i / 2),
      "viewport " + std::to_string(i));
  }
}

// Strokes of other mappers don't hide strokes, and the picture is the same after picking.
void TestSeveral()
{
  Picture picture(Size, Size);
  vtkSmartPointer<vtkActor> near =
    picture.AddStrokes(MakeLines({ { { 50, 5, 20 }, { 50, 95, 20 } } }), 6);
  vtkSmartPointer<vtkActor> strokes = picture.AddStrokes(MakeTwo(), 9);
  near->GetProperty()->SetOpacity(0.01); // so that the picture is that of the others
  CheckPicks(picture, picture.Renderer, strokes, 0, 0, "over another");
  near->PickableOff();
  CheckPicks(picture, picture.Renderer, strokes, 0, 0, "over one that can not be picked");
  const double before = picture.GetInk();
  picture.Render();
  Check(picture.GetInk() == before, "the picture is the same after picking");
}

void TestPickers()
{
  Picture picture(Size, Size);
  picture.Renderer->AddActor(MakeSquare(10));
  vtkSmartPointer<vtkActor> strokes = picture.AddStrokes(MakeTwo(), 9);
  strokes->SetPosition(0, 0, -7);
  picture.Render();
  vtkNew<vtkPropPicker> picker;
  Check(picker->Pick(20, 34, 0, picture.Renderer) != 0 && picker->GetActor() == strokes,
    "vtkPropPicker, within the stroke");
  Check(std::abs(picker->GetPickPosition()[0] - 20) < 1 &&
      std::abs(picker->GetPickPosition()[2] + 7) < 0.1,
    "its place: " + std::to_string(picker->GetPickPosition()[2]));
  Check(picker->Pick(20, 45, 0, picture.Renderer) == 0, "vtkPropPicker, beside it");
  Check(picker->Pick(45, 34, 0, picture.Renderer) != 0 && picker->GetActor() != strokes,
    "vtkPropPicker, where it is hidden");

  vtkNew<vtkCellPicker> cellPicker;
  cellPicker->SetTolerance(0.02);
  Check(cellPicker->Pick(20, 85, 0, picture.Renderer) != 0 && cellPicker->GetActor() == strokes &&
      cellPicker->GetCellId() == 2,
    "vtkCellPicker: cell " + std::to_string(cellPicker->GetCellId()));
}
}

int TestStrokePicking(int, char*[])
{
  vtkNPROffscreen::Setup();
  TestVisibility();
  TestStyles();
  TestThin();
  TestViewports();
  TestSeveral();
  TestPickers();
  return nprtest::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
