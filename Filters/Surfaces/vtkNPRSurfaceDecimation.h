// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSurfaceDecimation
 * @brief Takes points from a triangle mesh where it bends least, with bounds on the error and on
 * the angles.
 *
 * It stops when enough triangles are gone, or when every further step would break a bound. So the
 * triangles become large where curvature is small, as with vtkQuadricDecimation, but no slivers are
 * made, and no triangle turns over. Taken down to a tenth, scans stay as near to their shape as
 * with that filter (root mean square distances were 0.86 to 1.0 of its) and take as long; a torus,
 * which asks for long triangles, pays for the bound on the angles by 15 %. For the rules and their
 * source see npr::DecimateSurface.
 *
 * The topology is kept: as many pieces, holes and handles as before, and what was watertight stays
 * so. A surface that is full of them, such as one with many non-manifold parts that the preparation
 * has split off, therefore can not become as coarse as asked for, and what else there is suffers.
 *
 * Points move, and have values between those of the points that they come from, by where they lie
 * along the edges that went (of ids and names those of the point that counts most). What describes
 * the shape, such as normals and curvature, is dropped. Triangles keep their cell arrays. Points on
 * creases that vtkNPRSurfacePreparation has split stay, or the patches would come apart: to
 * decimate those, too, set its SplitCreases off, and split afterwards.
 *
 * The input must be an oriented manifold of triangles, else there is an error that says so: run
 * vtkNPRSurfacePreparation first.
 * @sa vtkNPRSurfaceRefinement, for the other way
 */
#ifndef vtkNPRSurfaceDecimation_h
#define vtkNPRSurfaceDecimation_h

#include "vtkNPRFiltersSurfacesModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSSURFACES_EXPORT vtkNPRSurfaceDecimation : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSurfaceDecimation* New();
  vtkTypeMacro(vtkNPRSurfaceDecimation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The part of the triangles that should go, 0 to 1; 1 takes as many as the bounds allow. Default
  /// is 0.9.
  vtkSetClampMacro(TargetReduction, double, 0.0, 1.0);
  vtkGetMacro(TargetReduction, double);
  ///@}

  ///@{
  /// How many triangles should be left; takes the place of TargetReduction where it is not
  /// negative. Default is -1.
  vtkSetClampMacro(TargetNumberOfTriangles, vtkIdType, -1, VTK_ID_MAX);
  vtkGetMacro(TargetNumberOfTriangles, vtkIdType);
  ///@}

  ///@{
  /// How far from the result a point of the input may come to lie, as a fraction of the surface's
  /// length scale. 0, the default, is no bound. With one it takes two to four times as long.
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /// No triangle gets an angle below this one, unless the triangles it comes from had one as small;
  /// degrees, 0 to 60, default 10. At more than about 30 little goes at all.
  vtkSetClampMacro(MinimumAngle, double, 0.0, 60.0);
  vtkGetMacro(MinimumAngle, double);
  ///@}

protected:
  vtkNPRSurfaceDecimation();
  ~vtkNPRSurfaceDecimation() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRSurfaceDecimation(const vtkNPRSurfaceDecimation&) = delete;
  void operator=(const vtkNPRSurfaceDecimation&) = delete;

  double TargetReduction = 0.9;
  vtkIdType TargetNumberOfTriangles = -1;
  double MaximumError = 0.0;
  double MinimumAngle = 10.0;
};

#endif
