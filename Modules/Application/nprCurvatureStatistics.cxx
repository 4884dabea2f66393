// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCurvatureStatistics.h"

#include "nprArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

namespace npr
{
namespace
{
void PrintCount(const char* what, vtkPolyData* surface, const char* flags)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(flags);
  vtkIdType count = 0;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    count += array->GetTuple1(i) != 0.0;
  }
  std::printf("%-14s %lld of %lld\n", what, static_cast<long long>(count),
    static_cast<long long>(surface->GetNumberOfPoints()));
}
}

//------------------------------------------------------------------------------
Distribution::Distribution(
  vtkPolyData* surface, const char* array, const std::function<double(double)>& change)
{
  vtkPointData* data = surface->GetPointData();
  vtkDataArray* values = data->GetArray(array);
  vtkDataArray* areas = data->GetArray(names::PointArea);
  vtkDataArray* unknown = data->GetArray(names::UnknownCurvature);
  std::vector<std::pair<double, double>> weighted;
  double whole = 0.0;
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    if (unknown && unknown->GetTuple1(i) != 0.0)
    {
      continue;
    }
    const double area = areas ? areas->GetTuple1(i) : 1.0;
    weighted.emplace_back(change(values->GetTuple1(i)), area);
    whole += area;
    this->Mean += area * weighted.back().first;
  }
  if (weighted.empty() || !(whole > 0.0))
  {
    this->Mean = 0.0;
    return;
  }
  this->Mean /= whole;
  std::sort(weighted.begin(), weighted.end());
  this->Levels[0] = weighted.front().first;
  this->Levels[4] = weighted.back().first;
  constexpr double shares[3] = { 0.05, 0.5, 0.95 };
  std::size_t place = 0;
  double below = weighted.front().second;
  for (int level = 0; level < 3; ++level)
  {
    while (below < shares[level] * whole && place + 1 < weighted.size())
    {
      below += weighted[++place].second;
    }
    this->Levels[level + 1] = weighted[place].first;
  }
}

//------------------------------------------------------------------------------
void PrintCurvature(vtkPolyData* surface)
{
  PrintCount("border points", surface, names::BorderPoints);
  PrintCount("unknown", surface, names::UnknownCurvature);
  std::printf("%-14s %11s %11s %11s %11s %11s %11s\n", "curvature", "minimum", "5 %", "median",
    "95 %", "maximum", "mean");
  const std::pair<const char*, const char*> rows[] = { { "k1", names::PrincipalCurvature1 },
    { "k2", names::PrincipalCurvature2 }, { "mean H", names::MeanCurvature },
    { "Gaussian K", names::GaussianCurvature } };
  for (const auto& [title, array] : rows)
  {
    const Distribution of(surface, array);
    std::printf("  %-12s %11.4g %11.4g %11.4g %11.4g %11.4g %11.4g\n", title, of.GetMinimum(),
      of.GetLow(), of.GetMedian(), of.GetHigh(), of.GetMaximum(), of.GetMean());
  }
}
}
