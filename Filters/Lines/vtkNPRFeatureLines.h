// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRFeatureLines
 * @brief Feature lines of a surface, as chained polylines.
 *
 * Give it one or more line definitions, by object or by name, and for lines that move with the view
 * the camera; when the surface is drawn by a prop with a matrix, that too. The output is in the
 * space of the input, so a prop with the same matrix draws it in its place. The camera's, the
 * matrix's and the definitions' changes count as changes of the filter: Render() alone keeps the
 * lines current.
 *
 * @par Input
 * Triangles with the point arrays that the definitions need (an error names the array and the
 * filter that makes it). WeldedPointIds, from vtkNPRSurfacePreparation, says which points are
 * copies of one where creases split the surface.
 *
 * @par Output
 * Polylines in double precision; a closed one ends with the point it starts with. Each runs through
 * neighbouring triangles or edges with the front (the positive side of its field, or its triangle)
 * on its left, seen from outside. No piece has no length, and none comes twice within one kind.
 * Cell arrays LineType (index into the field data array LineTypeNames) and LineLevel (the value of
 * the field that the line is at, 0 for most kinds), point arrays Strength
 * (in [0, 1]) and Normals (the surface's).
 *
 * @par Props with a matrix
 * The eye is brought into the space of the model by the inverse of the matrix. A point is on a
 * contour in the world exactly when it is on one for that eye in the model, for every invertible
 * affine matrix, also with uneven scale or mirrored. Suggestive contours use the curvature of the
 * unscaled model.
 *
 * @par Cost
 * Work that no view changes (adjacency, arrays, triangles that are ruled out, view-independent
 * lines) is kept until the input or a definition changes.
 *
 * @sa vtkNPRLineDefinition
 */
#ifndef vtkNPRFeatureLines_h
#define vtkNPRFeatureLines_h

#include "nprVTKCompat.h"
#include "vtkNPRFiltersLinesModule.h"
#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkMatrix4x4;
VTK_ABI_NAMESPACE_END
class vtkNPRLineDefinition;
namespace npr
{
class LineRuler;
struct LineChains;
}

class VTKNPRFILTERSLINES_EXPORT vtkNPRFeatureLines : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRFeatureLines* New();
  vtkTypeMacro(vtkNPRFeatureLines, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// @name Definitions
  /// Which lines to extract. The index of a definition is its LineType. Default is none, an error.
  ///@{
  void AddDefinition(vtkNPRLineDefinition* definition);
  /// Makes one by its name, such as "contours", and returns it; an unknown name is an error, and
  /// returns null.
  vtkNPRLineDefinition* AddDefinition(const char* name);
  void RemoveAllDefinitions();
  int GetNumberOfDefinitions() const;
  /// Null when the index is out of range.
  vtkNPRLineDefinition* GetDefinition(int index) const;
  ///@}

  ///@{
  /// The camera that looks at the lines. Needed for lines that move with the view, and for
  /// MinimumLength. Default is none.
  virtual void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera() const;
  ///@}

  ///@{
  /// Takes the model to the world, as vtkProp3D::GetMatrix(). None is the identity. Default is
  /// none.
  virtual void SetMatrix(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetMatrix() const;
  ///@}

  ///@{
  /// The length that curvatures are multiplied by before they meet a threshold. 0 takes the input's
  /// field data LengthScale, or without it the root mean square distance of the surface from its
  /// centroid. Set one value for all frames of an animation. Range [0, infinity), in units of the
  /// input. Default is 0.
  vtkSetClampMacro(LengthScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LengthScale, double);
  ///@}

  ///@{
  /// Chains that look shorter than this fraction of the view's height are left out. A chain's
  /// length is measured as the camera sees it, whether hidden or not. Range [0, infinity). Default
  /// is 0, which keeps all.
  vtkSetClampMacro(MinimumLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumLength, double);
  ///@}

  ///@{
  /// Chains whose strength is nowhere as high as this are left out, those that reach it keep their
  /// weak ends (hysteresis). Range [0, 1]. Default is 0, which keeps all.
  vtkSetClampMacro(MinimumStrength, double, 0.0, 1.0);
  vtkGetMacro(MinimumStrength, double);
  ///@}

  /// Also counts camera, matrix and definitions.
  vtkMTimeType GetMTime() override;

protected:
  vtkNPRFeatureLines();
  ~vtkNPRFeatureLines() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  bool PrepareSurface(vtkPolyData* input);
  bool IsWanted(
    const npr::LineChains& chains, std::size_t chain, const npr::LineRuler* ruler) const;

  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkMatrix4x4> Matrix;
  double LengthScale = 0.0;
  double MinimumLength = 0.0;
  double MinimumStrength = 0.0;

  class Internals;
  std::unique_ptr<Internals> Internal;

  vtkNPRFeatureLines(const vtkNPRFeatureLines&) = delete;
  void operator=(const vtkNPRFeatureLines&) = delete;
};

#endif
