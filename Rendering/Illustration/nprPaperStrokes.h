// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprPaperStrokes_h
#define nprPaperStrokes_h

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

class vtkAlgorithmOutput;
class vtkNPRStrokeVisibility;
class vtkPolyData;
class vtkRenderer;

namespace npr
{
class ActorIllustration;
class LineStrokes;
struct PageScale;

/**
 * @class PaperStrokes
 * @brief The strokes of all actors of an illustration, cut where surfaces hide them.
 *
 * Lines are cut as they have been found, for there they lie on their surfaces; what remains is then
 * made smooth, and tapers where it is a line's end and no cut. What no view changes of the surfaces
 * is kept.
 */
class PaperStrokes
{
public:
  using Actors = std::vector<std::unique_ptr<ActorIllustration>>;

  /// @param names of the lines that the style draws
  void Make(const Actors& actors, vtkRenderer* renderer, const std::vector<std::string>& names,
    int maximumLayers, vtkPolyData* strokes);

  /// @name Seconds that it took so far
  ///@{
  double GetVisibilitySeconds() const { return this->VisibilitySeconds; }
  double GetStrokesSeconds() const { return this->StrokesSeconds; }
  ///@}

private:
  /// The strokes of one kind of line on one actor.
  struct Group
  {
    const LineStrokes* Strokes;
    int Type;
  };
  vtkSmartPointer<vtkPolyData> GatherLines(const Actors& actors, std::vector<Group>& groups);
  void SetSurfaces(const Actors& actors);
  void DrawParts(vtkPolyData* parts, const std::vector<Group>& groups, const PageScale& scale,
    vtkRenderer* renderer, vtkPolyData* strokes);

  vtkNew<vtkNPRStrokeVisibility> Visibility;
  std::vector<vtkSmartPointer<vtkAlgorithmOutput>> Surfaces;
  double VisibilitySeconds = 0.0;
  double StrokesSeconds = 0.0;
};
}

#endif
