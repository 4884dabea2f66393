// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprCutLines.h"

#include "nprActorIllustration.h"
#include "nprLineStrokes.h"
#include "nprPageScale.h"
#include "vtkNPRStrokeVisibility.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkTimerLog.h>

namespace npr
{
namespace
{
// Thousandths of the image's shorter side: twice as wide as lines are, whose round ends make gaps
// shorter and pieces longer by once their width. What is shorter is no line, but dirt.
constexpr double ShortestPart = 5.0;
}

//------------------------------------------------------------------------------
void CutLines::Update(const Actors& actors, vtkRenderer* renderer, const PageScale& scale,
  int maximumLayers, bool clipped)
{
  std::vector<WorldLines::Source> sources;
  std::vector<LineStrokes*> shown;
  int number = 0; // of a kind of line on an actor, the same whatever is shown
  for (const auto& actor : actors)
  {
    for (LineStrokes& strokes : actor->GetStrokes())
    {
      if (actor->IsShown() && strokes.IsVisible)
      {
        strokes.SetParts(this->Visibility->GetOutputPort(), number);
        sources.push_back({ strokes.GetLinesPort(), actor->GetActor()->GetMatrix(), number });
        shown.push_back(&strokes);
      }
      ++number;
    }
  }
  if (shown.empty())
  {
    return;
  }
  this->Lines->SetSources(sources);
  this->Lines->Update();

  const double start = vtkTimerLog::GetUniversalTime();
  this->Surfaces.GiveTo(this->Visibility, actors, renderer, clipped);
  this->Visibility->SetInputConnection(this->Lines->GetOutputPort());
  this->Visibility->SetCamera(renderer->GetActiveCamera());
  this->Visibility->SetViewportHeight(renderer->GetSize()[1]);
  this->Visibility->SetMinimumLength(ShortestPart * scale.PixelsPerUnit);
  this->Visibility->SetMaximumLayers(maximumLayers);
  this->Visibility->Update();
  const double middle = vtkTimerLog::GetUniversalTime();
  this->VisibilitySeconds += middle - start;
  for (LineStrokes* const strokes : shown)
  {
    strokes->GetPartStrokes();
  }
  this->StrokesSeconds += vtkTimerLog::GetUniversalTime() - middle;
}
}
