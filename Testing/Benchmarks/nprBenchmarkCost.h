// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprBenchmarkCost.h
 * @brief Seconds and megabytes.
 */
#ifndef nprBenchmarkCost_h
#define nprBenchmarkCost_h

#include <vtkSMPTools.h>

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace nprbench
{
struct Cost
{
  double Wall = 1e30;
  double Processor = 1e30; // of all threads
};

/// TBB, once held to one thread, would not take two again.
inline void UseThreads(int threads)
{
  vtkSMPTools::SetBackend(threads == 1 ? "Sequential" : "TBB");
  vtkSMPTools::Initialize(threads);
}

/// By a clock that also knows parts of a scheduler's tick.
inline double GetProcessorSeconds()
{
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return time.tv_sec + 1e-9 * time.tv_nsec;
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

/// The mean over many pieces of work, each the least of several runs.
inline Cost MeasureMean(int count, int runs, const std::function<void(int)>& work)
{
  std::vector<Cost> least(count);
  for (int run = 0; run < runs; ++run)
  {
    for (int i = 0; i < count; ++i)
    {
      const Cost cost = Measure(1, [&]() { work(i); });
      least[i].Wall = std::min(least[i].Wall, cost.Wall);
      least[i].Processor = std::min(least[i].Processor, cost.Processor);
    }
  }
  Cost mean{ 0.0, 0.0 };
  for (const Cost& cost : least)
  {
    mean.Wall += cost.Wall / count;
    mean.Processor += cost.Processor / count;
  }
  return mean;
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
