// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprCutLines_h
#define nprCutLines_h

#include "nprSceneSurfaces.h"
#include "nprWorldLines.h"

#include <vtkNew.h>

#include <memory>
#include <vector>

class vtkNPRStrokeVisibility;
class vtkRenderer;

namespace npr
{
class ActorIllustration;
struct PageScale;

/**
 * @class CutLines
 * @brief The lines of all actors of an illustration, cut where surfaces hide them; for pictures as
 * for drawings on paper.
 *
 * Lines are cut as they have been found, for there they lie on their surfaces; what remains is then
 * made smooth, and tapers where it is a line's end and no cut. What no view changes of the surfaces
 * is kept.
 */
class CutLines
{
public:
  using Actors = std::vector<std::unique_ptr<ActorIllustration>>;

  /// Cuts the lines that are shown for the camera as it stands, and makes strokes of the parts:
  /// see LineStrokes::GetPartStrokes().
  /// @param maximumLayers more of them are not counted
  /// @param clipped whether what the mappers' clipping planes cut away does not hide
  void Update(const Actors& actors, vtkRenderer* renderer, const PageScale& scale,
    int maximumLayers, bool clipped);

  /// @name Seconds that it took so far
  ///@{
  double GetVisibilitySeconds() const { return this->VisibilitySeconds; }
  double GetStrokesSeconds() const { return this->StrokesSeconds; }
  ///@}

private:
  vtkNew<WorldLines> Lines;
  SceneSurfaces Surfaces;
  vtkNew<vtkNPRStrokeVisibility> Visibility;
  double VisibilitySeconds = 0.0;
  double StrokesSeconds = 0.0;
};
}

#endif
