// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines of random meshes against brute force: the same segments, joined to the same chains. The
// meshes have borders, holes, several components, opposite windings, fans that meet in one point
// and edges of many triangles; the fields are often exactly 0.
#include "nprBruteForceLines.h"
#include "nprGivenLines.h"

#include "vtkNPRCreases.h"

#include <numeric>
#include <random>

using namespace nprtest;

namespace
{
using Random = std::mt19937;

// The standard's distributions differ from library to library.
int Draw(Random& random, int low, int high)
{
  return low + static_cast<int>(random() % static_cast<unsigned int>(high - low + 1));
}

double DrawReal(Random& random, double low, double high)
{
  return low + (high - low) * (random() / 4294967296.0);
}

bool DrawShare(Random& random, double share)
{
  return DrawReal(random, 0.0, 1.0) < share;
}

void AddTriangle(BruteForceMesh& mesh, std::array<int, 3> triangle, Random& random, double turned)
{
  if (DrawShare(random, turned))
  {
    std::swap(triangle[1], triangle[2]);
  }
  mesh.Triangles.push_back(triangle);
}

// Grids, with any diagonals and holes; those of one mesh lie apart.
BruteForceMesh MakeGrids(Random& random, bool flat)
{
  BruteForceMesh mesh;
  const double turned = Draw(random, 0, 1) * 0.2;
  const double holes = Draw(random, 0, 1) * 0.15;
  const int components = Draw(random, 1, 3);
  for (int component = 0; component < components; ++component)
  {
    const int nu = Draw(random, 2, 9);
    const int nv = Draw(random, 2, 9);
    const int first = static_cast<int>(mesh.Points.size());
    for (int i = 0; i < nu; ++i)
    {
      for (int j = 0; j < nv; ++j)
      {
        mesh.Points.emplace_back(4 * i + Draw(random, -1, 1) + 64 * component,
          4 * j + Draw(random, -1, 1), flat ? 0 : Draw(random, 0, 3));
      }
    }
    for (int i = 0; i + 1 < nu; ++i)
    {
      for (int j = 0; j + 1 < nv; ++j)
      {
        const int a = first + i * nv + j;
        const int b = a + nv;
        const int c = b + 1;
        const int d = a + 1;
        const bool falling = Draw(random, 0, 1) == 1;
        const std::array<int, 3> lower = { a, b, falling ? d : c };
        const std::array<int, 3> upper = { falling ? b : a, c, d };
        for (const std::array<int, 3>& triangle : { lower, upper })
        {
          if (!DrawShare(random, holes))
          {
            AddTriangle(mesh, triangle, random, turned);
          }
        }
      }
    }
  }
  return mesh;
}

// Fans around one hub, closed and open, some with pages in place of a spoke.
BruteForceMesh MakeFans(Random& random)
{
  BruteForceMesh mesh;
  mesh.Points.emplace_back(0.0, 0.0, 0.0);
  const int fans = Draw(random, 1, 4);
  for (int fan = 0; fan < fans; ++fan)
  {
    const int spokes = Draw(random, 3, 40);
    const int first = static_cast<int>(mesh.Points.size());
    for (int i = 0; i < spokes; ++i)
    {
      const double angle = 2.0 * Pi * i / spokes;
      mesh.Points.emplace_back(std::round(900.0 * std::cos(angle)),
        std::round(900.0 * std::sin(angle)), 40 * fan + Draw(random, 1, 30));
    }
    const bool closed = Draw(random, 0, 1) == 1;
    for (int i = 0; i + (closed ? 0 : 1) < spokes; ++i)
    {
      AddTriangle(mesh, { 0, first + i, first + (i + 1) % spokes }, random, 0.1);
    }
    const int pages = Draw(random, 0, 3);
    for (int page = 0; page < pages; ++page)
    {
      mesh.Points.emplace_back(100 * page + 7, -950 - fan, 500 + page);
      AddTriangle(mesh, { 0, first, static_cast<int>(mesh.Points.size()) - 1 }, random, 0.5);
    }
  }
  return mesh;
}

// Any triangles between few points: nearly every edge and point is one that no surface has.
BruteForceMesh MakeSoup(Random& random)
{
  BruteForceMesh mesh;
  const int points = Draw(random, 5, 14);
  for (int i = 0; i < points; ++i)
  {
    mesh.Points.emplace_back(8 * i + Draw(random, 0, 5), Draw(random, 0, 99), Draw(random, 0, 99));
  }
  std::set<std::set<int>> made;
  const int tries = Draw(random, 2, 40);
  for (int i = 0; i < tries; ++i)
  {
    const std::array<int, 3> triangle = { Draw(random, 0, points - 1), Draw(random, 0, points - 1),
      Draw(random, 0, points - 1) };
    const std::set<int> corners(triangle.begin(), triangle.end());
    if (corners.size() == 3 && made.insert(corners).second)
    {
      mesh.Triangles.push_back(triangle);
    }
  }
  return mesh;
}

// A closed surface.
BruteForceMesh MakeRing(Random& random)
{
  BruteForceMesh mesh;
  const int nu = Draw(random, 3, 20);
  const int nv = Draw(random, 3, 12);
  for (int i = 0; i < nu; ++i)
  {
    for (int j = 0; j < nv; ++j)
    {
      const Vector p = 800.0 * Torus().Point(2.0 * Pi * i / nu, 2.0 * Pi * j / nv);
      mesh.Points.emplace_back(std::round(p[0]), std::round(p[1]), std::round(p[2]));
    }
  }
  for (int i = 0; i < nu; ++i)
  {
    for (int j = 0; j < nv; ++j)
    {
      const int a = i * nv + j;
      const int b = (i + 1) % nu * nv + j;
      const int c = (i + 1) % nu * nv + (j + 1) % nv;
      const int d = i * nv + (j + 1) % nv;
      mesh.Triangles.push_back({ a, b, c });
      mesh.Triangles.push_back({ a, c, d });
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSurface(
  const BruteForceMesh& mesh, const std::vector<Vector>& normals)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector& point : mesh.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const std::array<int, 3>& c : mesh.Triangles)
  {
    triangles->InsertNextCell({ c[0], c[1], c[2] });
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  auto array = AddArray(surface, npr::names::Normals, 3);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), normals[i].data());
  }
  return surface;
}

std::vector<Chain> ExtractFrom(
  vtkPolyData* surface, vtkNPRLineDefinition* definition, vtkCamera* camera = nullptr)
{
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(definition);
  lines->SetCamera(camera);
  lines->SetInputData(surface);
  lines->Update();
  return GetChains(lines->GetOutput());
}

//------------------------------------------------------------------------------
// What happened in all meshes; a kind of trouble that never came up was not tested.
struct Coverage
{
  std::size_t Segments = 0;
  std::size_t Closed = 0;
  std::size_t Open = 0;
  std::size_t PointPlaces = 0;
  std::size_t Meetings = 0;
  std::size_t Cuts = 0;
};

void Compare(const BruteForceLines& truth, const std::vector<Chain>& chains, const char* what,
  int seed, Coverage& coverage, Checks& check)
{
  // The coordinates go up to a thousand; the library keeps what a test cuts in single precision.
  constexpr double tolerance = 2.0e-3;
  const std::size_t unmatched = CountUnmatched(truth.GetSegments(), GetSegments(chains), tolerance);
  if (!check(unmatched == 0, what, static_cast<double>(unmatched)))
  {
    std::cerr << "  segments differ; seed " << seed << "\n";
  }
  const std::vector<Form> forms = truth.GetForms();
  if (!check(forms == GetForms(chains), what, static_cast<double>(chains.size())))
  {
    std::cerr << "  of " << forms.size() << " chains; seed " << seed << "\n";
  }
  coverage.Segments += truth.GetSegments().size();
  for (const auto& [size, closed] : forms)
  {
    (closed ? coverage.Closed : coverage.Open) += 1;
  }
  coverage.PointPlaces += truth.CountPointPlaces();
  coverage.Meetings += truth.CountMeetings();
  coverage.Cuts += truth.CountCuts();
}

//------------------------------------------------------------------------------
void TestFields(const BruteForceMesh& mesh, bool flat, int seed, Random& random, Coverage& coverage,
  Checks& check)
{
  const std::size_t size = mesh.Points.size();
  BruteForceField values;
  const int range = Draw(random, 0, 4); // 0 has no zeros
  for (std::size_t i = 0; i < size; ++i)
  {
    values.Field.push_back(
      range > 0 ? Draw(random, -range, range) : static_cast<float>(DrawReal(random, -1.0, 1.0)));
  }
  auto surface = MakeSurface(mesh, std::vector<Vector>(size, Vector::UnitZ()));
  auto field = AddArray(surface, "Field", 1);
  auto test = AddArray(surface, "Test", 1);
  auto axes = AddArray(surface, "Axes", 3);
  std::vector<double> tests;
  std::vector<Vector> directions;
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    field->SetTuple1(id, values.Field[i]);
    tests.push_back(static_cast<float>(DrawReal(random, -0.5, 1.0)));
    test->SetTuple1(id, tests[i]);
    const double angle = DrawReal(random, -0.6, 0.6) + Pi * Draw(random, 0, 1);
    directions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    axes->SetTuple(id, directions[i].data());
  }
  const auto run = [&](const char* what)
  {
    vtkNew<GivenLines> definition;
    definition->Tested = !values.Test.empty();
    definition->Axial = !values.Axes.empty();
    BruteForceLines truth(mesh);
    truth.AddField(values);
    Compare(truth, ExtractFrom(surface, definition), what, seed, coverage, check);
  };
  run("a field");
  values.Test = tests;
  run("a field with a test");
  // The axes lie in the plane; elsewhere they would not be tangents.
  if (flat)
  {
    values.Axes = directions;
    run("a field with axes and a test");
    values.Test.clear();
    run("a field with axes");
  }
}

//------------------------------------------------------------------------------
// Normals and eyes of integers: n.v is exact, and often 0.
void TestContours(
  const BruteForceMesh& mesh, int seed, Random& random, Coverage& coverage, Checks& check)
{
  std::vector<Vector> normals;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    normals.emplace_back(Draw(random, -1, 1), Draw(random, -1, 1), Draw(random, 1, 2));
  }
  const bool parallel = Draw(random, 0, 1) == 1;
  // In parallel views the eye is at unit distance: along an axis that is exact.
  const Vector eye = parallel ? Vector(Vector::Unit(Draw(random, 0, 1)))
                              : Vector(Draw(random, -99, 99), Draw(random, -99, 99), 30);
  BruteForceField values;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    values.Field.push_back(normals[i].dot(parallel ? eye : Vector(eye - mesh.Points[i])));
  }
  BruteForceLines truth(mesh);
  truth.AddField(values);
  for (const auto& [edge, triangles] : truth.GetEdges())
  {
    if (triangles.size() == 1)
    {
      truth.AddEdge(edge);
    }
  }
  auto camera = MakeCamera(eye, parallel);
  const auto definition = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName("contours"));
  Compare(truth, ExtractFrom(MakeSurface(mesh, normals), definition, camera), "contours", seed,
    coverage, check);
}

//------------------------------------------------------------------------------
Vector GetAreaNormal(const BruteForceMesh& mesh, int t)
{
  const std::array<int, 3>& c = mesh.Triangles[t];
  return (mesh.Points[c[1]] - mesh.Points[c[0]]).cross(mesh.Points[c[2]] - mesh.Points[c[0]]);
}

// Whether two triangles run along their edge the same way.
bool IsOpposite(const BruteForceMesh& mesh, const std::vector<int>& triangles, int low, int high)
{
  const auto isForward = [&](int t)
  {
    const std::array<int, 3>& c = mesh.Triangles[t];
    return (c[0] == low && c[1] == high) || (c[1] == low && c[2] == high) ||
      (c[2] == low && c[0] == high);
  };
  return isForward(triangles[0]) == isForward(triangles[1]);
}

void TestEdges(const BruteForceMesh& mesh, int seed, Coverage& coverage, Checks& check)
{
  BruteForceLines boundaries(mesh);
  BruteForceLines creases(mesh);
  BruteForceLines junctions(mesh);
  const double cosine = std::cos(40.0 * Pi / 180.0);
  for (const auto& [edge, triangles] : boundaries.GetEdges())
  {
    if (triangles.size() == 1)
    {
      boundaries.AddEdge(edge);
      continue;
    }
    if (triangles.size() > 2)
    {
      junctions.AddEdge(edge);
      continue;
    }
    // Products of integers are exact.
    const Vector a = GetAreaNormal(mesh, triangles[0]);
    const Vector b = GetAreaNormal(mesh, triangles[1]);
    const double dot = IsOpposite(mesh, triangles, edge.first, edge.second) ? -a.dot(b) : a.dot(b);
    const double norms = a.norm() * b.norm();
    if (norms > 0.0 && dot < cosine * norms)
    {
      creases.AddEdge(edge);
    }
  }
  const auto surface = MakeSurface(mesh, std::vector<Vector>(mesh.Points.size(), Vector::UnitZ()));
  const auto borders = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName("boundaries"));
  Compare(boundaries, ExtractFrom(surface, borders), "boundaries", seed, coverage, check);
  vtkNew<vtkNPRCreases> sharp;
  sharp->SetLeastEdges(1.0);
  sharp->SetTolerance(0.0);
  Compare(creases, ExtractFrom(surface, sharp), "creases", seed, coverage, check);
  const auto meetings = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName("non-manifold"));
  Compare(junctions, ExtractFrom(surface, meetings), "non-manifold", seed, coverage, check);
}

//------------------------------------------------------------------------------
// On a sphere every closed line parts one region from another: there is one region more than lines.
void TestEuler(int seed, Random& random, Checks& check)
{
  const auto sphere = MakeSphere(12, 1.0);
  const vtkIdType size = sphere->GetNumberOfPoints();
  auto field = AddArray(sphere, "Field", 1);
  const double share = DrawReal(random, 0.2, 0.8);
  for (vtkIdType i = 0; i < size; ++i)
  {
    field->SetTuple1(i, DrawReal(random, 0.1, 1.0) * (DrawShare(random, share) ? 1.0 : -1.0));
  }
  std::vector<vtkIdType> regions(size);
  std::iota(regions.begin(), regions.end(), 0);
  const auto findRoot = [&regions](vtkIdType point)
  {
    while (regions[point] != point)
    {
      point = regions[point];
    }
    return point;
  };
  vtkIdType count = size;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < sphere->GetNumberOfPolys(); ++t)
  {
    sphere->GetPolys()->GetCellAtId(t, ids);
    for (int e = 0; e < 3; ++e)
    {
      const vtkIdType a = ids->GetId(e);
      const vtkIdType b = ids->GetId((e + 1) % 3);
      if ((field->GetTuple1(a) > 0.0) == (field->GetTuple1(b) > 0.0) && findRoot(a) != findRoot(b))
      {
        regions[findRoot(a)] = findRoot(b);
        --count;
      }
    }
  }
  vtkNew<GivenLines> definition;
  const auto chains = ExtractFrom(sphere, definition);
  check(static_cast<vtkIdType>(chains.size()) + 1 == count,
    "a sphere has one region more than closed lines", seed);
  check(std::all_of(chains.begin(), chains.end(), [](const Chain& chain) { return chain.Closed; }),
    "all lines on a sphere are closed", seed);
}
}

int TestLinesBruteForce(int, char*[])
{
  Checks check;
  Coverage coverage;
  for (int seed = 1; seed <= 120; ++seed)
  {
    Random random(static_cast<unsigned int>(seed));
    const bool flat = seed % 2 == 0;
    for (const BruteForceMesh& mesh :
      { MakeGrids(random, flat), MakeFans(random), MakeSoup(random), MakeRing(random) })
    {
      const bool isFlat = std::all_of(mesh.Points.begin(), mesh.Points.end(),
        [](const Vector& point) { return point[2] == 0.0; });
      TestFields(mesh, isFlat, seed, random, coverage, check);
      TestContours(mesh, seed, random, coverage, check);
      TestEdges(mesh, seed, coverage, check);
    }
    TestEuler(seed, random, check);
  }
  check(coverage.Segments > 100000, "there are segments", double(coverage.Segments));
  check(coverage.Closed > 1000, "there are closed chains", double(coverage.Closed));
  check(coverage.Open > 10000, "there are open chains", double(coverage.Open));
  check(coverage.PointPlaces > 10000, "lines go through points", double(coverage.PointPlaces));
  check(coverage.Meetings > 1000, "many lines meet in a place", double(coverage.Meetings));
  check(coverage.Cuts > 1000, "lines end in triangles", double(coverage.Cuts));
  return check.GetResult();
}
