// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprDrawingOptions.h
 * @brief The options of vector drawings: which paper, at which scale, with which hidden lines.
 */
#ifndef nprDrawingOptions_h
#define nprDrawingOptions_h

#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
}
class vtkNPRDrawingWriter;
class vtkNPRIllustrationStyle;
class vtkRenderer;

namespace npr
{
class Reporter;

/// Whether a file's name is that of a vector drawing.
bool IsDrawingFile(const std::string& file);

/// What lies below the lines of a drawing.
enum class DrawingShading
{
  None,
  Image, // a picture
  Tones  // filled areas
};

struct DrawingOptions
{
  std::string Hidden = "none";
  std::string Scale; ///< P:Q; empty: as large as the page holds
  bool ScaleBar = false;
  std::string Unit = "mm"; ///< of the model
  std::string Paper = "A4";
  std::string Shading = "auto";

  void AddTo(CLI::App& command);

  /// Throws a CommandError when any of the options was given, for what is no drawing.
  void RefuseFor(const std::string& file) const;

  /// A writer with what the options say but the style. Throws a CommandError where they make no
  /// sense; to be called before any long work.
  vtkSmartPointer<vtkNPRDrawingWriter> MakeWriter(
    const std::string& file, bool isParallel, const std::array<int, 2>& size) const;

  /// Throws a CommandError for tones of a style that does not shade.
  DrawingShading GetShading(vtkNPRIllustrationStyle* style) const;

  /// For a drawing to scale: turn the paper, and make the renderer's window and view as large as
  /// the room on it. Throws a CommandError when there is too little of it, and when the drawing
  /// would be a dot; warns of one that is small on its paper.
  void FitViewToPage(vtkRenderer* renderer, vtkNPRDrawingWriter* writer, Reporter& reporter) const;

private:
  double GetMillimetresPerUnit() const;

  std::vector<CLI::Option*> Given;
};
}

#endif
