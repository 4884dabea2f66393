// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprViewOptions.h
 * @brief The options that several verbs share: which model, seen from where.
 */
#ifndef nprViewOptions_h
#define nprViewOptions_h

#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
}
class vtkNPRModelImporter;
class vtkPolyData;
class vtkRenderer;

namespace npr
{
class Reporter;

struct ModelOptions
{
  std::vector<std::string> Files;
  std::optional<double> IsoValue;
  double VolumeSmoothing = 1.0;
  bool Sample = false; ///< The built-in one, instead of files.

  /// The options that say how a file is read.
  void AddReadingTo(CLI::App& command);
  /// These and the files. Returns the option of the files, which is required.
  CLI::Option* AddTo(CLI::App& command);
  /// The files are not required then.
  void AddWithSampleTo(CLI::App& command, const std::string& description);

  /// Read one file. Throws a CommandError that names it; warns of what had to be left out.
  vtkSmartPointer<vtkNPRModelImporter> Read(const std::string& file, Reporter& reporter) const;
  /// Read every file, or put the sample, into the renderer. Throws a CommandError that names the
  /// file, also where none of its polygons has an area, and so nothing to draw.
  void Import(vtkRenderer* renderer, Reporter& reporter) const;
  /// Which axis is up by the custom of the files' formats; y where they differ.
  int GetUpAxis() const;
  /// From where the first model is seen from the front, by its kind.
  double GetFrontAzimuth() const;
};

/// Throws a CommandError where the file's surface has no area.
void CheckArea(const std::string& file, vtkPolyData* surface);

/// What the words of ViewOptions mean.
struct ViewSpecification
{
  bool IsParallel = false;
  std::optional<int> UpAxis;
  /// @name Without an eye
  ///@{
  std::string Name; ///< Of a view; empty: the two angles count, in degrees.
  double Azimuth = 0.0;
  double Elevation = 0.0;
  ///@}
  std::optional<std::array<double, 3>> Eye, Target, Up;
};

struct ViewOptions
{
  std::string Size = "1600x1200";
  std::string View = "three-quarter";
  std::string Projection = "perspective";
  std::string Eye, Target, Up;
  const CLI::Option* GivenView = nullptr; ///< Null without a command line.

  void AddTo(CLI::App& command);

  /// Throws a CommandError where the words make no sense; to be called before any long work.
  ViewSpecification Parse() const;

  /// Which way is up, in the world.
  std::array<double, 3> GetUp(const ModelOptions& models) const;

  /// Width and height in pixels.
  std::array<int, 2> GetSize() const;

  /// Point the renderer's camera at its actors. The renderer's window has its size by then.
  /// The models' files say which axis is up where the user does not.
  void Apply(vtkRenderer* renderer, const ModelOptions& models) const;
};

/// Put the built-in sample into the renderer.
void AddSample(vtkRenderer* renderer);

/// "a, b,c" as its parts, without blanks around them and without the empty ones.
std::vector<std::string> SplitList(const std::string& text);
}

#endif
