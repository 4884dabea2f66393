// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCurvatureStatistics.h
 * @brief How the values on a surface are distributed, and the tables that say so.
 */
#ifndef nprCurvatureStatistics_h
#define nprCurvatureStatistics_h

#include <functional>

class vtkPolyData;

namespace npr
{
/// Of the values at points that have an estimate. Each point counts with its area, so that what
/// comes out does not depend on where the mesh is fine.
class Distribution
{
public:
  /// @param change is applied to each value first
  Distribution(
    vtkPolyData* surface, const char* array,
    const std::function<double(double)>& change = [](double value) { return value; });

  double GetMinimum() const { return this->Levels[0]; }
  double GetLow() const { return this->Levels[1]; } ///< 5 % of the surface are below.
  double GetMedian() const { return this->Levels[2]; }
  double GetHigh() const { return this->Levels[3]; } ///< 95 % of the surface are below.
  double GetMaximum() const { return this->Levels[4]; }
  double GetMean() const { return this->Mean; }

private:
  double Levels[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
  double Mean = 0.0;
};

/// Points at borders, points without an estimate, and the distributions of the curvatures, to
/// standard output.
void PrintCurvature(vtkPolyData* surface);
}

#endif
