// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Curves that the stroke mapper makes of lines look like those that vtkNPRSplineStrokes makes for
// it, within the comparator's limits and closer: open ones with corners, closed ones, far and near,
// with all that points and lines may have, and with all that the mapper does.
#include "nprImageComparison.h"
#include "nprStrokeTesting.h"
#include "vtkNPROffscreen.h"
#include "vtkNPRSplineStrokes.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkHardwareSelector.h>
#include <vtkIntArray.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

using nprtest::Check;
using nprtest::Line;
using nprtest::MakeLines;
using nprtest::Picture;

namespace
{
constexpr int Size = 240;
int ArgC = 0;
char** ArgV = nullptr;

/// Changes a picture of strokes, before their first frame or between two.
using Change = std::function<void(Picture&, vtkActor*)>;

vtkSmartPointer<vtkImageData> GetImage(Picture& picture)
{
  picture.Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(picture.Window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  image->Update();
  return image->GetOutput();
}

npr::ImageLimits MakeLimits(bool hidden)
{
  npr::ImageLimits limits;
  // Where surfaces hide strokes is found for pieces of two pixels, which differ along other
  // segments: that far ends may move, with the same ink within a pixel of them.
  limits.LocalSSIM = hidden ? 0.0 : limits.LocalSSIM;
  limits.MaxDifference = hidden ? 1.0 : 0.35;
  return limits;
}

void CheckSame(Picture& theirs, Picture& ours, const std::string& what, bool hidden)
{
  const npr::ImageComparison comparison =
    npr::CompareImages(GetImage(theirs), GetImage(ours), MakeLimits(hidden));
  Check(theirs.GetInk() > 100, what + ": something is drawn");
  Check(comparison.Passes(), what + "\n" + comparison.Report());
  ours.Write(ArgC, ArgV, "Curves " + what);
  theirs.Write(ArgC, ArgV, "Curves " + what + ", by the filter");
}

/// Draws the curves of lines both ways, as often as there are changes.
void Compare(vtkPolyData* lines, int type, const std::string& what,
  const std::vector<Change>& changes, double cornerAngle = 60, bool hidden = false)
{
  Picture theirs(Size, Size);
  Picture ours(Size, Size);
  vtkNew<vtkNPRSplineStrokes> splines;
  splines->SetInputData(lines);
  splines->SetSplineType(type);
  splines->SetCornerAngle(cornerAngle);
  splines->SetMaximumChordError(0.02);
  splines->Update();
  const vtkSmartPointer<vtkActor> reference = theirs.AddStrokes(splines->GetOutput(), 4);
  const vtkSmartPointer<vtkActor> strokes = ours.AddStrokes(lines, 4);
  nprtest::GetMapper(strokes)->SetSplineType(type);
  nprtest::GetMapper(strokes)->SetSplineCornerAngle(cornerAngle);
  int number = 0;
  for (const Change& change : changes)
  {
    change(theirs, reference);
    change(ours, strokes);
    splines->Update(); // where the change was one of the lines
    CheckSame(
      theirs, ours, what + (changes.size() > 1 ? " " + std::to_string(++number) : ""), hidden);
  }
}

void Same(Picture&, vtkActor*) {}

/// With one corner.
Line MakeOpen()
{
  return { { 20, 60, -30 }, { 50, 35, 0 }, { 85, 40, 20 }, { 105, 75, 0 }, { 140, 95, -10 },
    { 170, 70, 40 }, { 175, 120, 0 }, { 195, 140, -20 }, { 225, 130, -40 } };
}

/// Without corners.
Line MakeClosed()
{
  Line line;
  for (int i = 0; i <= 10; ++i)
  {
    const double angle = 2 * nprtest::Pi * (i % 10) / 10;
    const double radius = 48 + 6 * (i % 2);
    line.push_back(
      { 70 + radius * std::cos(angle), 165 + radius * std::sin(angle), 30 * std::cos(2 * angle) });
  }
  return line;
}

/// With a corner at its seam and another.
Line MakeLeaf()
{
  return { { 150, 170, 0 }, { 165, 200, 0 }, { 195, 215, 0 }, { 225, 218, 0 }, { 215, 190, 0 },
    { 190, 172, 0 }, { 150, 170, 0 } };
}

vtkSmartPointer<vtkPolyData> MakeAll()
{
  return MakeLines({ MakeOpen(), MakeClosed(), MakeLeaf() });
}

Change Look(bool parallel, double zoom)
{
  return [=](Picture& picture, vtkActor*)
  {
    vtkCamera* const camera = picture.Renderer->GetActiveCamera();
    const double middle[2] = { zoom > 1 ? 100.0 : 120.0, zoom > 1 ? 60.0 : 120.0 };
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(0.5 * Size / zoom);
    camera->SetFocalPoint(middle[0], middle[1], 0);
    camera->SetPosition(middle[0] + 80 / zoom, middle[1] - 60 / zoom, 500 / zoom);
    camera->SetClippingRange(zoom > 1 ? 20 : 50, 20000);
  };
}

void TestShapes()
{
  for (const int type : { vtkNPRStrokeMapper::CATMULL_ROM, vtkNPRStrokeMapper::B_SPLINE })
  {
    const std::string name = type == vtkNPRStrokeMapper::B_SPLINE ? "B-spline " : "Catmull-Rom ";
    Compare(MakeLines({ MakeOpen() }), type, name + "open with a corner", { Same });
    Compare(MakeLines({ MakeOpen() }), type, name + "open without corner", { Same }, 180);
    Compare(MakeLines({ MakeClosed() }), type, name + "closed with corners", { Same }, 20);
    Compare(MakeLines({ MakeClosed() }), type, name + "closed", { Same });
    Compare(MakeLines({ MakeLeaf() }), type, name + "leaf", { Same });
    // One mapper, farther and nearer: more parts where they are needed.
    for (const bool parallel : { true, false })
    {
      Compare(MakeAll(), type, name + (parallel ? "parallel" : "perspective"),
        { Look(parallel, 0.3), Look(parallel, 1), Look(parallel, 5), Look(parallel, 0.5) });
    }
    // So many control points that spans are straight, and few are needed.
    Line dense;
    for (int i = 0; i <= 3000; ++i)
    {
      const double t = 0.001 * i;
      dense.push_back({ 120 + 100 * std::sin(2 * t), 120 + 90 * std::cos(5 * t), 0 });
    }
    Compare(MakeLines({ dense }), type, name + "dense", { Same });
  }
}

/// Points that are not finite or in one place, and lines too short for a curve.
void TestBadLines()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Line cut = MakeOpen();
  cut.insert(cut.begin() + 3, { nan, 0, 0 });
  Line twice = MakeClosed();
  twice.insert(twice.begin() + 2, twice[1]);
  Compare(MakeLines({ {}, { { 5, 5, 0 } }, cut, { { 9, 9, 0 }, { 9, 9, 0 } },
            { { 200, 20, 0 }, { 220, 40, 0 } }, twice }),
    vtkNPRStrokeMapper::CATMULL_ROM, "bad lines", { Same });
  Picture picture(Size, Size);
  for (const std::vector<Line>& lines :
    { std::vector<Line>{}, { {} }, { { { nan, nan, nan }, { nan, 0, 0 } } } })
  {
    nprtest::GetMapper(picture.AddStrokes(MakeLines(lines), 4))->SetSplineTypeToCatmullRom();
  }
  picture.Render();
  Check(picture.GetInk() == 0, "nothing to draw");
}

void AddArray(vtkPolyData* lines, const char* name)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(static_cast<float>(0.6 + 0.3 * std::sin(static_cast<double>(i))));
  }
  lines->GetPointData()->AddArray(array);
}

void AddColors(vtkDataSetAttributes* data, vtkIdType count)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double color[3] = { static_cast<double>(80 * (i % 4)), static_cast<double>(60 * (i % 3)),
      static_cast<double>(100 * (i % 2)) };
    colors->InsertNextTuple(color);
  }
  data->SetScalars(colors);
}

void TestArrays()
{
  constexpr int type = vtkNPRStrokeMapper::CATMULL_ROM;
  for (const char* name : { "Width", "Opacity", "Strength" })
  {
    const vtkSmartPointer<vtkPolyData> lines = MakeAll();
    AddArray(lines, name);
    Compare(lines, type, name,
      { [](Picture&, vtkActor* strokes)
        {
          nprtest::GetMapper(strokes)->StrengthToWidthOn();
          nprtest::GetMapper(strokes)->StrengthToOpacityOn();
          nprtest::GetMapper(strokes)->SetWidth(9);
        } });
  }
  const Change color = [](Picture&, vtkActor* strokes)
  { strokes->GetMapper()->ScalarVisibilityOn(); };
  const Change dash = [](Picture&, vtkActor* strokes)
  { nprtest::GetMapper(strokes)->SetDashes(9, 7); };
  for (const bool ofCells : { false, true })
  {
    const vtkSmartPointer<vtkPolyData> lines = MakeAll();
    AddColors(ofCells ? static_cast<vtkDataSetAttributes*>(lines->GetCellData())
                      : static_cast<vtkDataSetAttributes*>(lines->GetPointData()),
      ofCells ? lines->GetNumberOfCells() : lines->GetNumberOfPoints());
    Compare(lines, type, ofCells ? "colours of cells" : "colours of points", { color, dash });
  }
  const vtkSmartPointer<vtkPolyData> lines = MakeAll();
  vtkNew<vtkIntArray> layers;
  layers->SetName("HidingLayers");
  for (const int layer : { 0, 2, 0 })
  {
    layers->InsertNextValue(layer);
  }
  lines->GetCellData()->AddArray(layers);
  Compare(lines, type, "hiding layers",
    { [](Picture&, vtkActor* strokes) { nprtest::GetMapper(strokes)->UseHidingLayersOn(); } });
}

void AddSphere(Picture& picture, vtkActor*)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(130, 110, -20);
  sphere->SetRadius(70);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.8, 0.9, 0.7);
  picture.Renderer->AddActor(actor);
}

void TestUses()
{
  constexpr int type = vtkNPRStrokeMapper::B_SPLINE;
  const auto set = [](const std::function<void(vtkNPRStrokeMapper*)>& how)
  { return [how](Picture&, vtkActor* strokes) { how(nprtest::GetMapper(strokes)); }; };
  using Mapper = vtkNPRStrokeMapper*;
  Compare(MakeAll(), type, "behind a sphere", { AddSphere }, 60, true);
  Compare(MakeAll(), type, "depth peeling",
    { [](Picture& picture, vtkActor* strokes)
      {
        AddSphere(picture, strokes);
        picture.Renderer->UseDepthPeelingOn();
      } },
    60, true);
  Compare(MakeAll(), type, "joins and caps",
    { set([](Mapper mapper) { mapper->SetJoinToMitre(); }),
      set([](Mapper mapper) { mapper->SetCapToButt(); }),
      // And back: what was evaluated on the CPU is now on the GPU again.
      [](Picture&, vtkActor* strokes)
      {
        nprtest::GetMapper(strokes)->SetJoinToRound();
        nprtest::GetMapper(strokes)->SetCapToRound();
      } });
  Compare(MakeAll(), type, "dashes",
    { set([](Mapper mapper) { mapper->SetDashes(12, 10); }),
      set([](Mapper mapper) { mapper->SetDashUnitToWorld(); }) });
  Compare(MakeAll(), type, "pencil",
    { set(
      [](Mapper mapper)
      {
        mapper->SetMediumToPencil();
        mapper->SetPaperGrain(0.7);
        mapper->SetWidth(8);
      }) });
  Compare(MakeAll(), type, "clipping",
    { [](Picture&, vtkActor* strokes)
      {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(120, 110, 0);
        plane->SetNormal(1, 0.6, 0);
        strokes->GetMapper()->AddClippingPlane(plane);
      } });
  Compare(MakeAll(), type, "an actor that is moved",
    { [](Picture&, vtkActor* strokes)
      {
        strokes->SetScale(0.5, 0.7, 0.5);
        strokes->RotateZ(20);
        strokes->SetPosition(60, 20, 0);
      } });
  Compare(MakeAll(), type, "two viewports",
    { [](Picture& picture, vtkActor* strokes)
      {
        picture.Renderer->SetViewport(0, 0, 0.5, 1);
        vtkNew<vtkRenderer> second;
        second->SetViewport(0.5, 0, 1, 1);
        second->SetBackground(1, 1, 1);
        second->AddActor(strokes);
        picture.Window->AddRenderer(second);
        second->GetActiveCamera()->DeepCopy(picture.Renderer->GetActiveCamera());
        second->GetActiveCamera()->Zoom(3);
      } });
  const vtkSmartPointer<vtkPolyData> lines = MakeAll();
  Compare(lines, type, "points that move",
    { Same,
      [&lines](Picture&, vtkActor*)
      {
        lines->GetPoints()->SetPoint(2, 60, 110, 0);
        lines->GetPoints()->Modified();
      } });
}

/// Cells that are picked are those of the input, also after lines that make no curve.
void TestPicking()
{
  for (const bool dashed : { false, true })
  {
    Picture picture(Size, Size);
    const vtkSmartPointer<vtkActor> strokes =
      picture.AddStrokes(MakeLines({ MakeOpen(), { { 5, 5, 0 } }, MakeClosed(), MakeLeaf() }), 9);
    nprtest::GetMapper(strokes)->SetSplineTypeToCatmullRom();
    nprtest::GetMapper(strokes)->SetCap(dashed ? vtkNPRStrokeMapper::BUTT_CAP : 0);
    picture.Render();
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(picture.Renderer);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    selector->SetArea(0, 0, Size - 1, Size - 1);
    Check(selector->CaptureBuffers(), "the window can select");
    const unsigned int places[3][2] = { { 50, 35 }, { 118, 165 }, { 195, 215 } };
    for (int i = 0; i < 3; ++i)
    {
      const vtkHardwareSelector::PixelInformation pixel = selector->GetPixelInformation(places[i]);
      Check(pixel.Valid && pixel.AttributeID == (i == 0 ? 0 : i + 1),
        "the cell at a control point, " + std::to_string(i));
    }
  }
}

/// That bounds hold what reaches beyond the control points.
void TestBounds()
{
  Picture picture(Size, Size);
  vtkNew<vtkNPRSplineStrokes> splines;
  const vtkSmartPointer<vtkPolyData> lines =
    MakeLines({ { { 20, 30, 0 }, { 60, 200, 0 }, { 180, 200, 0 }, { 220, 30, 0 } } });
  splines->SetInputData(lines);
  splines->SetCornerAngle(180);
  splines->Update();
  const vtkSmartPointer<vtkActor> strokes = picture.AddStrokes(lines, 4);
  nprtest::GetMapper(strokes)->SetSplineTypeToCatmullRom();
  double reached[6];
  double bounds[6];
  splines->GetOutput()->GetBounds(reached);
  for (int i = 0; i < 2; ++i)
  {
    nprtest::GetMapper(strokes)->GetBounds(bounds); // twice the same
  }
  Check(reached[3] > 210 && bounds[3] >= reached[3] && bounds[3] < reached[3] + 60,
    "bounds hold curves: " + std::to_string(bounds[3]));
}
}

int TestStrokeCurves(int argc, char* argv[])
{
  if (!vtkNPROffscreen::Setup())
  {
    return EXIT_FAILURE;
  }
  ArgC = argc;
  ArgV = argv;
  TestShapes();
  TestBadLines();
  TestArrays();
  TestUses();
  TestPicking();
  TestBounds();
  return nprtest::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
