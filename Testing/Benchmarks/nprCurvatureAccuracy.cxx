// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How right curvature is: the tables of Documentation/Curvature.md.
 *
 *   nprCurvatureAccuracy [LEVELS]
 *
 * Surfaces that are known by formula, as regular grids, jittered by 0.3 of a cell, and jittered
 * with noise along the normal (standard deviation 1 % of the mean edge), on LEVELS (4) resolutions
 * of about 3, 12, 46 and 184 thousand triangles. Each cell of the tables has the relative RMS error
 * and, after the slash, the largest one. vtkCurvatures has no principal curvatures: they are
 * computed from its mean and Gaussian curvature, with the sign of the mean that fits better.
 */
#include "nprErrorStatistics.h"
#include "nprIrregularSurfaces.h"
#include "vtkNPRCurvatureTensor.h"

#include <vtkCurvatures.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkObject.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
using namespace nprtest;

struct Subject
{
  const char* Name;
  /// n is 24 on the coarsest level.
  std::function<AnalyticSurface(int n, bool irregular)> Make;
};

std::function<AnalyticSurface(int, bool)> Grid(
  const ParametricSurface& surface, double cellsInU, double cellsInV)
{
  return [=](int n, bool irregular)
  {
    return MakeSurface(surface, static_cast<int>(cellsInU * n), static_cast<int>(cellsInV * n),
      { irregular ? 0.3 : 0.0, 1 });
  };
}

std::vector<Subject> GetSubjects()
{
  const auto ellipsoid = [](const Vector3d& axes)
  {
    return [=](int n, bool irregular)
    { return MakeRemeshedEllipsoid(axes, static_cast<int>(0.8 * n), 1, irregular); };
  };
  return { { "sphere", ellipsoid({ 1.0, 1.0, 1.0 }) },
    { "ellipsoid", ellipsoid({ 1.0, 0.7, 0.5 }) }, { "torus", Grid(Torus(1.0, 0.4), 2.5, 1.0) },
    { "cylinder", Grid(Cylinder(0.5, 2.0), 2.0, 1.25) },
    { "cone", Grid(Cone(0.5, 2.0, 1.0), 2.5, 1.0) },
    { "monkey saddle", Grid(MonkeySaddle(), 1.6, 1.6) },
    { "height field", Grid(Waves(), 1.6, 1.6) } };
}

SurfaceStatistics MeasureEstimator(const AnalyticSurface& surface, int estimator)
{
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetInputData(surface.Mesh);
  tensor->SetEstimator(estimator);
  tensor->Update();
  return MeasureSurface(tensor->GetOutput(), surface.Truths);
}

SurfaceStatistics MeasureVTK(const AnalyticSurface& surface)
{
  vtkNew<vtkCurvatures> mean;
  mean->SetInputData(surface.Mesh);
  mean->SetCurvatureTypeToMean();
  mean->Update();
  vtkNew<vtkCurvatures> gauss;
  gauss->SetInputData(surface.Mesh);
  gauss->SetCurvatureTypeToGaussian();
  gauss->Update();
  SurfaceStatistics best;
  for (const double sign : { 1.0, -1.0 })
  {
    vtkNew<vtkPolyData> result;
    result->ShallowCopy(surface.Mesh);
    vtkNew<vtkDoubleArray> k1;
    k1->SetName(npr::names::PrincipalCurvature1);
    vtkNew<vtkDoubleArray> k2;
    k2->SetName(npr::names::PrincipalCurvature2);
    for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
    {
      const double h = sign * mean->GetOutput()->GetPointData()->GetScalars()->GetTuple1(i);
      const double k = gauss->GetOutput()->GetPointData()->GetScalars()->GetTuple1(i);
      const double root = std::sqrt(std::max(0.0, h * h - k));
      k1->InsertNextValue(h + root);
      k2->InsertNextValue(h - root);
    }
    result->GetPointData()->AddArray(k1);
    result->GetPointData()->AddArray(k2);
    const SurfaceStatistics statistics = MeasureSurface(result, surface.Truths);
    if (sign > 0.0 || statistics.All.Principal.Rms < best.All.Principal.Rms)
    {
      best = statistics;
    }
  }
  return best;
}

std::string Write(const RelativeError& error)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.2g / %.2g", error.Rms, error.Max);
  return std::isnan(error.Rms) ? "-" : text;
}

struct Row
{
  std::string Title;
  std::vector<SurfaceStatistics> Results; // the estimators, then vtkCurvatures
};

void PrintTable(const std::vector<Row>& rows, const std::vector<std::string>& estimators,
  ErrorStatistics SurfaceStatistics::*part)
{
  std::printf("| surface, mesh | triangles |");
  for (const std::string& name : estimators)
  {
    std::printf(" %s k |", name.c_str());
  }
  std::printf(" vtkCurvatures k |");
  for (const std::string& name : estimators)
  {
    std::printf(" %s C |", name.c_str());
  }
  std::printf("\n| --- | ---: |");
  for (std::size_t i = 0; i < 2 * estimators.size() + 1; ++i)
  {
    std::printf(" --- |");
  }
  std::printf("\n");
  for (const Row& row : rows)
  {
    if ((row.Results.front().*part).Points == 0)
    {
      continue;
    }
    std::printf("| %s |", row.Title.c_str());
    for (const SurfaceStatistics& result : row.Results)
    {
      std::printf(" %s |", Write((result.*part).Principal).c_str());
    }
    for (std::size_t i = 0; i < estimators.size(); ++i)
    {
      std::printf(" %s |", Write((row.Results[i].*part).Cubic).c_str());
    }
    std::printf("\n");
  }
}
}

int main(int argc, char* argv[])
{
  const int levels = argc > 1 ? std::atoi(argv[1]) : 4;
  if (levels < 1 || levels > 6)
  {
    std::fprintf(stderr, "nprCurvatureAccuracy [LEVELS]: from 1 to 6\n");
    return EXIT_FAILURE;
  }
  vtkObject::GlobalWarningDisplayOff(); // vtkCurvatures warns of each border
  std::vector<int> numbers;
  std::vector<std::string> names;
  for (int i = 0; i < vtkNPRCurvatureTensor::GetNumberOfEstimators(); ++i)
  {
    if (const char* name = vtkNPRCurvatureTensor::GetEstimatorName(i))
    {
      numbers.push_back(i);
      names.emplace_back(name);
    }
  }
  std::vector<Row> rows;
  for (const Subject& subject : GetSubjects())
  {
    for (const char* mesh : { "regular", "jittered", "noisy" })
    {
      for (int level = 0; level < levels; ++level)
      {
        const bool isNoisy = mesh == std::string("noisy");
        AnalyticSurface surface =
          subject.Make(24 << level, isNoisy || mesh == std::string("jittered"));
        if (isNoisy)
        {
          AddNoise(surface, 0.01);
        }
        Row row{ std::string(subject.Name) + ", " + mesh + " | " +
            std::to_string(surface.Mesh->GetNumberOfPolys()),
          {} };
        for (const int number : numbers)
        {
          row.Results.push_back(MeasureEstimator(surface, number));
        }
        row.Results.push_back(MeasureVTK(surface));
        rows.push_back(row);
        std::fprintf(stderr, "%s\n", row.Title.c_str());
      }
    }
  }
  std::printf("Interior, farther than two rings of triangles from a border:\n\n");
  PrintTable(rows, names, &SurfaceStatistics::Interior);
  std::printf("\nWithin two rings of a border:\n\n");
  PrintTable(rows, names, &SurfaceStatistics::Border);
  return EXIT_SUCCESS;
}
