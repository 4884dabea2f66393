// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprRenderJob.h
 * @brief From a renderer with actors to an illustration in a file; what render and demo share.
 */
#ifndef nprRenderJob_h
#define nprRenderJob_h

#include "nprDrawingOptions.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

class vtkImageData;
class vtkNPRDrawingWriter;
class vtkNPRIllustration;
class vtkNPRIllustrationStyle;
class vtkRenderWindow;
class vtkRenderer;

namespace npr
{
class Reporter;

/// The window that this machine can draw with; throws a CommandError when there is none.
vtkSmartPointer<vtkRenderWindow> MakeWindow(Reporter& reporter, const std::array<int, 2>& size);

/// Draws the window's scene, and returns it as an RGB image.
vtkSmartPointer<vtkImageData> GrabImage(vtkRenderWindow* window, Reporter& reporter);

/// A window without a display, one renderer in it, and the illustration on that.
class RenderJob
{
public:
  /// Without pixels, the window is only there for its size: this needs no graphics.
  RenderJob(Reporter& reporter, const std::array<int, 2>& size, bool withPixels = true);
  ~RenderJob();

  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkNPRIllustration* GetIllustration() { return this->Illustration; }

  /// Illustrate what the renderer shows and write it. May be called again with another style.
  void Run(vtkNPRIllustrationStyle* style, const std::string& file, bool transparent);

  /// Illustrate what the renderer shows and write it as a vector drawing, with what is asked for
  /// below. The writer has its page.
  void RunDrawing(vtkNPRIllustrationStyle* style, vtkNPRDrawingWriter* writer,
    const std::string& file, DrawingShading shading, bool transparent);

  /// @name The steps of Run() but the last, for those who draw more than one picture
  ///@{
  void Apply(vtkNPRIllustrationStyle* style);
  vtkSmartPointer<vtkImageData> Draw();
  /// Tell the reporter how long the illustration took; `seconds` is the time from Apply() on.
  void AddStages(double seconds);
  ///@}

private:
  void AddIllustrationStages();
  vtkSmartPointer<vtkImageData> DrawShading(bool transparent);
  vtkSmartPointer<vtkImageData> DrawTones();
  vtkSmartPointer<vtkImageData> DrawWithoutPaper();

  Reporter& Output;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkNPRIllustration> Illustration;
};
}

#endif
