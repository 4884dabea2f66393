// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nprHoles.h"

#include "nprTriangleArea.h"

#include <vtkSMPTools.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <utility>

namespace npr
{
namespace
{
using Index = TriangleMesh::Index;
using Triangle = TriangleMesh::Triangle;
using Eigen::Vector3d;

/// The time grows with the third power of it, the memory with the second.
constexpr std::size_t LongestBorder = 400; // edges
/// Of 1 - cos of the angle between normals.
constexpr double BendStep = 0.25;
constexpr double LargestBend = 1.5;
constexpr double LargestShare = 0.5; // of the component's area

/// Points of a hole's border, and for each the triangle beyond the edge to the next, which a
/// triangle inside of the hole meets the other way.
struct Border
{
  std::vector<Index> Points;
  std::vector<Index> Outside;
};

//------------------------------------------------------------------------------
/// Walks along all borders, and parts them where they pass through a point again: each closed
/// border passes through each of its points once.
class BorderFinder
{
public:
  explicit BorderFinder(const TriangleMesh& mesh)
    : Mesh(mesh), Next(mesh.GetNumberOfPoints() + 1, 0), Place(mesh.GetNumberOfPoints(), -1)
  {
    for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
    {
      for (int e = 0; e < 3; ++e)
      {
        if (mesh.GetNeighbour(t, e) == TriangleMesh::Boundary)
        {
          this->Exits.push_back({ mesh.GetTriangle(t)[e], mesh.GetTriangle(t)[(e + 1) % 3], t });
        }
      }
    }
    std::sort(this->Exits.begin(), this->Exits.end());
    for (const Exit& exit : this->Exits)
    {
      ++this->Next[exit[From] + 1];
    }
    std::partial_sum(this->Next.begin(), this->Next.end(), this->Next.begin());
    this->Ends.assign(this->Next.begin() + 1, this->Next.end());
  }

  std::vector<Border> Run(double maximumLength)
  {
    for (const Exit& start : this->Exits)
    {
      this->Walk(start[From], maximumLength);
    }
    return std::move(this->Borders);
  }

private:
  /// A triangle's edge on the border: its ends, and the triangle.
  using Exit = std::array<Index, 3>;
  enum
  {
    From,
    To,
    Outside
  };

  void Walk(Index point, double maximumLength)
  {
    std::vector<Exit> path;
    for (;;)
    {
      if (this->Place[point] >= 0)
      {
        const auto begin = path.begin() + this->Place[point];
        for (auto exit = begin; exit != path.end(); ++exit)
        {
          this->Place[(*exit)[From]] = -1;
        }
        this->AddBorder({ begin, path.end() }, maximumLength);
        path.erase(begin, path.end());
      }
      if (this->Next[point] == this->Ends[point])
      {
        break; // the start, or where triangles do not agree
      }
      this->Place[point] = static_cast<Index>(path.size());
      path.push_back(this->Exits[this->Next[point]++]);
      point = path.back()[To];
    }
    for (const Exit& exit : path)
    {
      this->Place[exit[From]] = -1;
    }
  }

  void AddBorder(const std::vector<Exit>& path, double maximumLength)
  {
    double length = 0.0;
    Border border;
    // The other way round, as seen from the hole.
    for (auto exit = path.rbegin(); exit != path.rend(); ++exit)
    {
      length += (this->Mesh.GetPoint((*exit)[To]) - this->Mesh.GetPoint((*exit)[From])).norm();
      border.Points.push_back((*exit)[To]);
      border.Outside.push_back((*exit)[Outside]);
    }
    if (length <= maximumLength)
    {
      this->Borders.push_back(std::move(border));
    }
  }

  const TriangleMesh& Mesh;
  std::vector<Exit> Exits;  ///< by the points they come from
  std::vector<Index> Next;  ///< for each point, its first exit not yet taken
  std::vector<Index> Ends;  ///< and the end of its exits
  std::vector<Index> Place; ///< on the path, or negative
  std::vector<Border> Borders;
};

//------------------------------------------------------------------------------
/// For each triangle, the area of all that hangs together with it.
std::vector<double> ComputeComponentAreas(const TriangleMesh& mesh)
{
  std::vector<double> areas(mesh.GetNumberOfTriangles(), -1.0);
  std::vector<Index> component;
  for (Index seed = 0; seed < mesh.GetNumberOfTriangles(); ++seed)
  {
    if (areas[seed] >= 0.0)
    {
      continue;
    }
    component.assign(1, seed);
    areas[seed] = 0.0;
    double area = 0.0;
    for (std::size_t i = 0; i < component.size(); ++i)
    {
      area += 0.5 * mesh.GetAreaNormal(component[i]).cast<double>().norm();
      for (int e = 0; e < 3; ++e)
      {
        const Index next = mesh.GetNeighbour(component[i], e);
        if (next >= 0 && areas[next] < 0.0)
        {
          areas[next] = 0.0;
          component.push_back(next);
        }
      }
    }
    for (Index t : component)
    {
      areas[t] = area;
    }
  }
  return areas;
}

//------------------------------------------------------------------------------
/// Finds the best triangulation of one border.
class Triangulator
{
public:
  Triangulator(const TriangleMesh& mesh, const Border& border)
    : Mesh(mesh), Hole(border), Size(static_cast<int>(border.Points.size()))
  {
    this->Parts.resize(static_cast<std::size_t>(this->Size) * this->Size);
    for (int i = 0; i < this->Size; ++i)
    {
      this->Positions.push_back(mesh.GetPoint(border.Points[i]).cast<double>());
      this->OutsideNormals.push_back(
        mesh.GetAreaNormal(border.Outside[i]).cast<double>().normalized());
    }
  }

  /// False if there is none.
  bool Run()
  {
    for (int i = 0; i + 1 < this->Size; ++i)
    {
      Part& part = this->At(i, i + 1);
      part.Normal = this->OutsideNormals[i];
      part.Bend = 0;
    }
    for (int width = 2; width < this->Size; ++width)
    {
      for (int i = 0; i + width < this->Size; ++i)
      {
        this->Solve(i, i + width);
      }
    }
    return this->At(0, this->Size - 1).Bend >= 0;
  }

  /// Appends the triangles, and for each the triangle outside at one of the border's edges.
  void Collect(std::vector<Triangle>& triangles, std::vector<Index>& neighbours) const
  {
    std::vector<std::pair<int, int>> parts(1, { 0, this->Size - 1 });
    while (!parts.empty())
    {
      const auto [i, k] = parts.back();
      parts.pop_back();
      if (k - i < 2)
      {
        continue;
      }
      const int m = this->At(i, k).Middle;
      triangles.push_back({ this->Hole.Points[i], this->Hole.Points[m], this->Hole.Points[k] });
      neighbours.push_back(this->Hole.Outside[k == m + 1 ? m : i]);
      parts.emplace_back(m, k);
      parts.emplace_back(i, m);
    }
  }

  double GetArea() const
  {
    std::vector<Triangle> triangles;
    std::vector<Index> neighbours;
    this->Collect(triangles, neighbours);
    double area = 0.0;
    for (const Triangle& t : triangles)
    {
      const auto& a = this->Mesh.GetPoint(t[0]);
      area += 0.5 * (this->Mesh.GetPoint(t[1]) - a).cross(this->Mesh.GetPoint(t[2]) - a).norm();
    }
    return area;
  }

private:
  /// The best triangulation of the border from one point to a later one and back.
  struct Part
  {
    Vector3d Normal = Vector3d::Zero(); ///< of the triangle (or outside) at the edge back
    double Cost = 0.0;
    int Bend = -1; ///< the sharpest, in steps; negative: there is no triangulation
    int Middle = -1;
  };

  Part& At(int i, int k) { return this->Parts[static_cast<std::size_t>(i) * this->Size + k]; }
  const Part& At(int i, int k) const
  {
    return this->Parts[static_cast<std::size_t>(i) * this->Size + k];
  }

  /// In steps; negative for one that is too sharp.
  static int GetBend(const Vector3d& a, const Vector3d& b)
  {
    const double bend = 1.0 - a.dot(b);
    return bend > LargestBend ? -1 : static_cast<int>(bend / BendStep);
  }

  void Solve(int i, int k)
  {
    Part& best = this->At(i, k);
    const bool isLast = i == 0 && k == this->Size - 1;
    if (!isLast && this->Mesh.CountTrianglesAtEdge(this->Hole.Points[i], this->Hole.Points[k]) > 0)
    {
      return;
    }
    const double back = (this->Positions[k] - this->Positions[i]).squaredNorm();
    for (int m = i + 1; m < k; ++m)
    {
      const Part& left = this->At(i, m);
      const Part& right = this->At(m, k);
      if (left.Bend < 0 || right.Bend < 0)
      {
        continue;
      }
      const Vector3d a = this->Positions[m] - this->Positions[i];
      const Vector3d b = this->Positions[k] - this->Positions[m];
      const Vector3d normal = a.cross(b);
      const double twiceArea = normal.norm();
      const double longest = std::max({ a.squaredNorm(), b.squaredNorm(), back });
      if (!CountsAsArea(twiceArea, longest))
      {
        continue;
      }
      const Vector3d unit = normal / twiceArea;
      const int atLeft = GetBend(unit, left.Normal);
      const int atRight = GetBend(unit, right.Normal);
      const int atBack = isLast ? GetBend(unit, this->OutsideNormals[k]) : 0;
      if (atLeft < 0 || atRight < 0 || atBack < 0)
      {
        continue;
      }
      const int bend = std::max({ left.Bend, right.Bend, atLeft, atRight, atBack });
      const double cost = left.Cost + right.Cost + back;
      if (best.Bend < 0 || bend < best.Bend || (bend == best.Bend && cost < best.Cost))
      {
        best = { unit, cost, bend, m };
      }
    }
  }

  const TriangleMesh& Mesh;
  const Border& Hole;
  const int Size;
  std::vector<Vector3d> Positions;
  std::vector<Vector3d> OutsideNormals; ///< beyond the edge to the next point
  std::vector<Part> Parts;
};

//------------------------------------------------------------------------------
/// The edges of the triangles that are not the border's, the lower end first.
std::set<std::pair<Index, Index>> GetInnerEdges(
  const Border& border, const std::vector<Triangle>& triangles)
{
  std::set<std::pair<Index, Index>> edges;
  for (const Triangle& corners : triangles)
  {
    for (int e = 0; e < 3; ++e)
    {
      edges.insert(std::minmax(corners[e], corners[(e + 1) % 3]));
    }
  }
  for (std::size_t i = 0; i < border.Points.size(); ++i)
  {
    edges.erase(std::minmax(border.Points[i], border.Points[(i + 1) % border.Points.size()]));
  }
  return edges;
}
}

//------------------------------------------------------------------------------
HoleFilling FillHoles(const TriangleMesh& mesh, double maximumLength)
{
  const std::vector<Border> borders = BorderFinder(mesh).Run(maximumLength);
  HoleFilling result;
  if (borders.empty())
  {
    return result;
  }
  const std::vector<double> areas = ComputeComponentAreas(mesh);
  std::vector<HoleFilling> fillings(borders.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(borders.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Border& border = borders[i];
        if (border.Points.size() > LongestBorder)
        {
          continue;
        }
        double area = 0.0;
        for (Index outside : border.Outside)
        {
          area = std::max(area, areas[outside]);
        }
        Triangulator triangulator(mesh, border);
        if (triangulator.Run() && triangulator.GetArea() < LargestShare * area)
        {
          triangulator.Collect(fillings[i].Triangles, fillings[i].Neighbours);
        }
      }
    });
  // Two holes may have two points in common, but not the edge between them.
  std::set<std::pair<Index, Index>> edges;
  for (std::size_t i = 0; i < borders.size(); ++i)
  {
    const HoleFilling& filling = fillings[i];
    const std::set<std::pair<Index, Index>> own = GetInnerEdges(borders[i], filling.Triangles);
    const bool isFree =
      std::none_of(own.begin(), own.end(), [&](const auto& edge) { return edges.count(edge) > 0; });
    if (filling.Triangles.empty() || !isFree)
    {
      ++result.OpenHoles;
      continue;
    }
    ++result.FilledHoles;
    edges.insert(own.begin(), own.end());
    result.Triangles.insert(
      result.Triangles.end(), filling.Triangles.begin(), filling.Triangles.end());
    result.Neighbours.insert(
      result.Neighbours.end(), filling.Neighbours.begin(), filling.Neighbours.end());
  }
  return result;
}
}
