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
  bool good = style->Load(this->Style);
  if (good && !this->Lines.empty())
  {
    good = style->SelectLines(
      this->Lines == "none" ? std::vector<std::string>() : SplitList(this->Lines));
  }
  if (good && !this->Background.empty() && !this->IsTransparent())
  {
    good = style->SetBackground(this->Background);
  }
  reporter.DropVTKErrors();
  if (!good)
  {
    throw CommandError(InputError, style->GetErrorMessage());
  }
}
}
