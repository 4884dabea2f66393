// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprRendererIllustration_h
#define nprRendererIllustration_h

#include "nprStyleDocument.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkLight;
class vtkNPREdgePass;
class vtkNPRShadingPass;
class vtkRenderPass;
class vtkRenderer;

namespace npr
{
struct PageScale;

/**
 * @class RendererIllustration
 * @brief What a style changes on a renderer itself, given back by the destructor.
 */
class RendererIllustration
{
public:
  RendererIllustration(vtkRenderer* renderer, const StyleDocument& style);
  ~RendererIllustration();
  RendererIllustration(const RendererIllustration&) = delete;
  void operator=(const RendererIllustration&) = delete;

  /// False where the style has one that can not be drawn, for the renderer's own pass.
  bool HasOutline() const { return this->OutlineIsDrawn; }

  /// Before each frame: the size of the window.
  void Follow(const PageScale& scale);

private:
  void SetLights(const std::vector<LightStyle>& lights);
  void SetShading(const StyleDocument& style);
  void SetOutline(const OutlineStyle& outline);

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderPass> Pass;
  std::vector<vtkSmartPointer<vtkLight>> Lights;
  bool AutomaticLights;
  bool Gradient;
  bool DepthPeeling;
  double Background[3];
  double Background2[3];

  vtkSmartPointer<vtkNPRShadingPass> Shading;
  vtkSmartPointer<vtkNPREdgePass> Edges;
  double OutlineWidth = 0.0; // thousandths
  bool OutlineIsDrawn = true;
};
}

#endif
