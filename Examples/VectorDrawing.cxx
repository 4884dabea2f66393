// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a scene to a drawing on paper, as SVG and as PDF: what is hidden is dashed. Nothing is
// rendered, so no display is needed.
#include <vtkNPRDrawingStyle.h>
#include <vtkNPRIllustration.h>
#include <vtkNPRIllustrationStyle.h>
#include <vtkNPRPDFWriter.h>
#include <vtkNPRSVGWriter.h>
#include <vtkNPRSampleSource.h>
#include <vtkNPRViewpoint.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <string>

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : "VectorDrawing";

  // Any scene; here it is the built-in sample.
  vtkNew<vtkNPRSampleSource> sample;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sample->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  vtkNew<vtkNPRViewpoint> viewpoint;
  viewpoint->SetParallelProjection(true);
  viewpoint->Apply(renderer);

  // The lines of a style, cut where they are hidden.
  vtkNew<vtkNPRIllustrationStyle> style;
  style->LoadBuiltIn("ink");
  vtkNew<vtkNPRIllustration> illustration;
  illustration->SetRenderer(renderer);
  illustration->SetStyle(style);
  vtkNew<vtkPolyData> strokes;
  if (!illustration->Apply() || !illustration->GetStrokes(strokes))
  {
    return EXIT_FAILURE;
  }

  // Both writers draw the same on an A4 page.
  vtkNew<vtkNPRSVGWriter> svg;
  vtkNew<vtkNPRPDFWriter> pdf;
  const auto write = [&](vtkNPRDrawingWriter* writer, const std::string& file)
  {
    writer->SetInputData(strokes);
    writer->SetCamera(renderer->GetActiveCamera());
    writer->SetViewportSize(window->GetSize());
    vtkNew<vtkNPRDrawingStyle> inks;
    style->GetDrawingStyle(inks, writer->GetShorterSide());
    writer->SetStyle(inks);
    writer->SetHiddenLines(vtkNPRDrawingWriter::HIDDEN_LINES_DASHED);
    writer->SetTitle("The built-in sample");
    writer->SetFileName(file.c_str());
    return writer->Write() != 0;
  };
  return write(svg, name + ".svg") && write(pdf, name + ".pdf") ? EXIT_SUCCESS : EXIT_FAILURE;
}
