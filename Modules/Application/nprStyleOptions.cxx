// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStyleOptions.h"

#include "nprReporter.h"
#include "nprViewOptions.h"
#include "vtkNPRIllustrationStyle.h"

#include <CLI/CLI.hpp>

namespace npr
{
//------------------------------------------------------------------------------
void StyleOptions::AddTo(CLI::App& command)
{
  command
    .add_option("--style", this->Style, "A style's name (npr styles) or the path of a style file")
    ->capture_default_str();
  command.add_option("--lines", this->Lines,
    "The kinds of lines to draw, such as contours,suggestive; none for no lines "
    "(npr lines --list)");
  command.add_option(
    "--background", this->Background, "The paper: #rrggbb, an HTML colour name, or transparent");
}

//------------------------------------------------------------------------------
void StyleOptions::ApplyTo(vtkNPRIllustrationStyle* style, Reporter& reporter) const
{
  const auto check = [&](bool good, ExitCode code)
  {
    reporter.DropVTKErrors();
    if (!good)
    {
      throw CommandError(code, style->GetErrorMessage());
    }
  };
  check(style->Load(this->Style), InputError);
  if (!this->Lines.empty())
  {
    const bool none = this->Lines == "none";
    check(
      style->SelectLines(none ? std::vector<std::string>() : SplitList(this->Lines)), UsageError);
  }
  if (!this->Background.empty() && !this->IsTransparent())
  {
    check(style->SetBackground(this->Background), UsageError);
  }
}
}
