// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRDepthVisibility
 * @brief Cuts strokes where what a renderer shows hides them, by its depth buffer.
 *
 * The counterpart of vtkNPRStrokeVisibility in the image: its time does not depend on the number
 * of triangles, nothing has to be prepared, and all that writes depth hides; but it knows no more
 * than one depth for each pixel. Render the surfaces first, and this filter then; its output is
 * that of the renderer's last picture, until the next one.
 *
 * @par What is visible
 * The axis of a stroke is looked at once a pixel, by the rule of vtkNPRStrokeMapper: it is visible
 * unless it lies behind *all* of the surface within VisibilityRadius by more than DepthTolerance.
 * A surface that is too near to be the stroke's own hides it up to the surface's edge. Where the
 * point array Normals tells that the stroke's surface is not seen edge-on (the cosine between
 * normal and view is more than 0.25), it goes on around the stroke: there only the pixels at the
 * stroke decide, and the tolerance grows with the slope of the surface.
 *
 * @par Output
 * As that of vtkNPRStrokeVisibility, with the cell array HidingLayers (int; 0: visible, 1: hidden).
 * What is outside of the viewport or of the clipping range is left out. The result does not depend
 * on the number of threads.
 *
 * @par How right it is
 * Of the length of contours, suggestive contours and creases, in images 700 pixels high, 1.6 to 3.6
 * % is taken for visible and is hidden, mostly just inside of outlines, and up to 0.4 % the other
 * way round (vtkNPRStrokeVisibility: up to 0.15 % each); nprVisibilityBenchmark measures it.
 *
 * @sa vtkNPRStrokeVisibility, vtkNPRStrokeMapper
 */
#ifndef vtkNPRDepthVisibility_h
#define vtkNPRDepthVisibility_h

#include "vtkNPRRenderingStrokesModule.h"
#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>

#include "nprVTKCompat.h" // for VTK_ABI_NAMESPACE_BEGIN

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

class VTKNPRRENDERINGSTROKES_EXPORT vtkNPRDepthVisibility : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRDepthVisibility* New();
  vtkTypeMacro(vtkNPRDepthVisibility, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whose camera and depth buffer. Default: null, an error. */
  virtual void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer() const;
  ///@}

  ///@{
  /** Takes the strokes to the world. None is the identity. Default: none. */
  virtual void SetStrokeMatrix(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetStrokeMatrix() const;
  ///@}

  ///@{
  /** How far behind a surface a stroke is still visible, in sizes of a pixel there; not negative.
   * Default: 1. */
  vtkSetClampMacro(DepthTolerance, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(DepthTolerance, double);
  ///@}

  ///@{
  /** Radius of the neighbourhood whose farthest surface decides, in pixels, [1, 100]. A larger one
   * closes gaps of contours that lie on a coarse mesh, and shows more of what is hidden just inside
   * the edge of a surface. Default: 1. */
  vtkSetClampMacro(VisibilityRadius, double, 1.0, 100.0);
  vtkGetMacro(VisibilityRadius, double);
  ///@}

  ///@{
  /** Parts that look shorter than this are made part of their neighbours, as
   * vtkNPRStrokeVisibility does. In pixels, [0, 1e6]. Default: 2. */
  vtkSetClampMacro(MinimumLength, double, 0.0, 1e6);
  vtkGetMacro(MinimumLength, double);
  ///@}

  /** Also counts the matrix; each picture of the renderer is a change. */
  vtkMTimeType GetMTime() override;

protected:
  vtkNPRDepthVisibility();
  ~vtkNPRDepthVisibility() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRDepthVisibility(const vtkNPRDepthVisibility&) = delete;
  void operator=(const vtkNPRDepthVisibility&) = delete;

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkMatrix4x4> StrokeMatrix;
  unsigned long EndObserver = 0;
  double DepthTolerance = 1.0;
  double VisibilityRadius = 1.0;
  double MinimumLength = 2.0;
};

#endif
