// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes that are not drawn into the picture as it is: those with depth peeling, which wait for
// the renderer's end, and those that a selector draws.
#include "vtkNPRStrokeMapper.h"

#include "nprInkArea.h"
#include "nprPostponedStrokes.h"
#include "nprStrokeGraphics.h"

#include <vtkCommand.h>
#include <vtkHardwareSelector.h>
#include <vtkOpenGLError.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPolyData.h>
#include <vtkShaderProgram.h>

#include <algorithm>

//------------------------------------------------------------------------------
// What depth peeling draws into is neither the picture nor has it the depth of opaque surfaces.
void vtkNPRStrokeMapper::Postpone(vtkRenderer* renderer, vtkActor* actor)
{
  npr::PostponedStrokes& postponed = *this->Postponed;
  if (postponed.Renderer != renderer)
  {
    // An aborted picture had no end.
    if (postponed.Renderer)
    {
      postponed.Renderer->RemoveObserver(postponed.Observer);
    }
    postponed.Actors.clear();
    postponed.Renderer = renderer;
    postponed.Observer =
      renderer->AddObserver(vtkCommand::EndEvent, this, &vtkNPRStrokeMapper::DrawPostponed);
  }
  // Peeling draws an actor many times, and it is to be drawn once.
  if (std::find(postponed.Actors.begin(), postponed.Actors.end(), actor) == postponed.Actors.end())
  {
    postponed.Actors.emplace_back(actor);
  }
}

//------------------------------------------------------------------------------
void vtkNPRStrokeMapper::DrawPostponed()
{
  vtkRenderer* renderer = this->Postponed->Renderer;
  const std::vector<vtkWeakPointer<vtkActor>> actors = std::move(this->Postponed->Actors);
  renderer->RemoveObserver(this->Postponed->Observer);
  *this->Postponed = npr::PostponedStrokes();
  vtkOpenGLRenderWindow* window = this->Graphics->GetWindow();
  if (!window || window != renderer->GetRenderWindow())
  {
    return;
  }
  int viewport[4];
  renderer->GetTiledSizeAndOrigin(&viewport[2], &viewport[3], &viewport[0], &viewport[1]);
  vtkOpenGLState::ScopedglViewport savedViewport(window->GetState());
  window->GetState()->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  for (vtkActor* actor : actors)
  {
    if (actor)
    {
      this->DrawStrokes(renderer, actor, false);
    }
  }
}

//------------------------------------------------------------------------------
void vtkNPRStrokeMapper::DrawForSelection(vtkRenderer* renderer, vtkActor* actor)
{
  npr::StrokeGraphics& graphics = *this->Graphics;
  vtkOpenGLState* state = graphics.GetWindow()->GetState();
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  vtkOpenGLClearErrorMacro();
  graphics.Picking.DrawDepth(graphics.GetWindow(), renderer, viewport[2], viewport[3]);
  graphics.UploadCells();
  vtkShaderProgram* program = this->ReadyProgram("#define NPR_PICKED\n");
  if (!program)
  {
    return;
  }

  vtkHardwareSelector* selector = renderer->GetSelector();
  const int pass = selector->GetCurrentPass();
  selector->BeginRenderProp();
  if (pass == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
  {
    selector->RenderCompositeIndex(1);
  }
  selector->UpdateMaximumCellId(this->GetInput()->GetNumberOfCells());
  vtkOpenGLState::ScopedglDepthMask savedDepthMask(state);
  vtkOpenGLState::ScopedglDepthFunc savedDepthFunc(state);
  vtkOpenGLState::ScopedglEnableDisable savedDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable savedBlend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable savedCull(state, GL_CULL_FACE);
  // What hides strokes is decided along their axes; the depth is written for what comes later.
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  this->SetUniforms(renderer, actor, program, viewport);
  program->SetUniformi("nprDepthTest", this->DepthTest);
  program->SetUniform3f("nprPickedColor", selector->GetPropColorValue());
  program->SetUniformi("nprPickedPart",
    pass == vtkHardwareSelector::CELL_ID_LOW24      ? 1
      : pass == vtkHardwareSelector::CELL_ID_HIGH24 ? 2
                                                    : 0);
  graphics.Draw(program, graphics.Picking.GetDepth(), this->IsStyled(), true);
  selector->EndRenderProp();
  vtkOpenGLCheckErrorMacro("failed after drawing strokes for selection");
}
