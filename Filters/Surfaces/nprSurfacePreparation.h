// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprSurfacePreparation.h
 * @brief From whatever polygons come to a clean, oriented mesh of triangles in smooth patches.
 */
#ifndef nprSurfacePreparation_h
#define nprSurfacePreparation_h

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
  double WeldTolerance = 0.0; // length
  bool Orient = true;
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
  vtkIdType DuplicateTriangles = 0;  ///< dropped for having the points of an earlier one
  vtkIdType ReorientedTriangles = 0; ///< turned over
  vtkIdType NonManifoldEdges = 0;    ///< edges with more than two triangles
  vtkIdType BoundaryEdges = 0;       ///< edges with one triangle
  vtkIdType CreaseEdges = 0;         ///< edges that the mesh was split along
  vtkIdType SplitPoints = 0;         ///< copies of points made for that
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

VTKNPRFILTERSSURFACES_EXPORT PreparedSurface PrepareSurface(
  vtkPolyData* input, const SurfacePreparationOptions& options);

/// Turns triangles over until neighbours agree and closed components have their normals outside;
/// open ones keep the side of most of their triangles (needs the neighbours). Returns how many it
/// turned.
VTKNPRFILTERSSURFACES_EXPORT vtkIdType OrientTriangles(TriangleMesh& mesh);
}

#endif
