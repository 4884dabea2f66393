// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Regions where a field has one sign, of which light ones become a part of what is around them:
// stripes beside a plain reference, and zeros, ghosts and what is no number.
#include "nprAnalyticSurfaces.h"
#include "nprSignRegions.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <limits>
#include <random>

using namespace nprtest;

namespace
{
constexpr int Columns = 200;
constexpr int Rows = 6;

vtkSmartPointer<vtkPolyData> MakeSheet()
{
  return MakeSurface(
    { [](double x, double y) {
       return MakeHeightTruth(x, y, { 0.0, { 0, 0 }, { 0, 0, 0 }, { 0, 0, 0, 0 } });
     },
      { 0.0, Columns, 0.0, Rows } },
    Columns, Rows)
    .Mesh;
}

// Values of the columns of points as those of the points, and back.
std::vector<float> ToPoints(const npr::LineSurface& surface, const std::vector<double>& columns)
{
  std::vector<float> values;
  for (npr::TriangleMesh::Index i = 0; i < surface.GetMesh().GetNumberOfPoints(); ++i)
  {
    values.push_back(static_cast<float>(columns[surface.GetPointId(i) / (Rows + 1)]));
  }
  return values;
}

std::vector<double> ToColumns(const npr::LineSurface& surface, const std::vector<float>& values)
{
  std::vector<double> columns(Columns + 1);
  for (npr::TriangleMesh::Index i = 0; i < surface.GetMesh().GetNumberOfPoints(); ++i)
  {
    columns[surface.GetPointId(i) / (Rows + 1)] = values[i];
  }
  return columns;
}

std::vector<double> Merge(const npr::LineSurface& surface, const std::vector<double>& density,
  double least, const std::vector<double>& field)
{
  std::vector<float> values = ToPoints(surface, field);
  npr::MergeLightRegions(surface, ToPoints(surface, density), least, values);
  return ToColumns(surface, values);
}

// Stripes by the definition: as long as the lightest is too light, it goes to its neighbours.
std::vector<bool> MergeStripes(
  const std::vector<double>& density, double least, const std::vector<double>& field)
{
  struct Stripe
  {
    bool Positive;
    double Weight;
    int Size;
  };
  std::vector<Stripe> stripes;
  for (int column = 0; column <= Columns; ++column)
  {
    const bool positive = field[column] >= 0.0;
    if (stripes.empty() || stripes.back().Positive != positive)
    {
      stripes.push_back({ positive, 0.0, 0 });
    }
    const bool isBorder = column == 0 || column == Columns;
    stripes.back().Weight += Rows * density[column] * (isBorder ? 0.5 : 1.0);
    ++stripes.back().Size;
  }
  while (stripes.size() > 1)
  {
    const auto lightest = std::min_element(stripes.begin(), stripes.end(),
      [](const Stripe& a, const Stripe& b) { return a.Weight < b.Weight; });
    if (lightest->Weight >= least)
    {
      break;
    }
    const auto first = lightest == stripes.begin() ? lightest : lightest - 1;
    const auto last = lightest + 1 == stripes.end() ? lightest : lightest + 1;
    Stripe merged = { !lightest->Positive, -2.0 * lightest->Weight, 0 };
    for (auto stripe = first; stripe <= last; ++stripe)
    {
      merged.Weight += stripe->Weight;
      merged.Size += stripe->Size;
    }
    *first = merged;
    stripes.erase(first + 1, last + 1);
  }
  std::vector<bool> signs;
  for (const Stripe& stripe : stripes)
  {
    signs.insert(signs.end(), stripe.Size, stripe.Positive);
  }
  return signs;
}

void TestStripes(const npr::LineSurface& surface, Checks& check)
{
  std::mt19937 random(5);
  const auto draw = [&] { return random() / 4294967296.0; };
  int most = 0;
  for (int trial = 0; trial < 60; ++trial)
  {
    std::vector<double> field(Columns + 1);
    std::vector<double> density(Columns + 1);
    for (int i = 0; i <= Columns; ++i)
    {
      field[i] = draw() < 0.3 && i > 0 ? field[i - 1] : draw() - 0.5;
      density[i] = 0.1 + draw();
    }
    const double least = 200.0 * draw() * draw();
    const auto signs = MergeStripes(density, least, field);
    const auto merged = Merge(surface, density, least, field);
    int changes = 0;
    for (int i = 0; i <= Columns; ++i)
    {
      check((merged[i] >= 0.0) == signs[i], "stripes are merged by their weights", i);
      check(std::abs(merged[i]) == std::abs(static_cast<float>(field[i])), "nothing but signs");
      changes += i > 0 && signs[i] != signs[i - 1] ? 1 : 0;
    }
    most = std::max(most, changes);
  }
  check(most > 10, "some trials leave many stripes", most);
}

void TestValues(const npr::LineSurface& surface, Checks& check)
{
  const std::vector<double> density(Columns + 1, 1.0);
  std::vector<double> field(Columns + 1, -1.0);
  field[70] = 0.0;
  check(Merge(surface, density, 100.0, field)[70] < 0.0, "a slight zero goes below, too");
  check(Merge(surface, density, 1.0, field)[70] == 0.0, "one that is not slight stays");
  field[70] = std::numeric_limits<double>::quiet_NaN();
  field[71] = 2.0;
  const auto merged = Merge(surface, density, 100.0, field);
  check(std::isnan(merged[70]) && merged[71] == -2.0, "what is no number has no part in it");
  const std::vector<double> same(Columns + 1, 1.0);
  check(Merge(surface, density, 1.0e9, same) == same, "what has nothing around it stays");
}

// The last column of triangles is another piece's.
void TestGhosts(Checks& check)
{
  const auto sheet = MakeSheet();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < sheet->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    sheet->GetCellBounds(i, bounds);
    ghosts->InsertNextValue(bounds[1] > Columns - 0.5 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  sheet->GetCellData()->AddArray(ghosts);
  const npr::LineSurface surface(sheet);
  const std::vector<double> density(Columns + 1, 1.0);
  std::vector<double> field(Columns + 1, -1.0);
  field[70] = 1.0;
  field[Columns - 1] = 1.0;
  const auto merged = Merge(surface, density, 100.0, field);
  check(merged[70] == -1.0 && merged[Columns - 1] == 1.0,
    "regions that may go on in another piece are kept");
}
}

int TestSignRegions(int, char*[])
{
  Checks check;
  const npr::LineSurface surface(MakeSheet());
  TestStripes(surface, check);
  TestValues(surface, check);
  TestGhosts(check);
  return check.GetResult();
}
