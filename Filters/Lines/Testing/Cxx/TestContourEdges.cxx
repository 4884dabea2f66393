// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The outline of meshes with whole coordinates, seen from whole points and in whole directions,
// against arithmetic that does not round: boxes and grids, most faces of which are seen edge-on.
#include "nprLineTesting.h"

#include <vtkIdList.h>

#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>

using namespace nprtest;

namespace
{
using Whole = std::array<std::int64_t, 3>;
using Edge = std::array<Whole, 2>; // the lesser end first

struct Mesh
{
  std::vector<Whole> Points;
  std::vector<std::array<int, 3>> Triangles;
};

// In a soup each triangle has points of its own, as if all its edges were creases that the
// preparation split.
vtkSmartPointer<vtkPolyData> MakeSurface(const Mesh& mesh, bool isSoup)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  const auto insert = [&](const Whole& p)
  {
    return points->InsertNextPoint(
      static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
  };
  if (!isSoup)
  {
    std::for_each(mesh.Points.begin(), mesh.Points.end(), insert);
  }
  vtkNew<vtkCellArray> triangles;
  std::vector<vtkIdType> firsts(mesh.Points.size(), -1);
  std::vector<vtkIdType> welded;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    std::array<vtkIdType, 3> corners = { t[0], t[1], t[2] };
    for (int i = 0; isSoup && i < 3; ++i)
    {
      corners[i] = insert(mesh.Points[t[i]]);
      firsts[t[i]] = firsts[t[i]] < 0 ? corners[i] : firsts[t[i]];
      welded.push_back(firsts[t[i]]);
    }
    triangles->InsertNextCell({ corners[0], corners[1], corners[2] });
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  if (isSoup)
  {
    AddWeldedIds(surface, welded);
  }
  return surface;
}

// The surface of the cells of a grid for which `isFull` holds, each quad as two triangles. Where
// cells touch along an edge only, that edge has four triangles.
Mesh MakeBlocks(int n, const std::function<bool(int, int, int)>& isFull)
{
  Mesh mesh;
  std::map<Whole, int> ids;
  const auto full = [&](const Whole& c)
  {
    return std::all_of(c.begin(), c.end(), [n](std::int64_t x) { return x >= 0 && x < n; }) &&
      isFull(static_cast<int>(c[0]), static_cast<int>(c[1]), static_cast<int>(c[2]));
  };
  for (std::int64_t i = 0; i < std::int64_t(n) * n * n; ++i)
  {
    const Whole cell = { i % n, i / n % n, i / n / n };
    for (int face = 0; full(cell) && face < 6; ++face)
    {
      const int axis = face / 2;
      Whole other = cell;
      other[axis] += face % 2 == 1 ? 1 : -1;
      if (full(other))
      {
        continue;
      }
      std::array<int, 4> corners;
      for (int c = 0; c < 4; ++c)
      {
        Whole p = cell;
        p[axis] += face % 2;
        p[(axis + 1) % 3] += c == 1 || c == 2;
        p[(axis + 2) % 3] += c >= 2;
        const auto [place, isNew] = ids.emplace(p, static_cast<int>(mesh.Points.size()));
        if (isNew)
        {
          mesh.Points.push_back(p);
        }
        corners[face % 2 == 1 ? c : 3 - c] = place->second;
      }
      mesh.Triangles.push_back({ corners[0], corners[1], corners[2] });
      mesh.Triangles.push_back({ corners[0], corners[2], corners[3] });
    }
  }
  return mesh;
}

Mesh MakeSheet(int n, std::mt19937& random)
{
  Mesh mesh;
  for (int i = 0; i < n * n; ++i)
  {
    mesh.Points.push_back({ i / n, i % n, static_cast<int>(random() % 3) });
  }
  for (int i = 0; i + 1 < n; ++i)
  {
    for (int j = 0; j + 1 < n; ++j)
    {
      const int a = i * n + j;
      mesh.Triangles.push_back({ a, a + n, a + n + 1 });
      mesh.Triangles.push_back({ a, a + n + 1, a + 1 });
    }
  }
  return mesh;
}

// Whether a triangle faces the eye, or in parallel projection the direction to it.
bool IsFront(const Mesh& mesh, const std::array<int, 3>& t, const Whole& eye, bool parallel)
{
  const Whole& p = mesh.Points[t[0]];
  Whole a, b, e;
  for (int i = 0; i < 3; ++i)
  {
    a[i] = mesh.Points[t[1]][i] - p[i];
    b[i] = mesh.Points[t[2]][i] - p[i];
    e[i] = eye[i] - (parallel ? 0 : p[i]);
  }
  return (a[1] * b[2] - a[2] * b[1]) * e[0] + (a[2] * b[0] - a[0] * b[2]) * e[1] +
    (a[0] * b[1] - a[1] * b[0]) * e[2] >=
    0;
}

struct Truth
{
  std::map<Edge, int> Edges;               // and how many triangles each has
  std::set<std::array<Whole, 2>> Directed; // with the front triangle, or the only one, on the left
};

// On edges with four triangles, each pair of blocks has an outline of its own; they cancel where
// both run along the edge, in opposite directions.
Truth FindTruth(const Mesh& mesh, const Whole& eye, bool parallel)
{
  struct Sides
  {
    int Count = 0;
    int Balance = 0; // of triangles that face the eye, by the direction in which they run
    bool Forward = true;
  };
  std::map<Edge, Sides> all;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const bool front = IsFront(mesh, t, eye, parallel);
    for (int e = 0; e < 3; ++e)
    {
      const Whole& a = mesh.Points[t[e]];
      const Whole& b = mesh.Points[t[(e + 1) % 3]];
      Sides& sides = all[a < b ? Edge{ a, b } : Edge{ b, a }];
      ++sides.Count;
      sides.Forward = a < b;
      sides.Balance += front ? (a < b ? 1 : -1) : 0;
    }
  }
  Truth truth;
  for (const auto& [edge, sides] : all)
  {
    if (sides.Count == 1 || sides.Balance != 0)
    {
      const bool forward = sides.Count == 1 ? sides.Forward : sides.Balance > 0;
      truth.Edges[edge] = sides.Count;
      truth.Directed.insert(forward ? edge : Edge{ edge[1], edge[0] });
    }
  }
  return truth;
}

// Whether a line that comes from one point and goes on to another passes around a fan of triangles
// that face the eye: from the one on its left before to the one on its left after, across edges
// that are not of the outline (or have many triangles, some of which may go on).
bool IsAroundFan(const Mesh& mesh, const Truth& truth, const std::array<Whole, 3>& way,
  const std::function<bool(const std::array<int, 3>&)>& isFront)
{
  // The neighbours of the point in the middle, in pairs: before and after, in each front triangle.
  std::vector<std::array<Whole, 2>> corners;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (mesh.Points[t[i]] == way[1] && isFront(t))
      {
        corners.push_back({ mesh.Points[t[(i + 2) % 3]], mesh.Points[t[(i + 1) % 3]] });
      }
    }
  }
  std::set<Whole> reached;
  std::vector<Whole> open = { way[0] };
  while (!open.empty())
  {
    const Whole from = open.back();
    open.pop_back();
    for (const auto& [before, after] : corners)
    {
      if (before == from && reached.insert(after).second)
      {
        const auto edge =
          truth.Edges.find(after < way[1] ? Edge{ after, way[1] } : Edge{ way[1], after });
        if (edge == truth.Edges.end() || edge->second > 2)
        {
          open.push_back(after);
        }
      }
    }
  }
  return reached.count(way[2]) == 1;
}

Whole ToWhole(const Vector& p)
{
  return { std::llround(p[0]), std::llround(p[1]), std::llround(p[2]) };
}

enum class Kind
{
  Open,
  Closed,
  Soup // closed as well
};

struct Result
{
  int Edges = 0;
  int EdgeOn = 0;   // triangles that are seen exactly so
  int Meetings = 0; // of lines, where more than two edges meet
};

// Where triangles have agreeing orientations and there are no borders.
void CheckWays(const Mesh& mesh, const Truth& truth, const std::vector<Chain>& chains,
  const Whole& eye, bool parallel, Result& result, Checks& check)
{
  std::map<Whole, int> degrees;
  for (const auto& [edge, count] : truth.Edges)
  {
    ++degrees[edge[0]];
    ++degrees[edge[1]];
  }
  const auto isFront = [&](const std::array<int, 3>& t) { return IsFront(mesh, t, eye, parallel); };
  for (const Chain& chain : chains)
  {
    check(chain.Closed, "on a closed surface the outline is closed");
    for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i)
    {
      const Whole a = ToWhole(chain.Points[i]);
      const Whole b = ToWhole(chain.Next(i));
      const Whole c = ToWhole(chain.Next((i + 1) % chain.Points.size()));
      check(truth.Directed.count({ a, b }) == 1, "the front is on the left");
      if (chain.Closed && degrees[b] > 2)
      {
        ++result.Meetings;
        check(IsAroundFan(mesh, truth, { a, b, c }, isFront),
          "where lines meet, each goes around one fan of triangles");
      }
    }
  }
}

Result CheckView(const Mesh& mesh, Kind kind, const Whole& eye, bool parallel, Checks& check)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(
    static_cast<double>(eye[0]), static_cast<double>(eye[1]), static_cast<double>(eye[2]));
  // Only in parallel projection does it matter where the camera looks.
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetParallelProjection(parallel);
  const auto chains = Extract(MakeSurface(mesh, kind == Kind::Soup), { "contour-edges" }, camera);
  const Truth truth = FindTruth(mesh, eye, parallel);

  std::set<Edge> found;
  std::size_t pieces = 0;
  for (const Chain& chain : chains)
  {
    for (std::size_t i = 0; i < chain.GetNumberOfSegments(); ++i, ++pieces)
    {
      const Whole a = ToWhole(chain.Points[i]);
      const Whole b = ToWhole(chain.Next(i));
      found.insert(a < b ? Edge{ a, b } : Edge{ b, a });
    }
  }
  check(pieces == found.size(), "no edge comes twice");
  check(found.size() == truth.Edges.size() &&
      std::all_of(
        found.begin(), found.end(), [&](const Edge& edge) { return truth.Edges.count(edge) == 1; }),
    "the outline is the same in whole numbers",
    static_cast<double>(found.size()) - static_cast<double>(truth.Edges.size()));
  Result result;
  result.Edges = static_cast<int>(found.size());
  if (kind != Kind::Open)
  {
    CheckWays(mesh, truth, chains, eye, parallel, result, check);
  }
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    result.EdgeOn +=
      IsFront(mesh, t, eye, parallel) && IsFront(mesh, { t[0], t[2], t[1] }, eye, parallel);
  }
  return result;
}

// How often lines meet.
int TestAgainstWholeNumbers(
  const Mesh& mesh, Kind kind, int size, std::mt19937& random, Checks& check)
{
  Result all;
  for (int view = 0; view < 60; ++view)
  {
    // Near enough that the eye is often in the plane of faces, at times within, or at a point.
    Whole eye;
    for (std::int64_t& x : eye)
    {
      x = static_cast<std::int64_t>(random() % (3 * size)) - size;
    }
    for (const bool parallel : { false, true })
    {
      if (!parallel || eye != Whole{ 0, 0, 0 })
      {
        const Result result = CheckView(mesh, kind, eye, parallel, check);
        all.Edges += result.Edges;
        all.EdgeOn += result.EdgeOn;
        all.Meetings += result.Meetings;
      }
    }
  }
  check(all.Edges > 1000 && all.EdgeOn > 300, "there are edges, and triangles seen edge-on",
    static_cast<double>(std::min(all.Edges, all.EdgeOn)));
  return all.Meetings;
}

// The same box, split at its edges as the preparation does: points differ, welded ids agree.
void TestSplit(Checks& check)
{
  for (const bool split : { false, true })
  {
    const auto outline =
      Extract(MakeCube(split), { "contour-edges" }, MakeCamera({ 5.0, 4.0, 3.0 }));
    CheckSound(outline, check);
    check(outline.size() == 1 && outline[0].Closed && outline[0].Points.size() == 6 &&
        GetLength(outline[0]) == 12.0,
      "the outline of a cube is a hexagon of its edges", static_cast<double>(outline.size()));
  }
}

// On a fine sphere the edges run beside the smooth contour; facets do not turn that far.
void TestSphere(Checks& check)
{
  const int n = 60;
  const auto outline =
    Extract(MakeSphere(n, 1.0), { "contour-edges" }, MakeCamera({ 3.0, 2.0, 1.5 }));
  check(!outline.empty(), "a sphere has an outline");
  const Vector eye(3.0, 2.0, 1.5);
  for (const Chain& chain : outline)
  {
    for (const Vector& p : chain.Points)
    {
      check(std::abs(p.dot((eye - p).normalized())) < 2.0 * Pi / n,
        "edges of the outline are at the smooth contour, within an edge");
    }
  }
}
}

int TestContourEdges(int, char*[])
{
  Checks check;
  std::mt19937 random(7);
  const auto always = [](int, int, int) { return true; };
  TestAgainstWholeNumbers(MakeBlocks(5, always), Kind::Closed, 5, random, check);
  // An L: faces that look at each other, corners that bend inwards.
  TestAgainstWholeNumbers(MakeBlocks(4, [](int x, int y, int) { return x < 2 || y < 2; }),
    Kind::Closed, 4, random, check);
  // Blocks that touch along edges and at corners.
  std::array<bool, 64> full;
  std::generate(full.begin(), full.end(), [&random]() { return random() % 2 == 0; });
  const Mesh touching =
    MakeBlocks(4, [&full](int x, int y, int z) { return full[x + 4 * y + 16 * z]; });
  for (const Kind kind : { Kind::Closed, Kind::Soup })
  {
    const int meetings = TestAgainstWholeNumbers(touching, kind, 4, random, check);
    check(meetings > 500, "lines meet at blocks that touch", meetings);
  }
  // A box whose points have moved: most of its triangles have planes of their own.
  Mesh bent = MakeBlocks(5, always);
  for (Whole& p : bent.Points)
  {
    for (std::int64_t& x : p)
    {
      x = 3 * x + static_cast<int>(random() % 3) - 1;
    }
  }
  const int meetings = TestAgainstWholeNumbers(bent, Kind::Closed, 15, random, check);
  check(meetings > 500, "lines meet between triangles that are not in one plane", meetings);
  TestAgainstWholeNumbers(MakeSheet(12, random), Kind::Open, 12, random, check);
  TestSplit(check);
  TestSphere(check);
  return check.GetResult();
}
