// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprStyleOptions.h
 * @brief The options that say how an illustration looks.
 */
#ifndef nprStyleOptions_h
#define nprStyleOptions_h

#include <array>
#include <string>
#include <tuple>
#include <vector>

namespace CLI
{
class App;
}
class vtkNPRIllustrationStyle;

namespace npr
{
/// What is wrong with what --lines was given; empty if nothing is.
inline std::string CheckLines(const std::string& lines)
{
  return lines.empty() ? "no kind of line is named (npr lines --list); none draws no lines" : "";
}

class Reporter;

struct StyleOptions
{
  std::string Style = "technical";
  std::string Lines;
  std::string Outline;               ///< A kind's name; empty for the style's.
  std::vector<std::string> Settings; ///< KIND.PARAMETER=VALUE
  /// Lines that users define: name, field and test.
  std::vector<std::tuple<std::string, std::string, std::string>> Definitions;
  std::vector<std::string> Constants; ///< NAME=VALUE, in the formulas of the definitions.
  std::string Background;

  void AddTo(CLI::App& command);
  /// Only the options for Settings, Definitions and Constants.
  void AddSettingsTo(CLI::App& command);
  /// Throws a CommandError when the style or what is changed in it is not valid.
  void ApplyTo(vtkNPRIllustrationStyle* style, Reporter& reporter) const;
  bool IsTransparent() const { return this->Background == "transparent"; }

private:
  /// Makes the definitions known by their names, and returns these.
  std::vector<std::string> Define() const;
};

/// Heights are above the ground, as on maps, where nobody has given topographic lines a direction.
void PointHeightsUp(vtkNPRIllustrationStyle* style, const std::array<double, 3>& up);
}

#endif
