// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSurfaceRefinement
 * @brief Makes a coarse triangle mesh look smooth.
 *
 * Triangles are parted at the midpoints of their edges, and the midpoints moved onto the curves
 * that the normals describe: so outlines become round, creases that vtkNPRSurfacePreparation has
 * split stay sharp (and become round along their length), and flat parts stay flat, and stay
 * coarse. See npr::RefineSurface for the rules and their source.
 *
 * The input should come from vtkNPRSurfacePreparation and vtkNPRSurfaceNormals; without normals
 * they are computed. Curvature and its derivatives are best estimated before (vtkNPRCurvatureTensor
 * on the mesh as it was measured). Points of the input stay where and which they are; midpoints
 * follow. Point arrays are interpolated linearly (integers other than bytes taken from one end);
 * the curvature tensor and its derivatives are turned into the tangent planes of the new points,
 * and what follows from the tensor computed anew. PointArea and NeighbourhoodRadius, which belong
 * to the coarse triangles, are dropped. Cell arrays pass to all parts of a cell. A cell array
 * ChordError tells, unless the input has it, how far the coarse triangle was from the smooth
 * surface: what the refinement does about that is a guess, and bodies that touch by so much may
 * not be told apart.
 *
 * Pieces of a surface are refined alike where they meet: the filter asks for the ghost levels that
 * it needs, and drops them. But MaximumNumberOfTriangles holds for each piece, and the input should
 * have the field data LengthScale of the whole. If the filter is aborted the output is the input.
 *
 * @sa vtkNPRSurfacePreparation vtkNPRSurfaceNormals vtkNPRCurvatureTensor
 */
#ifndef vtkNPRSurfaceRefinement_h
#define vtkNPRSurfaceRefinement_h

#include "vtkNPRFiltersCurvatureModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSCURVATURE_EXPORT vtkNPRSurfaceRefinement : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSurfaceRefinement* New();
  vtkTypeMacro(vtkNPRSurfaceRefinement, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// How long an edge that is not flat may be, as a fraction of the surface's length scale. Default
  /// is 0.02. Ignored if NumberOfLevels is set.
  vtkSetClampMacro(MaximumEdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /// How far the normals at the ends of an edge may differ, so that triangles adapt to curvature:
  /// an edge becomes as long as this turn divided by the curvature along it, but not shorter than
  /// half of MaximumEdgeLength (set that to 0 for no such limit). Degrees, 0 to 180; 0, the
  /// default, splits all edges that are too long and not flat, unless MaximumChordError is set.
  /// Ignored if NumberOfLevels is set.
  vtkSetClampMacro(MaximumTurn, double, 0.0, 180.0);
  vtkGetMacro(MaximumTurn, double);
  ///@}

  ///@{
  /// How far the middle of an edge may be from the curve that its normals describe, as a fraction
  /// of the surface's length scale: so flat faces stay whole, and a cylinder gets no more triangles
  /// along its axis. None becomes shorter than half of MaximumEdgeLength. 0, the default, does not
  /// ask for it; if both are given, an edge has to keep both. Ignored if NumberOfLevels is set.
  vtkSetClampMacro(MaximumChordError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumChordError, double);
  ///@}

  ///@{
  /// The refinement ends where it would make more; of edges that are too long, the longest are
  /// split first. Default is 2,000,000.
  vtkSetClampMacro(MaximumNumberOfTriangles, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfTriangles, vtkIdType);
  ///@}

  ///@{
  /// If not negative, every triangle is parted into four this many times (up to 12), flat or not,
  /// unless that makes too many. Default is -1.
  vtkSetClampMacro(NumberOfLevels, int, -1, 12);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

protected:
  vtkNPRSurfaceRefinement();
  ~vtkNPRSurfaceRefinement() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRSurfaceRefinement(const vtkNPRSurfaceRefinement&) = delete;
  void operator=(const vtkNPRSurfaceRefinement&) = delete;

  /// False if there is nothing to refine or it was aborted: then the output is as it was.
  bool Compute(vtkPolyData* input, vtkPolyData* output, bool isPiece);

  double MaximumEdgeLength = 0.02;
  double MaximumTurn = 0.0;
  double MaximumChordError = 0.0;
  vtkIdType MaximumNumberOfTriangles = 2000000;
  int NumberOfLevels = -1;
};

#endif
