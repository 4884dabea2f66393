// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprChecks.h
 * @brief What a test found.
 */
#ifndef nprChecks_h
#define nprChecks_h

#include <cstdlib>
#include <iostream>
#include <string>

namespace nprtest
{
constexpr double Pi = 3.14159265358979323846;

/// Counts and tells what failed.
class Checks
{
public:
  bool operator()(bool condition, const std::string& what, double value = 0.0)
  {
    if (!condition)
    {
      std::cerr << "FAILED: " << what << " (" << value << ")\n";
      ++this->Failures;
    }
    return condition;
  }
  int GetResult() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  int Failures = 0;
};
}

#endif
