// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprCurvatureOptions.h"
#include "nprCurvaturePicture.h"
#include "nprCurvatureStatistics.h"
#include "nprImageFile.h"
#include "nprReporter.h"
#include "nprViewOptions.h"
#include "vtkNPRModelImporter.h"
#include "vtkNPRSampleSource.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

namespace npr
{
namespace
{
struct CurvatureCommandOptions
{
  ModelOptions Models;
  ViewOptions View;
  CurvatureOptions Curvature;
  std::string Output;
  std::string Show;
};

bool IsSurfaceFile(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".vtp" || extension == ".vtk";
}

template<class Writer>
void WriteWith(Writer* writer, vtkPolyData* surface, const std::string& file)
{
  writer->SetInputData(surface);
  WriteWhole(file,
    [&](const std::string& partial)
    {
      writer->SetFileName(partial.c_str());
      return writer->Write() == 1;
    });
}

void WriteSurface(vtkPolyData* surface, const std::string& file)
{
  if (ExtensionOf(file) == ".vtp")
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    WriteWith(writer.Get(), surface, file);
  }
  else
  {
    vtkNew<vtkPolyDataWriter> writer;
    writer->SetFileTypeToBinary();
    WriteWith(writer.Get(), surface, file);
  }
}

/// All that can be refused is refused before the long work.
void Check(const CurvatureCommandOptions& options)
{
  if (options.Models.Sample == !options.Models.Files.empty() || options.Models.Files.size() > 1)
  {
    throw CommandError(
      UsageError, "curvature needs one model file, or --sample (see npr curvature --help)");
  }
  if (options.Output.empty() || IsSurfaceFile(options.Output))
  {
    if (!options.Show.empty())
    {
      throw CommandError(UsageError, "--show draws a picture: name one, such as -o picture.png");
    }
    if (!options.Output.empty())
    {
      CheckWritable(options.Output);
    }
    return;
  }
  try
  {
    CheckImageFile(options.Output);
  }
  catch (const CommandError& error)
  {
    if (error.Code == UsageError)
    {
      throw CommandError(UsageError,
        options.Output +
          ": write a surface with its arrays as .vtp or .vtk, or a picture as .png, .jpg, .tif, "
          ".bmp or .ppm");
    }
    throw;
  }
  options.View.GetSize();
  options.View.Parse();
}

vtkSmartPointer<vtkPolyData> GetModel(const CurvatureCommandOptions& options, Reporter& reporter)
{
  if (options.Models.Sample)
  {
    vtkNew<vtkNPRSampleSource> sample;
    sample->Update();
    return sample->GetOutput();
  }
  auto model = vtkSmartPointer<vtkPolyData>::New();
  options.Models.Read(options.Models.Files.front(), reporter)->GetSurface(model);
  CheckArea(options.Models.Files.front(), model);
  return model;
}

void MakeCurvature(const CurvatureCommandOptions& options, Reporter& reporter)
{
  Check(options);
  reporter.BeginStage("read");
  const vtkSmartPointer<vtkPolyData> model = GetModel(options, reporter);
  reporter.EndStage();
  vtkNew<vtkNPRSurfacePreparation> preparation;
  const auto surface = options.Curvature.Compute(preparation, model, reporter);
  if (IsSurfaceFile(options.Output))
  {
    reporter.BeginStage("write");
    WriteSurface(surface, options.Output);
  }
  else if (!options.Output.empty())
  {
    DrawCurvature(surface, options.Show.empty() ? "k1" : options.Show, options.View, options.Models,
      options.Output, reporter);
  }
  reporter.EndStage();
  reporter.ThrowOnVTKError(OutputError);
  if (!reporter.Quiet)
  {
    std::printf("%-14s %s\n", "file",
      options.Models.Sample ? "the built-in sample" : options.Models.Files.front().c_str());
    std::printf("%-14s %lld\n", "triangles", static_cast<long long>(surface->GetNumberOfPolys()));
    options.Curvature.Print(surface);
    PrintCurvature(surface);
  }
  reporter.PrintStages();
}
}

//------------------------------------------------------------------------------
void AddCurvatureCommand(CLI::App& program, Reporter& reporter)
{
  CLI::App* command = program.add_subcommand(
    "curvature", "Estimate curvature; write it as arrays of the surface, or draw it");
  auto options = std::make_shared<CurvatureCommandOptions>();
  options->Models.AddWithSampleTo(*command, "Take the built-in sample instead of a model");
  command->add_option("-o,--output", options->Output,
    "A surface with all arrays, .vtp or .vtk; or an image: .png, .jpg, .tif, .bmp or .ppm. "
    "Without it only the statistics are printed");
  options->Curvature.AddTo(*command);
  command->add_option("--show", options->Show, "What an image shows; default: k1")
    ->check(CLI::IsMember(GetPictureNames()));
  options->View.AddTo(*command);
  command->footer(
    "Printed are the curvatures' distributions over the surface's area; the length unit is the\n"
    "model's. A sphere of radius r has k1 = k2 = 1/r.\n"
    "Examples:\n"
    "  npr curvature scan.ply -o scan.vtp\n"
    "  npr curvature scan.ply -o scan.png --show shape-index --view front");
  command->callback([options, &reporter]() { MakeCurvature(*options, reporter); });
}
}
