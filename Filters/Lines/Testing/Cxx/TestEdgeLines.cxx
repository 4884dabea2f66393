// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines along edges: creases and outline of a cube, borders of an open cylinder.
#include "nprLineTesting.h"

#include "vtkNPRCreases.h"

using namespace nprtest;

namespace
{
void TestCube(bool split, Checks& check)
{
  auto cube = MakeCube(split);
  const auto creases = Extract(cube, { "creases" }, nullptr);
  CheckSound(creases, check);
  check(creases.size() == 12, "a cube has twelve creases", static_cast<double>(creases.size()));
  for (const Chain& chain : creases)
  {
    check(chain.Points.size() == 2 && GetLength(chain) == 2.0, "a crease is an edge of the cube");
  }

  for (bool parallel : { false, true })
  {
    auto camera = MakeCamera({ 5.0, 4.0, 3.0 }, parallel);
    const auto outline = Extract(cube, { "contours" }, camera);
    CheckSound(outline, check);
    if (check(outline.size() == 1 && outline[0].Closed, "the outline of a cube is closed",
          static_cast<double>(outline.size())) &&
      split)
    {
      check(outline[0].Points.size() == 6 && GetLength(outline[0]) == 12.0,
        "seen from a corner, the outline of a cube is a hexagon");
      // The corners that the eye sees first and last are not on it.
      for (const Vector& p : outline[0].Points)
      {
        check(std::abs(p.sum()) < 2.0, "the outline runs around the corner that is seen");
      }
    }
  }

  // Exactly in front of a face, the sides are seen edge-on: the outline must not vanish or double.
  for (bool parallel : { false, true })
  {
    const auto outline = Extract(cube, { "contours" }, MakeCamera({ 0.0, 0.0, 5.0 }, parallel));
    CheckSound(outline, check);
    check(outline.size() == 1 && outline[0].Closed, "the outline of a face is closed");
  }
}

void TestAngle(Checks& check)
{
  auto cube = MakeCube(true);
  vtkNew<vtkNPRCreases> creases;
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(creases);
  lines->SetInputData(cube);
  creases->SetAngle(91.0);
  lines->Update();
  check(lines->GetOutput()->GetNumberOfLines() == 0, "a right angle is no crease above 91 degrees");
  creases->SetAngle(89.0);
  lines->Update();
  check(lines->GetOutput()->GetNumberOfLines() == 12, "a right angle is a crease above 89 degrees");
}

// One sharp edge within a surface is noise; where it runs from border to border it is a fold.
void TestNoise(Checks& check)
{
  for (bool within : { false, true })
  {
    auto sheet = within ? MakeGrid(6, 6, false, false) : MakeGrid(3, 2, false, false);
    for (vtkIdType i = 0; i < sheet->GetNumberOfPoints(); ++i)
    {
      const vtkIdType columns = within ? 6 : 2;
      const double x = static_cast<double>(i / columns);
      const double y = static_cast<double>(i % columns);
      const bool raised = within ? (i == 2 * 6 + 2 || i == 2 * 6 + 3) : i / 2 == 1;
      sheet->GetPoints()->SetPoint(i, x, y, raised ? (within ? 0.6 : 2.0) : 0.0);
    }
    vtkNew<vtkNPRCreases> creases;
    creases->SetAngle(60.0);
    vtkNew<vtkNPRFeatureLines> lines;
    lines->AddDefinition(creases);
    lines->SetInputData(sheet);
    lines->Update();
    check(lines->GetOutput()->GetNumberOfLines() == (within ? 0 : 1),
      "a lone sharp edge is left out, a fold is kept",
      static_cast<double>(lines->GetOutput()->GetNumberOfLines()));
    creases->SetLeastEdges(1.0);
    lines->Update();
    check(lines->GetOutput()->GetNumberOfLines() == 1, "each sharp edge is kept when asked for",
      static_cast<double>(lines->GetOutput()->GetNumberOfLines()));
  }
}

// A tube of which both ends are open; where it is cut along its side, the points are split and
// welded.
vtkSmartPointer<vtkPolyData> MakeTube(int n, bool cut)
{
  auto tube = MakeGrid(cut ? n + 1 : n, 4, !cut, false);
  auto normals = AddArray(tube, npr::names::Normals, 3);
  std::vector<vtkIdType> welded;
  for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
  {
    const double u = 2.0 * Pi * ((i / 4) % n) / n;
    tube->GetPoints()->SetPoint(i, std::cos(u), std::sin(u), static_cast<double>(i % 4));
    normals->SetTuple3(i, std::cos(u), std::sin(u), 0.0);
    welded.push_back(i % (4 * n));
  }
  AddWeldedIds(tube, welded);
  return tube;
}

void TestTube(Checks& check)
{
  for (bool cut : { false, true })
  {
    const int n = 24;
    auto tube = MakeTube(n, cut);
    const auto borders = Extract(tube, { "boundaries", "creases" }, nullptr);
    CheckSound(borders, check);
    check(borders.size() == 2, "a tube has two borders and no crease",
      static_cast<double>(borders.size()));
    for (const Chain& chain : borders)
    {
      check(chain.Closed && chain.Points.size() == n, "the borders of a tube are closed");
      for (std::size_t i = 0; i < chain.Points.size(); ++i)
      {
        const Vector left = chain.Normals[i].cross(chain.Next(i) - chain.Points[i]);
        check(
          left[2] * (1.5 - chain.Points[i][2]) > 0.0, "the surface is on the left of its border");
      }
    }

    const auto outline = Extract(tube, { "contours" }, MakeCamera({ 7.0, 1.3, 6.0 }));
    CheckSound(outline, check);
    int closed = 0;
    for (const Chain& chain : outline)
    {
      closed += chain.Closed;
    }
    check(closed == 2 && outline.size() == 4,
      "the outline of a tube is its two borders and two lines along its sides",
      static_cast<double>(outline.size()));
  }
}

// A sheet of 10 rows of 20 points, whose profile across the rows is given.
vtkSmartPointer<vtkPolyData> MakeProfile(const std::vector<std::array<double, 2>>& profile)
{
  const int n = 20;
  auto sheet = MakeGrid(static_cast<int>(profile.size()), n, false, false);
  for (vtkIdType i = 0; i < sheet->GetNumberOfPoints(); ++i)
  {
    const auto& [x, z] = profile[i / n];
    sheet->GetPoints()->SetPoint(i, x, 0.1 * (i % n), z);
  }
  return sheet;
}

std::vector<Chain> ExtractCreases(vtkPolyData* surface, double tolerance, Checks& check)
{
  vtkNew<vtkNPRCreases> creases;
  creases->SetTolerance(tolerance < 0.0 ? creases->GetTolerance() : tolerance);
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(creases);
  lines->SetInputData(surface);
  lines->Update();
  const auto chains = GetChains(lines->GetOutput());
  CheckSound(chains, check);
  return chains;
}

// What is narrower than the tolerance makes no crease and hides none.
void TestTolerance(Checks& check)
{
  const double usual = -1.0;
  const double thin = 1.0e-4;
  // A row of slivers in a flat sheet that stand on end, and a step.
  for (const double end : { 0.0, thin })
  {
    auto flat =
      MakeProfile({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, thin }, { 1.0 + thin, end }, { 2.0, end } });
    check(ExtractCreases(flat, usual, check).empty(), "slivers of a flat face make no crease");
    check(!ExtractCreases(flat, 0.0, check).empty(), "without a tolerance they do");
  }
  // Slivers of all directions beside a fold: it is found, and nothing else.
  for (const double tilt : { -thin, 0.0, thin })
  {
    auto fold = MakeProfile({ { 0.0, 0.0 }, { 0.5, 0.0 }, { 1.0, 0.0 }, { 1.0 + tilt, thin },
      { 1.0, 0.5 }, { 1.0, 1.0 } });
    const auto chains = ExtractCreases(fold, usual, check);
    check(!chains.empty() && chains.size() <= 2, "a fold beside slivers is one line, or two as one",
      static_cast<double>(chains.size()));
    for (const Chain& chain : chains)
    {
      check(std::abs(GetLength(chain) - 1.9) < 1.0e-6, "a fold beside slivers is whole",
        GetLength(chain));
      check((chain.Points[0] - Vector(1.0, chain.Points[0][1], 0.0)).norm() < 2.0 * thin,
        "a fold is where it is");
    }
  }
  // A thin plate keeps its rim: beyond the narrow face is the other side.
  auto plate = MakeProfile({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, thin }, { 0.0, thin } });
  check(ExtractCreases(plate, usual, check).size() <= 2,
    "the rim of a plate is no more than its edges");
  auto thick = MakeProfile({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.1 }, { 0.0, 0.1 } });
  check(ExtractCreases(thick, usual, check).size() == 2, "a thick plate has two edges");
  // A slope that is wider than the tolerance, but not much.
  for (const double height : { 0.003, 0.1 })
  {
    auto step =
      MakeProfile({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0 + height, height }, { 2.0, height } });
    const auto chains = ExtractCreases(step, usual, check);
    check(chains.size() == (height < 0.01 ? 0 : 2), "a step must be high enough to be seen",
      static_cast<double>(chains.size()));
  }
  // A bend of 12 degrees a facet.
  std::vector<std::array<double, 2>> bend;
  for (int i = 0; i <= 15; ++i)
  {
    bend.push_back({ std::sin(Pi * i / 15.0), std::cos(Pi * i / 15.0) });
  }
  check(ExtractCreases(MakeProfile(bend), usual, check).empty(), "a round bend is no crease");
  // A sheet that lies on itself.
  check(
    ExtractCreases(MakeProfile({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.2, 0.0 } }), usual, check).empty(),
    "a flat fold is no crease");
}

// Three wings along one axis, of which one is bent: its fold is a crease, the axis is not.
void TestWings(Checks& check)
{
  for (const bool split : { false, true })
  {
    const int n = 5;
    auto wings = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> triangles;
    std::vector<vtkIdType> welded;
    const auto add = [&](double x, double y, int step, vtkIdType weld)
    {
      const vtkIdType id = points->InsertNextPoint(x, y, step);
      welded.push_back(weld < 0 ? id : weld);
      return id;
    };
    const auto strip = [&](const std::vector<vtkIdType>& a, const std::vector<vtkIdType>& b)
    {
      for (int i = 0; i < n; ++i)
      {
        triangles->InsertNextCell({ a[i], b[i], b[i + 1] });
        triangles->InsertNextCell({ a[i], b[i + 1], a[i + 1] });
      }
    };
    std::vector<vtkIdType> shared;
    for (int i = 0; i <= n; ++i)
    {
      shared.push_back(add(0.0, 0.0, i, -1));
    }
    for (int wing = 0; wing < 3; ++wing)
    {
      const double angle = 2.0 * Pi * wing / 3.0;
      std::vector<vtkIdType> axis, middle, rim;
      for (int i = 0; i <= n; ++i)
      {
        axis.push_back(split && wing > 0 ? add(0.0, 0.0, i, shared[i]) : shared[i]);
        middle.push_back(add(std::cos(angle), std::sin(angle), i, -1));
        rim.push_back(wing == 2 ? add(std::cos(angle) + 1.0, std::sin(angle), i, -1)
                                : add(2.0 * std::cos(angle), 2.0 * std::sin(angle), i, -1));
      }
      strip(axis, middle);
      strip(middle, rim);
    }
    wings->SetPoints(points);
    wings->SetPolys(triangles);
    AddWeldedIds(wings, welded);
    const auto chains = Extract(wings, { "non-manifold", "creases", "boundaries" }, nullptr);
    CheckSound(chains, check);
    const auto segments = GetSegments(chains);
    check(std::adjacent_find(segments.begin(), segments.end()) == segments.end(),
      "no edge is of two kinds");
    for (int type = 0; type < 2; ++type)
    {
      int count = 0;
      for (const Chain& chain : chains)
      {
        count += chain.Type == type;
        check(chain.Type != type || (chain.Points.size() == n + 1 && GetLength(chain) == n),
          "the axis and the fold run from end to end");
        check(chain.Type != 0 || chain.Points[0].head<2>().norm() == 0.0,
          "more than two triangles meet at the axis alone");
      }
      check(count == 1, "one axis, one fold", count);
    }
  }
}
}

int TestEdgeLines(int, char*[])
{
  Checks check;
  TestCube(true, check);
  TestCube(false, check);
  TestAngle(check);
  TestNoise(check);
  TestTube(check);
  TestWings(check);
  TestTolerance(check);
  return check.GetResult();
}
