// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprBenchmarkCost.h
 * @brief Seconds and megabytes.
 */
#ifndef nprBenchmarkCost_h
#define nprBenchmarkCost_h

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <string>

namespace nprbench
{
struct Cost
{
  double Wall = 1e30;
  double Processor = 1e30; // of all threads
};

inline double GetProcessorSeconds()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_utime.tv_sec + usage.ru_stime.tv_sec +
    1e-6 * (usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// The least of several runs.
inline Cost Measure(int runs, const std::function<void()>& work)
{
  Cost cost;
  for (int i = 0; i < runs; ++i)
  {
    const double processor = GetProcessorSeconds();
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    cost.Wall = std::min(cost.Wall, wall.count());
    cost.Processor = std::min(cost.Processor, GetProcessorSeconds() - processor);
  }
  return cost;
}

/// A line of /proc/self/status, in megabytes: VmRSS, or VmHWM, its largest value so far.
inline double ReadMegabytes(const std::string& what)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
  {
    if (word == what + ":")
    {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes / 1024.0;
    }
  }
  return 0.0;
}

inline void ForgetPeak()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

}

#endif
