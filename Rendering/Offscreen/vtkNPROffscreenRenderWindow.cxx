// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPROffscreenRenderWindow.h"

#include "nprGLContext.h"

#include <vtkOpenGLError.h> // brings the OpenGL entry points
#include <vtkOpenGLState.h>

#include <vector>

class vtkNPROffscreenRenderWindow::vtkInternals
{
public:
  std::shared_ptr<npr::GLContext> Context;
  bool Failed = false; // no context could be had: say it once, not at each call
  std::vector<std::function<void()>> Pushed;
};

//------------------------------------------------------------------------------
vtkNPROffscreenRenderWindow::vtkNPROffscreenRenderWindow()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetOwnContext(0);
  this->SetOffScreenRendering(1);
  this->SetReadyForRendering(true);
  this->SetMultiSamples(0);
  // There is no surface behind the context that a frame could be copied to.
  this->SetFrameBlitModeToNoBlit();
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
}

//------------------------------------------------------------------------------
vtkNPROffscreenRenderWindow::~vtkNPROffscreenRenderWindow()
{
  // The base class's destructor can not reach our context any more.
  this->vtkNPROffscreenRenderWindow::Finalize();
}

//------------------------------------------------------------------------------
void vtkNPROffscreenRenderWindow::Initialize()
{
  if (!this->Initialized)
  {
    this->OpenGLInit();
  }
}

//------------------------------------------------------------------------------
void vtkNPROffscreenRenderWindow::Finalize()
{
  if (!this->Internals->Context)
  {
    return;
  }
  // Whoever else is drawing in this thread goes on undisturbed.
  std::function<void()> restore;
  if (!this->IsCurrent())
  {
    restore = npr::CaptureCurrentContext();
    this->MakeCurrent();
  }
  this->ReleaseGraphicsResources(this);
  this->Internals->Context.reset();
  this->Initialized = false;
  if (restore)
  {
    restore();
  }
}

//------------------------------------------------------------------------------
void vtkNPROffscreenRenderWindow::MakeCurrent()
{
  vtkInternals& internals = *this->Internals;
  if (internals.Failed)
  {
    return;
  }
  std::string reason = "the driver refused to make the context current";
  if (!internals.Context)
  {
    internals.Context = this->NewContext(reason);
  }
  if (!internals.Context || (!this->IsCurrent() && !internals.Context->MakeCurrent()))
  {
    internals.Failed = true;
    vtkErrorMacro("No OpenGL context: " << reason
                                        << ". This window stays empty; choose another backend "
                                           "with vtkNPROffscreen::Setup or NPR_OFFSCREEN.");
  }
}

//------------------------------------------------------------------------------
bool vtkNPROffscreenRenderWindow::IsCurrent()
{
  return this->Internals->Context && this->Internals->Context->IsCurrent();
}

//------------------------------------------------------------------------------
void vtkNPROffscreenRenderWindow::PushContext()
{
  // VTK frees textures and buffers between Push and Pop, often while another window draws.
  this->Internals->Pushed.push_back(
    this->IsCurrent() ? std::function<void()>() : npr::CaptureCurrentContext());
  this->MakeCurrent();
}

//------------------------------------------------------------------------------
void vtkNPROffscreenRenderWindow::PopContext()
{
  if (this->Internals->Pushed.empty())
  {
    return;
  }
  const std::function<void()> restore = std::move(this->Internals->Pushed.back());
  this->Internals->Pushed.pop_back();
  if (restore)
  {
    restore();
  }
}

//------------------------------------------------------------------------------
int vtkNPROffscreenRenderWindow::SupportsOpenGL()
{
  this->PushContext();
  this->Initialize();
  this->PopContext();
  this->OpenGLSupportTested = true;
  this->OpenGLSupportResult = this->Initialized ? 1 : 0;
  this->OpenGLSupportMessage = this->Initialized
    ? "OpenGL 3.2 or later is available without a display"
    : "The backend gives no context of OpenGL 3.2 or later";
  return this->OpenGLSupportResult;
}

//------------------------------------------------------------------------------
void vtkNPROffscreenRenderWindow::OpenGLInit()
{
  // The base class touches OpenGL's state before it loads OpenGL's functions.
  this->MakeCurrent();
  if (this->IsCurrent())
  {
    this->OpenGLInitContext();
    if (this->Initialized)
    {
      this->Superclass::OpenGLInit();
    }
  }
}

//------------------------------------------------------------------------------
void vtkNPROffscreenRenderWindow::OpenGLInitContext()
{
  if (this->Initialized)
  {
    return;
  }
  this->ContextCreationTime.Modified();
  // GLEW also looks for a GLX display and, finding none, returns an error; by then it has loaded
  // every entry point of OpenGL, through libglvnd, for whichever context is current.
  glewExperimental = GL_TRUE;
  const GLenum result = glewInit();
  constexpr GLenum NoGLXDisplay = 4; // GLEW_ERROR_NO_GLX_DISPLAY, which old GLEW lacks
  this->GlewInitValid = (result == GLEW_OK || result == NoGLXDisplay) && GLEW_VERSION_3_2 &&
    glGetString(GL_VERSION) != nullptr;
  if (!this->GlewInitValid)
  {
    vtkErrorMacro("GLEW found no OpenGL 3.2 in this context (code "
      << result << "). Choose another backend with vtkNPROffscreen::Setup or NPR_OFFSCREEN.");
    return;
  }
  this->Initialized = true;
  GLfloat range[2] = { 1.0f, 1.0f };
  glGetFloatv(
    this->LineSmoothing ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = range[1];
}

//------------------------------------------------------------------------------
void vtkNPROffscreenRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << (this->Internals->Context ? "created" : "none yet") << "\n";
}
