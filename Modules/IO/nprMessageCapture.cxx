// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprMessageCapture.h"

#include "nprFileFormats.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

#include <iostream>
#include <mutex>
#include <regex>

namespace npr
{
namespace
{
// Readers that work in several threads complain from each of them.
class CapturingWindow : public vtkOutputWindow
{
public:
  static CapturingWindow* New();
  vtkTypeMacro(CapturingWindow, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->Add(this->Errors, text); }
  void DisplayWarningText(const char* text) override { this->Add(this->Warnings, text); }
  void DisplayGenericWarningText(const char* text) override { this->Add(this->Warnings, text); }

  std::vector<std::string> GetErrors() { return this->Copy(this->Errors); }
  std::vector<std::string> GetWarnings() { return this->Copy(this->Warnings); }

private:
  void Add(std::vector<std::string>& texts, const char* text)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    texts.emplace_back(text ? text : "");
  }
  std::vector<std::string> Copy(const std::vector<std::string>& texts)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return texts;
  }

  std::mutex Mutex;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};
vtkStandardNewMacro(CapturingWindow);

// "ERROR: In f.cxx, line 12\nvtkReader (0x55d): Text\n\n" becomes "Text".
std::string OneLine(std::string text)
{
  static const std::regex heading("^\\s*(ERROR|Warning|Generic Warning): In [^\n]*\n");
  static const std::regex object("^\\s*vtk\\w+ \\([^)]*\\): ");
  static const std::regex space("\\s+");
  text = std::regex_replace(text, heading, "");
  text = std::regex_replace(text, object, "");
  text = std::regex_replace(text, space, " ");
  const auto first = text.find_first_not_of(' ');
  const auto last = text.find_last_not_of(" .");
  text = first == std::string::npos ? "" : text.substr(first, last - first + 1);
  const std::size_t longest = 200;
  return Printable(text.size() > longest ? text.substr(0, longest) + "..." : text);
}

std::vector<std::string> OneLineEach(const std::vector<std::string>& texts)
{
  std::vector<std::string> lines;
  for (const std::string& text : texts)
  {
    std::string line = OneLine(text);
    if (!line.empty())
    {
      lines.push_back(std::move(line));
    }
  }
  return lines;
}
}

MessageCapture::MessageCapture()
  : Previous(vtkOutputWindow::GetInstance()), Window(vtkSmartPointer<CapturingWindow>::New()),
    PreviousErrorBuffer(std::cerr.rdbuf(this->ErrorStream.rdbuf())),
    PreviousVerbosity(vtkLogger::GetCurrentVerbosityCutoff())
{
  vtkOutputWindow::SetInstance(this->Window);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

MessageCapture::~MessageCapture()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::ConvertToVerbosity(this->PreviousVerbosity));
  vtkOutputWindow::SetInstance(this->Previous);
  std::cerr.rdbuf(this->PreviousErrorBuffer);
}

std::vector<std::string> MessageCapture::GetErrors() const
{
  return OneLineEach(static_cast<CapturingWindow*>(this->Window.Get())->GetErrors());
}

std::vector<std::string> MessageCapture::GetWarnings() const
{
  return OneLineEach(static_cast<CapturingWindow*>(this->Window.Get())->GetWarnings());
}

std::string MessageCapture::GetConsoleText() const
{
  return OneLine(this->ErrorStream.str());
}
}
