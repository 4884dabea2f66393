// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfaceDecimation.h"

#include <vtkMath.h>

#include <OpenMesh/Core/Geometry/QuadricT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>

#include <algorithm>
#include <cmath>

namespace npr
{
namespace
{
using OpenMesh::Vec3d;

constexpr double LargestTurn = 60.0; // degrees, of a triangle in one collapse

//------------------------------------------------------------------------------
/// The priority of a collapse. OpenMesh's own quadrics know no borders, and refuse what is flat
/// where rounding makes its error negative.
template<typename MeshT>
class ShapeError : public OpenMesh::Decimater::ModBaseT<MeshT>
{
public:
  DECIMATING_MODULE(ShapeError, MeshT, ShapeError);

  explicit ShapeError(MeshT& mesh) : Base(mesh, false) { mesh.add_property(this->Quadrics); }
  ~ShapeError() override { Base::mesh().remove_property(this->Quadrics); }

  void initialize() override
  {
    MeshT& mesh = Base::mesh();
    for (const auto vertex : mesh.vertices())
    {
      mesh.property(this->Quadrics, vertex).clear();
    }
    for (const auto face : mesh.faces())
    {
      const Vec3d cross = GetAreaNormal(face);
      const double length = cross.norm();
      if (length > 0.0)
      {
        const auto h = mesh.halfedge_handle(face);
        const Quadric quadric = MakePlane(cross / length, mesh.point(mesh.to_vertex_handle(h)));
        for (const auto corner : mesh.fv_range(face))
        {
          mesh.property(this->Quadrics, corner) += quadric * (0.5 * length);
        }
      }
    }
    for (const auto h : mesh.halfedges())
    {
      if (mesh.is_boundary(h))
      {
        this->AddBorder(h);
      }
    }
  }

  float collapse_priority(const CollapseInfo& info) override
  {
    // The sum of both quadrics at the end that stays, less what that end has cost already. So it
    // does not change with what the other end takes over, of which OpenMesh tells only some of the
    // neighbours.
    const double error = Base::mesh().property(this->Quadrics, info.v0)(info.p1);
    // Far below the error of a bend that matters, so it only orders collapses that cost nothing.
    constexpr double ShortFirst = 1e-9;
    const double squaredLength = (info.p1 - info.p0).sqrnorm();
    return static_cast<float>(std::max(0.0, error) + ShortFirst * squaredLength * squaredLength);
  }

  void postprocess_collapse(const CollapseInfo& info) override
  {
    MeshT& mesh = Base::mesh();
    mesh.property(this->Quadrics, info.v1) += mesh.property(this->Quadrics, info.v0);
  }

private:
  using Quadric = OpenMesh::Geometry::Quadricd;

  static Quadric MakePlane(const Vec3d& normal, const Vec3d& point)
  {
    return Quadric(normal[0], normal[1], normal[2], -OpenMesh::dot(normal, point));
  }

  /// As long as twice the area.
  Vec3d GetAreaNormal(typename MeshT::FaceHandle face)
  {
    MeshT& mesh = Base::mesh();
    const auto h = mesh.halfedge_handle(face);
    return OpenMesh::cross(
      mesh.calc_edge_vector(h), mesh.calc_edge_vector(mesh.next_halfedge_handle(h)));
  }

  /// A plane through the edge, across its triangle.
  void AddBorder(typename MeshT::HalfedgeHandle h)
  {
    MeshT& mesh = Base::mesh();
    const Vec3d edge = mesh.calc_edge_vector(h);
    const Vec3d across = OpenMesh::cross(
      edge, this->GetAreaNormal(mesh.face_handle(mesh.opposite_halfedge_handle(h))));
    const double length = across.norm();
    if (length > 0.0)
    {
      const Quadric quadric =
        MakePlane(across / length, mesh.point(mesh.to_vertex_handle(h))) * edge.sqrnorm();
      mesh.property(this->Quadrics, mesh.to_vertex_handle(h)) += quadric;
      mesh.property(this->Quadrics, mesh.from_vertex_handle(h)) += quadric;
    }
  }

  OpenMesh::VPropHandleT<Quadric> Quadrics;
};

//------------------------------------------------------------------------------
/// Refuses what makes angles too small. (OpenMesh's bound of the aspect ratio compares with that
/// before an earlier collapse.)
template<typename MeshT>
class AngleBound : public OpenMesh::Decimater::ModBaseT<MeshT>
{
public:
  DECIMATING_MODULE(AngleBound, MeshT, AngleBound);

  explicit AngleBound(MeshT& mesh) : Base(mesh, true) {}

  void SetMinimumAngle(double radians) { this->LargestCosine = std::cos(radians); }

  float collapse_priority(const CollapseInfo& info) override
  {
    MeshT& mesh = Base::mesh();
    double before = -1.0;
    double after = -1.0;
    for (const auto h : mesh.voh_range(info.v0))
    {
      if (!mesh.is_boundary(h))
      {
        const auto v1 = mesh.to_vertex_handle(h);
        const auto v2 = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
        before = std::max(before, GetLargestCosine(info.p0, mesh.point(v1), mesh.point(v2)));
        if (v1 != info.v1 && v2 != info.v1)
        {
          after = std::max(after, GetLargestCosine(info.p1, mesh.point(v1), mesh.point(v2)));
        }
      }
    }
    return after <= std::max(before, this->LargestCosine) ? float(Base::LEGAL_COLLAPSE)
                                                          : float(Base::ILLEGAL_COLLAPSE);
  }

private:
  /// Of the three angles of a triangle; 1 without an area.
  static double GetLargestCosine(const Vec3d& a, const Vec3d& b, const Vec3d& c)
  {
    const Vec3d sides[3] = { b - a, c - b, a - c };
    double largest = -1.0;
    for (int i = 0; i < 3; ++i)
    {
      const Vec3d& u = sides[i];
      const Vec3d& v = sides[(i + 1) % 3];
      const double lengths = std::sqrt(u.sqrnorm() * v.sqrnorm());
      largest = std::max(largest, lengths > 0.0 ? -OpenMesh::dot(u, v) / lengths : 1.0);
    }
    return largest;
  }

  double LargestCosine = 1.0;
};

//------------------------------------------------------------------------------
class ProgressObserver : public OpenMesh::Decimater::Observer
{
public:
  ProgressObserver(const Progress& progress, std::size_t collapses)
    : Observer(std::max<std::size_t>(1, std::min<std::size_t>(collapses / 50, 10000))),
      Report(progress), Collapses(collapses)
  {
  }
  void notify(std::size_t done) override
  {
    this->IsEnded = !this->Report(std::min(1.0, static_cast<double>(done) / this->Collapses));
  }
  bool abort() const override { return this->IsEnded; }

private:
  const Progress& Report;
  std::size_t Collapses;
  bool IsEnded = false;
};
}

//------------------------------------------------------------------------------
void DecimateSurface(
  HalfEdgeMesh& mesh, const SurfaceDecimationOptions& options, const Progress& progress)
{
  mesh.request_face_normals();
  mesh.update_face_normals();
  {
    OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(mesh);
    ShapeError<HalfEdgeMesh>::Handle error;
    decimater.add(error);
    OpenMesh::Decimater::ModNormalFlippingT<HalfEdgeMesh>::Handle flipping;
    decimater.add(flipping);
    decimater.module(flipping).set_max_normal_deviation(LargestTurn);
    AngleBound<HalfEdgeMesh>::Handle angles;
    decimater.add(angles);
    decimater.module(angles).SetMinimumAngle(vtkMath::RadiansFromDegrees(options.MinimumAngle));
    OpenMesh::Decimater::ModHausdorffT<HalfEdgeMesh>::Handle distance;
    if (options.MaximumError > 0.0)
    {
      decimater.add(distance);
      decimater.module(distance).set_tolerance(options.MaximumError);
    }
    const std::size_t excess = mesh.n_faces() - std::min(mesh.n_faces(), options.NumberOfTriangles);
    ProgressObserver observer(progress, excess / 2 + 1);
    decimater.set_observer(&observer);
    decimater.initialize();
    decimater.decimate_to_faces(0, options.NumberOfTriangles);
  }
  mesh.release_face_normals();
}
}
