// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprCommands.h
 * @brief The verbs of the command npr. Each adds itself, with its options and help, to the program.
 */
#ifndef nprCommands_h
#define nprCommands_h

namespace CLI
{
class App;
}

namespace npr
{
class Reporter;

void AddRenderCommand(CLI::App& program, Reporter& reporter);
void AddDemoCommand(CLI::App& program, Reporter& reporter);
void AddLinesCommand(CLI::App& program, Reporter& reporter);
void AddSheetCommand(CLI::App& program, Reporter& reporter);
void AddCurvatureCommand(CLI::App& program, Reporter& reporter);
void AddStylesCommand(CLI::App& program, Reporter& reporter);
void AddInfoCommand(CLI::App& program, Reporter& reporter);
void AddDoctorCommand(CLI::App& program, Reporter& reporter);
}

#endif
