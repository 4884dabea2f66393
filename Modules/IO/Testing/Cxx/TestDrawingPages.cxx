// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The page: sizes, scale, layers and their looks, metadata, and the same bytes every time.
#include "nprArrayNames.h"
#include "nprChecks.h"
#include "nprDrawingTesting.h"
#include "vtkNPRDrawingStyle.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>

#include <clocale>
#include <cmath>

namespace
{
using namespace nprtest;

Checks check;
std::string folder;

vtkXMLDataElement* FindElement(const Drawing& drawing, const char* name)
{
  return drawing.Root ? drawing.Root->LookupElementWithName(name) : nullptr;
}

/// Contours and creases, each visible and hidden, next to each other.
vtkSmartPointer<vtkPolyData> MakeTypedStrokes(
  const std::vector<Line3>& lines = { { { -30, 20, 0 }, { 30, 20, 0 } },
    { { -30, 10, 0 }, { 30, 10, 0 } }, { { -30, 0, 0 }, { 30, 0, 0 } },
    { { -30, -10, 0 }, { 30, -10, 0 } } })
{
  vtkSmartPointer<vtkPolyData> strokes = MakeStrokes(lines);
  vtkNew<vtkIntArray> types;
  types->SetName(npr::names::LineType);
  vtkNew<vtkIntArray> hiding;
  hiding->SetName(npr::names::HidingLayers);
  for (int line = 0; line < 4; ++line)
  {
    types->InsertNextValue(line % 2);
    hiding->InsertNextValue(line < 2 ? 0 : line);
  }
  vtkNew<vtkStringArray> names;
  names->SetName(npr::names::LineTypeNames);
  names->InsertNextValue("contours");
  names->InsertNextValue("creases");
  strokes->GetCellData()->AddArray(types);
  strokes->GetCellData()->AddArray(hiding);
  strokes->GetFieldData()->AddArray(names);
  return strokes;
}

/// A segment of 100 mm at 1:2 is 50 mm long, whatever the window and the page are.
void TestScale()
{
  const vtkSmartPointer<vtkPolyData> strokes =
    MakeStrokes({ { { 3, 4, 0 }, { 63, 84, 0 } }, { { 3, 4, 0 }, { 103, 4, 0 } } });
  for (const int width : { 640, 1333 })
  {
    for (const double height : { 20.0, 777.0 })
    {
      vtkNew<vtkNPRSVGWriter> writer;
      SetPlainPage(writer, strokes);
      writer->SetCamera(LookDown(height));
      writer->SetViewportSize(width, 480);
      writer->SetPaper(vtkNPRDrawingWriter::A4_PAPER);
      writer->SetFit(vtkNPRDrawingWriter::TRUE_SCALE);
      writer->SetScale(0.5);
      const Drawing drawing = Draw(writer, folder + "DrawingPages.svg");
      check(drawing.Root && std::string(drawing.Root->GetAttribute("width")) == "297mm" &&
          std::string(drawing.Root->GetAttribute("viewBox")) == "0 0 297 210",
        "a user unit is a millimetre");
      const Layer* const layer = drawing.Find("lines (visible)");
      if (check(layer && layer->Paths.size() == 2, "two lines"))
      {
        for (const Path& path : layer->Paths)
        {
          const double length = (path.End() - path.Start()).norm();
          check(std::abs(length - 50) < 0.0015, "50 mm", length);
        }
        check((layer->Paths[0].Start() - Point2(148.5 - 25, 105 + 20)).norm() < 0.002,
          "in the middle of the page");
      }
    }
  }
}

void TestFits()
{
  const vtkSmartPointer<vtkPolyData> strokes = MakeStrokes({ { { 10, 0, 0 }, { 30, 10, 0 } } });
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, strokes);
  writer->SetPageSize(120, 60);
  writer->SetMargin(10);
  writer->SetFit(vtkNPRDrawingWriter::FIT_STROKES);
  Path path = Draw(writer, folder + "DrawingPages.svg").Layers.at(0).Paths.at(0);
  check((path.Start() - Point2(20, 50)).norm() + (path.End() - Point2(100, 10)).norm() < 0.003,
    "strokes fill the page within its margins");

  writer->SetFit(vtkNPRDrawingWriter::FIT_VIEWPORT);
  path = Draw(writer, folder + "DrawingPages.svg").Layers.at(0).Paths.at(0);
  check((path.Start() - Point2(64, 30)).norm() < 0.002, "the viewport fits the page");

  writer->SetPaper(vtkNPRDrawingWriter::VIEWPORT_PAPER);
  double size[2];
  writer->GetPageSize(size);
  check(std::abs(size[0] - 1000 * 25.4 / 96) < 1e-9, "a viewport is as large as on a screen");
  writer->SetPaper(vtkNPRDrawingWriter::LETTER_PAPER);
  writer->SetOrientation(vtkNPRDrawingWriter::LANDSCAPE);
  writer->GetPageSize(size);
  check(size[0] == 279.4 && size[1] == 215.9, "Letter on its side");

  // One line along an axis has no height, and one place no size at all.
  writer->SetPageSize(100, 100);
  writer->SetFit(vtkNPRDrawingWriter::FIT_STROKES);
  writer->SetInputData(MakeStrokes({ { { 0, 5, 0 }, { 7, 5, 0 } } }));
  path = Draw(writer, folder + "DrawingPages.svg").Layers.at(0).Paths.at(0);
  check((path.End() - path.Start() - Point2(80, 0)).norm() < 0.002, "a line fits, too");
}

void TestLayers()
{
  const vtkSmartPointer<vtkPolyData> strokes = MakeTypedStrokes();
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, strokes);
  Drawing drawing = Draw(writer, folder + "DrawingPages.svg");
  check(drawing.Layers.size() == 2 && drawing.Layers[0].Name == "creases (visible)" &&
      drawing.Layers[1].Name == "contours (visible)",
    "hidden lines are left out, and contours lie on top");

  writer->SetHiddenLines(vtkNPRDrawingWriter::HIDDEN_LINES_DASHED);
  writer->GetStyle()->SetWidthInPoints("contours", 72 / 25.4);
  writer->GetStyle()->SetColor("creases", 1, 0.5, 0);
  writer->GetStyle()->SetOpacity("creases", 0.5);
  writer->GetStyle()->SetJoin("creases", vtkNPRDrawingStyle::BEVEL_JOIN);
  writer->GetStyle()->SetDashes("creases", 4, 1, 0.5, 1);
  drawing = Draw(writer, folder + "DrawingPages.svg");
  check(drawing.Layers.size() == 4 && drawing.Layers[0].Name == "creases (hidden)" &&
      drawing.Layers[1].Name == "contours (hidden)",
    "hidden lines lie below");
  const Layer* const contours = drawing.Find("contours (visible)");
  const Layer* const hidden = drawing.Find("contours (hidden)");
  const Layer* const creases = drawing.Find("creases (visible)");
  if (check(contours && hidden && creases, "layers have names"))
  {
    check(
      contours->Get("inkscape:groupmode") == "layer" && contours->Get("id") == "contours-visible",
      "layers are layers");
    check(contours->Get("stroke-width") == "1" && contours->Get("stroke-dasharray").empty() &&
        contours->Get("stroke-linecap") == "round" && contours->Get("stroke") == "#000000",
      "visible lines are solid");
    check(hidden->Get("stroke-width") == "0.6" && hidden->Get("stroke-dasharray") == "1.6 0.8" &&
        hidden->Get("stroke-linecap") == "butt",
      "hidden lines are thinner, and dashed");
    check(creases->Get("stroke") == "#ff8000" && creases->Get("opacity") == "0.5" &&
        creases->Get("stroke-linejoin") == "bevel" &&
        creases->Get("stroke-dasharray") == "4 1 0.5 1",
      "a style's colour, opacity, joins and dashes");
    check(hidden->Paths.size() == 1 && std::abs(hidden->Paths[0].Start().y() - 50) < 0.002,
      "lines are in their layers");
  }
  writer->SetHiddenLines(vtkNPRDrawingWriter::HIDDEN_LINES_SHOWN);
  drawing = Draw(writer, folder + "DrawingPages.svg");
  check(drawing.Find("contours (hidden)") &&
      drawing.Find("contours (hidden)")->Get("stroke-dasharray").empty(),
    "hidden lines, shown");
}

/// Along a visible line, and along one of its own kind, a hidden line is not drawn; lines that it
/// crosses do not cut it.
void TestHiddenLinesAlongOthers()
{
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer,
    MakeTypedStrokes({ { { -30, 20, 0 }, { 30, 20, 0 } }, { { -30, 10, 0 }, { 30, 10, 0 } },
      { { -30, 20.2, 0 }, { 0, 20.2, 0 }, { 0, -20, 0 } },
      { { 0, 0, 0 }, { 0, -20, 0 }, { 20, -20, 0 }, { 0.1, -19, 0 }, { 0.1, -1, 0 } } }));
  writer->SetHiddenLines(vtkNPRDrawingWriter::HIDDEN_LINES_DASHED);
  const Drawing drawing = Draw(writer, folder + "DrawingPages.svg");
  const auto isOnePath = [&](const char* name, const Point2& start, const Point2& end)
  {
    const Layer* const layer = drawing.Find(name);
    return layer && layer->Paths.size() == 1 && (layer->Paths[0].Start() - start).norm() < 1.0 &&
      (layer->Paths[0].End() - end).norm() < 1.0;
  };
  check(isOnePath("contours (visible)", { 20, 30 }, { 80, 30 }) &&
      isOnePath("creases (visible)", { 20, 40 }, { 80, 40 }),
    "visible lines are whole");
  check(isOnePath("contours (hidden)", { 50, 30 }, { 50, 70 }), "hidden along a visible line");
  check(isOnePath("creases (hidden)", { 50, 70 }, { 50, 69 }), "hidden along a hidden line");
}

void TestMetadata()
{
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, MakeTypedStrokes());
  writer->SetTitle("<a> & \"b\"\x01 \xc3\xa4");
  writer->SetDate("2026-01-31");
  writer->SetFit(vtkNPRDrawingWriter::TRUE_SCALE);
  writer->SetScale(0.5);
  writer->SetMillimetresPerUnit(1);
  writer->SetScaleBar(true);
  writer->SetUnitName("mm");
  const Drawing drawing = Draw(writer, folder + "DrawingPages.svg");
  vtkXMLDataElement* const title = FindElement(drawing, "title");
  check(title && std::string(title->GetCharacterData()) == "<a> & \"b\"? \xc3\xa4", "the title");
  vtkXMLDataElement* const facts = FindElement(drawing, "npr:drawing");
  if (check(facts != nullptr, "metadata"))
  {
    const auto get = [facts](const char* name)
    { return std::string(facts->GetAttribute(name) ? facts->GetAttribute(name) : ""); };
    check(get("scale") == "1:2" && get("style") == "ink" && get("date") == "2026-01-31" &&
        get("projection") == "parallel" && get("millimetres-per-unit") == "0.5" &&
        get("camera-position") == "0 0 100" && get("viewport") == "1000 1000",
      "what metadata tells");
  }
  // 40 % of the page's width hold a bar of 50 units, 25 mm.
  const Layer* const bar = drawing.Find("scale bar");
  if (check(bar && bar->Paths.size() == 1, "a scale bar"))
  {
    check(std::abs((bar->Paths[0].End() - bar->Paths[0].Start()).norm() - 25) < 0.002,
      "of a round length");
    vtkXMLDataElement* const text = bar->Element->FindNestedElementWithName("text");
    check(text && std::string(text->GetCharacterData()) == "50 mm", "and what it is");
  }
}

void TestSameBytes()
{
  std::vector<Line3> lines;
  for (int i = 0; i < 500; ++i)
  {
    Line3 line;
    for (int k = 0; k < 50; ++k)
    {
      line.push_back({ 0.1 * i - 25 + std::sin(0.1 * k + i), 0.8 * k - 20, 0 });
    }
    lines.push_back(line);
  }
  const auto write = [&](int threads)
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkNPRSVGWriter> writer;
    SetPlainPage(writer, MakeStrokes(lines));
    writer->SetFileName((folder + "DrawingPages.svg").c_str());
    writer->Write();
    return ReadFile(folder + "DrawingPages.svg");
  };
  const std::string first = write(1);
  check(first.size() > 10000 && write(4) == first && write(1) == first,
    "the same bytes for any number of threads");
  // A locale that writes a comma must not show; without one installed this is no other case.
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  check(write(2) == first, "the same bytes in every locale");
  std::setlocale(LC_ALL, "C");
  vtkSMPTools::Initialize(0);
}

void TestImage()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::memset(image->GetScalarPointer(), 200, 18);
  vtkNew<vtkNPRSVGWriter> writer;
  SetPlainPage(writer, MakeTypedStrokes());
  writer->SetImage(image);
  const Drawing drawing = Draw(writer, folder + "DrawingPages.svg");
  const Layer* const shading = drawing.Find("shading");
  vtkXMLDataElement* const element =
    shading ? shading->Element->FindNestedElementWithName("image") : nullptr;
  if (check(element && &drawing.Layers.front() == shading, "an image lies below"))
  {
    const std::string data = element->GetAttribute("xlink:href");
    check(data.rfind("data:image/png;base64,iVBORw0KGgo", 0) == 0, "it is a PNG");
    check(std::string(element->GetAttribute("width")) == "100", "and as large as the viewport");
  }
}
}

int TestDrawingPages(int argc, char* argv[])
{
  folder = OutputFolder(argc, argv);
  TestScale();
  TestFits();
  TestLayers();
  TestHiddenLinesAlongOthers();
  TestMetadata();
  TestSameBytes();
  TestImage();
  return check.GetResult();
}
