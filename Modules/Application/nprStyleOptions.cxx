// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprStyleOptions.h"

#include "nprReporter.h"
#include "nprViewOptions.h"
#include "vtkNPRExpressionLines.h"
#include "vtkNPRIllustrationStyle.h"

#include <vtkNew.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>

namespace npr
{
//------------------------------------------------------------------------------
void StyleOptions::AddTo(CLI::App& command)
{
  command
    .add_option("--style", this->Style, "A style's name (npr styles) or the path of a style file")
    ->capture_default_str();
  command
    .add_option("--lines", this->Lines,
      "The kinds of lines to draw, such as contours,suggestive; none for no lines "
      "(npr lines --list)")
    ->check(CheckLines, "");
  command
    .add_option("--outline", this->Outline,
      "A cheap outline without lines, in place of the style's: none, back-faces (an even rim), "
      "grazing (dark where surfaces are seen edge-on), image-edges (edges of the picture); most "
      "often with --lines none")
    ->check(CLI::IsMember(vtkNPRIllustrationStyle::GetOutlineNames()));
  this->AddSettingsTo(command);
  command.add_option("--background", this->Background,
    "The paper: #rrggbb, an HTML colour name, or transparent (not in .jpg, .bmp and .ppm)");
}

//------------------------------------------------------------------------------
void StyleOptions::AddSettingsTo(CLI::App& command)
{
  command
    .add_option("--set", this->Settings,
      "Set KIND.PARAMETER=VALUE of the lines: a text, or numbers parted by commas; such as "
      "isophotes.levels=5 topographic.direction=0,1,0 (may be given several times)")
    ->allow_extra_args(false);
  command
    .add_option("--define", this->Definitions,
      "Lines of your own: NAME FIELD TEST. They run where FIELD is 0 and TEST holds (\"\" for "
      "everywhere); such as --define mine kr \"dwkr > 2 and ndotv > 0\" (may be given several "
      "times)")
    ->type_name("NAME FIELD TEST");
  command
    .add_option("--constant", this->Constants,
      "NAME=VALUE: a number for the formulas of --define (may be given several times)")
    ->allow_extra_args(false);
}

//------------------------------------------------------------------------------
std::vector<std::string> StyleOptions::Define() const
{
  std::string constants;
  for (const std::string& constant : this->Constants)
  {
    constants += (constants.empty() ? "" : ", ") + constant;
  }
  if (this->Definitions.empty() && !constants.empty())
  {
    throw CommandError(UsageError, "--constant is for --define, which is missing");
  }
  std::vector<std::string> names;
  for (const auto& [name, field, test] : this->Definitions)
  {
    vtkNew<vtkNPRExpressionLines> lines;
    lines->SetName(name);
    lines->SetField(field);
    lines->SetTest(test);
    lines->SetConstants(constants);
    if (std::find(names.begin(), names.end(), name) != names.end())
    {
      throw CommandError(
        UsageError, "--define " + name + ": it is defined twice; give each its own name");
    }
    const std::string problem = lines->FindProblem();
    if (!problem.empty())
    {
      throw CommandError(UsageError, "--define " + name + ": " + problem);
    }
    if (!vtkNPRLineDefinition::AddKind(lines))
    {
      throw CommandError(
        UsageError, "--define " + name + ": this is the name of a built-in kind of line");
    }
    names.push_back(name);
  }
  return names;
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
  const std::vector<std::string> defined = this->Define();
  if (this->Lines.empty())
  {
    check(style->AddLines(defined), UsageError);
  }
  else
  {
    std::vector<std::string> lines;
    if (this->Lines != "none")
    {
      lines = SplitList(this->Lines);
      // What is defined is wanted, also where --lines does not say so.
      for (const std::string& name : defined)
      {
        if (std::find(lines.begin(), lines.end(), name) == lines.end())
        {
          lines.push_back(name);
        }
      }
    }
    check(style->SelectLines(lines), UsageError);
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
  if (!this->Outline.empty())
  {
    const std::vector<std::string> names = vtkNPRIllustrationStyle::GetOutlineNames();
    style->SetOutline(
      static_cast<int>(std::find(names.begin(), names.end(), this->Outline) - names.begin()));
  }
  if (!this->Background.empty() && !this->IsTransparent())
  {
    check(style->SetBackground(this->Background), UsageError);
  }
}

//------------------------------------------------------------------------------
void PointHeightsUp(vtkNPRIllustrationStyle* style, const std::array<double, 3>& up)
{
  if (style->UsesLineDefault("topographic", "direction"))
  {
    char direction[128];
    std::snprintf(direction, sizeof(direction), "%.17g,%.17g,%.17g", up[0], up[1], up[2]);
    style->SetLineParameter("topographic", "direction", direction);
  }
}
}
