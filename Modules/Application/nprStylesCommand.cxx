// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCommands.h"

#include "nprReporter.h"
#include "vtkNPRIllustrationStyle.h"

#include <vtkNew.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace npr
{
namespace
{
void ListStyles()
{
  vtkNew<vtkNPRIllustrationStyle> style;
  for (const std::string& name : vtkNPRIllustrationStyle::GetBuiltInNames())
  {
    style->LoadBuiltIn(name);
    std::printf("%-12s %s\n", name.c_str(), style->GetDescription().c_str());
  }
}

void ShowStyle(const std::string& name, Reporter& reporter)
{
  vtkNew<vtkNPRIllustrationStyle> style;
  const bool good = style->LoadBuiltIn(name);
  reporter.DropVTKErrors();
  if (!good)
  {
    throw CommandError(InputError, style->GetErrorMessage());
  }
  std::fputs(vtkNPRIllustrationStyle::GetBuiltInJson(name).c_str(), stdout);
}
}

//------------------------------------------------------------------------------
void AddStylesCommand(CLI::App& program, Reporter& reporter)
{
  CLI::App* command = program.add_subcommand("styles", "List the built-in styles");
  auto name = std::make_shared<std::string>();
  command->add_option("--show", *name, "Print this style's file, to start one of your own from");
  command->footer("Example: a style of your own\n"
                  "  npr styles --show ink > mine.json\n"
                  "  npr render scan.ply -o scan.png --style ./mine.json");
  command->callback(
    [name, &reporter]()
    {
      if (name->empty())
      {
        ListStyles();
      }
      else
      {
        ShowStyle(*name, reporter);
      }
    });
}
}
