// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file npr.cxx
 * @brief The command npr: reads the words, runs the verb, and turns failures into one line.
 */
#include "nprCommands.h"
#include "nprReporter.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <string>

int main(int argc, char* argv[])
{
  npr::Reporter reporter;
  CLI::App program("npr draws 3-D models as illustrations. It needs no display and no GPU.", "npr");
  program.set_version_flag("--version", "npr " NPR_VERSION);
  program.require_subcommand(1);
  program.footer("Examples:\n"
                 "  npr render scan.ply -o scan.png\n"
                 "  npr render part.stl -o part.png --style ink --view front\n"
                 "  npr render head.nii.gz --iso 60 -o head.png --style technical\n"
                 "  npr lines scan.ply -o lines.vtp --lines contours,suggestive\n"
                 "  npr sheet scan.ply -o sheet.png\n"
                 "  npr curvature scan.ply -o scan.vtp\n"
                 "\n"
                 "Exit codes: 0 done, 1 wrong words, 2 a model or style that can not be used,\n"
                 "3 a file that can not be written, 4 drawing failed, 5 anything else.");

  npr::AddRenderCommand(program, reporter);
  npr::AddDemoCommand(program, reporter);
  npr::AddLinesCommand(program, reporter);
  npr::AddSheetCommand(program, reporter);
  npr::AddCurvatureCommand(program, reporter);
  npr::AddStylesCommand(program, reporter);
  npr::AddInfoCommand(program, reporter);
  npr::AddDoctorCommand(program, reporter);
  for (CLI::App* command : program.get_subcommands({}))
  {
    command->add_flag("--quiet", reporter.Quiet, "Print nothing but errors");
    command->add_flag("--verbose", reporter.Verbose, "Print what is done and how long it takes");
  }

  reporter.CaptureVTKMessages();
  try
  {
    program.parse(argc, argv);
  }
  catch (const CLI::Success& request) // --help and --version
  {
    return program.exit(request);
  }
  catch (const CLI::ParseError& error)
  {
    const auto commands = program.get_subcommands();
    const std::string verb = commands.empty() ? "" : commands.front()->get_name() + " ";
    const std::string what =
      verb.empty() && argc > 1 ? std::string(argv[1]) + " is not a subcommand" : error.what();
    std::fprintf(stderr, "npr: %s (see npr %s--help)\n", what.c_str(), verb.c_str());
    return npr::UsageError;
  }
  catch (const npr::CommandError& error)
  {
    reporter.ClearProgress();
    std::fprintf(stderr, "npr: %s\n", error.what());
    return error.Code;
  }
  catch (const std::bad_alloc&)
  {
    reporter.ClearProgress();
    std::fprintf(stderr,
      "npr: not enough memory for this model and image size; try a smaller --size "
      "or a coarser model\n");
    return npr::InputError;
  }
  catch (const std::exception& error)
  {
    reporter.ClearProgress();
    std::fprintf(stderr, "npr: something unforeseen went wrong: %s\n", error.what());
    return npr::OtherError;
  }
  return npr::Success;
}
