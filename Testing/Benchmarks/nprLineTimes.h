// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprLineTimes.h
 * @brief What lines cost in a new view, beside the plain implementations and VTK.
 */
#ifndef nprLineTimes_h
#define nprLineTimes_h

#include "nprBenchmarkViews.h"
#include "vtkNPRFeatureLines.h"

#include <string>

namespace nprbench
{
using Names = std::vector<std::string>;

/// All kinds of lines that can be drawn on any surface.
Names GetAllLineNames();

vtkSmartPointer<vtkNPRFeatureLines> MakeLineFilter(vtkPolyData* surface, const Names& names);

/// A table, of a surface with all its curvature.
void PrintLineTimes(vtkPolyData* surface, const Views& views, int runs);
}

#endif
