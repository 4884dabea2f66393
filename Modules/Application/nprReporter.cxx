// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprReporter.h"

#include <vtkCallbackCommand.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <utility>

namespace npr
{
namespace
{
/// Keeps VTK's messages, each folded to one line without the file, line and address before it.
/// They may come from the threads of vtkSMPTools.
class MessageCollector : public vtkOutputWindow
{
public:
  static MessageCollector* New();
  vtkTypeMacro(MessageCollector, vtkOutputWindow);

  void DisplayErrorText(const char* text) override { this->Add(this->Errors, text); }
  void DisplayWarningText(const char* text) override { this->Add(this->Warnings, text); }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}

  /// All since the last call.
  std::vector<std::string> TakeErrors() { return this->Take(this->Errors); }
  std::vector<std::string> TakeWarnings() { return this->Take(this->Warnings); }

private:
  void Add(std::vector<std::string>& messages, const char* text)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    messages.push_back(Fold(text));
  }
  std::vector<std::string> Take(std::vector<std::string>& messages)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return std::exchange(messages, {});
  }
  static std::string Fold(const char* text)
  {
    std::string message = text ? text : "";
    if (const std::size_t address = message.find("): "); address != std::string::npos)
    {
      message.erase(0, address + 3);
    }
    std::replace(message.begin(), message.end(), '\n', ' ');
    message.erase(message.find_last_not_of(' ') + 1);
    return message;
  }

  std::mutex Mutex;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};
vtkStandardNewMacro(MessageCollector);

MessageCollector* GetCollector()
{
  return MessageCollector::SafeDownCast(vtkOutputWindow::GetInstance());
}

struct Watched
{
  Reporter* Self;
  std::string What;
};

void OnProgress(vtkObject*, unsigned long, void* clientData, void* callData)
{
  const Watched* watched = static_cast<Watched*>(clientData);
  if (callData)
  {
    watched->Self->ShowProgress(watched->What, *static_cast<double*>(callData));
  }
}
}

//------------------------------------------------------------------------------
void Reporter::CaptureVTKMessages()
{
  // VTK also logs each message to stderr.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<MessageCollector> collector;
  vtkOutputWindow::SetInstance(collector);
}

//------------------------------------------------------------------------------
void Reporter::ThrowOnVTKError(ExitCode code)
{
  MessageCollector* collector = GetCollector();
  for (const std::string& warning : collector->TakeWarnings())
  {
    this->Note("warning: " + warning);
  }
  const std::vector<std::string> errors = collector->TakeErrors();
  if (!errors.empty())
  {
    throw CommandError(code, errors.front());
  }
}

//------------------------------------------------------------------------------
void Reporter::DropVTKErrors()
{
  GetCollector()->TakeErrors();
}

//------------------------------------------------------------------------------
void Reporter::Watch(vtkObject* object, const std::string& what)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnProgress);
  command->SetClientData(new Watched{ this, what });
  command->SetClientDataDeleteCallback([](void* data) { delete static_cast<Watched*>(data); });
  object->AddObserver(vtkCommand::ProgressEvent, command);
}

//------------------------------------------------------------------------------
void Reporter::ShowProgress(const std::string& what, double fraction)
{
  static const bool isTerminal = isatty(STDERR_FILENO) != 0;
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (this->Quiet || !isTerminal || percent == this->LastPercent)
  {
    return;
  }
  this->LastPercent = percent;
  this->LineIsDirty = true;
  std::fprintf(stderr, "\r\033[K%s %3d %%", what.c_str(), percent);
  std::fflush(stderr);
}

//------------------------------------------------------------------------------
void Reporter::ClearProgress()
{
  if (this->LineIsDirty)
  {
    std::fputs("\r\033[K", stderr);
    this->LineIsDirty = false;
  }
}

//------------------------------------------------------------------------------
void Reporter::Note(const std::string& text)
{
  if (this->Verbose)
  {
    this->ClearProgress();
    std::fprintf(stderr, "npr: %s\n", text.c_str());
  }
}

//------------------------------------------------------------------------------
void Reporter::Warn(const std::string& text)
{
  if (!this->Quiet)
  {
    this->ClearProgress();
    std::fprintf(stderr, "npr: warning: %s\n", text.c_str());
  }
}

//------------------------------------------------------------------------------
void Reporter::BeginStage(const std::string& name)
{
  this->EndStage();
  this->CurrentStage = name;
  this->StageStart = Clock::now();
}

//------------------------------------------------------------------------------
void Reporter::AddStage(const std::string& name, double seconds)
{
  this->Stages.emplace_back(name, seconds);
}

//------------------------------------------------------------------------------
double Reporter::StopClock() const
{
  return std::chrono::duration<double>(Clock::now() - this->StageStart).count();
}

//------------------------------------------------------------------------------
void Reporter::EndStage()
{
  if (!this->CurrentStage.empty())
  {
    this->AddStage(this->CurrentStage, this->StopClock());
    this->CurrentStage.clear();
  }
}

//------------------------------------------------------------------------------
void Reporter::PrintStages()
{
  this->EndStage();
  this->ClearProgress();
  if (!this->Verbose)
  {
    return;
  }
  for (const auto& [name, seconds] : this->Stages)
  {
    std::fprintf(stderr, "npr: %-10s %7.2f s\n", name.c_str(), seconds);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::fprintf(stderr, "npr: %-10s %7.2f s, peak memory %.0f MB\n", "in all",
    std::chrono::duration<double>(Clock::now() - this->Start).count(), usage.ru_maxrss / 1024.0);
}
}
