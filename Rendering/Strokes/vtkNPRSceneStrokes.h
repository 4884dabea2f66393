// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSceneStrokes
 * @brief The lines of all that a renderer shows, in the world: for a vector drawing of any scene.
 *
 * What a vtkNPRStrokeMapper draws is taken as it is. Every other visible actor with polygons is
 * drawn by its edges, for the renderer's camera: "contour-edges", "creases" and "boundaries" (see
 * vtkNPRFeatureLines). Parts of assemblies are taken where they are shown; other props, and what an
 * actor has other than polygons, are not.
 *
 * The output has polylines in double precision with the cell array `LineType`, the field data
 * `LineTypeNames`, and the point array `Strength`, which is 1 where the input has none. Lines of
 * one name are of one type, from whichever actor they come.
 *
 * The output follows the camera, the actors and their data. vtkNPRStrokeVisibility finds what of it
 * is hidden, and vtkNPRSVGWriter puts it on paper.
 *
 * @sa vtkNPRStrokeMapper, vtkNPRFeatureLines, vtkNPRSVGWriter
 */
#ifndef vtkNPRSceneStrokes_h
#define vtkNPRSceneStrokes_h

#include "vtkNPRRenderingStrokesModule.h"
#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>

#include "nprVTKCompat.h" // for VTK_ABI_NAMESPACE_BEGIN

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

class VTKNPRRENDERINGSTROKES_EXPORT vtkNPRSceneStrokes : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSceneStrokes* New();
  vtkTypeMacro(vtkNPRSceneStrokes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Whose actors and camera. Default: null, an error. */
  virtual void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer() const;
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkNPRSceneStrokes();
  ~vtkNPRSceneStrokes() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRSceneStrokes(const vtkNPRSceneStrokes&) = delete;
  void operator=(const vtkNPRSceneStrokes&) = delete;

  vtkSmartPointer<vtkRenderer> Renderer;
};

#endif
