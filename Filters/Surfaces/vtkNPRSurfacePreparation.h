// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNPRSurfacePreparation
 * @brief Makes whatever polygons come a clean, oriented triangle mesh in smooth patches.
 *
 * In this order: polygons and strips are triangulated, and cells without a surface dropped;
 * triangles with points that are NaN or infinite dropped; points in the same place welded (all
 * attributes are those of the first, so texture coordinates may differ at seams: shade the original
 * mesh, or set Weld off); triangles without area and duplicates dropped, and folds, which are small
 * flaps whose two sides coincide (decimated scans have them); cracks closed between faces that
 * part a common edge differently, by splitting the triangles there (not with Weld off); the surface
 * split where it is no manifold, so that each edge has at most two triangles and each point one fan
 * of them; triangles oriented alike across edges that have two, with the normals of closed
 * components outside, and open ones left as most of their triangles were; triangles laid back that
 * are folded over their neighbours, by flipping an edge (slivers of CAD are so; see
 * npr::MendFoldovers); small holes filled, if asked for; and the surface split into smooth patches
 * along its creases, so that normals and curvatures there are those of either side and nothing is
 * smeared across.
 *
 * Points keep their precision, and point and cell arrays pass; triangles that fill a hole have the
 * cell data of a triangle beside it. The output has the point array WeldedPointIds (for copies that
 * a split made the point they were copied from, for all others their own id; copies follow at the
 * end) and the field data LengthScale, unless the input has one.
 *
 * What was found and done can be asked for count by count, or as one line: GetReport(), which also
 * goes to vtkLogger at verbosity 1. It travels with the surface, too, as the field data array
 * PreparationCounts: one tuple whose components have the counts' names, so that readers of files
 * and ParaView's spreadsheet see it.
 *
 * Of a surface in pieces the filter sees one at a time, and asks for no ghost levels: points of two
 * pieces are not welded, closed components not known as such, and the LengthScale is the piece's.
 * So prepare the whole before it is parted. What ghost cells there are stay ghost cells (the array
 * vtkGhostType passes like all others).
 * @sa vtkNPRSurfaceNormals vtkNPRSurfaceRefinement
 */
#ifndef vtkNPRSurfacePreparation_h
#define vtkNPRSurfacePreparation_h

#include "nprSurfacePreparation.h" // for its counts
#include "vtkNPRFiltersSurfacesModule.h"
#include <vtkPolyDataAlgorithm.h>

#include <string>

class VTKNPRFILTERSSURFACES_EXPORT vtkNPRSurfacePreparation : public vtkPolyDataAlgorithm
{
public:
  static vtkNPRSurfacePreparation* New();
  vtkTypeMacro(vtkNPRSurfacePreparation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether points in the same place become one, and cracks are closed. Default is on.
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
  /// Whether triangles are turned until neighbours agree, and outwards, and those mended that are
  /// folded over. Default is on.
  vtkSetMacro(Orient, bool);
  vtkGetMacro(Orient, bool);
  vtkBooleanMacro(Orient, bool);
  ///@}

  ///@{
  /// Whether the surface is split at edges of more than two triangles, at points where several fans
  /// of triangles meet, and, if triangles are oriented, along edges where they can not agree, as on
  /// a Moebius strip. Only copies of points are made; nothing moves. Default is on.
  vtkSetMacro(SplitNonManifold, bool);
  vtkGetMacro(SplitNonManifold, bool);
  vtkBooleanMacro(SplitNonManifold, bool);
  ///@}

  ///@{
  /// Holes whose border is at most so long are filled with triangles between its points; as a
  /// fraction of the surface's length scale, default 0: none. A sphere's equator has 6.28. What is
  /// taken for a hole, and how it is filled, says npr::FillHoles.
  vtkSetClampMacro(FillHoles, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FillHoles, double);
  ///@}

  ///@{
  /// Whether the surface is split along its creases. Default is on.
  vtkSetMacro(SplitCreases, bool);
  vtkGetMacro(SplitCreases, bool);
  vtkBooleanMacro(SplitCreases, bool);
  ///@}

  ///@{
  /// An edge is a crease if its triangles' normals differ by more, or by more than half of it and
  /// it stands out from the edges beside it; degrees, 0 to 180, default 40. Lone sharp edges are
  /// taken for noise: see npr::FindCreases.
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
  /// Triangles dropped because they have the points of another one.
  vtkIdType GetNumberOfDuplicateTriangles() const { return this->Counts.DuplicateTriangles; }
  /// Triangles dropped because they coincide with one that faces the other way, on a fold of less
  /// than a thousandth of the area. A larger two-sided sheet, or one by itself, keeps one side.
  vtkIdType GetNumberOfFoldTriangles() const { return this->Counts.FoldTriangles; }
  /// Triangles turned over.
  vtkIdType GetNumberOfReorientedTriangles() const { return this->Counts.ReorientedTriangles; }
  /// Boundary edges split where points of another border that runs along them lie on them.
  vtkIdType GetNumberOfCrackEdges() const { return this->Counts.CrackEdges; }
  /// Edges with more than two triangles.
  vtkIdType GetNumberOfNonManifoldEdges() const { return this->Counts.NonManifoldEdges; }
  /// Points with several fans of triangles that are at no such edge.
  vtkIdType GetNumberOfNonManifoldPoints() const { return this->Counts.NonManifoldPoints; }
  /// Edges whose two triangles can not be made to agree; none if triangles are not oriented.
  vtkIdType GetNumberOfNonOrientableEdges() const { return this->Counts.NonOrientableEdges; }
  /// Copies of points made to split the surface at all these.
  vtkIdType GetNumberOfNonManifoldSplitPoints() const
  {
    return this->Counts.NonManifoldSplitPoints;
  }
  /// Edges with one triangle, before anything was split or filled.
  vtkIdType GetNumberOfBoundaryEdges() const { return this->Counts.BoundaryEdges; }
  /// Edges flipped where a triangle was folded over its neighbours, so that it no longer is. None
  /// if triangles are not oriented.
  vtkIdType GetNumberOfMendedFoldovers() const { return this->Counts.MendedFoldovers; }
  /// Triangles that are folded over all their neighbours, and no flip helps.
  vtkIdType GetNumberOfLeftFoldovers() const { return this->Counts.LeftFoldovers; }
  /// Holes that were filled.
  vtkIdType GetNumberOfFilledHoles() const { return this->Counts.FilledHoles; }
  /// Triangles that fill them.
  vtkIdType GetNumberOfFillingTriangles() const { return this->Counts.FillingTriangles; }
  /// Borders short enough to be a hole's that were left open, since filling would do harm.
  vtkIdType GetNumberOfOpenHoles() const { return this->Counts.OpenHoles; }
  /// Creases that the surface was split along.
  vtkIdType GetNumberOfCreaseEdges() const { return this->Counts.CreaseEdges; }
  /// Copies of points made for that.
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
  bool SplitNonManifold = true;
  double FillHoles = 0.0;
  bool SplitCreases = true;
  double CreaseAngle = 40.0;
  npr::SurfacePreparationCounts Counts;
};

#endif
