// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprActorIllustration.h"
#include "nprImageFile.h"
#include "nprRenderJob.h"
#include "nprReporter.h"
#include "nprStyleDocument.h"
#include "nprSurfacePipeline.h"
#include "nprViewOptions.h"
#include "vtkNPRFeatureLines.h"
#include "vtkNPRLineDefinition.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkAppendPolyData.h>
#include <vtkFieldData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkXMLPolyDataWriter.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace npr
{
namespace
{
struct LinesOptions
{
  ModelOptions Models;
  ViewOptions View;
  std::string Output;
  std::string Lines = "contours,suggestive,creases,boundaries";
  bool List = false;
};

void ListLines()
{
  for (int i = 0; i < vtkNPRLineDefinition::GetNumberOfLineNames(); ++i)
  {
    const char* name = vtkNPRLineDefinition::GetLineName(i);
    const auto definition = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(name));
    std::printf("%-12s %s\n", name, definition->GetDescription());
  }
}

/// Checked before a model is read, which may take long.
std::vector<std::string> GetLineNames(const LinesOptions& options)
{
  std::vector<std::string> names = SplitList(options.Lines);
  std::string known;
  for (int i = 0; i < vtkNPRLineDefinition::GetNumberOfLineNames(); ++i)
  {
    known += (i == 0 ? "" : ", ") + std::string(vtkNPRLineDefinition::GetLineName(i));
  }
  for (const std::string& name : names)
  {
    if (!vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(name.c_str())))
    {
      throw CommandError(
        UsageError, "--lines: unknown kind of line '" + name + "'; there are: " + known);
    }
  }
  if (names.empty())
  {
    throw CommandError(UsageError, "--lines names no kind of line; there are: " + known);
  }
  return names;
}

/// The lines of one actor, in the world.
vtkSmartPointer<vtkPolyData> ExtractLines(
  vtkActor* actor, vtkRenderer* renderer, const std::vector<std::string>& names, Reporter& reporter)
{
  SurfacePipeline pipeline;
  pipeline.SetProgress([&](double fraction) { reporter.ShowProgress("extracting", fraction); });
  pipeline.SetInputConnection(actor->GetMapper()->GetInputConnection(0, 0));
  pipeline.Tune(GeometryStyle(), PageScale::Of(renderer).GetUnit(actor->GetMatrix()), true);
  vtkNPRFeatureLines* lines = pipeline.GetFeatureLines();
  for (const std::string& name : names)
  {
    lines->AddDefinition(name.c_str());
  }
  lines->SetCamera(renderer->GetActiveCamera());
  lines->SetMatrix(actor->GetMatrix());
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(actor->GetMatrix());
  vtkNew<vtkTransformPolyDataFilter> toWorld;
  toWorld->SetTransform(transform);
  toWorld->SetInputConnection(lines->GetOutputPort());
  toWorld->Update();
  reporter.ThrowOnVTKError(InputError);
  for (const char* stage : { "prepare", "curvature", "lines" })
  {
    reporter.AddStage(stage, pipeline.GetSeconds(stage));
  }
  return toWorld->GetOutput();
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
  const std::vector<std::string> names = GetLineNames(options);
  const std::array<int, 2> size = options.View.GetSize();

  // Nothing is drawn, but the shape of the image decides what the camera sees.
  const auto window = MakeWindow(reporter, size);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  reporter.BeginStage("read");
  options.Models.Import(renderer, reporter);
  reporter.EndStage();
  options.View.Apply(renderer, options.Models);

  vtkNew<vtkAppendPolyData> append;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator cookie;
  actors->InitTraversal(cookie);
  while (vtkActor* actor = actors->GetNextActor(cookie))
  {
    append->AddInputData(ExtractLines(actor, renderer, names, reporter));
  }
  append->Update();
  vtkPolyData* lines = append->GetOutput();
  lines->GetFieldData()->PassData(append->GetInput()->GetFieldData());
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
  command->add_option("--lines", options->Lines, "Which kinds of lines")->capture_default_str();
  command->add_flag("--list", options->List, "List the kinds of lines");
  options->View.AddTo(*command);
  command->footer(
    "Example: npr lines scan.ply -o lines.vtp --lines contours,suggestive --view front");
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
