// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprHoles.h
 * @brief Closes small holes of a triangle mesh.
 */
#ifndef nprHoles_h
#define nprHoles_h

#include "nprTriangleMesh.h"
#include "vtkNPRFiltersSurfacesModule.h"

#include <vector>

namespace npr
{
struct HoleFilling
{
  std::vector<TriangleMesh::Triangle> Triangles; ///< to be added to those of the mesh
  std::vector<TriangleMesh::Index> Neighbours;   ///< for each, a triangle at the border beside it
  vtkIdType FilledHoles = 0;
  vtkIdType OpenHoles = 0; ///< short enough, but not to be filled without harm
};

/**
 * Triangulates the holes whose borders are at most so long (needs the neighbours). No points are
 * added.
 *
 * Each border is triangulated by dynamic programming over its sub-polygons, as in Barequet and
 * Sharir, "Filling gaps in the boundary of a polyhedron", CAGD 12, 1995, and Liepa, "Filling Holes
 * in Meshes", SGP 2003: first of all the surface shall not bend sharply at any edge, those of the
 * border included (in steps of about 40 degrees), and of all such triangulations the one is taken
 * whose edges have the least sum of squares, which makes compact triangles.
 *
 * A border that passes through a point several times is several holes.
 *
 * Left open are borders of more than 400 edges, those that could only be closed by triangles
 * without area, by an edge that is there already, or by folding the surface back by more than 120
 * degrees, and those whose filling would have at least half the area of the component they bound:
 * they are the outline of a sheet and not a hole in one.
 *
 * @param maximumLength of the border
 */
VTKNPRFILTERSSURFACES_EXPORT HoleFilling FillHoles(const TriangleMesh& mesh, double maximumLength);
}

#endif
