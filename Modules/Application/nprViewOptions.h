// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprViewOptions.h
 * @brief The options that several verbs share: which model, seen from where.
 */
#ifndef nprViewOptions_h
#define nprViewOptions_h

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
}
class vtkRenderer;

namespace npr
{
class Reporter;

struct ModelOptions
{
  std::vector<std::string> Files;
  std::optional<double> IsoValue;
  double VolumeSmoothing = 1.0;

  /// Returns the option of the files, which is required.
  CLI::Option* AddTo(CLI::App& command);
  /// Read every file into the renderer. Throws a CommandError that names the file.
  void Import(vtkRenderer* renderer, Reporter& reporter) const;
};

struct ViewOptions
{
  std::string Size = "1600x1200";
  std::string View = "three-quarter";
  std::string Projection = "perspective";
  std::string Eye, Target, Up;

  void AddTo(CLI::App& command);

  /// Width and height in pixels.
  std::array<int, 2> GetSize() const;

  /// Point the renderer's camera at its actors. The renderer's window has its size by then.
  /// The models' files say which axis is up where the user does not.
  void Apply(vtkRenderer* renderer, const ModelOptions& models) const;
};

/// "a,b,c" as its parts, without the empty ones.
std::vector<std::string> SplitList(const std::string& text);
}

#endif
