// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprImageFile.h"
#include "nprRenderJob.h"
#include "nprReporter.h"
#include "nprStyleOptions.h"
#include "nprViewOptions.h"
#include "nprViewQuantities.h"
#include "vtkNPRIllustration.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPRLineDefinition.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataWriter.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace npr
{
namespace
{
struct LinesOptions
{
  ModelOptions Models;
  ViewOptions View;
  std::string Output;
  StyleOptions Style;
  std::string Quantities;
  bool List = false;
};

std::string DescribeParameters(vtkNPRLineDefinition* definition)
{
  std::string text;
  for (int i = 0; i < definition->GetNumberOfParameters(); ++i)
  {
    const char* name = definition->GetParameterName(i);
    text += (text.empty() ? "" : ", ") + std::string(name);
    for (const double value : definition->GetParameterValues(name))
    {
      char number[32];
      std::snprintf(number, sizeof(number), " %g", value);
      text += number;
    }
    if (definition->GetParameterSize(name) == 0)
    {
      text += " \"" + definition->GetTextParameter(name) + "\"";
    }
  }
  return text.empty() ? "-" : text;
}

void ListLines()
{
  std::vector<std::array<std::string, 4>> rows = { { "KIND", "MOVES", "SHOWS",
    "PARAMETERS, AS THEY ARE AT FIRST" } };
  for (int i = 0; i < vtkNPRLineDefinition::GetNumberOfLineNames(); ++i)
  {
    const char* name = vtkNPRLineDefinition::GetLineName(i);
    const auto definition = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(name));
    rows.push_back({ name, definition->IsViewDependent() ? "with view" : "-",
      definition->GetDescription(), DescribeParameters(definition) });
  }
  std::array<std::size_t, 3> widths = { 0, 0, 0 };
  for (const auto& row : rows)
  {
    for (std::size_t c = 0; c < widths.size(); ++c)
    {
      widths[c] = std::max(widths[c], row[c].size());
    }
  }
  for (const auto& row : rows)
  {
    for (std::size_t c = 0; c < widths.size(); ++c)
    {
      std::printf("%-*s  ", static_cast<int>(widths[c]), row[c].c_str());
    }
    std::printf("%s\n", row[3].c_str());
  }
}

void WriteLines(vtkPolyData* lines, const std::string& file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(lines);
  WriteWhole(file,
    [&](const std::string& partial)
    {
      writer->SetFileName(partial.c_str());
      return writer->Write() == 1;
    });
}

void MakeLines(const LinesOptions& options, Reporter& reporter)
{
  if (options.Output.size() < 5 || options.Output.substr(options.Output.size() - 4) != ".vtp")
  {
    throw CommandError(UsageError, options.Output + ": lines are written as .vtp");
  }
  CheckWritable(options.Output);
  options.View.Parse();
  if (options.Style.Lines == "none")
  {
    throw CommandError(
      UsageError, "--lines none leaves nothing to extract; name kinds (npr lines --list)");
  }
  // All styles have the same lines; how a style draws them plays no part.
  vtkNew<vtkNPRIllustrationStyle> style;
  options.Style.ApplyTo(style, reporter);
  for (const std::string& quantity : SplitList(options.Quantities))
  {
    if (!style->AddQuantity(quantity))
    {
      reporter.DropVTKErrors();
      throw CommandError(UsageError, "--quantities: " + style->GetErrorMessage());
    }
  }
  if (SplitList(options.Style.Lines).empty())
  {
    throw CommandError(UsageError, "--lines names no kind of line (npr lines --list)");
  }

  // Nothing is drawn, but the shape of the image decides what the camera sees.
  const auto window = MakeWindow(reporter, options.View.GetSize());
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  reporter.BeginStage("read");
  options.Models.Import(renderer, reporter);
  reporter.EndStage();
  options.View.Apply(renderer, options.Models);
  PointHeightsUp(style, options.View.GetUp(options.Models));

  vtkNew<vtkNPRIllustration> illustration;
  reporter.Watch(illustration, "extracting");
  illustration->SetRenderer(renderer);
  illustration->SetStyle(style);
  illustration->Apply();
  vtkNew<vtkPolyData> lines;
  illustration->GetLines(lines);
  reporter.ThrowOnVTKError(InputError);
  for (const char* stage : { "prepare", "curvature", "lines" })
  {
    reporter.AddStage(stage, illustration->GetStageSeconds(stage));
  }
  WriteLines(lines, options.Output);
  reporter.PrintStages();
  reporter.Note(std::to_string(lines->GetNumberOfLines()) + " chains of " +
    std::to_string(lines->GetNumberOfPoints()) + " points");
}
}

//------------------------------------------------------------------------------
void AddLinesCommand(CLI::App& program, Reporter& reporter)
{
  CLI::App* command = program.add_subcommand("lines", "Extract feature lines as chained polylines");
  auto options = std::make_shared<LinesOptions>();
  options->Models.AddTo(*command)->required(false);
  command->add_option("-o,--output", options->Output, "The file to write, .vtp");
  options->Style.Lines = "contours,suggestive,creases,boundaries,non-manifold";
  command->add_option("--lines", options->Style.Lines, "Which kinds of lines")
    ->capture_default_str();
  command->add_option("--quantities", options->Quantities,
    "What points carry of the surface: " + DescribeViewQuantities() +
      " (as in formulas), or the model's point arrays");
  options->Style.AddSettingsTo(*command);
  command->add_flag("--list", options->List, "List the kinds of lines");
  options->View.AddTo(*command);
  command->footer(
    "Examples:\n"
    "  npr lines scan.ply -o lines.vtp --lines contours,suggestive --view front\n"
    "  npr lines scan.ply -o lines.vtp --lines ridges,valleys --quantities K,H\n"
    "  npr lines scan.ply -o lines.vtp --lines contours --define flat \"K\" \"H > 0.5\"");
  command->callback(
    [options, &reporter]()
    {
      if (options->List)
      {
        ListLines();
      }
      else if (options->Models.Files.empty() || options->Output.empty())
      {
        throw CommandError(UsageError,
          "lines needs a model file and -o LINES.vtp, or --list (see npr lines --help)");
      }
      else
      {
        MakeLines(*options, reporter);
      }
    });
}
}
