// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprDrawingOptions.h"
#include "nprImageFile.h"
#include "nprRenderJob.h"
#include "nprReporter.h"
#include "nprViewOptions.h"
#include "nprVisibilityOptions.h"
#include "vtkNPRDrawingWriter.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPRStrokeVisibility.h"

#include <vtkNew.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>

namespace npr
{
namespace
{
struct DemoOptions
{
  std::string Folder = "demo";
  ViewOptions View;
  VisibilityOptions Visibility;
};

std::string MakeIndexPage(const std::string& entries)
{
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<title>vtkNPR: the built-in sample in every style</title>\n<style>\n"
         "body { font-family: serif; margin: 3rem auto; max-width: 72rem; color: #222; }\n"
         "main { display: grid; grid-template-columns: repeat(auto-fit, minmax(30rem, 1fr)); "
         "gap: 2rem; }\n"
         "figure { margin: 0; } img { width: 100%; border: 1px solid #ddd; }\n"
         "figcaption { padding: 0.5rem 0; } code { color: #555; }\n"
         "</style>\n</head>\n<body>\n<h1>The built-in sample in every style</h1>\n<main>\n" +
    entries + "</main>\n</body>\n</html>\n";
}

std::string MakeEntry(const std::string& file, const std::string& name,
  const std::string& description, const std::string& words)
{
  return "<figure><a href=\"" + file + "\"><img src=\"" + file + "\" alt=\"The sample: " + name +
    "\"></a>\n<figcaption><b>" + name + "</b>: " + description +
    "<br><code>./run render MODEL -o " + words + "</code></figcaption></figure>\n";
}

/// A vector drawing, where this build can make one. Returns its entry in the page.
std::string AddDrawing(
  const DemoOptions& options, RenderJob& job, vtkNPRIllustrationStyle* style, Reporter& reporter)
{
  if (!vtkNPRStrokeVisibility::IsAvailable())
  {
    return {};
  }
  DrawingOptions drawing;
  drawing.Hidden = "dashed";
  const std::string file = (std::filesystem::path(options.Folder) / "drawing.svg").string();
  const auto writer =
    drawing.MakeWriter(file, options.View.Parse().IsParallel, options.View.GetSize());
  style->LoadBuiltIn("ink");
  job.RunDrawing(style, writer, file, DrawingShading::None, false);
  if (!reporter.Quiet)
  {
    std::printf("%s\n", file.c_str());
  }
  return MakeEntry("drawing.svg", "drawing", "Ink as a vector drawing, with dashed hidden lines",
    "DRAWING.svg --style ink --hidden dashed");
}

void MakeFolder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  std::error_code ignored;
  if (std::filesystem::is_directory(folder, ignored))
  {
    return;
  }
  throw CommandError(OutputError,
    "demo: " +
      (std::filesystem::exists(folder, ignored) ? folder + " is a file; name a folder"
                                                : "the folder '" + folder + "' can not be made (" +
            error.message() + "); choose another place"));
}

void MakeDemo(const DemoOptions& options, Reporter& reporter)
{
  namespace fs = std::filesystem;
  const std::array<int, 2> size = options.View.GetSize();
  options.Visibility.Check();
  options.View.Parse(); // refuses what is wrong before a folder is made
  MakeFolder(options.Folder);
  const fs::path folder(options.Folder);
  CheckWritable((folder / "index.html").string());

  RenderJob job(reporter, size);
  options.Visibility.ApplyTo(job.GetIllustration());
  reporter.BeginStage("sample");
  AddSample(job.GetRenderer());
  options.View.Apply(job.GetRenderer(), {});
  reporter.EndStage();

  std::string entries;
  vtkNew<vtkNPRIllustrationStyle> style;
  for (const std::string& name : vtkNPRIllustrationStyle::GetBuiltInNames())
  {
    style->LoadBuiltIn(name);
    const std::string file = (folder / (name + ".png")).string();
    job.Run(style, file, false);
    entries += MakeEntry(name + ".png", name, style->GetDescription(), "IMAGE --style " + name);
    if (!reporter.Quiet)
    {
      std::printf("%s\n", file.c_str());
    }
  }
  entries += AddDrawing(options, job, style, reporter);
  const std::string index = (folder / "index.html").string();
  WriteWhole(index,
    [&](const std::string& partial)
    {
      std::ofstream page(partial);
      page << MakeIndexPage(entries);
      page.close();
      return page.good();
    });
  reporter.PrintStages();
  if (!reporter.Quiet)
  {
    std::printf("%s\n", index.c_str());
  }
}
}

//------------------------------------------------------------------------------
void AddDemoCommand(CLI::App& program, Reporter& reporter)
{
  CLI::App* command =
    program.add_subcommand("demo", "Draw the built-in sample in every style, with an index page");
  auto options = std::make_shared<DemoOptions>();
  command->add_option("FOLDER", options->Folder, "Where to; made if it does not exist")
    ->capture_default_str();
  options->View.AddTo(*command);
  options->Visibility.AddTo(*command);
  command->callback([options, &reporter]() { MakeDemo(*options, reporter); });
}
}
