// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Manifolds out of what is none, by hand and at random, and what the surface says of it.
#include "nprAnalyticSurfaces.h"
#include "nprArrayNames.h"
#include "nprManifoldChecks.h"
#include "nprPointValues.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkSMPTools.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

using namespace nprtest;

namespace
{
using Points = std::vector<std::array<double, 3>>;
using Expected = std::map<std::string, vtkIdType>;

/// Prepares a mesh; the counts are those that are expected, and all others are zero, in the array
/// and in the report alike.
vtkSmartPointer<vtkPolyData> Prepare(Checks& check, const std::string& what,
  vtkNPRSurfacePreparation* preparation, vtkPolyData* mesh, const Expected& expected)
{
  preparation->SetInputData(mesh);
  preparation->Update();
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->DeepCopy(preparation->GetOutput());
  auto* counts =
    vtkIdTypeArray::SafeDownCast(output->GetFieldData()->GetArray(npr::names::PreparationCounts));
  if (!check(counts && counts->GetNumberOfTuples() == 1, what + ": there are counts"))
  {
    return output;
  }
  std::size_t found = 0;
  for (int i = 0; i < counts->GetNumberOfComponents(); ++i)
  {
    const char* const name = counts->GetComponentName(i);
    if (!check(name != nullptr, what + ": each count has a name"))
    {
      continue;
    }
    const auto place = expected.find(name);
    const vtkIdType value = counts->GetValue(i);
    check(value == (place == expected.end() ? 0 : place->second), what + ": " + name,
      static_cast<double>(value));
    found += place != expected.end();
    if (value > 0)
    {
      check(preparation->GetReport().find(std::to_string(value) + " ") != std::string::npos,
        what + ": the report has " + name);
    }
  }
  check(found == expected.size(), what + ": all that are expected are counts");
  return output;
}

/// After the split: a manifold whose triangles agree, with the points of before.
void CheckManifold(Checks& check, const std::string& what, vtkPolyData* output)
{
  const Shape shape = GetShape(output);
  check(shape.NonManifoldEdges == 0, what + ": edges have two triangles",
    static_cast<double>(shape.NonManifoldEdges));
  check(shape.ManyFans == 0, what + ": points have one fan", static_cast<double>(shape.ManyFans));
  check(shape.Unused == 0, what + ": points are used", static_cast<double>(shape.Unused));
  check(
    shape.Disagreements == 0, what + ": triangles agree", static_cast<double>(shape.Disagreements));
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto first = static_cast<vtkIdType>(GetValue(output, npr::names::WeldedPointIds, i));
    double a[3];
    double b[3];
    output->GetPoint(i, a);
    output->GetPoint(first, b);
    check(GetValue(output, npr::names::WeldedPointIds, first) == static_cast<double>(first) &&
        a[0] == b[0] && a[1] == b[1] && a[2] == b[2],
      what + ": copies know their first");
  }
}

//------------------------------------------------------------------------------
void TestSheetsAtAnEdge(Checks& check)
{
  // A book of three sheets, and one of two cubes that share an edge.
  const Points points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 }, { -1, -1, 0 } };
  const auto book = MakeMesh(points, { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 0, 4 } });
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SplitCreasesOff();
  auto output = Prepare(check, "book", preparation, book,
    { { "NonManifoldEdges", 1 }, { "NonManifoldSplitPoints", 4 }, { "BoundaryEdges", 6 } });
  check(output->GetNumberOfPoints() == 9, "each sheet has its own points");
  CheckManifold(check, "book", output);
  check(preparation->GetNumberOfNonManifoldEdges() == 1 &&
      preparation->GetNumberOfNonManifoldSplitPoints() == 4 &&
      preparation->GetNumberOfNonManifoldPoints() == 0,
    "the getters say the same");

  preparation->SplitNonManifoldOff();
  output = Prepare(
    check, "book, whole", preparation, book, { { "NonManifoldEdges", 1 }, { "BoundaryEdges", 6 } });
  check(output->GetNumberOfPoints() == 5, "it can be left");

  // Creases are another matter: a fin on a fold is split at the fold only.
  preparation->SplitCreasesOn();
  preparation->SplitNonManifoldOff();
  output = Prepare(check, "book, creases", preparation, book,
    { { "NonManifoldEdges", 1 }, { "BoundaryEdges", 6 } });
  check(output->GetNumberOfPoints() == 5, "it has no crease, which takes two triangles");
}

//------------------------------------------------------------------------------
/// The twelve triangles of a box, outward or all inward.
void AddBox(Points& points, std::vector<Corners>& triangles, double x, double y, bool inward)
{
  const auto first = static_cast<vtkIdType>(points.size());
  for (int i = 0; i < 8; ++i)
  {
    points.push_back(
      { x + static_cast<double>(i & 1), y + static_cast<double>(i >> 1 & 1), i < 4 ? 0.0 : 1.0 });
  }
  const int quads[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& q : quads)
  {
    for (int half = 0; half < 2; ++half)
    {
      Corners corners = { first + q[0], first + q[1 + half], first + q[2 + half] };
      if (inward)
      {
        std::swap(corners[1], corners[2]);
      }
      triangles.push_back(corners);
    }
  }
}

void TestBoxesAtAnEdge(Checks& check)
{
  // Two boxes that share an edge come apart, and then each is closed and turned outward.
  Points points;
  std::vector<Corners> triangles;
  AddBox(points, triangles, 0.0, 0.0, false);
  AddBox(points, triangles, 1.0, 1.0, true);
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SplitCreasesOff();
  const auto output = Prepare(check, "boxes", preparation, MakeMesh(points, triangles),
    { { "WeldedPoints", 2 }, { "NonManifoldEdges", 1 }, { "NonManifoldSplitPoints", 2 },
      { "ReorientedTriangles", 12 } });
  CheckManifold(check, "boxes", output);
  const Shape shape = GetShape(output);
  check(shape.BoundaryEdges == 0 && shape.EulerCharacteristic == 4, "two closed boxes");
}

//------------------------------------------------------------------------------
/// A box whose faces are grids, each as fine as it likes, as programs for CAD write it: in a text,
/// with six digits.
vtkSmartPointer<vtkPolyData> MakeGridBox(const std::array<int, 6>& fineness, double gap)
{
  Points points;
  std::vector<Corners> triangles;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const int size = fineness[face];
    const auto first = static_cast<vtkIdType>(points.size());
    for (int i = 0; i <= size; ++i)
    {
      for (int j = 0; j <= size; ++j)
      {
        std::array<double, 3> corner;
        corner[axis] = face % 2 == 0 ? 0.0 : 1.0 + (face == 5 ? gap : 0.0);
        corner[(axis + 1) % 3] = double(i) / size;
        corner[(axis + 2) % 3] = double(j) / size;
        // Along no axis, so that rounding takes points off the edges.
        const Vector3d turned = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()) *
          Vector3d(corner[0], 2.0 * corner[1], 3.0 * corner[2]);
        for (int c = 0; c < 3; ++c)
        {
          corner[c] = std::round(1e5 * turned[c]) * 1e-5;
        }
        points.push_back(corner);
      }
    }
    for (vtkIdType i = 0; i < size; ++i)
    {
      for (vtkIdType j = 0; j < size; ++j)
      {
        const vtkIdType here = first + i * (size + 1) + j;
        const vtkIdType next = here + size + 1;
        const bool turns = face % 2 == 0;
        triangles.push_back({ here, turns ? next + 1 : next, turns ? next : next + 1 });
        triangles.push_back({ here, turns ? here + 1 : next + 1, turns ? next + 1 : here + 1 });
      }
    }
  }
  return MakeMesh(points, triangles);
}

/// Faces of one, two, three and four edges a side: each edge is split where the other face parts
/// it.
void TestCracks(Checks& check)
{
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SplitCreasesOff();
  const auto prepare = [&](const std::array<int, 6>& fineness, double gap)
  {
    preparation->SetInputData(MakeGridBox(fineness, gap));
    preparation->Update();
    CheckManifold(check, "cracks", preparation->GetOutput());
    return GetShape(preparation->GetOutput());
  };
  Shape shape = prepare({ 3, 3, 3, 3, 3, 3 }, 0.0);
  check(shape.BoundaryEdges == 0 && preparation->GetNumberOfCrackEdges() == 0, "alike faces fit");
  shape = prepare({ 1, 3, 1, 4, 2, 4 }, 0.0);
  check(shape.BoundaryEdges == 0 && shape.EulerCharacteristic == 2, "the box is closed",
    static_cast<double>(shape.BoundaryEdges));
  check(preparation->GetNumberOfReorientedTriangles() == 0, "no triangle is turned");
  check(preparation->GetNumberOfCrackEdges() > 12, "by splitting edges",
    static_cast<double>(preparation->GetNumberOfCrackEdges()));
  check(preparation->GetReport().find("edges split at T-junctions") != std::string::npos,
    "and the report says so");

  shape = prepare({ 1, 3, 1, 4, 2, 4 }, 1e-3);
  check(shape.BoundaryEdges >= 16, "a lid that stands off is not nailed on",
    static_cast<double>(shape.BoundaryEdges));
  preparation->WeldOff();
  prepare({ 1, 3, 1, 4, 2, 4 }, 0.0);
  check(preparation->GetNumberOfCrackEdges() == 0, "nor anything without welding");

  // A sheet that stands on another's edge with its corner only is another one.
  preparation->WeldOn();
  const auto sheets =
    MakeMesh({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 2, 0, 0 }, { 3, -1, 0 }, { 3, -1, 1 } },
      { { 0, 1, 2 }, { 3, 4, 5 } });
  Prepare(check, "a corner at an edge", preparation, sheets, { { "BoundaryEdges", 6 } });
}

//------------------------------------------------------------------------------
void TestBowTie(Checks& check)
{
  // Two triangles and a closed tetrahedron that share a point.
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 },
    { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 } };
  const auto mesh = MakeMesh(
    points, { { 0, 1, 2 }, { 0, 3, 4 }, { 0, 6, 5 }, { 0, 7, 6 }, { 0, 5, 7 }, { 5, 6, 7 } });
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SplitCreasesOff();
  const auto output = Prepare(check, "bow tie", preparation, mesh,
    { { "NonManifoldPoints", 1 }, { "NonManifoldSplitPoints", 2 }, { "BoundaryEdges", 6 } });
  check(output->GetNumberOfPoints() == 10, "three fans have three points");
  CheckManifold(check, "bow tie", output);
}

//------------------------------------------------------------------------------
void TestMoebius(Checks& check)
{
  constexpr int size = 24;
  Points points;
  std::vector<Corners> triangles;
  for (int i = 0; i < size; ++i)
  {
    const double angle = 2.0 * Pi * i / size;
    for (double side : { -0.3, 0.3 })
    {
      const double r = 1.0 + side * std::cos(0.5 * angle);
      points.push_back({ r * std::cos(angle), r * std::sin(angle), side * std::sin(0.5 * angle) });
    }
    const vtkIdType a = 2 * i;
    const bool last = i == size - 1;
    const vtkIdType b = last ? 1 : a + 2;
    const vtkIdType c = last ? 0 : a + 3;
    triangles.push_back({ a, b, c });
    triangles.push_back({ a, c, a + 1 });
  }
  const auto mesh = MakeMesh(points, triangles);
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SplitCreasesOff();
  preparation->SetInputData(mesh);
  preparation->Update();
  check(preparation->GetNumberOfNonOrientableEdges() == 1 &&
      preparation->GetNumberOfNonManifoldSplitPoints() == 2,
    "a Moebius strip has one cut");
  check(
    preparation->GetNumberOfNonManifoldEdges() + preparation->GetNumberOfNonManifoldPoints() == 0,
    "though it is a manifold");
  CheckManifold(check, "Moebius", preparation->GetOutput());
  check(GetShape(preparation->GetOutput()).EulerCharacteristic == 1, "and then it is a sheet");

  preparation->OrientOff();
  preparation->Update();
  check(preparation->GetNumberOfNonOrientableEdges() == 0 &&
      preparation->GetOutput()->GetNumberOfPoints() == 2 * size,
    "who does not orient does not cut");
}

//------------------------------------------------------------------------------
/// Few points and many triangles: nothing that can be wrong with a mesh is missing.
vtkSmartPointer<vtkPolyData> MakeSoup(int seed, int numberOfPoints, int numberOfTriangles)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(seed);
  const auto next = [&](double limit)
  {
    random->Next();
    return limit * random->GetValue();
  };
  Points points(numberOfPoints);
  for (auto& point : points)
  {
    point = { std::floor(next(6.0)), std::floor(next(6.0)), next(2.0) };
  }
  points.back()[1] = std::numeric_limits<double>::quiet_NaN();
  std::vector<Corners> triangles(numberOfTriangles);
  for (auto& corners : triangles)
  {
    const double first = next(numberOfPoints - 4.0);
    for (vtkIdType& corner : corners)
    {
      corner = static_cast<vtkIdType>(first + next(4.0));
    }
  }
  return MakeMesh(points, triangles);
}

void TestSoups(Checks& check)
{
  for (int seed = 1; seed <= 60; ++seed)
  {
    const auto soup = MakeSoup(seed, 10 + seed, 4 * seed);
    vtkNew<vtkNPRSurfacePreparation> preparation;
    preparation->SetInputData(soup);
    preparation->SetSplitCreases(seed % 2 == 0);
    preparation->SetFillHoles(seed % 3 == 0 ? 4.0 : 0.0);
    preparation->Update();
    CheckManifold(check, "soup " + std::to_string(seed), preparation->GetOutput());
  }
}

/// A sphere without a tenth of its triangles.
vtkSmartPointer<vtkPolyData> MakeSieve()
{
  vtkSmartPointer<vtkPolyData> sphere = MakeOctasphere(1.0, 4);
  std::vector<Corners> triangles = GetTriangles(sphere);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [&](const Corners&)
                    {
                      random->Next();
                      return random->GetValue() < 0.1;
                    }),
    triangles.end());
  const auto sieve = MakeMesh({}, triangles);
  sieve->SetPoints(sphere->GetPoints());
  return sieve;
}

void TestThreads(Checks& check, vtkPolyData* mesh, vtkIdType leastHoles)
{
  std::vector<vtkSmartPointer<vtkPolyData>> results;
  for (int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]()
      {
        vtkNew<vtkNPRSurfacePreparation> preparation;
        preparation->SetInputData(mesh);
        preparation->SetFillHoles(3.0);
        preparation->Update();
        check(preparation->GetNumberOfFilledHoles() >= leastHoles, "holes for the threads",
          static_cast<double>(preparation->GetNumberOfFilledHoles()));
        results.push_back(preparation->GetOutput());
      });
  }
  check(GetTriangles(results[0]) == GetTriangles(results[1]), "threads: the same triangles");
  bool same = results[0]->GetNumberOfPoints() == results[1]->GetNumberOfPoints();
  for (vtkIdType i = 0; same && i < results[0]->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    results[0]->GetPoint(i, a);
    results[1]->GetPoint(i, b);
    same = a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
  }
  check(same, "threads: the same points");
}

//------------------------------------------------------------------------------
/// A sphere of 2048 triangles, its points not welded, and more triangles.
vtkSmartPointer<vtkPolyData> MakeSphereAnd(const std::vector<std::array<Vector3d, 3>>& more)
{
  const auto mesh = MakeOctasphere(1.0, 4);
  for (const auto& triangle : more)
  {
    mesh->GetPolys()->InsertNextCell(3);
    for (const Vector3d& corner : triangle)
    {
      mesh->GetPolys()->InsertCellPoint(mesh->GetPoints()->InsertNextPoint(corner.data()));
    }
  }
  return mesh;
}

void TestFolds(Checks& check)
{
  const auto sphere = MakeOctasphere(1.0, 4);
  std::array<Vector3d, 3> first;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    sphere->GetPoint(i, first[i].data()); // its triangles are their own points, in order
  }
  const auto& [a, b, c] = first;
  const auto prepare = [&](const char* what, const std::vector<std::array<Vector3d, 3>>& more,
                         const Expected& expected, vtkIdType triangles, vtkIdType boundary)
  {
    vtkNew<vtkNPRSurfacePreparation> preparation;
    preparation->SplitCreasesOff();
    preparation->SetInputData(MakeSphereAnd(more));
    preparation->Update();
    const auto output = preparation->GetOutput();
    CheckManifold(check, what, output);
    check(output->GetNumberOfPolys() == triangles, std::string(what) + ": triangles",
      static_cast<double>(output->GetNumberOfPolys()));
    check(preparation->GetNumberOfBoundaryEdges() == boundary, std::string(what) + ": boundary",
      static_cast<double>(preparation->GetNumberOfBoundaryEdges()));
    const Expected found = { { "folds", preparation->GetNumberOfFoldTriangles() },
      { "duplicates", preparation->GetNumberOfDuplicateTriangles() },
      { "turned", preparation->GetNumberOfReorientedTriangles() } };
    check(found == expected, std::string(what) + ": counts");
  };
  const Vector3d tip = 1.01 * (0.5 * (a + b)).normalized();
  const Vector3d top = 1.02 * (0.5 * (a + b)).normalized();
  prepare("a flap of two triangles goes", { { a, b, tip }, { b, a, tip } },
    { { "folds", 2 }, { "duplicates", 0 }, { "turned", 0 } }, 2048, 0);
  prepare("a flap of four, too", { { a, b, tip }, { b, a, tip }, { b, top, tip }, { top, b, tip } },
    { { "folds", 4 }, { "duplicates", 0 }, { "turned", 0 } }, 2048, 0);
  prepare("a large one keeps a side", { { a, b, 2.0 * tip }, { b, a, 2.0 * tip } },
    { { "folds", 0 }, { "duplicates", 1 }, { "turned", 0 } }, 2049, 2);
  prepare("so does one by itself",
    { { 3.0 * a, 3.0 * b, 3.001 * b }, { 3.0 * b, 3.0 * a, 3.001 * b } },
    { { "folds", 0 }, { "duplicates", 1 }, { "turned", 0 } }, 2049, 3);
  prepare("to drop both would open a hole", { { b, a, c } },
    { { "folds", 0 }, { "duplicates", 1 }, { "turned", 0 } }, 2048, 0);
  prepare("most face one way", { { b, a, c }, { a, b, c } },
    { { "folds", 0 }, { "duplicates", 2 }, { "turned", 0 } }, 2048, 0);
  prepare("most face the other way, and are turned", { { b, a, c }, { b, a, c } },
    { { "folds", 0 }, { "duplicates", 2 }, { "turned", 1 } }, 2048, 0);
}
}

int TestSurfaceRepair(int, char*[])
{
  Checks check;
  TestFolds(check);
  TestSheetsAtAnEdge(check);
  TestBoxesAtAnEdge(check);
  TestCracks(check);
  TestBowTie(check);
  TestMoebius(check);
  TestSoups(check);
  TestThreads(check, MakeSoup(7, 4000, 6000), 0);
  TestThreads(check, MakeSieve(), 50);
  return check.GetResult();
}
