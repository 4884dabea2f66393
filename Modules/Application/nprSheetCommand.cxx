// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprArrayNames.h"
#include "nprCanvas.h"
#include "nprImageFile.h"
#include "nprRenderJob.h"
#include "nprReporter.h"
#include "nprStyleOptions.h"
#include "nprViewOptions.h"
#include "nprVisibilityOptions.h"
#include "vtkNPRIllustration.h"
#include "vtkNPRIllustrationStyle.h"
#include "vtkNPRLineDefinition.h"
#include "vtkNPRRegionBorders.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace npr
{
namespace
{
constexpr Colour Paper = { 1.0, 1.0, 1.0 };
constexpr Colour Ink = { 0.16, 0.16, 0.18 };
constexpr Colour PaleInk = { 0.55, 0.55, 0.58 };
constexpr int LargestSide = 16384; // of the sheet, in pixels

struct SheetOptions
{
  ModelOptions Models;
  ViewOptions View;
  VisibilityOptions Visibility;
  std::string Lines;
  std::string Output;
};

/// Where things are on the sheet, in pixels.
struct Layout
{
  Layout(int cells, const std::array<int, 2>& size)
    : Cell(size), Columns(static_cast<int>(std::ceil(std::sqrt(double(cells))))),
      Rows((cells + Columns - 1) / Columns), Gap(std::min(size[0], size[1]) / 16),
      TextSize(std::max(11, std::min(size[0], size[1]) / 20)), Label(2 * TextSize)
  {
  }

  int GetWidth() const { return this->Columns * (this->Cell[0] + this->Gap) + this->Gap; }
  int GetHeight() const
  {
    return this->Rows * (this->Cell[1] + this->Label + this->Gap) + this->Gap;
  }
  /// The lower left corner of a cell's picture; cells run along the rows, from the top.
  std::array<int, 2> GetCorner(int cell) const
  {
    const int row = this->Rows - 1 - cell / this->Columns;
    return { this->Gap + cell % this->Columns * (this->Cell[0] + this->Gap),
      this->Gap + row * (this->Cell[1] + this->Label + this->Gap) + this->Label };
  }

  std::array<int, 2> Cell;
  int Columns;
  int Rows;
  int Gap;
  int TextSize;
  int Label; ///< Height of the strip below a picture.
};

/// What the models bring, all of them, for lines that need data.
struct ModelData
{
  std::string PointArray; ///< The first with one number a point; empty where there is none.
  bool HasRegions = false;
};

std::string FindPointArray(vtkPolyData* surface)
{
  vtkPointData* const data = surface->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = data->GetArray(i);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1 &&
      array->GetDataType() != VTK_UNSIGNED_CHAR && array != data->GetGlobalIds() &&
      std::string(array->GetName()) != names::WeldedPointIds)
    {
      return array->GetName();
    }
  }
  return std::string();
}

ModelData FindData(vtkRenderer* renderer)
{
  ModelData found;
  vtkActorCollection* const actors = renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkMapper* const mapper = vtkActor::SafeDownCast(actors->GetItemAsObject(i))->GetMapper();
    mapper->Update();
    vtkPolyData* const surface = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
    const std::string array = surface ? FindPointArray(surface) : std::string();
    const bool hasRegions = surface &&
      surface->GetCellData()->GetArray(vtkNew<vtkNPRRegionBorders>()->GetArray().c_str());
    found.PointArray = i == 0 || found.PointArray == array ? array : std::string();
    found.HasRegions = hasRegions && (i == 0 || found.HasRegions);
  }
  return found;
}

/// The kinds that can be drawn on these models; says which can not.
std::vector<std::string> GetUsualKinds(const ModelData& data, const Reporter& reporter)
{
  std::vector<std::string> kinds;
  std::string others;
  for (int i = 0; i < vtkNPRLineDefinition::GetNumberOfLineNames(); ++i)
  {
    const std::string name = vtkNPRLineDefinition::GetLineName(i);
    const auto definition = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(name.c_str()));
    if (definition->IsForAnySurface() ||
      (definition->IsA("vtkNPRIsoLines") && !data.PointArray.empty()) ||
      (definition->IsA("vtkNPRRegionBorders") && data.HasRegions))
    {
      kinds.push_back(name);
    }
    else
    {
      others += (others.empty() ? "" : ", ") + name;
    }
  }
  if (!others.empty() && !reporter.Quiet)
  {
    std::printf(
      "left out, for they need an expression of yours, or data that the model has not: %s\n",
      others.c_str());
  }
  return kinds;
}

/// Thin grey contours, then each kind in black.
std::string MakeStyle(const std::vector<std::string>& kinds)
{
  std::string lines = R"({ "type": "contours", "width": 1.6, "color": "#b4b4ba",
    "spline": "catmull-rom", "minimum_length": 22 })";
  for (const std::string& kind : kinds)
  {
    const auto definition = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName(kind.c_str()));
    // What comes from derivatives has their noise; borders of regions step from edge to edge.
    const bool isSmooth = definition->HasField() && definition->HasTest();
    const bool isRegionBorder = definition->IsA("vtkNPRRegionBorders");
    lines += ",\n{ \"type\": \"" + kind + R"(", "width": 2.4, "color": "#000000", )" +
      (isSmooth ? R"("spline": "b-spline", "smoothing": 10, "taper": true, "minimum_length": 40 })"
          : isRegionBorder ? R"("spline": "b-spline", "smoothing": 10, "minimum_length": 20 })"
                           : R"("spline": "catmull-rom", "minimum_length": 20 })");
  }
  return R"({ "name": "sheet", "background": "#ffffff", "shading": { "style": "paper" },
    "lines": [)" +
    lines + "] }";
}

std::vector<int> CountChains(vtkNPRIllustration* illustration, std::size_t types)
{
  vtkNew<vtkPolyData> lines;
  illustration->GetLines(lines);
  std::vector<int> counts(types, 0);
  vtkDataArray* const type = lines->GetCellData()->GetArray(names::LineType);
  for (vtkIdType i = 0; type && i < type->GetNumberOfTuples(); ++i)
  {
    ++counts[static_cast<std::size_t>(type->GetComponent(i, 0))];
  }
  return counts;
}

void CheckSize(const Layout& layout)
{
  if (std::max(layout.GetWidth(), layout.GetHeight()) > LargestSide)
  {
    throw CommandError(UsageError,
      "the sheet would be " + std::to_string(layout.GetWidth()) + "x" +
        std::to_string(layout.GetHeight()) + " pixels; give its cells a smaller --size");
  }
}

void MakeSheet(const SheetOptions& options, Reporter& reporter)
{
  // All that can be refused is refused before the long work.
  if (options.Output.empty() || (options.Models.Sample && !options.Models.Files.empty()))
  {
    throw CommandError(UsageError,
      "sheet needs -o IMAGE, and a model file or --sample, not both (see npr sheet --help)");
  }
  CheckImageFile(options.Output);
  options.View.Parse();
  options.Visibility.Check();
  vtkNew<vtkNPRIllustrationStyle> style;
  if (options.Lines == "none")
  {
    throw CommandError(
      UsageError, "--lines none leaves nothing to draw; name kinds (npr lines --list)");
  }
  std::vector<std::string> kinds = SplitList(options.Lines);
  const bool isKnown = style->SelectLines(kinds);
  reporter.DropVTKErrors();
  if (!isKnown || (kinds.empty() && !options.Lines.empty()))
  {
    throw CommandError(UsageError,
      "--lines: " +
        (isKnown ? "it names no kind of line (npr lines --list)" : style->GetErrorMessage()));
  }
  const std::size_t most =
    kinds.empty() ? vtkNPRLineDefinition::GetNumberOfLineNames() : kinds.size();
  CheckSize(Layout(static_cast<int>(most), options.View.GetSize()));

  RenderJob job(reporter, options.View.GetSize());
  reporter.BeginStage("read");
  options.Models.Import(job.GetRenderer(), reporter);
  reporter.EndStage();
  const ModelData data = FindData(job.GetRenderer());
  if (kinds.empty())
  {
    kinds = GetUsualKinds(data, reporter);
  }
  const Layout layout(static_cast<int>(kinds.size()), options.View.GetSize());
  options.View.Apply(job.GetRenderer(), options.Models);
  style->LoadString(MakeStyle(kinds));
  if (!data.PointArray.empty() && style->UsesLineDefault("isolines", "array"))
  {
    style->SetLineParameter("isolines", "array", data.PointArray);
  }
  PointHeightsUp(style, options.View.GetUp(options.Models));
  options.Visibility.ApplyTo(job.GetIllustration());
  job.Apply(style);
  // All lines are extracted here, once.
  const std::vector<int> counts = CountChains(job.GetIllustration(), kinds.size() + 1);
  reporter.ThrowOnVTKError(InputError);

  vtkNew<vtkImageData> sheet;
  sheet->SetDimensions(layout.GetWidth(), layout.GetHeight(), 1);
  sheet->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  Canvas canvas(sheet);
  canvas.Fill(0, 0, layout.GetWidth(), layout.GetHeight(), Paper);
  for (int cell = 0; cell < static_cast<int>(kinds.size()); ++cell)
  {
    for (int type = 0; type <= static_cast<int>(kinds.size()); ++type)
    {
      job.GetIllustration()->SetLineVisibility(type, type == 0 || type == cell + 1);
    }
    const std::array<int, 2> corner = layout.GetCorner(cell);
    canvas.Paste(job.Draw(), corner[0], corner[1]);
    const int middle = corner[0] + layout.Cell[0] / 2;
    const int top = corner[1] - layout.TextSize / 4;
    const bool isEmpty = counts[cell + 1] == 0;
    canvas.Write(kinds[cell] + (isEmpty ? " (none here)" : ""), middle, top, layout.TextSize,
      isEmpty ? PaleInk : Ink, 0.5);
    reporter.ShowProgress("drawing", (cell + 1.0) / static_cast<double>(kinds.size()));
  }
  reporter.ClearProgress();
  job.AddStages(reporter.StopClock());
  reporter.BeginStage("write");
  WriteImage(sheet, options.Output);
  reporter.EndStage();
  reporter.PrintStages();
}
}

//------------------------------------------------------------------------------
void AddSheetCommand(CLI::App& program, Reporter& reporter)
{
  CLI::App* command =
    program.add_subcommand("sheet", "Draw each kind of line by itself, side by side in one image");
  auto options = std::make_shared<SheetOptions>();
  options->View.Size = "800x600";
  options->Models.AddWithSampleTo(
    *command, "Draw the built-in sample; so it is without a model, too");
  command->add_option("-o,--output", options->Output, "The image: .png, .jpg, .tif, .bmp or .ppm");
  command
    ->add_option("--lines", options->Lines,
      "Which kinds of lines, such as contours,creases (npr lines --list); default: all but "
      "those that need an expression of yours, or data that the model has not")
    ->check(CheckLines, "");
  options->View.AddTo(*command);
  options->Visibility.AddTo(*command);
  command->get_option("--size")->description("Size of each cell in pixels, WxH");
  command->footer("Each kind is drawn in black, over the contours in grey.\n"
                  "Examples:\n"
                  "  npr sheet -o sheet.png\n"
                  "  npr sheet scan.ply -o sheet.png --lines contours,suggestive,ridges --size "
                  "600x600");
  command->callback(
    [options, &reporter]()
    {
      options->Models.Sample |= options->Models.Files.empty();
      MakeSheet(*options, reporter);
    });
}
}
