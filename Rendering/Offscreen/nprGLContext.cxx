// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprGLContext.h"

namespace npr
{

GLDescription GLContext::Describe() const
{
  // The three names of glGetString and their values are fixed by OpenGL; no GL header is needed.
  using GetString = const unsigned char* (*)(unsigned int);
  const auto getString = reinterpret_cast<GetString>(this->GetProcAddress("glGetString"));
  const auto ask = [getString](unsigned int name)
  {
    const unsigned char* text = getString ? getString(name) : nullptr;
    return std::string(text ? reinterpret_cast<const char*>(text) : "");
  };
  return { ask(0x1F00), ask(0x1F01), ask(0x1F02) };
}

std::function<void()> CaptureCurrentContext()
{
  for (const auto capture : { CaptureOSMesa, CaptureEGL, CaptureGLX })
  {
    if (auto restore = capture())
    {
      return restore;
    }
  }
  return ReleaseCurrentContext;
}

void ReleaseCurrentContext()
{
  ReleaseOSMesa();
  ReleaseEGL();
  ReleaseGLX();
}

} // namespace npr
