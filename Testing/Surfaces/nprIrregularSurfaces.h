// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprIrregularSurfaces.h
 * @brief Meshes as they come from scanners and isosurfaces, of surfaces that are known by formula.
 *
 * Jittered grids are made by MakeSurface(surface, nu, nv, jitter). All is the same for the same
 * seed; points are in double precision.
 */
#ifndef nprIrregularSurfaces_h
#define nprIrregularSurfaces_h

#include "nprAnalyticSurfaces.h"

#include <vtkIdList.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <tuple>
#include <unordered_map>

namespace nprtest
{
/// In [-1, 1), the same on every machine.
inline double RandomOffset(std::mt19937& random)
{
  return random() / 2147483648.0 - 1.0;
}

/// About normally distributed, with mean 0 and standard deviation 1.
inline double RandomDeviation(std::mt19937& random)
{
  double sum = 0.0;
  for (int i = 0; i < 12; ++i)
  {
    sum += 0.5 * RandomOffset(random);
  }
  return sum;
}

using Corners = std::array<vtkIdType, 3>;

inline std::vector<Corners> GetTriangles(vtkPolyData* mesh)
{
  std::vector<Corners> triangles;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < mesh->GetPolys()->GetNumberOfCells(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, corners);
    triangles.push_back({ corners->GetId(0), corners->GetId(1), corners->GetId(2) });
  }
  return triangles;
}

inline vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<Truth>& truths, const std::vector<Corners>& triangles)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Truth& truth : truths)
  {
    points->InsertNextPoint(truth.Point.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const Corners& corners : triangles)
  {
    cells->InsertNextCell(3, corners.data());
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

/// Turns edges over at random, where both new triangles keep a decent shape and the sides that they
/// show. Neither points nor border change, but the numbers of triangles at the points do.
/// @param share how many of the edges are tried, in [0, 1]
inline void FlipEdges(AnalyticSurface& surface, double share, unsigned int seed)
{
  std::vector<Corners> triangles = GetTriangles(surface.Mesh);
  const auto key = [](vtkIdType a, vtkIdType b)
  { return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint64_t>(b); };
  std::unordered_map<std::uint64_t, std::size_t> triangleAt; // by directed edge
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      triangleAt[key(triangles[t][e], triangles[t][(e + 1) % 3])] = t;
    }
  }
  const auto at = [&](vtkIdType i)
  {
    Vector3d p;
    surface.Mesh->GetPoint(i, p.data());
    return p;
  };
  // Whether the triangle faces as the surface does, and is no thinner than one of 15 degrees.
  const auto isDecent = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const Vector3d p[3] = { at(a), at(b), at(c) };
    const Vector3d areaNormal = (p[1] - p[0]).cross(p[2] - p[0]);
    double longest = 0.0;
    for (int e = 0; e < 3; ++e)
    {
      longest = std::max(longest, (p[(e + 1) % 3] - p[e]).squaredNorm());
    }
    return areaNormal.norm() > 0.25 * longest &&
      areaNormal.dot(surface.Truths[a].Normal) > 0.8 * areaNormal.norm();
  };
  std::mt19937 random(seed);
  const auto attempts = static_cast<std::size_t>(1.5 * share * triangles.size());
  for (std::size_t attempt = 0; attempt < attempts; ++attempt)
  {
    const std::size_t t = random() % triangles.size();
    const int e = static_cast<int>(random() % 3);
    const vtkIdType a = triangles[t][e];
    const vtkIdType b = triangles[t][(e + 1) % 3];
    const vtkIdType c = triangles[t][(e + 2) % 3];
    const auto other = triangleAt.find(key(b, a));
    if (other == triangleAt.end())
    {
      continue;
    }
    const std::size_t o = other->second;
    const Corners& facing = triangles[o];
    const vtkIdType d = facing[0] != a && facing[0] != b ? facing[0]
      : facing[1] != a && facing[1] != b                 ? facing[1]
                                                         : facing[2];
    if (triangleAt.count(key(c, d)) || triangleAt.count(key(d, c)) || !isDecent(a, d, c) ||
      !isDecent(d, b, c))
    {
      continue;
    }
    triangleAt.erase(key(a, b));
    triangleAt.erase(key(b, a));
    triangles[t] = { a, d, c };
    triangles[o] = { d, b, c };
    for (const std::size_t changed : { t, o })
    {
      for (int i = 0; i < 3; ++i)
      {
        triangleAt[key(triangles[changed][i], triangles[changed][(i + 1) % 3])] = changed;
      }
    }
  }
  surface.Mesh = MakeMesh(surface.Truths, triangles);
}

/**
 * A sphere of 8 n^2 triangles as from a random remesher, mapped to an ellipsoid: an octahedron's
 * grid is wrapped around the sphere so that all its cells have the same area, the points are moved
 * at random by up to 0.35 of an edge, and edges are turned over at random.
 *
 * @param axes semi-axes; all 1 for the unit sphere
 * @param irregular whether to move points and turn edges
 */
inline AnalyticSurface MakeRemeshedEllipsoid(
  const Vector3d& axes, int n, unsigned int seed = 1, bool irregular = true)
{
  std::mt19937 random(seed);
  const double edge = std::sqrt(4.0 * Pi / (8.0 * n * n) * 4.0 / std::sqrt(3.0));
  AnalyticSurface sphere;
  std::vector<Vector3d> directions;
  // The points by their place on the octahedron |i| + |j| + |k| = n.
  std::map<std::array<int, 3>, vtkIdType> ids;
  const auto getPoint = [&](const std::array<int, 3>& place)
  {
    const auto added = ids.emplace(place, static_cast<vtkIdType>(directions.size()));
    if (added.second)
    {
      const int around = n - std::abs(place[2]);
      const double r = static_cast<double>(around) / n;
      const double quadrant =
        around == 0 ? 0.0 : 0.5 * Pi * std::abs(place[1]) / static_cast<double>(around);
      const double s = r * std::sqrt(2.0 - r * r);
      Vector3d direction(s * std::cos(quadrant), s * std::sin(quadrant), 1.0 - r * r);
      for (int i = 0; i < 3; ++i)
      {
        direction[i] *= place[i] < 0 ? -1.0 : 1.0;
      }
      if (irregular)
      {
        const npr::TangentFrame frame = npr::MakeTangentFrame(direction);
        const double distance = 0.35 * edge * std::sqrt(0.5 + 0.5 * RandomOffset(random));
        const double angle = Pi * RandomOffset(random);
        direction = (direction + distance * (std::cos(angle) * frame.U + std::sin(angle) * frame.V))
                      .normalized();
      }
      directions.push_back(direction);
    }
    return added.first->second;
  };
  std::vector<Corners> triangles;
  for (int octant = 0; octant < 8; ++octant)
  {
    const int sx = (octant & 1) ? -1 : 1;
    const int sy = (octant & 2) ? -1 : 1;
    const int sz = (octant & 4) ? -1 : 1;
    const auto add = [&](std::array<int, 3> a, std::array<int, 3> b, std::array<int, 3> c)
    {
      Corners corners;
      const std::array<int, 3>* places[3] = { &a, &b, &c };
      for (int i = 0; i < 3; ++i)
      {
        const auto& place = *places[i];
        corners[i] = getPoint({ sx * place[0], sy * place[1], sz * place[2] });
      }
      if (sx * sy * sz < 0)
      {
        std::swap(corners[1], corners[2]);
      }
      triangles.push_back(corners);
    };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; i + j < n; ++j)
      {
        const int k = n - i - j;
        add({ i + 1, j, k - 1 }, { i, j + 1, k - 1 }, { i, j, k });
        if (k > 1)
        {
          add({ i + 1, j, k - 1 }, { i + 1, j + 1, k - 2 }, { i, j + 1, k - 1 });
        }
      }
    }
  }
  for (const Vector3d& direction : directions)
  {
    sphere.Truths.push_back(MakeEllipsoidTruth(Vector3d::Ones(), direction));
  }
  sphere.Mesh = MakeMesh(sphere.Truths, triangles);
  if (irregular)
  {
    FlipEdges(sphere, 0.5, seed + 1);
  }
  AnalyticSurface ellipsoid;
  for (const Vector3d& direction : directions)
  {
    ellipsoid.Truths.push_back(MakeEllipsoidTruth(axes, direction));
  }
  ellipsoid.Mesh = MakeMesh(ellipsoid.Truths, GetTriangles(sphere.Mesh));
  return ellipsoid;
}

/// The torus whose parameters both stray by 0.3 of a cell, R = 1, r = 0.4: 5 n^2
/// triangles. n = 24, 48, 96, 192 give about 3, 12, 46 and 184 thousand.
inline AnalyticSurface MakeJitteredTorus(int n, unsigned int seed = 1)
{
  return MakeSurface(Torus(1.0, 0.4), 5 * n / 2, n, { 0.3, seed });
}

/// Mean length of the edges at each point; an inner edge counts twice.
inline std::vector<double> GetMeanEdges(vtkPolyData* mesh)
{
  std::vector<double> sums(mesh->GetNumberOfPoints(), 0.0);
  std::vector<int> counts(mesh->GetNumberOfPoints(), 0);
  for (const Corners& corners : GetTriangles(mesh))
  {
    for (int e = 0; e < 3; ++e)
    {
      const vtkIdType ends[2] = { corners[e], corners[(e + 1) % 3] };
      Vector3d p, q;
      mesh->GetPoint(ends[0], p.data());
      mesh->GetPoint(ends[1], q.data());
      for (const vtkIdType end : ends)
      {
        sums[end] += (q - p).norm();
        ++counts[end];
      }
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    sums[i] /= std::max(counts[i], 1);
  }
  return sums;
}

/// Moves the points along the true normals; what was true of the surface stays the truth.
/// @param deviation standard deviation, as a fraction of the mean edge at the point
inline void AddNoise(AnalyticSurface& surface, double deviation, unsigned int seed = 1)
{
  std::mt19937 random(seed);
  const std::vector<double> edges = GetMeanEdges(surface.Mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < surface.Truths.size(); ++i)
  {
    const Truth& truth = surface.Truths[i];
    const Vector3d p = truth.Point + deviation * edges[i] * RandomDeviation(random) * truth.Normal;
    points->InsertNextPoint(p.data());
  }
  surface.Mesh->SetPoints(points);
}

/// The triangles whose three points are inside, and the points that they need.
inline AnalyticSurface CutOut(
  const AnalyticSurface& surface, const std::function<bool(const Vector3d&)>& isInside)
{
  AnalyticSurface part;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  std::vector<vtkIdType> ids(surface.Truths.size(), -1);
  for (const Corners& corners : GetTriangles(surface.Mesh))
  {
    if (!std::all_of(corners.begin(), corners.end(),
          [&](vtkIdType i) { return isInside(surface.Truths[i].Point); }))
    {
      continue;
    }
    cells->InsertNextCell(3);
    for (const vtkIdType corner : corners)
    {
      if (ids[corner] < 0)
      {
        ids[corner] = points->InsertNextPoint(surface.Mesh->GetPoint(corner));
        part.Truths.push_back(surface.Truths[corner]);
      }
      cells->InsertCellPoint(ids[corner]);
    }
  }
  part.Mesh = vtkSmartPointer<vtkPolyData>::New();
  part.Mesh->SetPoints(points);
  part.Mesh->SetPolys(cells);
  return part;
}

/// The part of a surface above a slanting plane through the origin: its border runs through
/// triangles of every kind.
inline AnalyticSurface CutByPlane(const AnalyticSurface& surface)
{
  return CutOut(surface, [](const Vector3d& p) { return p.dot(Vector3d(0.48, 0.36, 0.8)) > 0.03; });
}
}

#endif
