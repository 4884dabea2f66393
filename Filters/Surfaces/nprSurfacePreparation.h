// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSurfacePreparation.h
 * @brief From whatever polygons come to a clean, oriented mesh of triangles in smooth patches.
 */
#ifndef nprSurfacePreparation_h
#define nprSurfacePreparation_h

#include "nprProgress.h"
#include "nprTriangleMesh.h"
#include "nprVTKCompat.h"
#include "vtkNPRFiltersSurfacesModule.h"

#include <vtkType.h>

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
struct SurfacePreparationOptions
{
  bool Weld = true;
  double WeldTolerance = 0.0; // fraction of the length scale
  bool Orient = true;
  bool SplitNonManifold = true;
  double FillHoles = 0.0; // longest border, fraction of the length scale
  bool SplitCreases = true;
  double CreaseAngle = 40.0; // degrees
};

/// What was found and done.
struct SurfacePreparationCounts
{
  vtkIdType DroppedCells = 0;        ///< vertices and lines
  vtkIdType TriangulatedCells = 0;   ///< polygons of more than three corners, and strips
  vtkIdType NonFiniteTriangles = 0;  ///< dropped for a NaN or infinite (or missing) point
  vtkIdType WeldedPoints = 0;        ///< that became one with an earlier one
  vtkIdType UnusedPoints = 0;        ///< dropped because no triangle was left that needs them
  vtkIdType DegenerateTriangles = 0; ///< dropped for having no area
  vtkIdType FlippedNeedles = 0;      ///< zero-area triangles between others, kept by an edge flip
  vtkIdType CrackEdges = 0;          ///< boundary edges split where points of others lie on them
  vtkIdType DuplicateTriangles = 0;  ///< dropped for having the points of another one
  vtkIdType FoldTriangles = 0;       ///< dropped with the one that faces the other way
  vtkIdType ReorientedTriangles = 0; ///< turned over
  vtkIdType NonManifoldEdges = 0;    ///< edges with more than two triangles
  vtkIdType NonManifoldPoints = 0;   ///< with several fans of triangles, at none of those edges
  vtkIdType NonOrientableEdges = 0;  ///< edges whose triangles can not be made to agree
  vtkIdType NonManifoldSplitPoints = 0; ///< copies of points made for all these
  vtkIdType BoundaryEdges = 0;          ///< edges with one triangle, before splits and fillings
  vtkIdType MendedFoldovers = 0;        ///< edges flipped to lay triangles back
  vtkIdType LeftFoldovers = 0;          ///< triangles still folded over all their neighbours
  vtkIdType FilledHoles = 0;            ///< closed
  vtkIdType FillingTriangles = 0;       ///< that did it
  vtkIdType OpenHoles = 0;              ///< short enough to be filled, but it would have done harm
  vtkIdType CreaseEdges = 0;            ///< edges that the mesh was split along
  vtkIdType SplitPoints = 0;            ///< copies of points made for that
};

struct PreparedSurface
{
  std::vector<TriangleMesh::Triangle> Triangles;
  std::vector<vtkIdType> SourceCells;  ///< for each triangle, the input's cell
  std::vector<vtkIdType> SourcePoints; ///< for each point, the input's point
  std::vector<TriangleMesh::Index> WeldedPointIds;
  double LengthScale = 0.0;
  SurfacePreparationCounts Counts;
};

/// An empty surface if `progress` says that it should end.
VTKNPRFILTERSSURFACES_EXPORT PreparedSurface PrepareSurface(vtkPolyData* input,
  const SurfacePreparationOptions& options, const Progress& progress = IgnoreProgress);
}

#endif
