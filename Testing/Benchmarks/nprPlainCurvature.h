// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprPlainCurvature.h
 * @brief Curvature as one writes it down from the paper: the yardstick of the benchmark.
 *
 * S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004,
 * with the normals of Max 1999 and the mixed Voronoi areas of Meyer et al. 2003: one thread, single
 * precision, loops over the triangles that add to their corners. It shares no code with the
 * library, so it also checks it.
 */
#ifndef nprPlainCurvature_h
#define nprPlainCurvature_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace nprbench
{
struct PlainMesh
{
  using Vector = Eigen::Vector3f;
  using Triangle = std::array<int, 3>;

  std::vector<Vector> Points;
  std::vector<Triangle> Triangles;

  std::vector<Vector> Normals;
  std::vector<std::vector<int>> AdjacentTriangles; // of a point
  std::vector<Triangle> Neighbours;                // across the edge opposite each corner, or -1
  std::vector<float> PointAreas;
  std::vector<std::array<float, 3>> CornerAreas;
  std::vector<float> K1;
  std::vector<float> K2;
  std::vector<Vector> E1;
  std::vector<Vector> E2;
  std::vector<std::array<float, 4>> Derivatives; // P, Q, S, T

  /// @name The steps, each of which needs those before it
  ///@{
  void ComputeNormals();
  void ComputeAdjacency();
  void ComputeAreas();
  void ComputeCurvature();
  void ComputeDerivatives();
  ///@}

  /// Gives the memory of all results back.
  void Clear();
};
}

#endif
