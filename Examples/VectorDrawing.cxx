// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a surface to a drawing on paper, as SVG and as PDF. No window is needed.
#include <vtkNPRCurvatureTensor.h>
#include <vtkNPRDrawingStyle.h>
#include <vtkNPRFeatureLines.h>
#include <vtkNPRPDFWriter.h>
#include <vtkNPRSVGWriter.h>
#include <vtkNPRSampleSource.h>
#include <vtkNPRSplineStrokes.h>
#include <vtkNPRSurfaceNormals.h>
#include <vtkNPRSurfacePreparation.h>

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <string>

namespace
{
bool Write(vtkNPRDrawingWriter* writer, const std::string& file, vtkAlgorithm* strokes,
  vtkCamera* camera, vtkNPRDrawingStyle* style)
{
  writer->SetInputConnection(strokes->GetOutputPort());
  writer->SetCamera(camera);
  writer->SetViewportSize(800, 600);
  writer->SetStyle(style);
  writer->SetFit(vtkNPRDrawingWriter::FIT_STROKES);
  writer->SetTitle("The built-in sample");
  writer->SetFileName(file.c_str());
  return writer->Write() != 0;
}
}

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : "VectorDrawing";

  // Independent of the view.
  vtkNew<vtkNPRSampleSource> sample;
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputConnection(sample->GetOutputPort());
  vtkNew<vtkNPRSurfaceNormals> normals;
  normals->SetInputConnection(preparation->GetOutputPort());
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetInputConnection(normals->GetOutputPort());
  tensor->Update();

  vtkNew<vtkCamera> camera;
  camera->SetPosition(5.0, 4.0, 10.0);
  camera->ParallelProjectionOn();

  // For this view: chained lines, then smooth strokes.
  vtkNew<vtkNPRFeatureLines> lines;
  lines->SetInputConnection(tensor->GetOutputPort());
  for (const char* kind : { "contours", "suggestive", "creases" })
  {
    lines->AddDefinition(kind);
  }
  lines->SetCamera(camera);
  lines->SetMinimumLength(0.03);
  vtkNew<vtkNPRSplineStrokes> strokes;
  strokes->SetSplineTypeToBSpline();
  strokes->SetSmoothingIterations(6);
  strokes->SetInputConnection(lines->GetOutputPort());

  // As large as an A4 page holds.
  vtkNew<vtkNPRDrawingStyle> style;
  style->SetWidth("creases", 0.18);
  vtkNew<vtkNPRSVGWriter> svg;
  vtkNew<vtkNPRPDFWriter> pdf;
  const bool isWritten = Write(svg, name + ".svg", strokes, camera, style) &&
    Write(pdf, name + ".pdf", strokes, camera, style);
  return isWritten ? EXIT_SUCCESS : EXIT_FAILURE;
}
