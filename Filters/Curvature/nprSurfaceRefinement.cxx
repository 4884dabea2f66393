// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprSurfaceRefinement.h"

#include "nprForAll.h"
#include "nprMidpointTurns.h"
#include "nprSurfaceNormals.h"

#include <vtkMath.h>
#include <vtkSMPTools.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;
using Eigen::Vector3d;

constexpr double SmallestCosine = 0.5; // normals that differ by more than 60 degrees: no curve
constexpr double LargestMove = 0.2;    // of the edge's length; a semicircle would need 0.5
constexpr double LargestMoveOfShortest = 0.5; // of the shortest edge at either end
// Of a triangle's area, from either half of it to the other: so every part keeps some, whichever of
// the edges are split.
constexpr double LargestLoss = 0.125;
constexpr double FlatCosine = 0.9999;     // less than 0.8 degrees from end to end
constexpr double FlatSlope = 0.01;        // between a normal and the plane across the edge
constexpr int MaximumNumberOfPasses = 12; // each halves the edges

/// Edges that are copies of one, where the preparation has split the surface.
using Copies = std::vector<Index>;

//------------------------------------------------------------------------------
/// One edge with its two normals.
struct Edge
{
  Vector3d Chord;
  Vector3d N0;
  Vector3d N1;
  double Length;

  bool IsCurve() const { return this->Length > 0.0 && this->N0.dot(this->N1) > SmallestCosine; }
  bool IsFlat() const
  {
    return this->N0.dot(this->N1) > FlatCosine &&
      std::abs(this->N0.dot(this->Chord)) < FlatSlope * this->Length &&
      std::abs(this->N1.dot(this->Chord)) < FlatSlope * this->Length;
  }
  /// Whether the normals at the ends differ by no more than an angle.
  bool TurnsAtMost(double cosine) const { return this->N0.dot(this->N1) >= cosine; }
  /// From the middle of the chord to the curve.
  Vector3d GetMove() const
  {
    if (!this->IsCurve())
    {
      return Vector3d::Zero();
    }
    // The PN rule divides by 8; this is the same for small angles, and exact for all chords of
    // spheres and round cylinders, whose normals at the ends differ by twice the angle a.
    const double length = (this->N0 + this->N1).norm(); // 2 cos a
    return (this->Chord.dot(this->N1) * this->N1 - this->Chord.dot(this->N0) * this->N0) /
      (length * (2.0 + length));
  }
  /// The mean of the two. (The quadratic rule of PN triangles, taken again and again, makes ripples
  /// in normals, and so in contours, where a surface bends to and fro.)
  Vector3d GetMiddleNormal() const
  {
    const Vector3d sum = this->N0 + this->N1;
    return sum.norm() > 1e-3 ? Vector3d(sum.normalized()) : this->N0;
  }
};

//------------------------------------------------------------------------------
/// One pass over the whole surface.
class Pass
{
public:
  Pass(RefinedSurface& surface) : Surface(surface), Mesh(surface.Points, surface.Triangles)
  {
    this->Mesh.BuildEdges();
    const Index size = this->Mesh.GetNumberOfEdges();
    this->Counts.resize(size);
    this->Lengths.resize(size);
    this->IsMarked.assign(size, 0);
    vtkSMPTools::For(0, size,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const auto ends = this->Mesh.GetEdge(static_cast<Index>(i));
          this->Counts[i] = this->Mesh.CountTrianglesAtEdge(ends[0], ends[1]);
          this->Lengths[i] = this->GetEdge(static_cast<Index>(i)).Length;
        }
      });
    this->FindCopies();
    this->FindShortestEdges();
  }

  void MarkAll() { std::fill(this->IsMarked.begin(), this->IsMarked.end(), 1); }

  void MarkCoarseEdges(const SurfaceRefinementOptions& options)
  {
    const double cosine = std::cos(vtkMath::RadiansFromDegrees(options.MaximumTurn));
    const bool hasTurn = options.MaximumTurn > 0.0;
    const bool hasError = options.MaximumChordError > 0.0;
    const auto isFine = [&](const Edge& edge)
    {
      return hasTurn || hasError ? (!hasTurn || edge.TurnsAtMost(cosine)) &&
          (!hasError || edge.GetMove().norm() <= options.MaximumChordError)
                                 : edge.IsFlat();
    };
    vtkSMPTools::For(0, this->Mesh.GetNumberOfEdges(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Edge edge = this->GetEdge(static_cast<Index>(i));
          this->IsMarked[i] = edge.Length > options.MaximumEdgeLength && !isFine(edge);
        }
      });
    for (const Copies& copies : this->AllCopies)
    {
      const bool any = std::any_of(
        copies.begin(), copies.end(), [this](Index edge) { return this->IsMarked[edge]; });
      for (Index edge : copies)
      {
        this->IsMarked[edge] = any;
      }
    }
  }

  /// Takes marks from the shortest edges until the surface will have no more triangles.
  void LimitNumberOfTriangles(vtkIdType maximum)
  {
    if (this->GetNumberOfTriangles() <= maximum)
    {
      return;
    }
    std::vector<std::pair<double, int>> marked;
    for (std::size_t i = 0; i < this->IsMarked.size(); ++i)
    {
      if (this->IsMarked[i])
      {
        marked.emplace_back(this->Lengths[i], this->Counts[i]);
      }
    }
    std::sort(marked.begin(), marked.end(), std::greater<>());
    vtkIdType total = this->Mesh.GetNumberOfTriangles();
    double limit = 0.0;
    for (const auto& edge : marked)
    {
      total += edge.second;
      if (total > maximum)
      {
        limit = edge.first;
        break;
      }
    }
    for (std::size_t i = 0; i < this->IsMarked.size(); ++i)
    {
      // Copies of an edge have the same length, so they stay together.
      this->IsMarked[i] = this->IsMarked[i] && this->Lengths[i] > limit;
    }
  }

  bool HasMarks() const
  {
    return std::any_of(
      this->IsMarked.begin(), this->IsMarked.end(), [](unsigned char mark) { return mark != 0; });
  }

  /// How many there will be: a marked edge parts each of its triangles once more.
  vtkIdType GetNumberOfTriangles() const
  {
    vtkIdType total = this->Mesh.GetNumberOfTriangles();
    for (std::size_t i = 0; i < this->IsMarked.size(); ++i)
    {
      total += this->IsMarked[i] ? this->Counts[i] : 0;
    }
    return total;
  }

  void Split()
  {
    this->AddMidpoints();
    this->SplitTriangles();
  }

private:
  Edge GetEdge(Index index) const
  {
    const auto ends = this->Mesh.GetEdge(index);
    Edge edge;
    edge.Chord = (this->Mesh.GetPoint(ends[1]) - this->Mesh.GetPoint(ends[0])).cast<double>();
    edge.N0 = this->Surface.Normals[ends[0]].cast<double>();
    edge.N1 = this->Surface.Normals[ends[1]].cast<double>();
    edge.Length = edge.Chord.norm();
    return edge;
  }

  void FindCopies()
  {
    const std::vector<Index>& welded = this->Surface.WeldedPointIds;
    std::vector<unsigned char> hasCopies(welded.size(), 0);
    for (std::size_t i = 0; i < welded.size(); ++i)
    {
      if (welded[i] != static_cast<Index>(i))
      {
        hasCopies[i] = hasCopies[welded[i]] = 1;
      }
    }
    std::vector<std::array<Index, 3>> keys;
    for (Index i = 0; i < this->Mesh.GetNumberOfEdges(); ++i)
    {
      const auto ends = this->Mesh.GetEdge(i);
      if (hasCopies[ends[0]] || hasCopies[ends[1]])
      {
        const auto sorted = std::minmax(welded[ends[0]], welded[ends[1]]);
        keys.push_back({ sorted.first, sorted.second, i });
      }
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < keys.size();)
    {
      Copies copies;
      const std::array<Index, 3> key = keys[i];
      for (; i < keys.size() && keys[i][0] == key[0] && keys[i][1] == key[1]; ++i)
      {
        copies.push_back(keys[i][2]);
      }
      if (copies.size() > 1)
      {
        this->AllCopies.push_back(std::move(copies));
      }
    }
  }

  void FindShortestEdges()
  {
    this->ShortestEdges.assign(this->Mesh.GetNumberOfPoints(), std::numeric_limits<double>::max());
    for (Index i = 0; i < this->Mesh.GetNumberOfEdges(); ++i)
    {
      for (Index end : this->Mesh.GetEdge(i))
      {
        this->ShortestEdges[end] = std::min(this->ShortestEdges[end], this->Lengths[i]);
      }
    }
  }

  /// By how much a move must be shortened.
  double GetFactor(const Copies& copies, const Vector3d& move) const
  {
    const double length = move.norm();
    if (!(length > 0.0))
    {
      return 1.0;
    }
    // A long edge between finely sampled places, such as the ends of a fillet, is no coarse piece
    // of a curve, whatever the normals at its ends say.
    double largest = LargestMove * this->Lengths[copies.front()];
    for (Index edge : copies)
    {
      for (Index end : this->Mesh.GetEdge(edge))
      {
        largest = std::min(largest, LargestMoveOfShortest * this->ShortestEdges[end]);
      }
    }
    double factor = std::min(1.0, largest / length);
    for (Index edge : copies)
    {
      factor = std::min(factor, this->GetFactorOfTriangles(edge, move));
    }
    return factor;
  }

  /// By how much a move must be shortened so that it folds none of the triangles at an edge over,
  /// such as a sliver that is left of a cap between a round rim and a point near it.
  double GetFactorOfTriangles(Index index, const Vector3d& move) const
  {
    const auto ends = this->Mesh.GetEdge(index);
    double factor = 1.0;
    for (const Index* t = this->Mesh.IncidentBegin(ends[0]); t != this->Mesh.IncidentEnd(ends[0]);
         ++t)
    {
      const Triangle& corners = this->Mesh.GetTriangle(*t);
      for (int e = 0; e < 3; ++e)
      {
        const Index from = corners[e];
        const Index to = corners[(e + 1) % 3];
        if (std::minmax(from, to) != std::minmax(ends[0], ends[1]))
        {
          continue;
        }
        const Vector3d a = this->Mesh.GetPoint(from).cast<double>();
        const Vector3d b = this->Mesh.GetPoint(to).cast<double>();
        const Vector3d c = this->Mesh.GetPoint(corners[(e + 2) % 3]).cast<double>();
        const Vector3d normal = (b - a).cross(c - a);
        // How the parts of the area beside a and b grow when the middle of the edge moves.
        const double least = std::min(move.cross(c - a).dot(normal), move.cross(b - c).dot(normal));
        const double allowed = LargestLoss * normal.squaredNorm();
        factor = least < -allowed ? std::min(factor, allowed / -least) : factor;
      }
    }
    return factor;
  }

  /// The shortest move that has the offset of each copy along that copy's normal.
  Vector3d GetCommonMove(const Copies& copies) const
  {
    Eigen::Matrix3d matrix = 1e-5 * Eigen::Matrix3d::Identity();
    Vector3d right = Vector3d::Zero();
    for (Index index : copies)
    {
      const Edge edge = this->GetEdge(index);
      if (edge.IsCurve())
      {
        const Vector3d normal = (edge.N0 + edge.N1).normalized();
        matrix += normal * normal.transpose();
        right += edge.GetMove().dot(normal) * normal;
      }
    }
    return matrix.inverse() * right;
  }

  /// Of marked edges. Copies of one need not run the same way, nor sum up to the same bits: the
  /// first does it for all.
  void FindMoves()
  {
    const Index size = this->Mesh.GetNumberOfEdges();
    this->FirstCopies.resize(size);
    std::iota(this->FirstCopies.begin(), this->FirstCopies.end(), 0);
    std::vector<const Copies*> groups(size, nullptr);
    for (const Copies& copies : this->AllCopies)
    {
      groups[copies.front()] = &copies;
      for (Index edge : copies)
      {
        this->FirstCopies[edge] = copies.front();
      }
    }
    this->Moves.assign(size, Vector3d::Zero());
    ForAll(size,
      [&](Index edge)
      {
        if (this->IsMarked[edge] && this->FirstCopies[edge] == edge)
        {
          const Copies copies = groups[edge] ? *groups[edge] : Copies{ edge };
          const Vector3d move =
            groups[edge] ? this->GetCommonMove(copies) : this->GetEdge(edge).GetMove();
          this->Moves[edge] = this->GetFactor(copies, move) * move;
        }
      });
  }

  TriangleMesh::Vector GetMidpoint(Index edge) const
  {
    const Index first = this->FirstCopies[edge];
    const std::array<Index, 2> ends = this->Mesh.GetEdge(first);
    const Vector3d middle = 0.5 *
      (this->Mesh.GetPoint(ends[0]).cast<double>() + this->Mesh.GetPoint(ends[1]).cast<double>());
    return (middle + this->Moves[first]).cast<float>();
  }

  void AddMidpoints()
  {
    RefinedSurface& surface = this->Surface;
    const Index size = this->Mesh.GetNumberOfEdges();
    const Index firstPoint = static_cast<Index>(surface.Points.size());
    this->Midpoints.assign(size, -1);
    std::vector<Index> edges;
    for (Index i = 0; i < size; ++i)
    {
      if (this->IsMarked[i])
      {
        this->Midpoints[i] = firstPoint + static_cast<Index>(edges.size());
        edges.push_back(i);
      }
    }
    this->FindMoves();
    LimitTurns(this->Mesh, surface.Normals, this->FirstCopies, this->Moves);
    const std::size_t total = firstPoint + edges.size();
    const Index firstParent = static_cast<Index>(surface.Parents.size());
    surface.Points.resize(total);
    surface.Normals.resize(total);
    surface.WeldedPointIds.resize(total);
    surface.BorderPoints.resize(total);
    surface.Parents.resize(firstParent + edges.size());
    vtkSMPTools::For(0, static_cast<vtkIdType>(edges.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Index index = edges[i];
          const Index point = firstPoint + static_cast<Index>(i);
          surface.Points[point] = this->GetMidpoint(index);
          surface.Normals[point] = this->GetEdge(index).GetMiddleNormal().cast<float>();
          surface.WeldedPointIds[point] = this->Midpoints[this->FirstCopies[index]];
          surface.BorderPoints[point] = this->Counts[index] != 2;
          surface.Parents[firstParent + i] = this->Mesh.GetEdge(index);
        }
      });
    surface.LevelStarts.push_back(static_cast<Index>(surface.Parents.size()));
  }

  void SplitTriangles()
  {
    RefinedSurface& surface = this->Surface;
    std::vector<Triangle> triangles;
    std::vector<Index> sources;
    const vtkIdType total = this->GetNumberOfTriangles();
    triangles.reserve(total);
    sources.reserve(total);
    for (Index t = 0; t < this->Mesh.GetNumberOfTriangles(); ++t)
    {
      const Triangle& c = this->Mesh.GetTriangle(t);
      std::array<Index, 3> m;
      int count = 0;
      for (int e = 0; e < 3; ++e)
      {
        m[e] = this->Midpoints[this->Mesh.FindEdge(c[e], c[(e + 1) % 3])];
        count += m[e] >= 0;
      }
      const std::size_t first = triangles.size();
      if (count == 0)
      {
        triangles.push_back(c);
      }
      else if (count == 3)
      {
        triangles.insert(triangles.end(),
          { { c[0], m[0], m[2] }, { m[0], c[1], m[1] }, { m[2], m[1], c[2] },
            { m[0], m[1], m[2] } });
      }
      else if (count == 1)
      {
        const int e = m[0] >= 0 ? 0 : (m[1] >= 0 ? 1 : 2);
        const Index opposite = c[(e + 2) % 3];
        triangles.insert(
          triangles.end(), { { c[e], m[e], opposite }, { m[e], c[(e + 1) % 3], opposite } });
      }
      else
      {
        // Edge e is whole; the corner opposite it is cut off, and the rest parted by the shorter
        // diagonal.
        const int e = m[0] < 0 ? 0 : (m[1] < 0 ? 1 : 2);
        const Index a = c[e];
        const Index b = c[(e + 1) % 3];
        const Index onB = m[(e + 1) % 3];
        const Index onA = m[(e + 2) % 3];
        triangles.push_back({ onA, onB, c[(e + 2) % 3] });
        const auto distance = [&](Index p, Index q)
        { return (surface.Points[p] - surface.Points[q]).cast<double>().squaredNorm(); };
        if (distance(a, onB) <= distance(b, onA))
        {
          triangles.insert(triangles.end(), { { a, b, onB }, { a, onB, onA } });
        }
        else
        {
          triangles.insert(triangles.end(), { { a, b, onA }, { b, onB, onA } });
        }
      }
      sources.insert(sources.end(), triangles.size() - first, surface.SourceTriangles[t]);
    }
    surface.Triangles.swap(triangles);
    surface.SourceTriangles.swap(sources);
  }

  RefinedSurface& Surface;
  TriangleMesh Mesh;
  std::vector<int> Counts; // of triangles at the edges
  std::vector<double> Lengths;
  std::vector<double> ShortestEdges; // at each point
  std::vector<unsigned char> IsMarked;
  std::vector<Copies> AllCopies;
  std::vector<Index> FirstCopies; // of the edges; those without copies are their own
  std::vector<Vector3d> Moves;    // from the middle of edges that are first copies
  std::vector<Index> Midpoints;   // of the edges, or -1
};
}

//------------------------------------------------------------------------------
int GetRefinementReach(int numberOfLevels)
{
  constexpr int ofPass = MidpointTurnsReach + 1;
  if (numberOfLevels < 0)
  {
    return MaximumNumberOfPasses * ofPass;
  }
  // 1 + 1/2 + 1/4 ...
  const double sum = 2.0 - std::ldexp(2.0, -numberOfLevels);
  return static_cast<int>(std::ceil(ofPass * sum));
}

//------------------------------------------------------------------------------
RefinedSurface RefineSurface(const TriangleMesh& mesh, const Tuples<3>& normals,
  const std::vector<Index>& weldedPointIds, const SurfaceRefinementOptions& options,
  const Progress& progress)
{
  RefinedSurface surface;
  surface.Points = mesh.GetPoints();
  surface.Normals = normals;
  surface.Triangles = mesh.GetTriangles();
  surface.WeldedPointIds = weldedPointIds;
  surface.BorderPoints = ComputeBorderPoints(mesh);
  surface.LevelStarts.push_back(0);
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    surface.SourceTriangles.push_back(t);
  }
  const bool isUniform = options.NumberOfLevels >= 0;
  const int passes =
    isUniform ? std::min(options.NumberOfLevels, MaximumNumberOfPasses) : MaximumNumberOfPasses;
  for (int level = 0; level < passes && progress(static_cast<double>(level) / passes); ++level)
  {
    Pass pass(surface);
    if (isUniform)
    {
      pass.MarkAll();
      if (pass.GetNumberOfTriangles() > options.MaximumNumberOfTriangles)
      {
        break;
      }
    }
    else
    {
      pass.MarkCoarseEdges(options);
      pass.LimitNumberOfTriangles(options.MaximumNumberOfTriangles);
    }
    if (!pass.HasMarks() || !progress((level + 0.5) / passes))
    {
      break;
    }
    pass.Split();
  }
  return surface;
}
}
