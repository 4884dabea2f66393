// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSurfacePreparation
 * @brief Makes whatever polygons come a clean, oriented triangle mesh in smooth patches.
 *
 * In this order: polygons and strips are triangulated, and cells without a surface dropped;
 * triangles with points that are NaN or infinite dropped; points in the same place welded (all
 * attributes are those of the first, so texture coordinates may differ at seams: shade the original
 * mesh, or set Weld off); triangles without area and duplicates dropped; triangles oriented alike
 * across edges that have two, with the normals of closed components outside, and open ones left as
 * most of their triangles were; and the surface split into smooth patches along its creases, so
 * that normals and curvatures there are those of either side and nothing is smeared across.
 *
 * Point and cell arrays pass. The output has the point array WeldedPointIds (for copies that the
 * split made the point they were copied from, for all others their own id; copies follow at the
 * end) and the field data LengthScale, unless the input has one.
 *
 * What was done can be asked for count by count, or as one line: GetReport().
 * @sa vtkNPRSurfaceNormals vtkNPRSurfaceRefinement
 */
#ifndef vtkNPRSurfacePreparation_h
#define vtkNPRSurfacePreparation_h

#include "nprSurfacePreparation.h" // for its counts
#include "vtkNPRFiltersSurfacesModule.h"
#include <vtkPolyDataAlgorithm.h>

class VTKNPRFILTERSSURFACES_EXPORT vtkNPRSurfacePreparation : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSurfacePreparation* New();
  vtkTypeMacro(vtkNPRSurfacePreparation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether points in the same place become one. Default is on.
  vtkSetMacro(Weld, bool);
  vtkGetMacro(Weld, bool);
  vtkBooleanMacro(Weld, bool);
  ///@}

  ///@{
  /// Distance within which points are taken for one, as a fraction of the surface's length scale.
  /// Default is 0: only equal coordinates. Above 0 it takes several times as long.
  vtkSetClampMacro(WeldTolerance, double, 0.0, 1.0);
  vtkGetMacro(WeldTolerance, double);
  ///@}

  ///@{
  /// Whether triangles are turned until neighbours agree, and outwards. Default is on.
  vtkSetMacro(Orient, bool);
  vtkGetMacro(Orient, bool);
  vtkBooleanMacro(Orient, bool);
  ///@}

  ///@{
  /// Whether the surface is split along its creases (and where it is not a manifold). Default is
  /// on.
  vtkSetMacro(SplitCreases, bool);
  vtkGetMacro(SplitCreases, bool);
  vtkBooleanMacro(SplitCreases, bool);
  ///@}

  ///@{
  /// An edge is a crease if its triangles' normals differ by more; degrees, 0 to 180, default 40.
  /// Lone sharp edges are taken for noise: see npr::FindCreases.
  vtkSetClampMacro(CreaseAngle, double, 0.0, 180.0);
  vtkGetMacro(CreaseAngle, double);
  ///@}

  /// @name What the last update did
  ///@{
  /// Vertices and lines, which have no surface.
  vtkIdType GetNumberOfDroppedCells() const { return this->Counts.DroppedCells; }
  /// Polygons of more than three corners and strips that became triangles.
  vtkIdType GetNumberOfTriangulatedCells() const { return this->Counts.TriangulatedCells; }
  /// Triangles dropped because a point was missing, NaN or infinite.
  vtkIdType GetNumberOfNonFiniteTriangles() const { return this->Counts.NonFiniteTriangles; }
  /// Points that became one with an earlier point in the same place.
  vtkIdType GetNumberOfWeldedPoints() const { return this->Counts.WeldedPoints; }
  /// Points dropped because no triangle needs them.
  vtkIdType GetNumberOfUnusedPoints() const { return this->Counts.UnusedPoints; }
  /// Triangles dropped because they have no area.
  vtkIdType GetNumberOfDegenerateTriangles() const { return this->Counts.DegenerateTriangles; }
  /// Triangles without area that closed a T-junction, replaced by an edge flip.
  vtkIdType GetNumberOfFlippedNeedles() const { return this->Counts.FlippedNeedles; }
  /// Triangles dropped because they have the points of an earlier one.
  vtkIdType GetNumberOfDuplicateTriangles() const { return this->Counts.DuplicateTriangles; }
  /// Triangles turned over.
  vtkIdType GetNumberOfReorientedTriangles() const { return this->Counts.ReorientedTriangles; }
  /// Edges with more than two triangles.
  vtkIdType GetNumberOfNonManifoldEdges() const { return this->Counts.NonManifoldEdges; }
  /// Edges with one triangle.
  vtkIdType GetNumberOfBoundaryEdges() const { return this->Counts.BoundaryEdges; }
  /// Edges that the surface was split along.
  vtkIdType GetNumberOfCreaseEdges() const { return this->Counts.CreaseEdges; }
  /// Copies of points that the split made.
  vtkIdType GetNumberOfSplitPoints() const { return this->Counts.SplitPoints; }
  /// All of it that is not zero, in one line.
  std::string GetReport() const;
  ///@}

protected:
  vtkNPRSurfacePreparation();
  ~vtkNPRSurfacePreparation() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNPRSurfacePreparation(const vtkNPRSurfacePreparation&) = delete;
  void operator=(const vtkNPRSurfacePreparation&) = delete;

  bool Weld = true;
  double WeldTolerance = 0.0;
  bool Orient = true;
  bool SplitCreases = true;
  double CreaseAngle = 40.0;
  npr::SurfacePreparationCounts Counts;
};

#endif
