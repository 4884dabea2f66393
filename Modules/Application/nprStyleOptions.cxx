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
  this->AddSettingsTo(command);
  command.add_option(
    "--background", this->Background, "The paper: #rrggbb, an HTML colour name, or transparent");
}

//------------------------------------------------------------------------------
void StyleOptions::AddSettingsTo(CLI::App& command)
{
  command
    .add_option("--set", this->Settings,
      "Set KIND.PARAMETER=VALUE of the lines: a text, or numbers parted by commas; such as "
      "isophotes.levels=5 topographic.direction=0,1,0 (may be given several times)")
    ->allow_extra_args(false);
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
  for (const std::string& setting : this->Settings)
  {
    const std::size_t dot = setting.find('.');
    const std::size_t equals = setting.find('=');
    if (dot == std::string::npos || equals == std::string::npos || equals < dot)
    {
      throw CommandError(UsageError,
        "--set " + setting + ": write KIND.PARAMETER=VALUE, such as isophotes.levels=5");
    }
    check(style->SetLineParameter(setting.substr(0, dot), setting.substr(dot + 1, equals - dot - 1),
            setting.substr(equals + 1)),
      UsageError);
  }
  if (!this->Background.empty() && !this->IsTransparent())
  {
    check(style->SetBackground(this->Background), UsageError);
  }
}
}
