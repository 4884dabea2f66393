// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprOrderedMesh_h
#define nprOrderedMesh_h

#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"

#include <vector>

namespace npr
{
/// A mesh whose points stand in memory as they lie in space: where a scanner's order is none, the
/// search for neighbours takes half the time. Its incidence is built.
struct OrderedMesh
{
  OrderedMesh(const TriangleMesh& mesh, const Tuples<3>& normals);

  /// What its points are in the mesh.
  std::vector<vtkIdType> Points;
  TriangleMesh Mesh;
  Tuples<3> Normals;
};
}

#endif
