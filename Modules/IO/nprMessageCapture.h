// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprMessageCapture_h
#define nprMessageCapture_h

#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

namespace npr
{
/**
 * @class MessageCapture
 * @brief While it lives, whatever VTK's readers have to complain about comes here instead of to the
 * console.
 *
 * Takes VTK's output window and its log on stderr, and std::cerr, which MetaIO writes to. All three
 * belong to the process, so reads in two threads at once share one another's messages.
 */
class MessageCapture
{
public:
  MessageCapture();
  ~MessageCapture();
  MessageCapture(const MessageCapture&) = delete;
  MessageCapture& operator=(const MessageCapture&) = delete;

  /// The errors so far, one line each, without VTK's file, line and object.
  std::vector<std::string> GetErrors() const;
  std::vector<std::string> GetWarnings() const;
  /// What was written to std::cerr, in one line; not always about an error.
  std::string GetConsoleText() const;

private:
  vtkSmartPointer<vtkOutputWindow> Previous;
  vtkSmartPointer<vtkOutputWindow> Window;
  std::ostringstream ErrorStream;
  std::streambuf* PreviousErrorBuffer;
  int PreviousVerbosity;
};
}

#endif
