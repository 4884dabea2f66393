// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprDrawingOptions.h"
#include "nprImageFile.h"
#include "nprRenderJob.h"
#include "nprReporter.h"
#include "nprStyleOptions.h"
#include "nprViewOptions.h"
#include "nprVisibilityOptions.h"
#include "vtkNPRDrawingWriter.h"
#include "vtkNPRIllustrationStyle.h"

#include <vtkNew.h>

#include <CLI/CLI.hpp>

#include <memory>

namespace npr
{
namespace
{
struct RenderOptions
{
  ModelOptions Models;
  ViewOptions View;
  StyleOptions Style;
  DrawingOptions Drawing;
  VisibilityOptions Visibility;
  std::string Output;
};

void Render(const RenderOptions& options, Reporter& reporter)
{
  // All that can be refused is refused before the long work.
  if (options.Models.Sample == !options.Models.Files.empty())
  {
    throw CommandError(
      UsageError, "render needs model files, or --sample, not both (see npr render --help)");
  }
  const std::array<int, 2> size = options.View.GetSize();
  const ViewSpecification view = options.View.Parse();
  vtkSmartPointer<vtkNPRDrawingWriter> drawing;
  if (IsDrawingFile(options.Output))
  {
    options.Visibility.RefuseFor(options.Output);
    drawing = options.Drawing.MakeWriter(options.Output, view.IsParallel, size);
  }
  else
  {
    CheckImageFile(options.Output, { ".svg", ".pdf" });
    options.Drawing.RefuseFor(options.Output);
    if (options.Style.IsTransparent())
    {
      CheckTransparency(options.Output);
    }
    options.Visibility.Check();
  }
  vtkNew<vtkNPRIllustrationStyle> style;
  options.Style.ApplyTo(style, reporter);
  const DrawingShading shading = drawing ? options.Drawing.GetShading(style) : DrawingShading::None;

  RenderJob job(reporter, size, !drawing || shading != DrawingShading::None);
  reporter.BeginStage("read");
  options.Models.Import(job.GetRenderer(), reporter);
  reporter.EndStage();
  options.View.Apply(job.GetRenderer(), options.Models);
  PointHeightsUp(style, options.View.GetUp(options.Models));
  if (drawing)
  {
    options.Drawing.FitViewToPage(job.GetRenderer(), drawing, reporter);
    job.RunDrawing(style, drawing, options.Output, shading, options.Style.IsTransparent());
  }
  else
  {
    options.Visibility.ApplyTo(job.GetIllustration());
    job.Run(style, options.Output, options.Style.IsTransparent());
  }
  reporter.PrintStages();
}
}

//------------------------------------------------------------------------------
void AddRenderCommand(CLI::App& program, Reporter& reporter)
{
  CLI::App* command =
    program.add_subcommand("render", "Draw models into an image or a vector drawing");
  auto options = std::make_shared<RenderOptions>();
  options->Models.AddWithSampleTo(*command, "Draw the built-in sample instead of a model");
  command
    ->add_option("-o,--output", options->Output,
      "The image: .png, .jpg, .tif, .bmp or .ppm; or the vector drawing: .svg or .pdf")
    ->required();
  options->Style.AddTo(*command);
  options->View.AddTo(*command);
  options->Visibility.AddTo(*command);
  options->Drawing.AddTo(*command);
  command->footer(
    "Examples:\n"
    "  npr render scan.ply -o scan.png\n"
    "  npr render --sample -o sample.png --style brush\n"
    "  npr render part.stl -o part.png --style ink --projection parallel\n"
    "  npr render head.nii.gz --iso 60 -o head.png --view 40,10\n"
    "  npr render a.obj b.obj -o both.png --style mine.json --background transparent\n"
    "  npr render scan.ply -o scan.svg --style ink\n"
    "  npr render part.stl -o part.pdf --hidden dashed --projection parallel --scale 1:2 "
    "--scale-bar");
  command->callback([options, &reporter]() { Render(*options, reporter); });
}
}
