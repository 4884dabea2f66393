// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprLengthScale.h"
#include "nprReporter.h"
#include "nprViewOptions.h"
#include "vtkNPRModelImporter.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace npr
{
namespace
{
struct InfoOptions
{
  ModelOptions Reading;
  std::string File;
  bool ListFormats = false;
};

void PrintArrays(const char* what, vtkDataSetAttributes* attributes)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (!array)
    {
      continue;
    }
    std::printf("%-14s %s (%s, %d)", what, array->GetName() ? array->GetName() : "unnamed",
      array->GetDataTypeAsString(), array->GetNumberOfComponents());
    if (array->GetNumberOfComponents() == 1)
    {
      double range[2];
      array->GetRange(range);
      std::printf(", %g to %g", range[0], range[1]);
    }
    std::printf("\n");
  }
}

void ListFormats()
{
  for (int i = 0; i < vtkNPRModelImporter::GetNumberOfFormats(); ++i)
  {
    std::printf("%-10s %s%s\n", vtkNPRModelImporter::GetFormatExtension(i),
      vtkNPRModelImporter::GetFormatDescription(i),
      vtkNPRModelImporter::GetFormatIsVolume(i) ? " (a volume takes --iso)" : "");
  }
}

void PrintInfo(const InfoOptions& options, Reporter& reporter)
{
  const auto importer = options.Reading.Read(options.File, reporter);
  vtkNew<vtkPolyData> surface;
  importer->GetSurface(surface);

  vtkNew<vtkNPRSurfacePreparation> preparation;
  reporter.Watch(preparation, "preparing");
  preparation->SetInputData(surface);
  preparation->Update();
  reporter.ThrowOnVTKError(InputError);

  double bounds[6];
  surface->GetBounds(bounds);
  std::printf("%-14s %s\n", "file", options.File.c_str());
  std::printf("%-14s %d\n", "parts", importer->GetNumberOfParts());
  std::printf("%-14s %lld\n", "points", static_cast<long long>(surface->GetNumberOfPoints()));
  std::printf("%-14s %lld\n", "polygons", static_cast<long long>(surface->GetNumberOfCells()));
  std::printf("%-14s x %g to %g, y %g to %g, z %g to %g\n", "bounds", bounds[0], bounds[1],
    bounds[2], bounds[3], bounds[4], bounds[5]);
  std::printf("%-14s %g\n", "length scale", GetLengthScale(preparation->GetOutput()));
  std::printf("%-14s %s\n", "preparation", preparation->GetReport().c_str());
  PrintArrays("point array", surface->GetPointData());
  PrintArrays("cell array", surface->GetCellData());
}
}

//------------------------------------------------------------------------------
void AddInfoCommand(CLI::App& program, Reporter& reporter)
{
  CLI::App* command = program.add_subcommand("info", "Say what is in a model");
  auto options = std::make_shared<InfoOptions>();
  CLI::Option* file = command->add_option("MODEL", options->File, "The file");
  options->Reading.AddReadingTo(*command);
  command->add_flag("--formats", options->ListFormats, "List the kinds of files that are read");
  command->callback(
    [options, file, &reporter]()
    {
      if (options->ListFormats)
      {
        ListFormats();
      }
      else if (file->count() == 0)
      {
        throw CommandError(
          UsageError, "info needs a model file, or --formats (see npr info --help)");
      }
      else
      {
        PrintInfo(*options, reporter);
      }
    });
}
}
