// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprImageFile.h"
#include "nprRenderJob.h"
#include "nprReporter.h"
#include "nprStyleOptions.h"
#include "nprViewOptions.h"
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
  std::string Output;
};

void Render(const RenderOptions& options, Reporter& reporter)
{
  // All that can be refused is refused before the long work.
  CheckImageFile(options.Output);
  const std::array<int, 2> size = options.View.GetSize();
  options.View.Parse();
  vtkNew<vtkNPRIllustrationStyle> style;
  options.Style.ApplyTo(style, reporter);

  RenderJob job(reporter, size);
  reporter.BeginStage("read");
  options.Models.Import(job.GetRenderer(), reporter);
  reporter.EndStage();
  options.View.Apply(job.GetRenderer(), options.Models);
  job.Run(style, options.Output, options.Style.IsTransparent());
  reporter.PrintStages();
}
}

//------------------------------------------------------------------------------
void AddRenderCommand(CLI::App& program, Reporter& reporter)
{
  CLI::App* command = program.add_subcommand("render", "Draw models into an image");
  auto options = std::make_shared<RenderOptions>();
  options->Models.AddTo(*command);
  command->add_option("-o,--output", options->Output, "The image: .png, .jpg, .tif, .bmp or .ppm")
    ->required();
  options->Style.AddTo(*command);
  options->View.AddTo(*command);
  command->footer(
    "Examples:\n"
    "  npr render scan.ply -o scan.png\n"
    "  npr render part.stl -o part.png --style ink --projection parallel\n"
    "  npr render head.nii.gz --iso 60 -o head.png --view 40,10\n"
    "  npr render a.obj b.obj -o both.png --style mine.json --background transparent");
  command->callback([options, &reporter]() { Render(*options, reporter); });
}
}
