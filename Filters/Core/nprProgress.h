// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprProgress.h
 * @brief How kernels tell filters how far they are, and learn that they should end.
 */
#ifndef nprProgress_h
#define nprProgress_h

#include "nprVTKCompat.h"

#include <vtkAlgorithm.h>
#include <vtkSMPTools.h>
#include <vtkType.h>

#include <algorithm>
#include <functional>

namespace npr
{
/// Told the fraction that is done, in [0, 1]; answers false when the computation should end.
using Progress = std::function<bool(double)>;

/// For those whom nobody watches.
inline bool IgnoreProgress(double)
{
  return true;
}

/// Whether somebody has asked the filter to abort.
inline bool IsAborted(vtkAlgorithm* filter)
{
#if NPR_VTK_AT_LEAST(9, 3)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

/// Tells the observers of a filter; [0, 1] there is [begin, end] of the filter's own progress.
inline Progress ReportTo(vtkAlgorithm* filter, double begin = 0.0, double end = 1.0)
{
  return [filter, begin, end](double fraction)
  {
    filter->UpdateProgress(begin + (end - begin) * fraction);
    return !IsAborted(filter);
  };
}

/// A part of somebody's progress.
inline Progress PartOf(const Progress& whole, double begin, double end)
{
  return [&whole, begin, end](double fraction) { return whole(begin + (end - begin) * fraction); };
}

/// vtkSMPTools::For over [0, size), with a word to `progress` now and then. False when it was
/// ended before all was done.
template<typename Function>
bool ForWithProgress(vtkIdType size, const Progress& progress, const Function& function)
{
  // A part must be worth the start of its threads, and not make those wait who want it to end.
  constexpr vtkIdType LeastPart = 2000;
  const vtkIdType part = std::max(LeastPart, size / 64 + 1);
  for (vtkIdType begin = 0; begin < size; begin += part)
  {
    if (!progress(static_cast<double>(begin) / size))
    {
      return false;
    }
    vtkSMPTools::For(begin, std::min(size, begin + part), function);
  }
  return progress(1.0);
}
}

#endif
