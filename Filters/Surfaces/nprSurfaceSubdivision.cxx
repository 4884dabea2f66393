// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfaceSubdivision.h"

#include <vtkMath.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Vertex = HalfEdgeMesh::VertexHandle;
using HalfEdge = HalfEdgeMesh::HalfedgeHandle;

//------------------------------------------------------------------------------
class Subdivision
{
public:
  Subdivision(
    const HalfEdgeMesh& mesh, const std::vector<Index>& weldedPointIds, SubdivisionStep& step)
    : Mesh(mesh), WeldedPointIds(weldedPointIds), Step(step)
  {
    this->FindCorners();
  }

  void AddLoopPoints()
  {
    for (const Vertex v : this->Mesh.vertices())
    {
      this->AddLoopPoint(v);
    }
    for (const auto edge : this->Mesh.edges())
    {
      const HalfEdge h = this->Mesh.halfedge_handle(edge, 0);
      const bool isBorder = this->Mesh.is_boundary(edge);
      this->Add(this->Mesh.from_vertex_handle(h), isBorder ? 0.5 : 0.375);
      this->Add(this->Mesh.to_vertex_handle(h), isBorder ? 0.5 : 0.375);
      if (!isBorder)
      {
        this->Add(this->GetApex(h), 0.125);
        this->Add(this->GetApex(this->Mesh.opposite_halfedge_handle(h)), 0.125);
      }
      this->Step.Stencils.Close();
    }
  }

  void AddButterflyPoints()
  {
    for (const Vertex v : this->Mesh.vertices())
    {
      this->Add(v, 1.0);
      this->Step.Stencils.Close();
    }
    for (const auto edge : this->Mesh.edges())
    {
      this->AddButterflyMidpoint(this->Mesh.halfedge_handle(edge, 0));
      this->Step.Stencils.Close();
    }
  }

  void AddTriangles()
  {
    const Index size = static_cast<Index>(this->Mesh.n_vertices());
    this->Step.Triangles.reserve(4 * this->Mesh.n_faces());
    for (const auto face : this->Mesh.faces())
    {
      // Each corner with the midpoint of the edge that leaves it.
      std::array<Index, 3> c;
      std::array<Index, 3> m;
      HalfEdge h = this->Mesh.halfedge_handle(face);
      for (int i = 0; i < 3; ++i, h = this->Mesh.next_halfedge_handle(h))
      {
        c[i] = this->Mesh.from_vertex_handle(h).idx();
        m[i] = size + this->Mesh.edge_handle(h).idx();
      }
      this->Step.Triangles.insert(this->Step.Triangles.end(),
        { { c[0], m[0], m[2] }, { m[0], c[1], m[1] }, { m[2], m[1], c[2] }, { m[0], m[1], m[2] } });
    }
  }

  void WeldMidpoints()
  {
    const Index size = static_cast<Index>(this->Mesh.n_vertices());
    this->Step.WeldedPointIds = this->WeldedPointIds;
    this->Step.WeldedPointIds.reserve(size + this->Mesh.n_edges());
    std::vector<std::array<Index, 3>> borders; // the ends' first copies, and the midpoint
    for (const auto edge : this->Mesh.edges())
    {
      const Index midpoint = size + edge.idx();
      this->Step.WeldedPointIds.push_back(midpoint);
      if (this->Mesh.is_boundary(edge))
      {
        const HalfEdge h = this->Mesh.halfedge_handle(edge, 0);
        const auto ends = std::minmax({ this->GetFirst(this->Mesh.from_vertex_handle(h)),
          this->GetFirst(this->Mesh.to_vertex_handle(h)) });
        borders.push_back({ ends.first, ends.second, midpoint });
      }
    }
    std::sort(borders.begin(), borders.end());
    for (std::size_t i = 1; i < borders.size(); ++i)
    {
      if (borders[i][0] == borders[i - 1][0] && borders[i][1] == borders[i - 1][1])
      {
        this->Step.WeldedPointIds[borders[i][2]] = this->Step.WeldedPointIds[borders[i - 1][2]];
      }
    }
  }

private:
  Index GetFirst(Vertex v) const { return this->WeldedPointIds[v.idx()]; }
  void Add(Vertex v, double weight) { this->Step.Stencils.Add(v.idx(), weight); }
  /// The corner opposite a half edge, in its triangle.
  Vertex GetApex(HalfEdge h) const
  {
    return this->Mesh.to_vertex_handle(this->Mesh.next_halfedge_handle(h));
  }
  /// The neighbours along the border of a point on it.
  std::array<Vertex, 2> GetBorderNeighbours(Vertex v) const
  {
    const HalfEdge h = this->Mesh.halfedge_handle(v); // OpenMesh keeps it on the border
    return { this->Mesh.to_vertex_handle(h),
      this->Mesh.from_vertex_handle(this->Mesh.prev_halfedge_handle(h)) };
  }

  /// A point of the border is no corner if its copies, all of them on borders, have the same two
  /// neighbours.
  void FindCorners()
  {
    const std::size_t size = this->Mesh.n_vertices();
    using Pair = std::array<Index, 2>;
    constexpr Pair None{ -1, -1 };
    std::vector<Pair> pairs(size, None);
    for (const Vertex v : this->Mesh.vertices())
    {
      if (!this->Mesh.is_isolated(v) && this->Mesh.is_boundary(v))
      {
        const auto ends = this->GetBorderNeighbours(v);
        const auto sorted = std::minmax({ this->GetFirst(ends[0]), this->GetFirst(ends[1]) });
        pairs[v.idx()] = { sorted.first, sorted.second };
      }
    }
    std::vector<unsigned char> isCorner(size, 0); // by the first copy
    for (const Vertex v : this->Mesh.vertices())
    {
      const Index first = this->GetFirst(v);
      const Pair& pair = pairs[v.idx()];
      if (pair != pairs[first] || (pair != None && pair[0] == pair[1]))
      {
        isCorner[first] = 1;
      }
    }
    this->IsCorner.resize(size);
    for (const Vertex v : this->Mesh.vertices())
    {
      this->IsCorner[v.idx()] = isCorner[this->GetFirst(v)];
    }
  }

  void AddLoopPoint(Vertex v)
  {
    if (this->Mesh.is_isolated(v) || this->IsCorner[v.idx()])
    {
      this->Add(v, 1.0);
    }
    else if (this->Mesh.is_boundary(v))
    {
      this->Add(v, 0.75);
      for (const Vertex neighbour : this->GetBorderNeighbours(v))
      {
        this->Add(neighbour, 0.125);
      }
    }
    else
    {
      const double valence = this->Mesh.valence(v);
      const double c = 0.375 + 0.25 * std::cos(2.0 * vtkMath::Pi() / valence);
      const double all = 0.625 - c * c; // of all neighbours
      this->Add(v, 1.0 - all);
      for (const Vertex neighbour : this->Mesh.vv_range(v))
      {
        this->Add(neighbour, all / valence);
      }
    }
    this->Step.Stencils.Close();
  }

  bool IsIrregular(Vertex v) const
  {
    return !this->Mesh.is_boundary(v) && this->Mesh.valence(v) != 6;
  }

  void AddButterflyMidpoint(HalfEdge h)
  {
    const HalfEdge back = this->Mesh.opposite_halfedge_handle(h);
    if (this->Mesh.is_boundary(h) || this->Mesh.is_boundary(back))
    {
      this->AddFourPointMidpoint(this->Mesh.is_boundary(h) ? h : back);
      return;
    }
    const bool isIrregular[2] = { this->IsIrregular(this->Mesh.from_vertex_handle(h)),
      this->IsIrregular(this->Mesh.to_vertex_handle(h)) };
    if (!isIrregular[0] && !isIrregular[1])
    {
      this->AddEightPointSide(h);
      this->AddEightPointSide(back);
      return;
    }
    const double share = isIrregular[0] && isIrregular[1] ? 0.5 : 1.0;
    if (isIrregular[0])
    {
      this->AddFan(h, share);
    }
    if (isIrregular[1])
    {
      this->AddFan(back, share);
    }
  }

  /// Along a border; beyond a corner the next point is mirrored.
  void AddFourPointMidpoint(HalfEdge h)
  {
    const Vertex from = this->Mesh.from_vertex_handle(h);
    const Vertex to = this->Mesh.to_vertex_handle(h);
    this->Add(from, 0.5625);
    this->Add(to, 0.5625);
    const auto addOuter = [this](Vertex end, Vertex other, Vertex outer)
    {
      if (this->IsCorner[end.idx()])
      {
        this->Add(end, -0.125);
        this->Add(other, 0.0625);
      }
      else
      {
        this->Add(outer, -0.0625);
      }
    };
    addOuter(from, to, this->Mesh.from_vertex_handle(this->Mesh.prev_halfedge_handle(h)));
    addOuter(to, from, this->Mesh.to_vertex_handle(this->Mesh.next_halfedge_handle(h)));
  }

  /// Half of the butterfly: the triangle at the half edge, and the two beside it.
  void AddEightPointSide(HalfEdge h)
  {
    const Vertex a = this->Mesh.from_vertex_handle(h);
    const Vertex b = this->Mesh.to_vertex_handle(h);
    const Vertex apex = this->GetApex(h);
    this->Add(a, 0.5); // the other side brings b
    this->Add(apex, 0.125);
    const auto addWing = [&](HalfEdge edge, Vertex near, Vertex far)
    {
      const HalfEdge across = this->Mesh.opposite_halfedge_handle(edge);
      if (this->Mesh.is_boundary(across))
      {
        this->Add(near, -0.0625);
        this->Add(apex, -0.0625);
        this->Add(far, 0.0625);
      }
      else
      {
        this->Add(this->GetApex(across), -0.0625);
      }
    };
    const HalfEdge next = this->Mesh.next_halfedge_handle(h);
    addWing(next, b, a);
    addWing(this->Mesh.next_halfedge_handle(next), a, b);
  }

  /// Around the irregular point that the half edge leaves.
  void AddFan(HalfEdge h, double share)
  {
    const Vertex centre = this->Mesh.from_vertex_handle(h);
    const int valence = static_cast<int>(this->Mesh.valence(centre));
    if (valence < 3) // two triangles back to back
    {
      this->Add(centre, 0.5 * share);
      this->Add(this->Mesh.to_vertex_handle(h), 0.5 * share);
      return;
    }
    this->Add(centre, 0.75 * share);
    for (int j = 0; j < valence; ++j)
    {
      double weight;
      if (valence == 3)
      {
        weight = j == 0 ? 5.0 / 12.0 : -1.0 / 12.0;
      }
      else if (valence == 4)
      {
        weight = j == 0 ? 0.375 : (j == 2 ? -0.125 : 0.0);
      }
      else
      {
        const double angle = 2.0 * vtkMath::Pi() * j / valence;
        weight = (0.25 + std::cos(angle) + 0.5 * std::cos(2.0 * angle)) / valence;
      }
      this->Add(this->Mesh.to_vertex_handle(h), weight * share);
      h = this->Mesh.ccw_rotated_halfedge_handle(h);
    }
  }

  const HalfEdgeMesh& Mesh;
  const std::vector<Index>& WeldedPointIds;
  SubdivisionStep& Step;
  std::vector<unsigned char> IsCorner;
};
}

//------------------------------------------------------------------------------
SubdivisionStep SubdivideSurface(
  const HalfEdgeMesh& mesh, const std::vector<Index>& weldedPointIds, SubdivisionScheme scheme)
{
  SubdivisionStep step;
  Subdivision subdivision(mesh, weldedPointIds, step);
  if (scheme == SubdivisionScheme::Loop)
  {
    subdivision.AddLoopPoints();
  }
  else
  {
    subdivision.AddButterflyPoints();
  }
  subdivision.AddTriangles();
  subdivision.WeldMidpoints();
  return step;
}
}
