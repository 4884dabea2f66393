// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What can't be drawn is refused with a reason, and what is bad in the strokes does no harm.
#include "nprArrayNames.h"
#include "nprChecks.h"
#include "nprDrawingTesting.h"
#include "vtkNPRDrawingStyle.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using namespace nprtest;

Checks check;
std::string folder;

vtkSmartPointer<vtkPolyData> MakePlainStrokes()
{
  return MakeStrokes({ { { -10, 0, 0 }, { 10, 0, 0 } } });
}

/// The error of a Write() must tell `words`, and have this code; nothing may be written.
void TestRefused(const std::string& what, const std::string& words, unsigned long code,
  const std::function<void(vtkNPRSVGWriter*)>& spoil)
{
  const std::string file = folder + "DrawingErrors.svg";
  std::remove(file.c_str());
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, MakePlainStrokes());
  writer->SetFileName(file.c_str());
  spoil(writer);
  std::string told;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&told);
  listen->SetCallback([](vtkObject*, unsigned long, void* client, void* data)
    { *static_cast<std::string*>(client) += static_cast<const char*>(data); });
  writer->AddObserver(vtkCommand::ErrorEvent, listen);
  const int written = writer->Write();
  check(written == 0 && writer->GetErrorCode() == code, what + ": code",
    static_cast<double>(writer->GetErrorCode()));
  check(told.find(words) != std::string::npos, what + ": \"" + told + "\" tells " + words);
  check(ReadFile(file).empty(), what + ": no file");
}

void TestRefusals()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const unsigned long user = vtkErrorCode::UserError;
  using Writer = vtkNPRSVGWriter*;
  TestRefused("no name", "SetFileName", vtkErrorCode::NoFileNameError,
    [](Writer w) { w->SetFileName(nullptr); });
  TestRefused("no folder", "can't be opened", vtkErrorCode::CannotOpenFileError,
    [](Writer w) { w->SetFileName((folder + "no such folder/a.svg").c_str()); });
  TestRefused("a folder", "can't be opened", vtkErrorCode::CannotOpenFileError,
    [](Writer w) { w->SetFileName(folder.c_str()); });
  TestRefused("no camera", "SetCamera", user, [](Writer w) { w->SetCamera(nullptr); });
  TestRefused("no viewport", "SetViewportSize", user, [](Writer w) { w->SetViewportSize(0, 5); });
  TestRefused("no page", "0 x 10 mm", user, [](Writer w) { w->SetPageSize(0, 10); });
  TestRefused("no size", "SetPageSize", user, [nan](Writer w) { w->SetPageSize(nan, 10); });
  TestRefused("endless", "SetPageSize", user, [](Writer w) { w->SetPageSize(INFINITY, 10); });
  TestRefused("margins", "leave nothing", user, [](Writer w) { w->SetMargin(50); });
  TestRefused("negative margins", "Margin", user, [](Writer w) { w->SetMargin(-1); });
  TestRefused("tolerance", "Tolerance", user, [](Writer w) { w->SetTolerance(0); });
  TestRefused("scale", "Scale is 0", user, [](Writer w) { w->SetScale(0); });
  TestRefused("scale in perspective", "in perspective, what is far away is smaller", user,
    [](Writer w)
    {
      w->GetCamera()->ParallelProjectionOff();
      w->SetFit(vtkNPRDrawingWriter::TRUE_SCALE);
    });
  TestRefused("scale bar in perspective", "no bar holds for all depths", user,
    [](Writer w)
    {
      w->GetCamera()->ParallelProjectionOff();
      w->ScaleBarOn();
    });
  TestRefused("image of floats", "unsigned chars", user,
    [](Writer w)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(2, 2, 1);
      image->AllocateScalars(VTK_FLOAT, 1);
      w->SetImage(image);
    });
  TestRefused("array of another length", "\"HidingLayers\" of the strokes has 3 tuples", user,
    [](Writer w)
    {
      vtkNew<vtkIntArray> hiding;
      hiding->SetName(npr::names::HidingLayers);
      hiding->SetNumberOfTuples(3);
      vtkPolyData::SafeDownCast(w->GetInput())->GetCellData()->AddArray(hiding);
    });
  TestRefused("line type", "\"LineType\" -1", user,
    [](Writer w)
    {
      vtkNew<vtkIntArray> types;
      types->SetName(npr::names::LineType);
      types->InsertNextValue(-1);
      vtkPolyData::SafeDownCast(w->GetInput())->GetCellData()->AddArray(types);
    });
#ifdef __linux__
  TestRefused("full disk", "disk is not full", vtkErrorCode::OutOfDiskSpaceError,
    [](Writer w) { w->SetFileName("/dev/full"); });
#endif
}

/// How many paths are drawn of a line, none of which may have a number that is none.
std::size_t CountPaths(vtkPolyData* strokes, double taper = 1.0)
{
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, strokes);
  writer->GetStyle()->SetTaper("lines", taper);
  const std::string file = folder + "DrawingErrors.svg";
  const Drawing drawing = Draw(writer, file);
  const std::string text = ReadFile(file);
  check(drawing.Root != nullptr, "a file of bad strokes is XML");
  check(text.find("nan") == std::string::npos && text.find("inf\"") == std::string::npos &&
      text.find("inf ") == std::string::npos,
    "no bad numbers");
  const Layer* const layer = drawing.Find("lines (visible)");
  return layer ? layer->Paths.size() : 0;
}

void TestBadStrokes()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  check(CountPaths(vtkSmartPointer<vtkPolyData>::New()) == 0, "no strokes");
  check(CountPaths(MakeStrokes({ {}, { { 1, 1, 0 } }, { { 1, 1, 0 }, { 2, 1, 0 } } })) == 1,
    "chains of no, one and two points");
  check(CountPaths(MakeStrokes({ { { 1, 1, 0 }, { 1, 1, 0 }, { 1, 1, 0 } },
          { { 1, 1, 0 }, { 1, 1, 0 }, { 5, 5, 0 }, { 5, 5, 0 }, { 5, 5, 0 } } })) == 1,
    "repeated points");
  check(CountPaths(MakeStrokes({ { { 0, 0, 0 }, { 9, 0, 0 }, { 0, 9, 0 }, { 0, 0, 0 } },
          { { 0, 0, 0 }, { 9, 0, 0 }, { 0, 0, 0 } } })) == 2,
    "loops of three and two");
  check(CountPaths(MakeStrokes({ { { 0, 0, 0 }, { 9, 0, 0 }, { nan, 0, 0 }, { 0, 5, 0 },
          { inf, 1, 0 }, { 1, 2, 0 }, { 3, 4, 0 } } })) == 2,
    "points that are not finite");
  check(CountPaths(MakeStrokes({ { { 1e300, 0, 0 }, { -1e300, 1, 0 } } })) <= 1, "far away");
  check(CountPaths(MakeStrokes({ { { 200, 0, 0 }, { 300, 50, 0 } },
          { { -200, 300, 0 }, { 300, 200, 0 }, { 400, -300, 0 } } })) == 0,
    "wholly off the page");
  check(CountPaths(MakeStrokes({ { { 0, 0, 500 }, { 1, 0, 500 } } })) == 0, "behind the camera");

  // Widths of nothing, less than nothing, and no number.
  for (const double width : { 0.0, -1.0, nan })
  {
    const vtkSmartPointer<vtkPolyData> strokes =
      MakeStrokes({ { { 0, 0, 0 }, { 5, 0, 0 }, { 9, 3, 0 } }, { { 0, 0, 0 }, { 9, 0, 0 } } });
    vtkNew<vtkDoubleArray> widths;
    widths->SetName(npr::names::Width);
    for (const double value : { width, width, 5.0, width, width })
    {
      widths->InsertNextValue(value);
    }
    strokes->GetPointData()->AddArray(widths);
    check(CountPaths(strokes) == 1, "a stroke without width is not drawn", width);
  }
  const vtkSmartPointer<vtkPolyData> tapered =
    MakeStrokes({ { { 0, 0, 0 }, { 0.001, 0, 0 }, { 0, 0.001, 0 }, { 0, 0, 0 } } });
  vtkNew<vtkDoubleArray> strength;
  strength->SetName(npr::names::Strength);
  for (const double value : { nan, 7.0, -3.0, inf })
  {
    strength->InsertNextValue(value);
  }
  tapered->GetPointData()->AddArray(strength);
  check(CountPaths(tapered, 0.0) <= 1, "a speck with bad strengths");
}

void TestManyChains()
{
  auto strokes = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  constexpr int Count = 1000000;
  for (int i = 0; i < Count; ++i)
  {
    const vtkIdType ids[] = { points->InsertNextPoint(0.09 * (i % 1000) - 45, i / 11500.0 - 45, 0),
      points->InsertNextPoint(0.09 * (i % 1000) - 44.95, i / 11500.0 - 44.98, 0) };
    cells->InsertNextCell(2, ids);
  }
  strokes->SetPoints(points);
  strokes->SetLines(cells);
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, strokes);
  const std::string file = folder + "DrawingErrors.svg";
  writer->SetFileName(file.c_str());
  check(writer->Write() == 1, "a million tiny chains");
  const std::size_t size = ReadFile(file).size();
  check(size > 30u * Count / 2 && size < 60u * Count, "bytes of them", static_cast<double>(size));
  std::remove(file.c_str());
}
}

int TestDrawingErrors(int argc, char* argv[])
{
  folder = OutputFolder(argc, argv);
  TestRefusals();
  TestBadStrokes();
  TestManyChains();
  return check.GetResult();
}
