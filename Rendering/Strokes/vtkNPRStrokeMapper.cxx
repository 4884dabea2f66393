// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNPRStrokeMapper.h"

#include "nprInkArea.h"
#include "nprInteraction.h"
#include "nprPostponedStrokes.h"
#include "nprStrokeGraphics.h"
#include "vtkNPRStrokeCompositeFS.h"
#include "vtkNPRStrokeFS.h"
#include "vtkNPRStrokeHiding.h"
#include "vtkNPRStrokeStyledFS.h"
#include "vtkNPRStrokeStyledMainFS.h"
#include "vtkNPRStrokeVS.h"

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkHardwareSelector.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLError.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <vtkTimerLog.h>

#include <algorithm>
#include <string>

namespace
{
// How much farther off axes and edges may be while something moves, which takes as much less time;
// of strokes that are drawn as they were, nothing more is left out.
constexpr double InteractiveError = 3.0;

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

vtkStandardNewMacro(vtkNPRStrokeMapper);

vtkNPRStrokeMapper::vtkNPRStrokeMapper()
  : Graphics(new npr::StrokeGraphics), Postponed(new npr::PostponedStrokes)
{
  this->ScalarVisibility = 0;
}

vtkNPRStrokeMapper::~vtkNPRStrokeMapper() = default;

void vtkNPRStrokeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Graphics->GetWindow() == window)
  {
    this->Graphics->Release();
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkNPRStrokeMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector &&
    (selector->GetFieldAssociation() != vtkDataObject::FIELD_ASSOCIATION_CELLS ||
      npr::StrokePicking::IsDrawingDepth()))
  {
    return;
  }
  if (!window || !vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera()))
  {
    vtkErrorMacro("Strokes are drawn by OpenGL, but the render window is not a "
                  "vtkOpenGLRenderWindow. Link and initialise VTK::RenderingOpenGL2.");
    return;
  }
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  vtkPolyData* input = this->GetInput();
  if (!input || !input->GetPoints() || this->Width <= 0.0 ||
    actor->GetProperty()->GetOpacity() <= 0.0)
  {
    return;
  }
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();

  this->Graphics->SetWindow(window);
  this->MapScalars(1.0);
  const bool hasColors = this->Colors && this->Colors->GetNumberOfComponents() == 4;
  if (!this->Graphics->Upload(input, hasColors ? this->Colors : nullptr,
        hasColors && this->AreColorsOfCells(), this->GetTolerance(renderer, actor),
        this->GetCurves()))
  {
    vtkErrorMacro("The shader that evaluates splines did not compile; OpenGL 3.2 or later is "
                  "needed. Use vtkNPRSplineStrokes instead of SplineType.");
    return;
  }
  if (this->Graphics->GetNumberOfSegments() == 0)
  {
    return;
  }
  const Translucency translucency = GetTranslucency(actor);
  if (selector)
  {
    this->DrawForSelection(renderer, actor);
  }
  else if (translucency == Translucency::Peeled)
  {
    this->Postpone(renderer, actor);
  }
  else
  {
    this->DrawStrokes(renderer, actor, translucency == Translucency::OrderIndependent);
  }

  timer->StopTimer();
  this->TimeToDraw = std::max(timer->GetElapsedTime(), 1e-4); // zero would mean: not drawn
  this->UpdateProgress(1.0);
}

//------------------------------------------------------------------------------
npr::StrokeTolerance vtkNPRStrokeMapper::GetTolerance(vtkRenderer* renderer, vtkActor* actor)
{
  double pixels = this->GetMaximumError();
  if (this->SplineType == NONE && npr::IsInteractive(renderer->GetRenderWindow()))
  {
    pixels *= InteractiveError;
  }
  const double pixel = npr::FindSmallestPixel(
    renderer, actor->GetMatrix(), this->GetInput()->GetPoints()->GetBounds());
  const double width = this->WidthUnit == WORLD && pixel > 0.0 ? this->Width / pixel : this->Width;
  npr::StrokeTolerance tolerance;
  tolerance.Length = static_cast<float>(pixels * pixel);
  if (this->DashUnit == WORLD && this->IsStyled())
  {
    tolerance.ArcLength = 4.0f * tolerance.Length;
  }
  tolerance.Sight = npr::FindSight(renderer->GetActiveCamera(), actor->GetMatrix());
  if (this->DepthTest)
  {
    // They must still be known as lying on their surface.
    tolerance.Sight.Depth = static_cast<float>(0.25 * this->DepthTolerance / pixels);
  }
  const float factor = static_cast<float>(2.0 * pixels / width);
  constexpr float tone = 1.0f / 256.0f;
  if (this->UseWidthArray)
  {
    tolerance.Width = factor;
  }
  if (this->UseOpacityArray)
  {
    tolerance.Opacity = tone;
  }
  if (this->StrengthToWidth || this->StrengthToOpacity)
  {
    tolerance.Strength = this->StrengthToOpacity ? std::min(factor, tone) : factor;
  }
  return tolerance;
}

//------------------------------------------------------------------------------
void vtkNPRStrokeMapper::DrawStrokes(vtkRenderer* renderer, vtkActor* actor, bool orderIndependent)
{
  vtkShaderProgram* program = this->ReadyProgram("");
  if (!program)
  {
    return;
  }
  vtkOpenGLRenderWindow* window = this->Graphics->GetWindow();
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
  const npr::InkArea area = this->DrawInk(renderer, actor, program);
  if (!area.IsEmpty())
  {
    this->LayInkOver(actor, area, orderIndependent);
  }
  vtkOpenGLCheckErrorMacro("failed after drawing strokes");
}

bool vtkNPRStrokeMapper::AreColorsOfCells()
{
  int cellFlag = 0;
  vtkAbstractMapper::GetScalars(this->GetInput(), this->ScalarMode, this->ArrayAccessMode,
    this->ArrayId, this->ArrayName, cellFlag);
  return cellFlag == 1;
}

bool vtkNPRStrokeMapper::IsStyled() const
{
  return this->Cap != ROUND_CAP || this->Join != ROUND_JOIN || this->Medium != INK ||
    this->PaperGrain > 0.0 || this->Dashes[1] > 0.0 ||
    (this->HiddenDashes[1] > 0.0 && this->HiddenOpacity > 0.0);
}

vtkShaderProgram* vtkNPRStrokeMapper::ReadyProgram(const std::string& purpose)
{
  std::string vertex = vtkNPRStrokeVS;
  std::string fragment = vtkNPRStrokeFS;
  const bool styled = this->IsStyled();
  const std::string variant = purpose +
    std::string(styled ? "#define NPR_STYLED\n#define NPR_COSINE_OF_CORNER 0.95\n" : "") +
    (this->Graphics->HasColors() ? "#define NPR_COLORED\n" : "") +
    (this->DepthTest ? "" : "#define NPR_UNTESTED\n");
  for (std::string* shader : { &vertex, &fragment })
  {
    vtkShaderProgram::Substitute(*shader, "//NPR::Variant::Dec", variant);
    vtkShaderProgram::Substitute(*shader, "//NPR::Hiding::Dec", vtkNPRStrokeHiding);
  }
  vtkShaderProgram::Substitute(fragment, "//NPR::Styled::Dec", styled ? vtkNPRStrokeStyledFS : "");
  vtkShaderProgram::Substitute(
    fragment, "//NPR::Styled::Impl", styled ? vtkNPRStrokeStyledMainFS : "");
  vtkShaderProgram* program = this->Graphics->GetWindow()->GetShaderCache()->ReadyShaderProgram(
    vertex.c_str(), fragment.c_str(), "");
  if (!program)
  {
    vtkErrorMacro("The stroke shaders did not compile; OpenGL 3.2 or later is needed.");
  }
  return program;
}

npr::InkArea vtkNPRStrokeMapper::DrawInk(
  vtkRenderer* renderer, vtkActor* actor, vtkShaderProgram* program)
{
  npr::StrokeGraphics& graphics = *this->Graphics;
  vtkOpenGLState* state = graphics.GetWindow()->GetState();
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  npr::InkArea area = this->SetUniforms(renderer, actor, program, viewport);
  if (area.IsEmpty())
  {
    return area;
  }
  const npr::PixelRectangle& bounds = area.Bounds;
  state->PushFramebufferBindings();
  {
    vtkOpenGLState::ScopedglViewport savedViewport(state);
    vtkOpenGLState::ScopedglColorMask savedColorMask(state);
    vtkOpenGLState::ScopedglScissor savedScissor(state);
    vtkOpenGLState::ScopedglEnableDisable savedScissorTest(state, GL_SCISSOR_TEST);
    vtkOpenGLState::ScopedglEnableDisable savedStencil(state, GL_STENCIL_TEST);
    state->vtkglDisable(GL_STENCIL_TEST);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const bool depthTest =
      this->DepthTest && graphics.Layer.CaptureDepth(graphics.GetWindow(), viewport, bounds);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(bounds[0], bounds[1], bounds[2], bounds[3]);
    state->vtkglViewport(0, 0, viewport[2], viewport[3]);
    vtkOpenGLState::ScopedglDepthMask savedDepthMask(state);
    vtkOpenGLState::ScopedglDepthFunc savedDepthFunc(state);
    const bool colored = graphics.HasColors();
    graphics.Layer.BindInk(graphics.GetWindow(), viewport[2], viewport[3], colored);
    int equations[2];
    state->vtkglGetIntegerv(GL_BLEND_EQUATION_RGB, &equations[0]);
    state->vtkglGetIntegerv(GL_BLEND_EQUATION_ALPHA, &equations[1]);
    if (colored)
    {
      state->vtkglEnable(GL_DEPTH_TEST);
      state->vtkglDepthFunc(GL_LESS);
      state->vtkglBlendFunc(GL_ONE, GL_ZERO);
    }
    else
    {
      state->vtkglBlendEquation(GL_MAX);
      state->vtkglBlendFunc(GL_ONE, GL_ONE);
    }

    program->SetUniformi("nprDepthTest", depthTest);
    graphics.Draw(program, depthTest ? graphics.Layer.GetDepth() : nullptr, this->IsStyled());
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglBlendEquationSeparate(equations[0], equations[1]);
  }
  state->PopFramebufferBindings();
  return area;
}

void vtkNPRStrokeMapper::LayInkOver(
  vtkActor* actor, const npr::InkArea& area, bool orderIndependent)
{
  npr::StrokeGraphics& graphics = *this->Graphics;
  vtkOpenGLRenderWindow* window = graphics.GetWindow();
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
  composite->SetUniformi("nprColored", graphics.HasColors());
  composite->SetUniform3f("nprColor", actor->GetProperty()->GetColor());
  composite->SetUniformf("nprOpacity", static_cast<float>(actor->GetProperty()->GetOpacity()));
  composite->SetUniformi("nprOrderIndependent", orderIndependent);
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  vtkOpenGLState::ScopedglScissor savedScissor(state);
  vtkOpenGLState::ScopedglEnableDisable savedScissorTest(state, GL_SCISSOR_TEST);
  state->vtkglEnable(GL_SCISSOR_TEST);
  for (const npr::PixelRectangle& rectangle : area.Rectangles)
  {
    state->vtkglScissor(
      viewport[0] + rectangle[0], viewport[1] + rectangle[1], rectangle[2], rectangle[3]);
    graphics.Composite->Render();
  }
  graphics.Layer.GetInk()->Deactivate();
}

void vtkNPRStrokeMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (vtkNPRStrokeMapper* other = vtkNPRStrokeMapper::SafeDownCast(mapper))
  {
    this->SetWidth(other->GetWidth());
    this->SetWidthUnit(other->GetWidthUnit());
    this->SetUseWidthArray(other->GetUseWidthArray());
    this->SetStrengthToWidth(other->GetStrengthToWidth());
    this->SetMinimumWidthFactor(other->GetMinimumWidthFactor());
    this->SetStrengthToOpacity(other->GetStrengthToOpacity());
    this->SetUseOpacityArray(other->GetUseOpacityArray());
    this->SetCap(other->GetCap());
    this->SetJoin(other->GetJoin());
    this->SetMitreLimit(other->GetMitreLimit());
    this->SetDashes(other->GetDashes());
    this->SetHiddenDashes(other->GetHiddenDashes());
    this->SetDashUnit(other->GetDashUnit());
    this->SetMedium(other->GetMedium());
    this->SetPaperGrain(other->GetPaperGrain());
    this->SetGrainSize(other->GetGrainSize());
    this->SetSeed(other->GetSeed());
    this->SetUseHidingLayers(other->GetUseHidingLayers());
    this->SetDepthTest(other->GetDepthTest());
    this->SetDepthTolerance(other->GetDepthTolerance());
    this->SetVisibilityRadius(other->GetVisibilityRadius());
    this->SetHiddenOpacity(other->GetHiddenOpacity());
    this->SetSplineType(other->GetSplineType());
    this->SetSplineChordError(other->GetSplineChordError());
    this->SetSplineCornerAngle(other->GetSplineCornerAngle());
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkNPRStrokeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "WidthUnit: " << this->WidthUnit << "\n";
  os << indent << "UseWidthArray: " << this->UseWidthArray << "\n";
  os << indent << "StrengthToWidth: " << this->StrengthToWidth << "\n";
  os << indent << "MinimumWidthFactor: " << this->MinimumWidthFactor << "\n";
  os << indent << "StrengthToOpacity: " << this->StrengthToOpacity << "\n";
  os << indent << "UseOpacityArray: " << this->UseOpacityArray << "\n";
  os << indent << "Cap: " << this->Cap << "\n";
  os << indent << "Join: " << this->Join << "\n";
  os << indent << "MitreLimit: " << this->MitreLimit << "\n";
  os << indent << "Dashes: " << this->Dashes[0] << " " << this->Dashes[1] << "\n";
  os << indent << "HiddenDashes: " << this->HiddenDashes[0] << " " << this->HiddenDashes[1] << "\n";
  os << indent << "DashUnit: " << this->DashUnit << "\n";
  os << indent << "Medium: " << this->Medium << "\n";
  os << indent << "PaperGrain: " << this->PaperGrain << "\n";
  os << indent << "GrainSize: " << this->GrainSize << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "UseHidingLayers: " << this->UseHidingLayers << "\n";
  os << indent << "DepthTest: " << this->DepthTest << "\n";
  os << indent << "DepthTolerance: " << this->DepthTolerance << "\n";
  os << indent << "VisibilityRadius: " << this->VisibilityRadius << "\n";
  os << indent << "HiddenOpacity: " << this->HiddenOpacity << "\n";
  os << indent << "SplineType: " << this->SplineType << "\n";
  os << indent << "SplineChordError: " << this->SplineChordError << "\n";
  os << indent << "SplineCornerAngle: " << this->SplineCornerAngle << "\n";
}
