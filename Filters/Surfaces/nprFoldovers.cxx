// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprFoldovers.h"

#include "nprPointFans.h"
#include "nprTriangleArea.h"

#include <vtkSMPTools.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;
using Eigen::Vector3d;
using Place = std::array<float, 3>;

// The cosine between the normals of two triangles that are folded over one another: 135 degrees.
constexpr double FoldCosine = -0.7071;

//------------------------------------------------------------------------------
Place GetPlace(const TriangleMesh& mesh, Index point)
{
  const TriangleMesh::Vector& place = mesh.GetPoint(point);
  return { place.x(), place.y(), place.z() };
}

//------------------------------------------------------------------------------
/// A unit normal, the same to the last bit from whichever corner on; zero without an area.
Vector3d GetNormal(const TriangleMesh& mesh, Triangle corners)
{
  std::rotate(corners.begin(),
    std::min_element(corners.begin(), corners.end(),
      [&](Index a, Index b) { return GetPlace(mesh, a) < GetPlace(mesh, b); }),
    corners.end());
  const Vector3d origin = mesh.GetPoint(corners[0]).cast<double>();
  const Vector3d a = mesh.GetPoint(corners[1]).cast<double>() - origin;
  const Vector3d b = mesh.GetPoint(corners[2]).cast<double>() - origin;
  const Vector3d normal = a.cross(b);
  const double length = normal.norm();
  const double longest = std::max({ a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm() });
  return CountsAsArea(length, longest) ? Vector3d(normal / length) : Vector3d::Zero();
}

//------------------------------------------------------------------------------
/// How many neighbours a triangle has, and over how many of them it is folded.
struct Folds
{
  int Neighbours = 0;
  int Folded = 0;

  void Add(double cosine)
  {
    ++this->Neighbours;
    this->Folded += cosine < FoldCosine;
  }
  bool MayBeMended() const { return this->Folded >= 2; }
  bool IsAll() const { return this->Folded >= 2 && this->Folded == this->Neighbours; }
};

//------------------------------------------------------------------------------
/// Those triangles that are folded over two neighbours at least.
std::vector<Index> FindFolded(const TriangleMesh& mesh)
{
  std::vector<unsigned char> isFolded(mesh.GetNumberOfTriangles(), 0);
  vtkSMPTools::For(0, mesh.GetNumberOfTriangles(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto t = static_cast<Index>(i);
        // Most are not folded, which is seen sooner without units.
        const Vector3d normal = mesh.GetAreaNormal(t).cast<double>();
        int turned = 0;
        for (int e = 0; e < 3; ++e)
        {
          const Index neighbour = mesh.GetNeighbour(t, e);
          turned += neighbour >= 0 && normal.dot(mesh.GetAreaNormal(neighbour).cast<double>()) < 0;
        }
        isFolded[t] = turned >= 2;
      }
    });
  std::vector<Index> folded;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    if (isFolded[t])
    {
      folded.push_back(t);
    }
  }
  return folded;
}

//------------------------------------------------------------------------------
/// Triangles whose edges are flipped one by one, and what is around them.
class FoldoverMender
{
public:
  FoldoverMender(TriangleMesh& mesh, PreparedSurface& surface) : Mesh(mesh), Surface(surface)
  {
    mesh.BuildIncidence();
    for (std::size_t i = 0; i < surface.WeldedPointIds.size(); ++i)
    {
      const Index original = surface.WeldedPointIds[i];
      if (original != static_cast<Index>(i))
      {
        this->IsSplit.resize(surface.WeldedPointIds.size(), 0);
        this->IsSplit[original] = this->IsSplit[i] = 1;
      }
    }
  }

  void Run(const std::vector<Index>& folded)
  {
    for (const Index t : folded)
    {
      this->Seek(t);
    }
    while (!this->Queue.empty())
    {
      const Index t = std::get<2>(*this->Queue.begin());
      const std::optional<Flip> flip = this->FindBestFlip(t);
      if (!flip || this->GetRank(*flip) != *this->Queue.begin())
      {
        // Other flips have changed what it saw.
        this->Queue.erase(this->Queue.begin());
        this->Seek(t);
        continue;
      }
      this->Queue.erase(this->Queue.begin());
      this->Apply(*flip);
      ++this->Surface.Counts.MendedFoldovers;
    }
  }

  bool IsFoldedOverAll(Index triangle) const { return this->GetFolds(triangle).IsAll(); }

private:
  /// The edge from A to B of a triangle with C becomes the one from C to D, across it.
  struct Flip
  {
    Index Triangle;
    Index Other;
    Index A;
    Index B;
    Index C;
    Index D;
    double Cosine; ///< Of the largest angle that it leaves.
  };
  /// Flips come in this order: the largest angle, the places of the edge, a triangle of it.
  using Rank = std::tuple<double, std::array<Place, 2>, Index>;

  Rank GetRank(const Flip& flip) const
  {
    const auto [low, high] =
      std::minmax({ GetPlace(this->Mesh, flip.A), GetPlace(this->Mesh, flip.B) });
    return { -flip.Cosine, { low, high }, flip.Triangle };
  }

  const Triangle& GetTriangle(Index triangle) const { return this->Surface.Triangles[triangle]; }

  /// The triangles around a point.
  std::vector<Index> GetAround(Index point) const
  {
    const auto changed = this->Around.find(point);
    return changed != this->Around.end()
      ? changed->second
      : std::vector<Index>(this->Mesh.IncidentBegin(point), this->Mesh.IncidentEnd(point));
  }

  bool HasEdge(Index from, Index to) const
  {
    const std::vector<Index> around = this->GetAround(from);
    return std::any_of(around.begin(), around.end(),
      [&](Index t)
      {
        const Triangle& corners = this->GetTriangle(t);
        return std::find(corners.begin(), corners.end(), to) != corners.end();
      });
  }

  /// The one other triangle at an edge, which runs through it from `to` to `from`; else -1.
  Index GetNeighbour(Index triangle, Index from, Index to) const
  {
    Index neighbour = -1;
    for (const Index t : this->GetAround(from))
    {
      const Triangle& corners = this->GetTriangle(t);
      if (t == triangle || std::find(corners.begin(), corners.end(), to) == corners.end())
      {
        continue;
      }
      if (neighbour >= 0 || !RunsOppositely(corners, from, to))
      {
        return -1;
      }
      neighbour = t;
    }
    return neighbour;
  }

  Folds GetFolds(Index triangle) const
  {
    const Triangle& corners = this->GetTriangle(triangle);
    const Vector3d normal = GetNormal(this->Mesh, corners);
    Folds folds;
    for (int e = 0; e < 3; ++e)
    {
      const Index neighbour = this->GetNeighbour(triangle, corners[e], corners[(e + 1) % 3]);
      if (neighbour >= 0)
      {
        folds.Add(normal.dot(GetNormal(this->Mesh, this->GetTriangle(neighbour))));
      }
    }
    return folds;
  }

  /// Puts the triangle's best flip into the queue, if it has one.
  void Seek(Index triangle)
  {
    if (const std::optional<Flip> flip = this->FindBestFlip(triangle))
    {
      this->Queue.insert(this->GetRank(*flip));
    }
  }

  std::optional<Flip> FindBestFlip(Index triangle) const
  {
    std::optional<Flip> best;
    if (this->GetFolds(triangle).MayBeMended())
    {
      for (int e = 0; e < 3; ++e)
      {
        const std::optional<Flip> flip = this->FindFlip(triangle, e);
        if (flip && (!best || this->GetRank(*flip) < this->GetRank(*best)))
        {
          best = flip;
        }
      }
    }
    return best;
  }

  /// The flip of an edge, if it makes the surface better.
  std::optional<Flip> FindFlip(Index triangle, int edge) const
  {
    const Triangle& corners = this->GetTriangle(triangle);
    const Index a = corners[edge];
    const Index b = corners[(edge + 1) % 3];
    const Index c = corners[(edge + 2) % 3];
    const Index other = this->GetNeighbour(triangle, a, b);
    if (other < 0)
    {
      return {};
    }
    const Triangle& across = this->GetTriangle(other);
    const Index d = across[(FindCorner(across, a) + 1) % 3];
    const Vector3d old = GetNormal(this->Mesh, corners);
    const Vector3d oldOther = GetNormal(this->Mesh, across);
    const Vector3d atA = GetNormal(this->Mesh, { c, a, d });
    const Vector3d atB = GetNormal(this->Mesh, { d, b, c });
    const double inner = atA.dot(atB);
    if (!(old.dot(oldOther) < FoldCosine) || atA.isZero() || atB.isZero() || inner < FoldCosine ||
      this->IsTaken(c, d))
    {
      return {};
    }
    // The edges around the two, with the normals of what is within, before and after.
    const std::tuple<Index, Index, Index, const Vector3d&, const Vector3d&> edges[] = {
      { triangle, b, c, old, atB }, { triangle, c, a, old, atA }, { other, a, d, oldOther, atA },
      { other, d, b, oldOther, atB }
    };
    double leastBefore = 1.0;
    double leastAfter = 1.0;
    for (const auto& [within, from, to, before, after] : edges)
    {
      const Index neighbour = this->GetNeighbour(within, from, to);
      if (neighbour < 0)
      {
        continue;
      }
      const Vector3d normal = GetNormal(this->Mesh, this->GetTriangle(neighbour));
      const double cosineBefore = normal.dot(before);
      const double cosineAfter = normal.dot(after);
      if (cosineAfter < FoldCosine && !(cosineBefore < FoldCosine))
      {
        return {};
      }
      leastBefore = std::min(leastBefore, cosineBefore);
      leastAfter = std::min(leastAfter, cosineAfter);
    }
    if (!(leastAfter > leastBefore))
    {
      return {};
    }
    return Flip{ triangle, other, a, b, c, d, std::min(leastAfter, inner) };
  }

  /// Whether an edge between two points is there already, or would be once split points are joined.
  bool IsTaken(Index a, Index b) const
  {
    const bool areSplit = !this->IsSplit.empty() && this->IsSplit[a] && this->IsSplit[b];
    return areSplit || this->HasEdge(a, b);
  }

  void Apply(const Flip& flip)
  {
    const auto isMoreFolded = [this](Index t, Index u)
    { return this->GetFolds(t).Folded > this->GetFolds(u).Folded; };
    // Which of the two is folded over the other one; if that is not known, one by its place.
    const bool isOtherFolded = isMoreFolded(flip.Other, flip.Triangle) ||
      (!isMoreFolded(flip.Triangle, flip.Other) &&
        GetPlace(this->Mesh, flip.D) < GetPlace(this->Mesh, flip.C));
    std::vector<vtkIdType>& cells = this->Surface.SourceCells;
    cells[flip.Triangle] = cells[flip.Other] = cells[isOtherFolded ? flip.Triangle : flip.Other];
    this->Surface.Triangles[flip.Triangle] = { flip.C, flip.A, flip.D };
    this->Surface.Triangles[flip.Other] = { flip.D, flip.B, flip.C };
    const auto erase = [](std::vector<Index>& all, Index one)
    { all.erase(std::find(all.begin(), all.end(), one)); };
    erase(this->Change(flip.A), flip.Other);
    erase(this->Change(flip.B), flip.Triangle);
    this->Change(flip.C).push_back(flip.Other);
    this->Change(flip.D).push_back(flip.Triangle);
    for (const Index point : { flip.A, flip.B, flip.C, flip.D })
    {
      for (const Index t : this->GetAround(point))
      {
        this->Seek(t);
      }
    }
  }

  /// The triangles around a point, to change them.
  std::vector<Index>& Change(Index point)
  {
    return this->Around.try_emplace(point, this->GetAround(point)).first->second;
  }

  const TriangleMesh& Mesh; ///< Its triangles stay those of before.
  PreparedSurface& Surface;
  std::vector<unsigned char> IsSplit; ///< Of points with copies, and of these; empty if none are.
  std::unordered_map<Index, std::vector<Index>> Around; ///< Of points where something has changed.
  std::set<Rank> Queue;
};
}

//------------------------------------------------------------------------------
void MendFoldovers(TriangleMesh& mesh, PreparedSurface& surface)
{
  const std::vector<Index> folded = FindFolded(mesh);
  if (folded.empty())
  {
    return;
  }
  FoldoverMender mender(mesh, surface);
  mender.Run(folded);
  // A flip folds nothing that was not.
  surface.Counts.LeftFoldovers =
    std::count_if(folded.begin(), folded.end(), [&](Index t) { return mender.IsFoldedOverAll(t); });
  if (surface.Counts.MendedFoldovers > 0)
  {
    mesh = TriangleMesh(mesh.GetPoints(), surface.Triangles, mesh.GetOrigin());
    mesh.BuildNeighbours();
  }
}
}
