// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// A PDF has the layers of the SVG, and what is drawn in one is drawn in the other. Read back by
// qpdf. ctest compares pixels of drawings with a layer switched off to those that never had it.
#include "nprDrawingOfAllKinds.h"
#include "nprPDFReading.h"
#include "vtkNPRPDFWriter.h"

#include <vtkErrorCode.h>

#include <functional>

namespace
{
using namespace nprtest;

Checks check;
std::string folder;

/// The same drawing as SVG and as PDF must have the same layers, with as much in each.
void TestSame(const std::string& name, const std::function<void(vtkNPRDrawingWriter*)>& set)
{
  const std::string file = folder + "DrawingPDFLayers-" + name;
  vtkNew<vtkNPRSVGWriter> svg;
  set(svg);
  const Drawing drawing = Draw(svg, file + ".svg");
  vtkNew<vtkNPRPDFWriter> pdf;
  set(pdf);
  pdf->SetFileName((file + ".pdf").c_str());
  check(drawing.Root && pdf->Write(), name + ": an SVG and a PDF");
  const PDFReading reading = ReadPDF(file + ".pdf");
  check(reading.Problems.empty(), name + ": " + reading.Problems);
  check(reading.Pages == 1, name + ": pages", reading.Pages);
  check(reading.Layers.size() == drawing.Layers.size(), name + ": layers",
    static_cast<double>(reading.Layers.size()));
  for (std::size_t i = 0; i < reading.Layers.size() && i < drawing.Layers.size(); ++i)
  {
    const PDFReading::Layer& layer = reading.Layers[i];
    const Layer& expected = drawing.Layers[i];
    check(layer.Name == expected.Name, name + ": " + layer.Name + ", not " + expected.Name);
    const int elements = expected.Element->GetNumberOfNestedElements();
    check(layer.Painted == elements,
      name + ": " + layer.Name + ": of " + std::to_string(elements) + " elements", layer.Painted);
  }
}

void TestNamesOfOthers()
{
  TestSame("names",
    [](vtkNPRDrawingWriter* writer)
    {
      vtkSmartPointer<vtkPolyData> strokes =
        MakeStrokes({ { { -40, 0, 0 }, { 40, 0, 0 } }, { { -40, 9, 0 }, { 40, 9, 0 } } });
      vtkNew<vtkIntArray> types;
      types->SetName(npr::names::LineType);
      types->InsertNextValue(0);
      types->InsertNextValue(1);
      vtkNew<vtkStringArray> names;
      names->SetName(npr::names::LineTypeNames);
      names->InsertNextValue("H\xc3\xb6henlinien (\xce\xba = 0)");
      names->InsertNextValue("a\\b) <c> /d %e");
      strokes->GetCellData()->AddArray(types);
      strokes->GetFieldData()->AddArray(names);
      SetPlainPage(writer, strokes);
    });
}

void TestNothing()
{
  const std::string file = folder + "DrawingPDFLayers-nothing.pdf";
  vtkNew<vtkNPRPDFWriter> writer;
  SetPlainPage(writer, MakeStrokes({}));
  writer->SetFileName(file.c_str());
  check(writer->Write() != 0, "an empty page");
  const PDFReading reading = ReadPDF(file);
  check(reading.Pages == 1 && reading.Layers.empty(), "without layers");
  check(reading.Problems.empty(), "empty: " + reading.Problems);
}

void TestFullDisk()
{
  vtkNew<vtkNPRPDFWriter> writer;
  SetDrawingOfAllKinds(writer);
  writer->SetFileName("/dev/full");
  vtkObject::GlobalWarningDisplayOff();
  check(writer->Write() == 0, "refuses");
  vtkObject::GlobalWarningDisplayOn();
  check(writer->GetErrorCode() == vtkErrorCode::OutOfDiskSpaceError, "a full disk",
    static_cast<double>(writer->GetErrorCode()));
}

/// Writes N-off.pdf, with a layer switched off, and N-without.pdf, which never had it.
void WriteSwitched()
{
  using Writer = vtkNPRDrawingWriter*;
  const std::pair<const char*, std::function<void(Writer)>> without[] = {
    { "shading", [](Writer w) { w->SetImage(nullptr); } },
    { "tones", [](Writer w) { w->SetTones(nullptr); } },
    { "contours (hidden)",
      [](Writer w) { w->SetHiddenLines(vtkNPRDrawingWriter::HIDDEN_LINES_NONE); } },
    { "suggestive (visible)", [](Writer w) { w->GetStyle()->SetWidth("suggestive", 0.0); } },
    { "veils (visible)", [](Writer w) { w->GetStyle()->SetWidth("veils", 0.0); } },
    { "scale bar", [](Writer w) { w->ScaleBarOff(); } },
  };
  int number = 0;
  for (const auto& [layer, leaveOut] : without)
  {
    const std::string file = folder + "Layer" + std::to_string(++number);
    vtkNew<vtkNPRPDFWriter> writer;
    SetDrawingOfAllKinds(writer);
    writer->SetFileName((folder + "Whole.pdf").c_str());
    check(writer->Write() && SwitchOff(folder + "Whole.pdf", layer, file + "-off.pdf"),
      std::string("there is a layer ") + layer);
    leaveOut(writer);
    writer->SetFileName((file + "-without.pdf").c_str());
    check(writer->Write() != 0, std::string("without ") + layer);
  }
}
}

int TestDrawingPDFLayers(int argc, char* argv[])
{
  folder = OutputFolder(argc, argv);
  TestSame("all", SetDrawingOfAllKinds);
  TestSame("shown",
    [](vtkNPRDrawingWriter* writer)
    {
      SetDrawingOfAllKinds(writer);
      writer->SetHiddenLines(vtkNPRDrawingWriter::HIDDEN_LINES_NONE);
      writer->SetImage(nullptr);
    });
  TestNamesOfOthers();
  TestNothing();
  TestFullDisk();
  WriteSwitched();
  return check.GetResult();
}
