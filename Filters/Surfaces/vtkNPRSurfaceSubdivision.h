// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSurfaceSubdivision
 * @brief Parts the triangles of a mesh into four, and smooths it (Loop) or keeps its points
 * (modified butterfly).
 *
 * The limit of Loop's scheme has continuous curvature but at points with other than six
 * neighbours, and lies inside a convex mesh; that of the modified butterfly goes through all
 * points, has continuous tangents only, and overshoots where the mesh turns sharply. On borders
 * and on the creases that vtkNPRSurfacePreparation has split, both follow the border alone: as a
 * cubic B-spline, and by the four-point rule. Points where creases meet or end stay. For the
 * weights and their source see npr::SubdivideSurface.
 *
 * The input must be an oriented manifold of triangles, else there is an error that says so: run
 * vtkNPRSurfacePreparation first. Points of the input keep their numbers, midpoints follow. Point
 * arrays of real numbers and bytes get the same weights as the coordinates; other ones the value of
 * the nearest point. Cell arrays pass to all four parts. Normals, curvatures and what else belongs
 * to the old shape is dropped: compute it anew.
 *
 * @sa vtkNPRSurfaceRefinement, which parts only what is coarse and bent, and follows given normals
 */
#ifndef vtkNPRSurfaceSubdivision_h
#define vtkNPRSurfaceSubdivision_h

#include "vtkNPRFiltersSurfacesModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSSURFACES_EXPORT vtkNPRSurfaceSubdivision : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSurfaceSubdivision* New();
  vtkTypeMacro(vtkNPRSurfaceSubdivision, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SchemeType
  {
    LOOP = 0,
    BUTTERFLY = 1
  };
  ///@{
  /// Default is LOOP.
  vtkSetClampMacro(Scheme, int, LOOP, BUTTERFLY);
  vtkGetMacro(Scheme, int);
  void SetSchemeToLoop() { this->SetScheme(LOOP); }
  void SetSchemeToButterfly() { this->SetScheme(BUTTERFLY); }
  ///@}

  ///@{
  /// How many times; each makes four triangles of one. 0 to 12, default 1.
  vtkSetClampMacro(NumberOfSubdivisions, int, 0, 12);
  vtkGetMacro(NumberOfSubdivisions, int);
  ///@}

protected:
  vtkNPRSurfaceSubdivision();
  ~vtkNPRSurfaceSubdivision() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRSurfaceSubdivision(const vtkNPRSurfaceSubdivision&) = delete;
  void operator=(const vtkNPRSurfaceSubdivision&) = delete;

  int Scheme = LOOP;
  int NumberOfSubdivisions = 1;
};

#endif
