// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprVisibilityOptions.h
 * @brief The option of images that says how it is found what surfaces hide.
 */
#ifndef nprVisibilityOptions_h
#define nprVisibilityOptions_h

#include <string>

namespace CLI
{
class App;
class Option;
}
class vtkNPRIllustration;

namespace npr
{
struct VisibilityOptions
{
  VisibilityOptions();

  std::string Visibility; ///< exact or depth

  void AddTo(CLI::App& command);

  /// Throws a CommandError when this build can not do what was asked for.
  void Check() const;

  /// Throws a CommandError when the option was given, for what is no image.
  void RefuseFor(const std::string& file) const;

  void ApplyTo(vtkNPRIllustration* illustration) const;

private:
  CLI::Option* Given = nullptr;
};
}

#endif
