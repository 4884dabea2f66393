// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef nprHidingSurfaces_h
#define nprHidingSurfaces_h

#include "nprRayTracer.h"
#include "nprTriangleMesh.h"
#include "nprVTKCompat.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace npr
{
/**
 * @class HidingSurfaces
 * @brief All triangles that can hide something, in the world, with what no view changes of them:
 * their adjacency and the hierarchy for rays.
 *
 * Points are floats relative to Centre, of all surfaces together. The adjacency runs within one
 * surface only, and over creases where its points were split (WeldedPointIds).
 */
class HidingSurfaces
{
public:
  using Index = TriangleMesh::Index;

  struct Surface
  {
    vtkPolyData* Data = nullptr;
    Eigen::Matrix4d ToWorld = Eigen::Matrix4d::Identity();
  };
  explicit HidingSurfaces(const std::vector<Surface>& surfaces);

  bool IsEmpty() const { return this->Triangles.empty(); }
  Index GetNumberOfTriangles() const { return static_cast<Index>(this->Triangles.size()); }
  const TriangleMesh::Triangle& GetTriangle(Index triangle) const
  {
    return this->Triangles[triangle];
  }
  Eigen::Vector3d GetPoint(Index point) const { return this->Points[point].cast<double>(); }
  Eigen::Vector3d GetCorner(Index triangle, int corner) const
  {
    return this->GetPoint(this->Triangles[triangle][corner]);
  }
  /// As long as twice the area.
  Eigen::Vector3d GetAreaNormal(Index triangle) const;
  /// The triangle across edge e, or TriangleMesh::Boundary or NonManifold.
  Index GetNeighbour(Index triangle, int edge) const { return this->Neighbours[triangle][edge]; }
  /// Whether the triangle across edge e has the same side in front.
  bool IsAlike(Index triangle, int edge) const
  {
    return this->IsOriented || this->CompareOrientation(triangle, edge);
  }

  /// How far a triangle may be from the smooth surface: its cell array ChordError, or else as the
  /// point array Normals says. 0 without them.
  double GetChordError(Index triangle) const { return this->ChordErrors[triangle]; }
  double GetLargestChordError() const { return this->LargestChordError; }
  /// The same for all triangles that are connected by edges.
  Index GetBody(Index triangle) const { return this->Bodies[triangle]; }

  const RayTracer& GetTracer() const { return *this->Tracer; }
  /// What is subtracted from places in the world.
  const Eigen::Vector3d& GetCentre() const { return this->Centre; }
  /// How far apart places can be that single precision does not tell apart, with some margin.
  double GetTolerance() const { return this->Tolerance; }
  double GetLongestEdge() const { return this->LongestEdge; }
  /// The farthest that a point is from the centre.
  double GetRadius() const { return this->Radius; }

private:
  void Append(const TriangleMesh& mesh, const Eigen::Matrix4d& toWorld);
  bool CompareOrientation(Index triangle, int edge) const;
  void Measure();
  void FindBodies();

  std::vector<Eigen::Vector3f> Points; // and one more, for the tracer
  std::vector<TriangleMesh::Triangle> Triangles;
  std::vector<TriangleMesh::Triangle> Neighbours;
  std::vector<float> ChordErrors;
  std::vector<Index> Bodies;
  Eigen::Vector3d Centre = Eigen::Vector3d::Zero();
  double Radius = 0.0;
  double Tolerance = 0.0;
  double LongestEdge = 0.0;
  double LargestChordError = 0.0;
  bool IsOriented = true;
  std::unique_ptr<RayTracer> Tracer;
};
}

#endif
