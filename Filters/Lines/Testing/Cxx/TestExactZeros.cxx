// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Fields that are exactly 0 at points and along edges: no line may get lost or come twice.
#include "nprGivenLines.h"
#include "nprLineTesting.h"

#include <functional>

using namespace nprtest;

namespace
{
// The lines of a field on the square [-4, 4]^2 of 8 x 8 cells.
std::vector<Chain> ExtractField(const std::function<double(double, double)>& function)
{
  const int n = 9;
  auto square = MakeGrid(n, n, false, false);
  auto normals = AddArray(square, npr::names::Normals, 3);
  auto field = AddArray(square, "Field", 1);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double x = i - n / 2;
      const double y = j - n / 2;
      square->GetPoints()->SetPoint(i * n + j, x, y, 0.0);
      normals->SetTuple3(i * n + j, 0.0, 0.0, 1.0);
      field->SetTuple1(i * n + j, function(x, y));
    }
  }
  vtkNew<GivenLines> definition;
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(definition);
  lines->SetInputData(square);
  lines->Update();
  return GetChains(lines->GetOutput());
}

double GetTotalLength(const std::vector<Chain>& chains)
{
  double length = 0.0;
  for (const Chain& chain : chains)
  {
    length += GetLength(chain);
  }
  return length;
}

void TestField(const std::function<double(double, double)>& function, double length,
  std::size_t numberOfChains, const char* what, Checks& check)
{
  const auto chains = ExtractField(function);
  CheckSound(chains, check);
  check(std::abs(GetTotalLength(chains) - length) < 1.0e-9, what, GetTotalLength(chains));
  check(chains.size() == numberOfChains, what, static_cast<double>(chains.size()));
}

// Two triangles on a split edge from x = 0 to 1. Above, the field falls and is 0 at 1/2; below, it
// rises and is 0 at 1/4. Their signs differ up to 1/4 and from 1/2 on.
void TestJumps(Checks& check)
{
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  for (const Vector& p : { Vector(0, 0, 0), Vector(1, 0, 0), Vector(0.5, 1, 0), Vector(0, 0, 0),
         Vector(1, 0, 0), Vector(0.5, -1, 0) })
  {
    points->InsertNextPoint(p.data());
  }
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 4, 3, 5 });
  AddWeldedIds(surface, { 0, 1, 2, 0, 1, 5 });
  auto normals = AddArray(surface, npr::names::Normals, 3);
  auto field = AddArray(surface, "Field", 1);
  const double values[] = { 1.0, -1.0, 1.0, -1.0, 3.0, 1.0 };
  for (vtkIdType i = 0; i < 6; ++i)
  {
    normals->SetTuple3(i, 0.0, 0.0, 1.0);
    field->SetTuple1(i, values[i]);
  }
  vtkNew<GivenLines> definition;
  definition->Jumps = true;
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(definition);
  lines->SetInputData(surface);
  lines->Update();
  const auto chains = GetChains(lines->GetOutput());
  CheckSound(chains, check);
  std::vector<Segment> along;
  for (const Segment& segment : GetSegments(chains))
  {
    if (segment[1] == 0.0 && segment[4] == 0.0)
    {
      along.push_back(segment);
    }
  }
  check(along == std::vector<Segment>{ { 0, 0, 0, 0.25, 0, 0 }, { 0.5, 0, 0, 1, 0, 0 } },
    "the line runs where the signs of the two sides differ", static_cast<double>(along.size()));
}
}

int TestExactZeros(int, char*[])
{
  Checks check;
  TestField([](double x, double) { return x - 0.5; }, 8.0, 1, "a line between the points", check);
  for (double sign : { -1.0, 1.0 })
  {
    TestField([sign](double x, double) { return sign * x; }, 8.0, 1, "along edges", check);
    TestField([sign](double x, double y) { return sign * (x - y); }, 8.0 * std::sqrt(2.0), 1,
      "along diagonal edges", check);
    TestField([sign](double x, double y) { return sign * (x + y); }, 8.0 * std::sqrt(2.0), 1,
      "through points and across diagonal edges", check);
    TestField([sign](double x, double y) { return sign * (std::abs(x) + std::abs(y) - 2.0); },
      8.0 * std::sqrt(2.0), 1, "around a diamond", check);
  }
  TestField(
    [](double x, double y) { return -x * y; }, 16.0, 4, "lines that cross in a point", check);
  // A ridge of zeros in negative land is one line; in positive land the sign never changes.
  TestField([](double x, double) { return -std::abs(x); }, 8.0, 1, "a ridge of zeros", check);
  TestField([](double x, double) { return std::abs(x); }, 0.0, 0, "a valley of zeros", check);
  TestField([](double x, double y) { return -x * x - y * y; }, 0.0, 0, "a lone zero", check);
  TestField([](double x, double y) { return x * x + y * y; }, 0.0, 0, "a lone zero", check);
  TestField([](double, double) { return 0.0; }, 0.0, 0, "zero everywhere", check);
  TestField([](double, double) { return -0.0; }, 0.0, 0, "minus zero everywhere", check);

  // The positive side is on the left.
  const auto chains = ExtractField([](double x, double) { return x; });
  check(chains.size() == 1 && chains[0].Points.back()[1] < chains[0].Points.front()[1],
    "with x > 0 on its left the line runs towards -y");
  TestJumps(check);
  return check.GetResult();
}
