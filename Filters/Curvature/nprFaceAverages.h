// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprFaceAverages_h
#define nprFaceAverages_h

#include "nprTriangleMesh.h"
#include "nprTupleArrays.h"

#include <Eigen/Core>

#include <vector>

namespace npr
{
/**
 * @class FaceAverages
 * @brief Forms at the points of a mesh as the means of those that fit its triangles best.
 *
 * S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004: in
 * each triangle the least squares solution of form (edge) = difference of what the form is the
 * derivative of; at a point their mean, weighted by the point's share of the area, each turned into
 * its tangent plane about the line where the planes meet. The fits stand in nprFaceFits.h.
 *
 * Each triangle writes down what it adds to its corners, weighted and turned; each point then adds
 * up what it finds, always in the order of the triangles. So the result does not depend on threads.
 *
 * Forms refer to MakeTangent(normal), lengths to the unit of the mesh.
 */
class FaceAverages
{
public:
  using Index = TriangleMesh::Index;

  /// The mesh needs its incidence. Both must outlive this.
  FaceAverages(const TriangleMesh& mesh, const Tuples<3>& normals);

  /// The second fundamental forms: the area that the mean was taken over (zero where nothing is
  /// known, as the rest is then), and a QuadraticForm.
  Tuples<4> AverageForms();

  /**
   * Their derivatives, from what AverageForms() gives: each a CubicForm.
   *
   * The forms at a border are one-sided, and their error there does not shrink faster than the
   * differences; so triangles at a border count only where there are no others, and a border point
   * takes what its inner neighbours have.
   */
  Tuples<4> AverageDerivatives(const Tuples<4>& forms);

private:
  void FitForms();
  void FitDerivatives(const Tuples<4>& forms, const std::vector<unsigned char>& border);
  Eigen::Vector4f AddUp(Index point) const;
  bool Average(Index point, bool touchingBorder, Eigen::Vector4f& mean) const;
  bool Extend(Index point, const Tuples<4>& values, const std::vector<unsigned char>& known,
    Eigen::Vector4f& mean) const;
  void FillBorder(
    std::vector<Index> open, std::vector<unsigned char>& known, Tuples<4>& values) const;

  const TriangleMesh& Mesh;
  const Tuples<3>& Normals;
  Tuples<4> Parts; // what a triangle adds to its corners, three for each
  std::vector<unsigned char> TouchesBorder;
};
}

#endif
