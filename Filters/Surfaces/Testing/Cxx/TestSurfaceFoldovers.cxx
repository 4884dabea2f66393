// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles that an edge flipped the wrong way folds over are laid right, and nothing else changes.
#include "nprAnalyticSurfaces.h"
#include "nprManifoldChecks.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

using namespace nprtest;

namespace
{
using Point = std::array<double, 3>;
using Points = std::vector<Point>;

struct Soup
{
  Points Positions;
  std::vector<Corners> Triangles;
  std::vector<int> Regions; ///< Of the triangles.
};

constexpr int Rows = 14; // along the profile
constexpr int Columns = 10;
constexpr int Lost = -1; // the region of a triangle that is folded over

/// A plane, a quarter of a cylinder and another plane, unrolled.
Point Fillet(double s, double t)
{
  constexpr double radius = 0.5;
  const double bend = std::clamp((s - 4.0) / 6.0, 0.0, 1.0) * 0.5 * vtkMath::Pi();
  const double before = 0.2 * std::min(s, 4.0);
  const double after = 0.2 * std::max(s - 10.0, 0.0);
  return { before + radius * std::sin(bend), 0.2 * t, radius * (std::cos(bend) - 1.0) - after };
}

/// Whether the cell's first corner is pushed across the diagonal that does not start at it.
bool IsPushed(int row, int column)
{
  return row > 0 && column > 0 && row % 2 == 0 && column % 3 == 1;
}

/// A strip whose pushed cells are no convex quads: only one of their diagonals parts them; the
/// other one folds a triangle over.
Soup MakeFillet(bool right)
{
  Soup soup;
  for (int row = 0; row <= Rows; ++row)
  {
    for (int column = 0; column <= Columns; ++column)
    {
      const double push =
        row < Rows && column < Columns && IsPushed(row, column) ? 0.55 + 0.02 * column : 0.0;
      soup.Positions.push_back(Fillet(row + push, column + push));
    }
  }
  for (int row = 0; row < Rows; ++row)
  {
    for (int column = 0; column < Columns; ++column)
    {
      const vtkIdType a = row * (Columns + 1) + column;
      const vtkIdType b = a + Columns + 1;
      const int region = row * Columns + column;
      if (right || !IsPushed(row, column))
      {
        soup.Triangles.push_back({ a, b, b + 1 });
        soup.Triangles.push_back({ a, b + 1, a + 1 });
        soup.Regions.insert(soup.Regions.end(), { region, region });
      }
      else
      {
        soup.Triangles.push_back({ a, b, a + 1 });
        soup.Triangles.push_back({ b, b + 1, a + 1 });
        soup.Regions.insert(soup.Regions.end(), { Lost, region });
      }
    }
  }
  return soup;
}

vtkIdType CountPushed()
{
  vtkIdType count = 0;
  for (int row = 0; row < Rows; ++row)
  {
    for (int column = 0; column < Columns; ++column)
    {
      count += IsPushed(row, column);
    }
  }
  return count;
}

vtkSmartPointer<vtkPolyData> MakeMesh(const Soup& soup)
{
  vtkSmartPointer<vtkPolyData> mesh = nprtest::MakeMesh(soup.Positions, soup.Triangles);
  vtkNew<vtkIntArray> regions;
  regions->SetName("Region");
  for (int region : soup.Regions)
  {
    regions->InsertNextValue(region);
  }
  mesh->GetCellData()->AddArray(regions);
  return mesh;
}

using Placed = std::pair<std::array<std::array<float, 3>, 3>, int>;

/// The triangles by the places of their corners, from the lowest on, with their regions; sorted.
std::vector<Placed> GetPlaced(vtkPolyData* mesh)
{
  vtkDataArray* const regions = mesh->GetCellData()->GetArray("Region");
  std::vector<Placed> all;
  for (const Corners& corners : GetTriangles(mesh))
  {
    Placed placed;
    for (int i = 0; i < 3; ++i)
    {
      const double* const point = mesh->GetPoint(corners[i]);
      std::copy(point, point + 3, placed.first[i].begin());
    }
    std::rotate(placed.first.begin(), std::min_element(placed.first.begin(), placed.first.end()),
      placed.first.end());
    placed.second =
      regions ? static_cast<int>(regions->GetComponent(static_cast<vtkIdType>(all.size()), 0)) : 0;
    all.push_back(placed);
  }
  std::sort(all.begin(), all.end());
  return all;
}

vtkSmartPointer<vtkNPRSurfacePreparation> Prepare(vtkPolyData* mesh)
{
  auto preparation = vtkSmartPointer<vtkNPRSurfacePreparation>::New();
  preparation->SetInputData(mesh);
  preparation->SplitCreasesOff();
  preparation->Update();
  return preparation;
}

void CheckUntouched(Checks& check, const std::string& what, vtkPolyData* mesh)
{
  const auto preparation = Prepare(mesh);
  check(preparation->GetNumberOfMendedFoldovers() == 0, what + ": nothing is mended",
    preparation->GetNumberOfMendedFoldovers());
  check(GetPlaced(preparation->GetOutput()) == GetPlaced(mesh), what + ": is as it was");
}

void TestFillet(Checks& check)
{
  const std::vector<Placed> expected = GetPlaced(MakeMesh(MakeFillet(true)));
  CheckUntouched(check, "fillet", MakeMesh(MakeFillet(true)));

  Soup soup = MakeFillet(false);
  const auto preparation = Prepare(MakeMesh(soup));
  std::cout << "fillet: " << preparation->GetReport() << "\n";
  check(preparation->GetNumberOfMendedFoldovers() == CountPushed(), "each fold is mended once",
    preparation->GetNumberOfMendedFoldovers());
  check(preparation->GetNumberOfLeftFoldovers() == 0, "and none left");
  check(GetPlaced(preparation->GetOutput()) == expected, "the fillet is the right one");
  CheckUntouched(check, "mended fillet", preparation->GetOutput());

  preparation->OrientOff();
  preparation->Update();
  check(GetPlaced(preparation->GetOutput()) == GetPlaced(MakeMesh(soup)) &&
      preparation->GetNumberOfMendedFoldovers() + preparation->GetNumberOfLeftFoldovers() == 0,
    "it is not done where triangles are not oriented");

  // Half of the triangles turned over: what is folded is known only after they agree.
  for (std::size_t t = 0; t < soup.Triangles.size(); t += 3)
  {
    std::swap(soup.Triangles[t][0], soup.Triangles[t][1]);
  }
  check(GetPlaced(Prepare(MakeMesh(soup))->GetOutput()) == expected, "a mess is oriented first");
}

/// The triangles in another order, from other corners, and the points, too.
Soup Shuffle(const Soup& soup, vtkMinimalStandardRandomSequence* random)
{
  const auto permute = [&](std::size_t size)
  {
    std::vector<vtkIdType> order(size);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = size; i-- > 1;)
    {
      random->Next();
      std::swap(order[i], order[static_cast<std::size_t>(random->GetRangeValue(0.0, i))]);
    }
    return order;
  };
  Soup shuffled;
  const std::vector<vtkIdType> points = permute(soup.Positions.size());
  shuffled.Positions.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    shuffled.Positions[points[i]] = soup.Positions[i];
  }
  for (const vtkIdType t : permute(soup.Triangles.size()))
  {
    Corners corners = soup.Triangles[t];
    std::rotate(corners.begin(), corners.begin() + t % 3, corners.end());
    shuffled.Triangles.push_back({ points[corners[0]], points[corners[1]], points[corners[2]] });
    shuffled.Regions.push_back(soup.Regions[t]);
  }
  return shuffled;
}

/// A torus that edges are flipped in at random, so that folds lie upon folds. With few points
/// around its tube an edge may be there already, on the other side.
Soup MakeTangle(int around, vtkMinimalStandardRandomSequence* random)
{
  const AnalyticSurface torus = MakeTorus(1.0, 0.4, 2 * around, around);
  const double stray = 0.6 / around;
  Soup soup;
  for (const Truth& truth : torus.Truths)
  {
    Point point;
    for (int i = 0; i < 3; ++i)
    {
      random->Next();
      point[i] = truth.Point[i] + stray * (random->GetValue() - 0.5);
    }
    soup.Positions.push_back(point);
  }
  soup.Triangles = GetTriangles(torus.Mesh);
  std::map<std::pair<vtkIdType, vtkIdType>, std::size_t> users;
  for (std::size_t t = 0; t < soup.Triangles.size(); ++t)
  {
    soup.Regions.push_back(static_cast<int>(t));
    for (int e = 0; e < 3; ++e)
    {
      users[{ soup.Triangles[t][e], soup.Triangles[t][(e + 1) % 3] }] = t;
    }
  }
  for (std::size_t i = 0; i < 2 * soup.Triangles.size(); ++i)
  {
    const std::size_t t = i % soup.Triangles.size();
    random->Next();
    const auto [a, b, c] = soup.Triangles[t];
    const std::size_t other = users.at({ b, a });
    if (random->GetValue() > 0.4)
    {
      continue;
    }
    const Corners& across = soup.Triangles[other];
    const vtkIdType d = std::accumulate(across.begin(), across.end(), -a - b);
    if (users.count({ c, d }) + users.count({ d, c }) > 0)
    {
      continue;
    }
    users.erase({ a, b });
    users.erase({ b, a });
    soup.Triangles[t] = { c, a, d };
    soup.Triangles[other] = { d, b, c };
    users[{ a, d }] = users[{ d, c }] = t;
    users[{ b, c }] = users[{ c, d }] = other;
  }
  return soup;
}

/// How many edges have triangles whose normals differ by more than an angle, in degrees.
vtkIdType CountBends(vtkPolyData* mesh, double angle)
{
  std::map<std::pair<vtkIdType, vtkIdType>, Vector3d> normals;
  for (const Corners& corners : GetTriangles(mesh))
  {
    std::array<Vector3d, 3> points;
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(corners[i], points[i].data());
    }
    for (int e = 0; e < 3; ++e)
    {
      normals[{ corners[e], corners[(e + 1) % 3] }] =
        (points[1] - points[0]).cross(points[2] - points[0]).normalized();
    }
  }
  vtkIdType bends = 0;
  for (const auto& [edge, normal] : normals)
  {
    const auto other = normals.find({ edge.second, edge.first });
    bends += edge.first < edge.second && other != normals.end() &&
      normal.dot(other->second) < std::cos(vtkMath::RadiansFromDegrees(angle));
  }
  return bends;
}

void TestTangles(Checks& check)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (int trial = 0; trial < 40; ++trial)
  {
    const Soup soup = MakeTangle(4 + trial, random);
    const vtkSmartPointer<vtkPolyData> mesh = MakeMesh(soup);
    const auto preparation = Prepare(mesh);
    vtkPolyData* const output = preparation->GetOutput();
    const vtkIdType before = CountBends(mesh, 135.0);
    const vtkIdType after = CountBends(output, 135.0);
    std::cout << "tangle: " << before << " sharp bends, then " << after << ": "
              << preparation->GetReport() << "\n";
    check(
      trial < 10 || preparation->GetNumberOfMendedFoldovers() > 0, "folds of a tangle are mended");
    check(after + preparation->GetNumberOfMendedFoldovers() <= before,
      "each flip takes one away, and makes none", static_cast<double>(after));
    const Shape shape = GetShape(output);
    check(shape.IsManifold() && shape.BoundaryEdges == 0 && shape.Disagreements == 0 &&
        shape.EulerCharacteristic == 0,
      "a torus stays one");
    CheckUntouched(check, "mended tangle", output);

    const std::vector<Placed> expected = GetPlaced(output);
    const Soup shuffled = Shuffle(soup, random);
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ 3 },
      [&]()
      {
        check(GetPlaced(Prepare(MakeMesh(shuffled))->GetOutput()) == expected,
          "the order of the triangles does not matter");
      });
  }
}

/// A point of three triangles that lies far outside of them: to flip any of their edges would only
/// make other folds, or edges that there are.
void TestHopeless(Checks& check)
{
  Soup soup;
  constexpr int size = 12;
  for (int row = 0; row <= size; ++row)
  {
    for (int column = 0; column <= size; ++column)
    {
      soup.Positions.push_back({ static_cast<double>(row), static_cast<double>(column), 0.0 });
    }
  }
  soup.Positions.push_back({ 8.4, 7.3, 0.01 });
  const auto last = static_cast<vtkIdType>(soup.Positions.size() - 1);
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      const vtkIdType a = row * (size + 1) + column;
      const vtkIdType b = a + size + 1;
      if (row == 4 && column == 4)
      {
        soup.Triangles.push_back({ a, b, last });
        soup.Triangles.push_back({ b, b + 1, last });
        soup.Triangles.push_back({ b + 1, a, last });
      }
      else
      {
        soup.Triangles.push_back({ a, b, b + 1 });
      }
      soup.Triangles.push_back({ a, b + 1, a + 1 });
    }
  }
  soup.Regions.resize(soup.Triangles.size());
  const vtkSmartPointer<vtkPolyData> mesh = MakeMesh(soup);
  CheckUntouched(check, "hopeless", mesh);
  const auto preparation = Prepare(mesh);
  std::cout << "hopeless: " << preparation->GetReport() << "\n";
  check(preparation->GetNumberOfLeftFoldovers() > 0, "what no flip helps is counted");
}

/// A fin that touches the surface at the ends of the edge that would mend a fold. Both points are
/// split; but where they are welded again, the edge would have three triangles.
void TestTouchingFin(Checks& check)
{
  Soup soup = MakeFillet(false);
  const vtkIdType pushed = 4 * (Columns + 1) + 4;
  soup.Triangles.push_back(
    { pushed, pushed + Columns + 2, static_cast<vtkIdType>(soup.Positions.size()) });
  soup.Positions.push_back({ 2.0, 1.0, 2.0 });
  soup.Regions.push_back(0);
  const auto preparation = Prepare(MakeMesh(soup));
  std::cout << "fin: " << preparation->GetReport() << "\n";
  check(preparation->GetNumberOfNonManifoldPoints() == 2, "a fin touches at two points",
    preparation->GetNumberOfNonManifoldPoints());
  check(preparation->GetNumberOfMendedFoldovers() == CountPushed() - 1 &&
      preparation->GetNumberOfLeftFoldovers() == 1,
    "the fold at the fin stays", preparation->GetNumberOfMendedFoldovers());
  const auto again = Prepare(preparation->GetOutput());
  check(again->GetNumberOfNonManifoldEdges() == 0, "no edge has three triangles once welded",
    again->GetNumberOfNonManifoldEdges());
}

/// Three triangles, one between two others, with points at random: the flip is the one that the
/// rule says.
void TestRule(Checks& check)
{
  constexpr double fold = -0.7071;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  int flips = 0;
  for (int trial = 0; trial < 20000; ++trial)
  {
    Soup soup;
    std::array<Vector3d, 5> points;
    for (Vector3d& point : points)
    {
      for (int i = 0; i < 3; ++i)
      {
        random->Next();
        point[i] = static_cast<float>((i < 2 ? 1.0 : 0.3) * random->GetValue());
      }
      soup.Positions.push_back({ point[0], point[1], point[2] });
    }
    const auto normal = [&](const Corners& corners)
    {
      const Vector3d& origin = points[corners[0]];
      const Vector3d area = (points[corners[1]] - origin).cross(points[corners[2]] - origin);
      return Vector3d(area.normalized());
    };
    const auto cosine = [&](const Corners& a, const Corners& b)
    { return normal(a).dot(normal(b)); };
    const Corners middle = { 0, 1, 2 };
    const Corners atEdge[2] = { { 1, 0, 3 }, { 2, 1, 4 } };
    soup.Triangles = { middle, atEdge[0], atEdge[1] };
    soup.Regions = { 0, 1, 2 };
    const double before[2] = { cosine(middle, atEdge[0]), cosine(middle, atEdge[1]) };
    // After either flip the two new triangles, of which the first is beside the other neighbour.
    const Corners after[2][2] = { { { 3, 1, 2 }, { 2, 0, 3 } }, { { 0, 1, 4 }, { 4, 2, 0 } } };
    Soup expected = soup;
    double best = -2.0;
    for (int flip = 0; flip < 2; ++flip)
    {
      const double inner = cosine(after[flip][0], after[flip][1]);
      const double outer = cosine(after[flip][0], atEdge[1 - flip]);
      if (before[0] < fold && before[1] < fold && inner >= fold && outer > before[1 - flip] &&
        std::min(inner, outer) > best)
      {
        best = std::min(inner, outer);
        expected.Triangles = { after[flip][0], after[flip][1], atEdge[1 - flip] };
        expected.Regions = { 1 + flip, 1 + flip, 2 - flip };
      }
    }
    flips += best > -2.0;
    check(GetPlaced(Prepare(MakeMesh(soup))->GetOutput()) == GetPlaced(MakeMesh(expected)),
      "the flip is that of the rule", trial);
  }
  std::cout << "rule: " << flips << " flips\n";
  check(flips > 100, "there are flips", flips);
}

/// A flat body, closed and with ears on top: polygons of points on a circle, the upper one a fan
/// from its first point, the lower one from its second or from a point in it.
Soup MakeLid(int sides, double thickness, bool hasCentre)
{
  Soup soup;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / sides;
    soup.Positions.push_back({ std::cos(angle), 0.7 * std::sin(angle), i == 1 ? -thickness : 0.0 });
  }
  soup.Positions.push_back({ 0.3, 0.1, -thickness });
  for (vtkIdType i = 1; i + 1 < sides; ++i)
  {
    soup.Triangles.push_back({ 0, i, i + 1 });
  }
  for (vtkIdType i = 0; i < sides; ++i)
  {
    const vtkIdType next = (i + 1) % sides;
    const vtkIdType apex = hasCentre ? sides : 1;
    if (i != apex && next != apex)
    {
      soup.Triangles.push_back({ next, i, apex });
    }
  }
  if (!hasCentre)
  {
    soup.Positions.pop_back();
  }
  soup.Regions.resize(soup.Triangles.size());
  return soup;
}

void TestUntouched(Checks& check)
{
  for (int sides = 3; sides < 12; ++sides)
  {
    for (double thickness : { 0.0, 1e-3, 0.03 })
    {
      const std::string what = "lid of " + std::to_string(sides);
      CheckUntouched(check, what, MakeMesh(MakeLid(sides, thickness, true)));
      if (sides > 3)
      {
        CheckUntouched(
          check, what + " without a centre", MakeMesh(MakeLid(sides, thickness, false)));
      }
    }
  }
  CheckUntouched(check, "torus", MakeTorus(1.0, 0.4, 60, 30).Mesh);

  // A sheet with two sides that share their border.
  Soup sheet = MakeFillet(true);
  const std::size_t size = sheet.Triangles.size();
  const auto points = static_cast<vtkIdType>(sheet.Positions.size());
  std::vector<vtkIdType> below(points);
  for (vtkIdType i = 0; i < points; ++i)
  {
    const vtkIdType row = i / (Columns + 1);
    const vtkIdType column = i % (Columns + 1);
    const bool isInner = row > 0 && row < Rows && column > 0 && column < Columns;
    below[i] = isInner ? static_cast<vtkIdType>(sheet.Positions.size()) : i;
    if (isInner)
    {
      Point point = sheet.Positions[i];
      point[0] -= 1e-3;
      point[2] -= 1e-3;
      sheet.Positions.push_back(point);
    }
  }
  // Not the corners that would be in the same place.
  for (std::size_t t = 0; t < size; ++t)
  {
    const auto [a, b, c] = sheet.Triangles[t];
    if (below[a] != a || below[b] != b || below[c] != c)
    {
      sheet.Triangles.push_back({ below[a], below[c], below[b] });
      sheet.Regions.push_back(sheet.Regions[t]);
    }
  }
  CheckUntouched(check, "two-sided sheet", MakeMesh(sheet));

  // A fifth of the edges' length, in any direction.
  AnalyticSurface scan = MakeTorus(1.0, 0.4, 160, 80);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (vtkIdType i = 0; i < scan.Mesh->GetNumberOfPoints(); ++i)
  {
    Vector3d point = scan.Truths[i].Point;
    for (double& c : point)
    {
      random->Next();
      c += 0.006 * (2.0 * random->GetValue() - 1.0);
    }
    scan.Mesh->GetPoints()->SetPoint(i, point.data());
  }
  CheckUntouched(check, "noisy scan", scan.Mesh);
}
}

int TestSurfaceFoldovers(int, char*[])
{
  Checks check;
  TestFillet(check);
  TestTangles(check);
  TestRule(check);
  TestHopeless(check);
  TestTouchingFin(check);
  TestUntouched(check);
  return check.GetResult();
}
