// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprTestModels.h
 * @brief Finds the models that Testing/Data/fetch has brought.
 */
#ifndef nprTestModels_h
#define nprTestModels_h

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace npr
{
/// What a test returns that can not run for want of a model; ctest reports it as skipped.
inline constexpr int SkipTest = 125;

/**
 * The path of a model, such as "bunny/bunny.ply"; see Testing/Data/README.md for what there is.
 *
 * Empty, with a message, if it could not be fetched; then return SkipTest. Declare such a test by
 * npr_tests_need_models(): there the fetching has run first. In continuous integration,
 * where the environment says CI, a missing model fails the test at once.
 */
inline std::string TestModel(const std::string& name)
{
  const char* folder = std::getenv("NPR_MODELS");
  const std::string path = std::string(folder ? folder : ".") + "/" + name;
  if (!folder || !std::ifstream(path))
  {
    std::cerr << "There is no model " << path
              << ". Run Testing/Data/fetch FOLDER and set NPR_MODELS to that folder.\n";
    if (std::getenv("CI"))
    {
      std::exit(EXIT_FAILURE); // a misspelt name would be skipped for ever
    }
    return {};
  }
  return path;
}
}

#endif
