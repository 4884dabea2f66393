// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfaceDecimation.h"

#include <vtkMath.h>
#include <vtkType.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

namespace npr
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Edge = HalfEdgeMesh::EdgeHandle;
using Face = HalfEdgeMesh::FaceHandle;
using HalfEdge = HalfEdgeMesh::HalfedgeHandle;
using Vertex = HalfEdgeMesh::VertexHandle;

// Of 60 degrees, by which a triangle may turn in one collapse: at 90 they fold.
constexpr double LeastTurnCosine = 0.5;

// Times the trace of a quadric: what draws its minimum to the middle of the edge. Where the surface
// bends by an angle a across the edge, the quadric itself has a^2.
constexpr double CentreWeight = 1e-3;

Vector3d GetPoint(const HalfEdgeMesh& mesh, Vertex vertex)
{
  return Eigen::Map<const Vector3d>(mesh.point(vertex).data());
}

//------------------------------------------------------------------------------
/// The weighted sum of squared distances from planes.
struct Quadric
{
  Matrix3d Squares = Matrix3d::Zero();
  Vector3d Linear = Vector3d::Zero();
  double Constant = 0.0;

  void AddPlane(const Vector3d& unitNormal, const Vector3d& point, double weight)
  {
    const double offset = -unitNormal.dot(point);
    this->Squares += weight * unitNormal * unitNormal.transpose();
    this->Linear += weight * offset * unitNormal;
    this->Constant += weight * offset * offset;
  }
  Quadric& operator+=(const Quadric& other)
  {
    this->Squares += other.Squares;
    this->Linear += other.Linear;
    this->Constant += other.Constant;
    return *this;
  }
  double GetError(const Vector3d& p) const
  {
    return std::max(0.0, p.dot(this->Squares * p + 2.0 * this->Linear) + this->Constant);
  }
  /// Where it is least; near a point where it does not care.
  Vector3d GetMinimum(const Vector3d& near) const
  {
    const Matrix3d squares =
      this->Squares + CentreWeight * this->Squares.trace() * Matrix3d::Identity();
    return near - squares.ldlt().solve(this->Squares * near + this->Linear);
  }
};

//------------------------------------------------------------------------------
/// Of the three angles of a triangle; 1 without an area.
double GetLargestCosine(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  const Vector3d sides[3] = { b - a, c - b, a - c };
  double largest = -1.0;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3d& u = sides[i];
    const Vector3d& v = sides[(i + 1) % 3];
    const double lengths = std::sqrt(u.squaredNorm() * v.squaredNorm());
    largest = std::max(largest, lengths > 0.0 ? -u.dot(v) / lengths : 1.0);
  }
  return largest;
}

//------------------------------------------------------------------------------
double GetSquaredDistance(const Vector3d& p, const Vector3d& a, const Vector3d& b)
{
  const Vector3d edge = b - a;
  const double length = edge.squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(edge) / length, 0.0, 1.0) : 0.0;
  return (a + t * edge - p).squaredNorm();
}

double GetSquaredDistance(
  const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  const Vector3d normal = (b - a).cross(c - a);
  if (normal.dot((b - a).cross(p - a)) > 0.0 && normal.dot((c - b).cross(p - b)) > 0.0 &&
    normal.dot((a - c).cross(p - c)) > 0.0)
  {
    const double height = normal.dot(p - a);
    return height * height / normal.squaredNorm();
  }
  return std::min(
    { GetSquaredDistance(p, a, b), GetSquaredDistance(p, b, c), GetSquaredDistance(p, c, a) });
}

//------------------------------------------------------------------------------
class Decimation
{
public:
  Decimation(HalfEdgeMesh& mesh, const SurfaceDecimationOptions& options)
    : Mesh(mesh), LargestCosine(std::cos(vtkMath::RadiansFromDegrees(options.MinimumAngle))),
      SquaredTolerance(options.MaximumError * options.MaximumError), Quadrics(mesh.n_vertices()),
      Entries(mesh.n_edges())
  {
    for (const Face face : mesh.faces())
    {
      this->AddFace(face);
    }
    for (const HalfEdge h : mesh.halfedges())
    {
      if (mesh.is_boundary(h))
      {
        this->AddBorder(h);
      }
    }
    if (options.MaximumError > 0.0)
    {
      this->FacePoints.resize(mesh.n_faces());
      for (const Vertex vertex : mesh.vertices())
      {
        this->Original.push_back(GetPoint(mesh, vertex));
      }
    }
    for (const Edge edge : mesh.edges())
    {
      this->Rate(edge);
    }
  }

  std::vector<PointMerge> Run(std::size_t numberOfTriangles, const Progress& progress)
  {
    std::vector<PointMerge> merges;
    const std::size_t all = this->Mesh.n_faces();
    const std::size_t excess = all - std::min(all, numberOfTriangles);
    std::size_t excessLeft = excess;
    std::size_t steps = 0;
    while (excessLeft > 0 && !this->Heap.empty())
    {
      if (++steps % 1000 == 0 && !progress(1.0 - static_cast<double>(excessLeft) / excess))
      {
        break;
      }
      const HeapEntry top = this->Heap.top();
      this->Heap.pop();
      Entry& entry = this->Entries[top.Edge.idx()];
      if (top.Stamp != entry.Stamp)
      {
        continue;
      }
      Collapse collapse;
      if (!this->FindCollapse(top.Edge, collapse))
      {
        entry.IsRefused = true;
        continue;
      }
      if (collapse.Cost > top.Cost)
      {
        // Only a worse place would do, and others may be cheaper than that.
        this->Heap.push({ collapse.Cost, top.Edge, top.Stamp });
        continue;
      }
      excessLeft -= std::min<std::size_t>(excessLeft, this->Mesh.is_boundary(top.Edge) ? 1 : 2);
      merges.push_back(this->Apply(collapse));
    }
    return merges;
  }

private:
  struct Entry
  {
    int Stamp = 0; ///< older ones in the heap are void
    bool IsRefused = false;
    float Cost = 0.0f;
  };
  struct HeapEntry
  {
    float Cost;
    HalfEdgeMesh::EdgeHandle Edge;
    int Stamp;
    /// The edge's number, so that the order is the same everywhere.
    bool operator<(const HeapEntry& other) const
    {
      return this->Cost != other.Cost ? this->Cost > other.Cost
                                      : this->Edge.idx() > other.Edge.idx();
    }
  };
  struct Collapse
  {
    HalfEdge Path; ///< from what goes to what is kept
    Vector3d Place;
    float Cost;
  };
  using Places = std::array<std::pair<double, Vector3d>, 4>; // with what they cost
  /// A triangle before a collapse, with the corner that would move.
  struct RingTriangle
  {
    Vector3d Moving;
    Vector3d Second;
    Vector3d Third;
    Face Number;
    bool IsKept; ///< does not lie at the edge
  };

  void AddFace(Face face)
  {
    const HalfEdge h = this->Mesh.halfedge_handle(face);
    const Vector3d normal = this->GetAreaNormal(h);
    const double length = normal.norm();
    if (length > 0.0)
    {
      Quadric quadric;
      quadric.AddPlane(
        normal / length, GetPoint(this->Mesh, this->Mesh.to_vertex_handle(h)), 0.5 * length);
      for (const Vertex corner : this->Mesh.fv_range(face))
      {
        this->Quadrics[corner.idx()] += quadric;
      }
    }
  }

  /// A plane through the edge, across its triangle.
  void AddBorder(HalfEdge h)
  {
    const Vector3d begin = GetPoint(this->Mesh, this->Mesh.from_vertex_handle(h));
    const Vector3d edge = GetPoint(this->Mesh, this->Mesh.to_vertex_handle(h)) - begin;
    const Vector3d across = edge.cross(this->GetAreaNormal(this->Mesh.opposite_halfedge_handle(h)));
    const double length = across.norm();
    if (length > 0.0)
    {
      Quadric quadric;
      quadric.AddPlane(across / length, begin, edge.squaredNorm());
      this->Quadrics[this->Mesh.to_vertex_handle(h).idx()] += quadric;
      this->Quadrics[this->Mesh.from_vertex_handle(h).idx()] += quadric;
    }
  }

  /// As long as twice the area.
  Vector3d GetAreaNormal(HalfEdge h) const
  {
    const Vector3d a = GetPoint(this->Mesh, this->Mesh.from_vertex_handle(h));
    const Vector3d b = GetPoint(this->Mesh, this->Mesh.to_vertex_handle(h));
    const Vector3d c =
      GetPoint(this->Mesh, this->Mesh.to_vertex_handle(this->Mesh.next_halfedge_handle(h)));
    return (b - a).cross(c - a);
  }

  /// The direction that keeps the end that must not move; invalid if both must not.
  HalfEdge GetPath(Edge edge) const
  {
    HalfEdge path = this->Mesh.halfedge_handle(edge, 0);
    Vertex gone = this->Mesh.from_vertex_handle(path);
    Vertex kept = this->Mesh.to_vertex_handle(path);
    const auto getRank = [this](Vertex vertex)
    { return (this->IsLocked(vertex) ? 2 : 0) + (this->Mesh.is_boundary(vertex) ? 1 : 0); };
    if (getRank(gone) > getRank(kept))
    {
      std::swap(gone, kept);
      path = this->Mesh.opposite_halfedge_handle(path);
    }
    const bool leavesBorder = this->Mesh.is_boundary(gone) && !this->Mesh.is_boundary(edge);
    return this->IsLocked(gone) || leavesBorder ? HalfEdge() : path;
  }

  bool IsLocked(Vertex vertex) const { return this->Mesh.status(vertex).locked(); }

  /// Whether only the place of what is kept can be the place of both.
  bool IsFixed(HalfEdge path) const
  {
    const Vertex kept = this->Mesh.to_vertex_handle(path);
    return this->IsLocked(kept) ||
      (this->Mesh.is_boundary(kept) &&
        !this->Mesh.is_boundary(this->Mesh.from_vertex_handle(path)));
  }

  /// The places to try, the cheapest first. Returns how many.
  int GetPlaces(HalfEdge path, Places& places) const
  {
    const Vertex gone = this->Mesh.from_vertex_handle(path);
    const Vertex kept = this->Mesh.to_vertex_handle(path);
    const Vector3d a = GetPoint(this->Mesh, gone);
    const Vector3d b = GetPoint(this->Mesh, kept);
    Quadric quadric = this->Quadrics[gone.idx()];
    quadric += this->Quadrics[kept.idx()];
    const double squaredLength = (b - a).squaredNorm();
    // Far below the error of a bend that matters, so it only orders collapses that cost nothing.
    const double shortFirst = 1e-9 * squaredLength * squaredLength;
    if (this->IsFixed(path))
    {
      places[0] = { quadric.GetError(b) + shortFirst, b };
      return 1;
    }
    const Vector3d middle = 0.5 * (a + b);
    const Vector3d best = quadric.GetMinimum(middle);
    // Rounding must not decide between places that are as good: the first wins.
    const double noise = 1e-13 * quadric.Squares.trace() * squaredLength;
    int number = 0;
    for (const Vector3d& place : { middle, b, a, best })
    {
      // What is far away comes from planes that are nearly the same.
      if (number < 3 || (best - middle).squaredNorm() <= 4.0 * squaredLength)
      {
        places[number] = { quadric.GetError(place) + noise * number + shortFirst, place };
        ++number;
      }
    }
    std::stable_sort(places.begin(), places.begin() + number,
      [](const auto& p, const auto& q) { return p.first < q.first; });
    return number;
  }

  void Rate(Edge edge)
  {
    Entry& entry = this->Entries[edge.idx()];
    ++entry.Stamp;
    entry.IsRefused = false;
    const HalfEdge path = this->GetPath(edge);
    if (!path.is_valid())
    {
      return;
    }
    Places places;
    this->GetPlaces(path, places);
    entry.Cost = static_cast<float>(places[0].first);
    this->Heap.push({ entry.Cost, edge, entry.Stamp });
  }

  void AddRing(Vertex vertex, Vertex other, std::vector<RingTriangle>& ring) const
  {
    const Vector3d point = GetPoint(this->Mesh, vertex);
    for (const HalfEdge h : this->Mesh.voh_range(vertex))
    {
      if (!this->Mesh.is_boundary(h))
      {
        const Vertex second = this->Mesh.to_vertex_handle(h);
        const Vertex third = this->Mesh.to_vertex_handle(this->Mesh.next_halfedge_handle(h));
        ring.push_back({ point, GetPoint(this->Mesh, second), GetPoint(this->Mesh, third),
          this->Mesh.face_handle(h), second != other && third != other });
      }
    }
  }

  bool FindCollapse(Edge edge, Collapse& collapse)
  {
    const HalfEdge path = this->GetPath(edge);
    // What OpenMesh does not refuse: of a tetrahedron there would be two triangles left, back to
    // back.
    if (!path.is_valid() || !this->Mesh.is_collapse_ok(path))
    {
      return false;
    }
    const Vertex gone = this->Mesh.from_vertex_handle(path);
    const Vertex kept = this->Mesh.to_vertex_handle(path);
    if (!this->Mesh.is_boundary(kept) && !this->Mesh.is_boundary(gone) &&
      this->Mesh.valence(kept) + this->Mesh.valence(gone) < 7)
    {
      return false;
    }
    this->Ring.clear();
    this->AddRing(gone, kept, this->Ring);
    this->AddRing(kept, gone, this->Ring);
    double largestCosine = this->LargestCosine;
    for (const RingTriangle& t : this->Ring)
    {
      largestCosine = std::max(largestCosine, GetLargestCosine(t.Moving, t.Second, t.Third));
    }
    if (!this->FacePoints.empty())
    {
      this->CollectPoints(path);
    }
    Places places;
    const int number = this->GetPlaces(path, places);
    for (int i = 0; i < number; ++i)
    {
      const Vector3d& place = places[i].second;
      if (this->IsGoodShape(place, largestCosine) && this->IsWithinTolerance(place))
      {
        collapse = { path, place, static_cast<float>(places[i].first) };
        return true;
      }
    }
    return false;
  }

  bool IsGoodShape(const Vector3d& place, double largestCosine) const
  {
    for (const RingTriangle& t : this->Ring)
    {
      if (!t.IsKept)
      {
        continue;
      }
      const Vector3d side = t.Third - t.Second;
      const Vector3d before = side.cross(t.Moving - t.Second);
      const Vector3d after = side.cross(place - t.Second);
      const double lengths = std::sqrt(before.squaredNorm() * after.squaredNorm());
      if ((before.squaredNorm() > 0.0 && before.dot(after) <= LeastTurnCosine * lengths) ||
        GetLargestCosine(place, t.Second, t.Third) > largestCosine)
      {
        return false;
      }
    }
    return true;
  }

  /// The points of the input that the triangles at both ends stand for.
  void CollectPoints(HalfEdge path)
  {
    this->Points.clear();
    for (const Vertex end :
      { this->Mesh.from_vertex_handle(path), this->Mesh.to_vertex_handle(path) })
    {
      if (GetPoint(this->Mesh, end) == this->Original[end.idx()])
      {
        this->Points.push_back(end.idx());
      }
    }
    for (const RingTriangle& t : this->Ring)
    {
      const std::vector<int>& points = this->FacePoints[t.Number.idx()];
      this->Points.insert(this->Points.end(), points.begin(), points.end());
    }
    std::sort(this->Points.begin(), this->Points.end());
    this->Points.erase(std::unique(this->Points.begin(), this->Points.end()), this->Points.end());
  }

  /// The triangle at the place that is nearest to a point.
  std::pair<double, Face> FindNearest(const Vector3d& point, const Vector3d& place) const
  {
    std::pair<double, Face> nearest{ VTK_DOUBLE_MAX, Face() };
    for (const RingTriangle& t : this->Ring)
    {
      if (t.IsKept)
      {
        const double distance = GetSquaredDistance(point, place, t.Second, t.Third);
        if (distance < nearest.first)
        {
          nearest = { distance, t.Number };
        }
      }
    }
    return nearest;
  }

  bool IsWithinTolerance(const Vector3d& place)
  {
    if (this->FacePoints.empty())
    {
      return true;
    }
    this->NearestFaces.clear();
    for (const int point : this->Points)
    {
      const auto nearest = this->FindNearest(this->Original[point], place);
      if (!(nearest.first <= this->SquaredTolerance))
      {
        return false;
      }
      this->NearestFaces.push_back(nearest.second);
    }
    return true;
  }

  PointMerge Apply(const Collapse& collapse)
  {
    const Vertex gone = this->Mesh.from_vertex_handle(collapse.Path);
    const Vertex kept = this->Mesh.to_vertex_handle(collapse.Path);
    const Vector3d from = GetPoint(this->Mesh, kept);
    const Vector3d edge = GetPoint(this->Mesh, gone) - from;
    const double length = edge.squaredNorm();
    const double share =
      length > 0.0 ? std::clamp(edge.dot(collapse.Place - from) / length, 0.0, 1.0) : 0.5;
    this->Quadrics[kept.idx()] += this->Quadrics[gone.idx()];
    this->Mesh.collapse(collapse.Path);
    this->Mesh.set_point(
      kept, OpenMesh::Vec3d(collapse.Place.x(), collapse.Place.y(), collapse.Place.z()));
    if (!this->FacePoints.empty())
    {
      for (const RingTriangle& t : this->Ring)
      {
        this->FacePoints[t.Number.idx()].clear();
      }
      for (std::size_t i = 0; i < this->Points.size(); ++i)
      {
        this->FacePoints[this->NearestFaces[i].idx()].push_back(this->Points[i]);
      }
    }
    for (const Edge changed : this->Mesh.ve_range(kept))
    {
      this->Rate(changed);
    }
    // What was refused beside it may now be possible.
    for (const Vertex neighbour : this->Mesh.vv_range(kept))
    {
      for (const Edge beside : this->Mesh.ve_range(neighbour))
      {
        Entry& entry = this->Entries[beside.idx()];
        if (entry.IsRefused)
        {
          entry.IsRefused = false;
          this->Heap.push({ entry.Cost, beside, entry.Stamp });
        }
      }
    }
    return { kept.idx(), gone.idx(), share };
  }

  HalfEdgeMesh& Mesh;
  const double LargestCosine;
  const double SquaredTolerance;
  std::vector<Quadric> Quadrics;            // of vertices
  std::vector<Entry> Entries;               // of edges
  std::vector<Vector3d> Original;           // of vertices
  std::vector<std::vector<int>> FacePoints; // that are no vertices now; empty without a bound
  std::priority_queue<HeapEntry> Heap;
  // Of the collapse that is looked at; kept for their memory.
  std::vector<RingTriangle> Ring;
  std::vector<int> Points;
  std::vector<Face> NearestFaces;
};
}

//------------------------------------------------------------------------------
std::vector<PointMerge> DecimateSurface(
  HalfEdgeMesh& mesh, const SurfaceDecimationOptions& options, const Progress& progress)
{
  return Decimation(mesh, options).Run(options.NumberOfTriangles, progress);
}
}
