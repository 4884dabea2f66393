// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprReporter.h
 * @brief What the command says while it works, and how it fails: one line, and an exit code.
 */
#ifndef nprReporter_h
#define nprReporter_h

#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

class vtkObject;

namespace npr
{
/// Exit codes, as `npr --help` documents them.
enum ExitCode
{
  Success = 0,
  UsageError = 1,  ///< The words of the command are wrong.
  InputError = 2,  ///< A model or a style can not be used.
  OutputError = 3, ///< A file can not be written.
  RenderError = 4, ///< No window could be made, or drawing failed.
  OtherError = 5   ///< Something that nobody foresaw.
};

/// Ends the command with a message and an exit code.
struct CommandError : std::runtime_error
{
  CommandError(ExitCode code, const std::string& message) : std::runtime_error(message), Code(code)
  {
  }
  ExitCode Code;
};

/**
 * Progress goes to stderr when that is a terminal; stage times with --verbose. VTK's own messages
 * are collected instead of being printed: an error among them ends the command.
 */
class Reporter
{
public:
  bool Quiet = false;
  bool Verbose = false;

  /// Route VTK's messages here for the rest of the process.
  void CaptureVTKMessages();
  /// Throws the first VTK error that came since the last call, if any.
  void ThrowOnVTKError(ExitCode code);
  /// Forget errors that somebody reports in better words.
  void DropVTKErrors();

  /// Show the progress of whatever this object and what it drives do.
  void Watch(vtkObject* object, const std::string& what);
  void ShowProgress(const std::string& what, double fraction);
  void ClearProgress();

  void Note(const std::string& text); ///< A line for --verbose.
  void Warn(const std::string& text); ///< A line unless --quiet.

  /// Start a stage of the work; its time ends with the next one or with PrintStages().
  void BeginStage(const std::string& name);
  void AddStage(const std::string& name, double seconds);
  void EndStage();
  /// @name For times that are shared out among stages
  ///@{
  void StartClock() { this->StageStart = Clock::now(); }
  double StopClock() const;
  ///@}
  void PrintStages(); ///< With --verbose: one line a stage and the peak memory.

private:
  using Clock = std::chrono::steady_clock;
  std::vector<std::pair<std::string, double>> Stages;
  std::string CurrentStage;
  Clock::time_point StageStart;
  Clock::time_point Start = Clock::now();
  int LastPercent = -1;
  bool LineIsDirty = false;
};
}

#endif
