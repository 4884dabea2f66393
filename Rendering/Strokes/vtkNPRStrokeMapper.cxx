// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRStrokeMapper.h"

#include "nprStrokeBuffer.h"
#include "nprStrokeLayer.h"
#include "vtkNPRStrokeCompositeFS.h"
#include "vtkNPRStrokeFS.h"
#include "vtkNPRStrokeVS.h"

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkBoundingBox.h>
#include <vtkCommand.h>
#include <vtkHardwareSelector.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLError.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkOpenGLVertexArrayObject.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <vtkTimeStamp.h>
#include <vtkTimerLog.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace
{
/// How VTK's translucent pass, if any, wants its colours.
enum class Translucency
{
  Blended,
  OrderIndependent,
  Peeled
};

Translucency GetTranslucency(vtkActor* actor)
{
  vtkInformation* keys = actor->GetPropertyKeys();
  const int passes = keys && keys->Has(vtkOpenGLRenderPass::RenderPasses())
    ? keys->Length(vtkOpenGLRenderPass::RenderPasses())
    : 0;
  for (int i = 0; i < passes; ++i)
  {
    vtkObjectBase* pass = keys->Get(vtkOpenGLRenderPass::RenderPasses(), i);
    if (pass->IsA("vtkOrderIndependentTranslucentPass"))
    {
      return Translucency::OrderIndependent;
    }
    if (pass->IsA("vtkDepthPeelingPass") || pass->IsA("vtkDualDepthPeelingPass"))
    {
      return Translucency::Peeled;
    }
  }
  return Translucency::Blended;
}
}

class vtkNPRStrokeMapper::Graphics
{
public:
  Graphics() = default;
  ~Graphics() { this->Release(); }

  /// Everything below belongs to one window; what was made for another is given back to it. A
  /// window that dies says so while its context still lives.
  void SetWindow(vtkOpenGLRenderWindow* window)
  {
    if (this->Window == window)
    {
      return;
    }
    this->Release();
    this->Window = window;
    this->WindowObserver = window->AddObserver(vtkCommand::DeleteEvent, this, &Graphics::Release);
  }

  void Release()
  {
    if (!this->Window)
    {
      return;
    }
    this->Window->PushContext();
    this->Composite.reset();
    this->Layer.ReleaseGraphicsResources(this->Window);
    this->VertexArray->ReleaseGraphicsResources();
    this->Buffer->ReleaseGraphicsResources();
    this->BufferTexture->ReleaseGraphicsResources(this->Window);
    this->NumberOfSegments = 0;
    this->UploadTime = vtkTimeStamp();
    this->Window->PopContext();
    this->Window->RemoveObserver(this->WindowObserver);
    this->Window = nullptr;
  }

  void Upload(vtkPolyData* input)
  {
    if (this->UploadTime > input->GetMTime() && this->UploadedInput == input)
    {
      return;
    }
    npr::StrokeRecords records = npr::MakeStrokeRecords(input);
    this->Origin = records.Origin;
    this->MaximumWidth = records.MaximumWidth;
    this->NumberOfSegments = std::max<std::ptrdiff_t>(records.Records.size(), 1) - 1;
    if (this->NumberOfSegments > 0)
    {
      const std::size_t size = records.Records.size() * (sizeof(npr::StrokeRecord) / sizeof(float));
      this->Buffer->Upload(records.Records[0].Position, size, vtkOpenGLBufferObject::TextureBuffer);
      this->BufferTexture->SetContext(this->Window);
      this->BufferTexture->CreateTextureBuffer(
        static_cast<unsigned int>(size / 4), 4, VTK_FLOAT, this->Buffer);
    }
    this->UploadedInput = input;
    this->UploadTime.Modified();
  }

  vtkOpenGLRenderWindow* Window = nullptr;
  unsigned long WindowObserver = 0;
  npr::StrokeLayer Layer;
  std::unique_ptr<vtkOpenGLQuadHelper> Composite;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkNew<vtkTextureObject> BufferTexture;

  std::ptrdiff_t NumberOfSegments = 0;
  std::array<double, 3> Origin = { 0, 0, 0 };
  float MaximumWidth = 1;
  vtkTimeStamp UploadTime;
  vtkWeakPointer<vtkPolyData> UploadedInput;
};

vtkStandardNewMacro(vtkNPRStrokeMapper);

vtkNPRStrokeMapper::vtkNPRStrokeMapper() : Resources(new Graphics) {}

vtkNPRStrokeMapper::~vtkNPRStrokeMapper() = default;

void vtkNPRStrokeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Resources->Window == window)
  {
    this->Resources->Release();
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkNPRStrokeMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (renderer->GetSelector())
  {
    return;
  }
  if (!window || !vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera()))
  {
    vtkErrorMacro("Strokes are drawn by OpenGL, but the render window is not a "
                  "vtkOpenGLRenderWindow. Link and initialise VTK::RenderingOpenGL2.");
    return;
  }
  const Translucency translucency = GetTranslucency(actor);
  if (translucency == Translucency::Peeled)
  {
    vtkWarningMacro("Strokes can not be drawn with depth peeling. Call "
                    "vtkRenderer::SetUseDepthPeeling(false).");
    return;
  }

  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  vtkPolyData* input = this->GetInput();
  if (!input || this->Width <= 0.0 || actor->GetProperty()->GetOpacity() <= 0.0)
  {
    return;
  }
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();

  Graphics& graphics = *this->Resources;
  graphics.SetWindow(window);
  graphics.Upload(input);
  if (graphics.NumberOfSegments == 0)
  {
    return;
  }
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vtkNPRStrokeVS, vtkNPRStrokeFS, "");
  if (!program)
  {
    vtkErrorMacro("The stroke shaders did not compile; OpenGL 3.2 or later is needed.");
    return;
  }

  vtkOpenGLClearErrorMacro();
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglDepthMask savedDepthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate savedBlendFunc(state);
  vtkOpenGLState::ScopedglEnableDisable savedDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedBlend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable savedCull(state, GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  this->DrawInk(renderer, actor, program);
  this->LayInkOver(window, actor, translucency == Translucency::OrderIndependent);
  vtkOpenGLCheckErrorMacro("failed after drawing strokes");

  timer->StopTimer();
  this->TimeToDraw = std::max(timer->GetElapsedTime(), 1e-4); // zero would mean: not drawn
  this->UpdateProgress(1.0);
}

void vtkNPRStrokeMapper::DrawInk(vtkRenderer* renderer, vtkActor* actor, vtkShaderProgram* program)
{
  Graphics& graphics = *this->Resources;
  vtkOpenGLState* state = graphics.Window->GetState();
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  state->PushFramebufferBindings();
  {
    vtkOpenGLState::ScopedglViewport savedViewport(state);
    vtkOpenGLState::ScopedglColorMask savedColorMask(state);
    vtkOpenGLState::ScopedglEnableDisable savedScissor(state, GL_SCISSOR_TEST);
    vtkOpenGLState::ScopedglEnableDisable savedStencil(state, GL_STENCIL_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_STENCIL_TEST);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const bool depthTest =
      this->DepthTest && graphics.Layer.CaptureDepth(graphics.Window, viewport);
    state->vtkglViewport(0, 0, viewport[2], viewport[3]);
    graphics.Layer.BindInk(graphics.Window, viewport[2], viewport[3]);
    int equations[2];
    state->vtkglGetIntegerv(GL_BLEND_EQUATION_RGB, &equations[0]);
    state->vtkglGetIntegerv(GL_BLEND_EQUATION_ALPHA, &equations[1]);
    state->vtkglBlendEquation(GL_MAX);
    state->vtkglBlendFunc(GL_ONE, GL_ONE);

    this->SetUniforms(renderer, actor, program, viewport);
    graphics.BufferTexture->Activate();
    const int recordsUnit = graphics.BufferTexture->GetTextureUnit();
    program->SetUniformi("nprRecords", recordsUnit);
    program->SetUniformi("nprDepthTest", depthTest);
    if (depthTest)
    {
      graphics.Layer.GetDepth()->Activate();
    }
    // Samplers of two kinds must not share a unit, even where one is not used.
    program->SetUniformi(
      "nprDepthTexture", depthTest ? graphics.Layer.GetDepth()->GetTextureUnit() : recordsUnit + 1);
    graphics.VertexArray->Bind(); // OpenGL wants one, even without attributes
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * graphics.NumberOfSegments));
    graphics.VertexArray->Release();
    graphics.BufferTexture->Deactivate();
    if (depthTest)
    {
      graphics.Layer.GetDepth()->Deactivate();
    }
    state->vtkglBlendEquationSeparate(equations[0], equations[1]);
  }
  state->PopFramebufferBindings();
}

void vtkNPRStrokeMapper::SetUniforms(
  vtkRenderer* renderer, vtkActor* actor, vtkShaderProgram* program, const int viewport[4])
{
  const Graphics& graphics = *this->Resources;
  vtkMatrix4x4* worldToView;
  vtkMatrix3x3* normals;
  vtkMatrix4x4* projection; // transposed, as all that VTK hands to shaders
  vtkMatrix4x4* worldToDevice;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, worldToView, normals, projection, worldToDevice);
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 3; ++i)
  {
    matrix->SetElement(i, 3, graphics.Origin[i]);
  }
  vtkMatrix4x4::Multiply4x4(actor->GetMatrix(), matrix, matrix);
  matrix->Transpose();
  vtkMatrix4x4::Multiply4x4(matrix, worldToDevice, matrix);
  program->SetUniformMatrix("nprMCDCMatrix", matrix);

  this->SetClippingUniforms(actor, program);

  const float size[2] = { static_cast<float>(viewport[2]), static_cast<float>(viewport[3]) };
  program->SetUniform2f("nprViewportSize", size);
  program->SetUniformf("nprWidth", static_cast<float>(this->Width));
  program->SetUniformi("nprUseWidths", this->UseWidthArray);
  program->SetUniformf("nprMinimumWidthFactor",
    this->StrengthToWidth ? static_cast<float>(this->MinimumWidthFactor) : 1.0f);
  program->SetUniformf("nprMinimumOpacityFactor", this->StrengthToOpacity ? 0.0f : 1.0f);
  const double widest = this->Width * (this->UseWidthArray ? graphics.MaximumWidth : 1.0f);
  program->SetUniformf("nprGuard", static_cast<float>(0.5 * widest + 2.0));

  const float depthProjection[4] = { static_cast<float>(projection->GetElement(2, 2)),
    static_cast<float>(projection->GetElement(3, 2)),
    static_cast<float>(projection->GetElement(2, 3)),
    static_cast<float>(projection->GetElement(3, 3)) };
  program->SetUniform4f("nprDepthProjection", depthProjection);
  program->SetUniformf(
    "nprPixelScale", static_cast<float>(2.0 / (projection->GetElement(1, 1) * viewport[3])));
  const vtkBoundingBox box(actor->GetBounds());
  program->SetUniformf("nprTolerance", static_cast<float>(this->DepthTolerance));
  program->SetUniformf(
    "nprModelSize", static_cast<float>(box.IsValid() ? box.GetDiagonalLength() : 0.0));
  program->SetUniformf("nprVisibilityRadius", static_cast<float>(this->VisibilityRadius));
  program->SetUniformf("nprHiddenOpacity", static_cast<float>(this->HiddenOpacity));
}

void vtkNPRStrokeMapper::SetClippingUniforms(vtkActor* actor, vtkShaderProgram* program)
{
  constexpr int maximum = 6; // as many as VTK's own mappers
  const std::array<double, 3>& origin = this->Resources->Origin;
  const int wanted = this->ClippingPlanes ? this->ClippingPlanes->GetNumberOfItems() : 0;
  if (wanted > maximum)
  {
    vtkErrorMacro("There are " << wanted << " clipping planes; the first " << maximum
                               << " are used. Remove the others.");
  }
  const int count = std::min(wanted, maximum);
  float planes[maximum][4] = {};
  for (int i = 0; i < count; ++i)
  {
    double plane[4];
    this->GetClippingPlaneInDataCoords(actor->GetMatrix(), i, plane);
    plane[3] += vtkMath::Dot(plane, origin.data());
    std::copy_n(plane, 4, planes[i]);
  }
  program->SetUniformi("nprNumberOfClippingPlanes", count);
  program->SetUniform4fv("nprClippingPlanes", maximum, planes);
}

void vtkNPRStrokeMapper::LayInkOver(
  vtkOpenGLRenderWindow* window, vtkActor* actor, bool orderIndependent)
{
  Graphics& graphics = *this->Resources;
  if (!graphics.Composite)
  {
    graphics.Composite.reset(new vtkOpenGLQuadHelper(window, nullptr, vtkNPRStrokeCompositeFS, ""));
  }
  else if (graphics.Composite->Program)
  {
    window->GetShaderCache()->ReadyShaderProgram(graphics.Composite->Program);
  }
  vtkShaderProgram* composite = graphics.Composite->Program;
  if (!composite)
  {
    vtkErrorMacro("The shader that lays strokes over the picture did not compile; OpenGL 3.2 or "
                  "later is needed.");
    return;
  }
  vtkOpenGLState* state = window->GetState();
  if (orderIndependent)
  {
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
  }
  else
  {
    state->vtkglBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  graphics.Layer.GetInk()->Activate();
  composite->SetUniformi("nprInkTexture", graphics.Layer.GetInk()->GetTextureUnit());
  composite->SetUniform3f("nprColor", actor->GetProperty()->GetColor());
  composite->SetUniformf("nprOpacity", static_cast<float>(actor->GetProperty()->GetOpacity()));
  composite->SetUniformi("nprOrderIndependent", orderIndependent);
  graphics.Composite->Render();
  graphics.Layer.GetInk()->Deactivate();
}

void vtkNPRStrokeMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (vtkNPRStrokeMapper* other = vtkNPRStrokeMapper::SafeDownCast(mapper))
  {
    this->SetWidth(other->GetWidth());
    this->SetUseWidthArray(other->GetUseWidthArray());
    this->SetStrengthToWidth(other->GetStrengthToWidth());
    this->SetMinimumWidthFactor(other->GetMinimumWidthFactor());
    this->SetStrengthToOpacity(other->GetStrengthToOpacity());
    this->SetDepthTest(other->GetDepthTest());
    this->SetDepthTolerance(other->GetDepthTolerance());
    this->SetVisibilityRadius(other->GetVisibilityRadius());
    this->SetHiddenOpacity(other->GetHiddenOpacity());
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkNPRStrokeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "UseWidthArray: " << this->UseWidthArray << "\n";
  os << indent << "StrengthToWidth: " << this->StrengthToWidth << "\n";
  os << indent << "MinimumWidthFactor: " << this->MinimumWidthFactor << "\n";
  os << indent << "StrengthToOpacity: " << this->StrengthToOpacity << "\n";
  os << indent << "DepthTest: " << this->DepthTest << "\n";
  os << indent << "DepthTolerance: " << this->DepthTolerance << "\n";
  os << indent << "VisibilityRadius: " << this->VisibilityRadius << "\n";
  os << indent << "HiddenOpacity: " << this->HiddenOpacity << "\n";
}
