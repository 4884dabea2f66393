// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// A PDF tells the same as the SVG, and the same on every run. ctest compares the pixels of both.
#include "nprDrawingOfAllKinds.h"
#include "vtkNPRPDFWriter.h"

#include <qpdf/QPDF.hh>

namespace
{
using namespace nprtest;

bool Write(vtkNPRDrawingWriter* writer, const std::string& file)
{
  SetDrawingOfAllKinds(writer);
  writer->SetFileName(file.c_str());
  return writer->Write() != 0;
}

/// What the document tells of itself, such as its /Title; empty if nothing.
std::string ReadFact(const std::string& file, const std::string& name)
{
  QPDF document;
  document.processFile(file.c_str());
  QPDFObjectHandle fact = document.getTrailer().getKey("/Info").getKey(name);
  return fact.isString() ? fact.getUTF8Value() : "";
}
}

int TestDrawingPDF(int argc, char* argv[])
{
  Checks check;
  const std::string name = OutputFolder(argc, argv) + "DrawingPDF";
  vtkNew<vtkNPRSVGWriter> svg;
  check(Write(svg, name + ".svg"), "an SVG");
  vtkNew<vtkNPRPDFWriter> pdf;
  check(Write(pdf, name + ".pdf"), "a PDF");
  const std::string bytes = ReadFile(name + ".pdf");
  check(bytes.rfind("%PDF-", 0) == 0, "begins as a PDF does");
  check(ReadFact(name + ".pdf", "/Title") == "One of everything", "tells its title");
  check(ReadFact(name + ".pdf", "/Creator") == "vtkNPR", "tells what made it");
  const std::string subject = ReadFact(name + ".pdf", "/Subject");
  check(subject.find("style: ") == 0, "tells its style: " + subject);
  check(subject.find("camera-position: 0 0 100;") != std::string::npos, "tells its camera");
  check(ReadFact(name + ".pdf", "/CreationDate").empty(), "tells no date that nobody set");
  vtkNew<vtkNPRPDFWriter> again;
  check(Write(again, name + ".pdf") && ReadFile(name + ".pdf") == bytes, "the same bytes again");

  again->SetDate("2026-01-31");
  again->Write();
  check(
    ReadFact(name + ".pdf", "/CreationDate").find("20260131") != std::string::npos, "tells a date");
  check(Write(pdf, name + ".pdf"), "as it was");
  return check.GetResult();
}
