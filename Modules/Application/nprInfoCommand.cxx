// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprCurvatureOptions.h"
#include "nprCurvatureStatistics.h"
#include "nprLengthScale.h"
#include "nprReporter.h"
#include "nprTriangleMesh.h"
#include "nprViewOptions.h"
#include "vtkNPRModelImporter.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace npr
{
namespace
{
struct InfoOptions
{
  ModelOptions Reading;
  CurvatureOptions Curvature;
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

/// Of the triangles that the preparation made.
void PrintMesh(vtkPolyData* surface)
{
  TriangleMesh mesh(surface);
  mesh.BuildEdges();
  double area = 0.0;
  for (TriangleMesh::Index i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    area += 0.5 * mesh.GetAreaNormal(i).norm();
  }
  double shortest = 0.0;
  double longest = 0.0;
  double sum = 0.0;
  for (TriangleMesh::Index i = 0; i < mesh.GetNumberOfEdges(); ++i)
  {
    const auto [from, to] = mesh.GetEdge(i);
    const double length = (mesh.GetPoint(from) - mesh.GetPoint(to)).norm();
    shortest = i == 0 ? length : std::min(shortest, length);
    longest = std::max(longest, length);
    sum += length;
  }
  std::printf("%-14s %d\n", "triangles", mesh.GetNumberOfTriangles());
  std::printf("%-14s %d, %g to %g long, %g on the average\n", "edges", mesh.GetNumberOfEdges(),
    shortest, longest, mesh.GetNumberOfEdges() > 0 ? sum / mesh.GetNumberOfEdges() : 0.0);
  std::printf("%-14s %g\n", "area", area);
  std::printf("%-14s %g\n", "length scale", GetLengthScale(surface));
}

void PrintPreparation(vtkNPRSurfacePreparation* preparation)
{
  std::printf("%-14s %lld with one triangle, %lld with more than two, %lld sharp\n", "odd edges",
    static_cast<long long>(preparation->GetNumberOfBoundaryEdges()),
    static_cast<long long>(preparation->GetNumberOfNonManifoldEdges()),
    static_cast<long long>(preparation->GetNumberOfCreaseEdges()));
  std::printf("%-14s %s\n", "preparation", preparation->GetReport().c_str());
}

void PrintInfo(const InfoOptions& options, Reporter& reporter)
{
  const auto importer = options.Reading.Read(options.File, reporter);
  vtkNew<vtkPolyData> surface;
  importer->GetSurface(surface);

  vtkNew<vtkNPRSurfacePreparation> preparation;
  const auto curvature = options.Curvature.Compute(preparation, surface, reporter);

  double bounds[6];
  surface->GetBounds(bounds);
  std::printf("%-14s %s\n", "file", options.File.c_str());
  std::printf("%-14s %d\n", "parts", importer->GetNumberOfParts());
  std::printf("%-14s %lld\n", "points", static_cast<long long>(surface->GetNumberOfPoints()));
  std::printf("%-14s %lld\n", "polygons", static_cast<long long>(surface->GetNumberOfCells()));
  std::printf("%-14s x %g to %g, y %g to %g, z %g to %g\n", "bounds", bounds[0], bounds[1],
    bounds[2], bounds[3], bounds[4], bounds[5]);
  PrintMesh(preparation->GetOutput());
  PrintPreparation(preparation);
  if (curvature->GetNumberOfPolys() > 0)
  {
    options.Curvature.Print(curvature);
    PrintCurvature(curvature);
  }
  PrintArrays("point array", surface->GetPointData());
  PrintArrays("cell array", surface->GetCellData());
}
}

//------------------------------------------------------------------------------
void AddInfoCommand(CLI::App& program, Reporter& reporter)
{
  CLI::App* command =
    program.add_subcommand("info", "Say what is in a model, how its mesh and its curvature are");
  auto options = std::make_shared<InfoOptions>();
  CLI::Option* file = command->add_option("MODEL", options->File, "The file");
  options->Reading.AddReadingTo(*command);
  options->Curvature.AddTo(*command);
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
