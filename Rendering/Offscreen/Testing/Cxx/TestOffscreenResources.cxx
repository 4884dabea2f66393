// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// A hundred windows come and go without growth in memory or open files.
#include "nprOffscreenTesting.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace npr::testing;

namespace
{

double ResidentMiB()
{
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;)
  {
    if (word == "VmRSS:")
    {
      double kibibytes = 0.0;
      file >> kibibytes;
      return kibibytes / 1024.0;
    }
  }
  return 0.0;
}

long OpenFiles()
{
  const std::filesystem::directory_iterator files("/proc/self/fd");
  return std::distance(begin(files), end(files));
}

void DrawAndDelete(int count)
{
  for (int i = 0; i < count; ++i)
  {
    NewSphereWindow(64, 8)->Render();
  }
}

} // namespace

int TestOffscreenResources(int, char*[])
{
  bool ok = true;
  for (const int backend : Backends())
  {
    ok &= Check(vtkNPROffscreen::Setup(backend), "Setup " + std::to_string(backend));
    DrawAndDelete(10); // fills the driver's caches
    const double memory = ResidentMiB();
    const long files = OpenFiles();
    DrawAndDelete(100);
    const double growth = ResidentMiB() - memory;
    std::cout << vtkNPROffscreen::GetWindowClassName() << ": " << memory << " MiB grew by "
              << growth << " MiB, open files from " << files << " to " << OpenFiles() << std::endl;
    // One context with its framebuffers takes more than a mebibyte: a leak would be over 100 MiB.
    ok &= Check(growth < 10.0, "no growth in memory");
    ok &= Check(OpenFiles() == files, "no growth in open files");
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
