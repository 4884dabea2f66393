// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Borders of regions that cell arrays of all kinds tell apart.
#include "nprLineTesting.h"

#include "vtkNPRRegionBorders.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkLongLongArray.h>
#include <vtkStringArray.h>

#include <limits>
#include <string>

using namespace nprtest;

namespace
{
constexpr int Size = 9;

// A flat sheet of 8 x 8 squares, of two triangles each, with a vertex in front of them: cell data
// begin with that.
vtkSmartPointer<vtkPolyData> MakeSheet()
{
  auto sheet = MakeGrid(Size, Size, false, false);
  for (vtkIdType i = 0; i < sheet->GetNumberOfPoints(); ++i)
  {
    sheet->GetPoints()->SetPoint(
      i, static_cast<double>(i / Size), static_cast<double>(i % Size), 0.0);
  }
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  sheet->SetVerts(vertices);
  return sheet;
}

// `value` gives a component for a square of the sheet.
template<typename Array, typename Value>
void AddCellArray(vtkPolyData* sheet, const char* name, int components, const Value& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(sheet->GetNumberOfCells());
  for (int c = 0; c < components; ++c)
  {
    array->SetTypedComponent(0, c, -1);
    for (int cell = 0; cell < 2 * (Size - 1) * (Size - 1); ++cell)
    {
      array->SetTypedComponent(cell + 1, c, value(cell / 2 / (Size - 1), cell / 2 % (Size - 1), c));
    }
  }
  sheet->GetCellData()->AddArray(array);
}

std::vector<Chain> ExtractBorders(vtkPolyData* sheet, const char* array)
{
  vtkNew<vtkNPRRegionBorders> borders;
  borders->SetTextParameter("array", array);
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(borders);
  lines->SetInputData(sheet);
  lines->Update();
  return GetChains(lines->GetOutput());
}

void CheckStraight(const std::vector<Chain>& chains, double x, Checks& check)
{
  CheckSound(chains, check);
  if (check(chains.size() == 1 && !chains[0].Closed && GetLength(chains[0]) == Size - 1.0,
        "one line between two regions", static_cast<double>(chains.size())))
  {
    for (const Vector& p : chains[0].Points)
    {
      check(p[0] == x, "the line is between the regions", p[0]);
    }
    // Triangles run from x to y, so the left of upwards is lesser x.
    check(
      chains[0].Points.back()[1] < chains[0].Points.front()[1], "the higher value is on the left");
  }
}

void TestKinds(Checks& check)
{
  auto sheet = MakeSheet();
  AddCellArray<vtkIntArray>(sheet, "RegionId", 1, [](int i, int, int) { return i < 3 ? 0 : 1; });
  // They differ in the last digit, which a double does not have.
  AddCellArray<vtkLongLongArray>(
    sheet, "big", 1, [](int i, int, int) { return (1LL << 60) + (i < 4 ? 0 : 1); });
  AddCellArray<vtkDoubleArray>(
    sheet, "real", 1, [](int i, int j, int) { return i < 5 ? (j % 2 == 0 ? 0.0 : -0.0) : 0.1; });
  AddCellArray<vtkDoubleArray>(sheet, "unknown", 1,
    [](int i, int, int) { return i < 6 ? 7.0 : std::numeric_limits<double>::quiet_NaN(); });
  AddCellArray<vtkIntArray>(
    sheet, "several", 3, [](int i, int, int c) { return c == 2 && i >= 7 ? 5 : 3; });
  const std::vector<const char*> names = { "RegionId", "big", "real", "unknown", "several" };
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    CheckStraight(ExtractBorders(sheet, names[i]), 3.0 + static_cast<double>(i), check);
  }
  CheckStraight(Extract(sheet, { "region-borders" }, nullptr), 3.0, check);
}

void TestIsland(Checks& check)
{
  auto sheet = MakeSheet();
  AddCellArray<vtkIntArray>(sheet, "island", 1,
    [](int i, int j, int) { return i >= 2 && i < 5 && j >= 2 && j < 4 ? 1 : 0; });
  const auto chains = ExtractBorders(sheet, "island");
  CheckSound(chains, check);
  check(chains.size() == 1 && chains[0].Closed && GetLength(chains[0]) == 10.0,
    "an island has one closed border", static_cast<double>(chains.size()));

  // Where three regions or more meet, their borders end.
  AddCellArray<vtkIntArray>(
    sheet, "quarters", 1, [](int i, int j, int) { return (i < 4 ? 0 : 1) + (j < 4 ? 0 : 2); });
  check(ExtractBorders(sheet, "quarters").size() == 4, "four borders meet in a cross");
}

void TestErrors(Checks& check)
{
  auto sheet = MakeSheet();
  vtkNew<vtkNPRRegionBorders> borders;
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(borders);
  lines->SetInputData(sheet);
  check(Contains(GetErrors(lines), "no cell arrays"), "a surface without cell arrays is an error");

  AddCellArray<vtkIntArray>(sheet, "material", 1, [](int, int, int) { return 0; });
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfTuples(sheet->GetNumberOfCells());
  sheet->GetCellData()->AddArray(words);
  vtkNew<vtkIntArray> tooShort;
  tooShort->SetName("short");
  tooShort->InsertNextValue(1);
  sheet->GetCellData()->AddArray(tooShort);
  for (const char* name : { "RegionId", "words", "short", "" })
  {
    borders->SetArray(name);
    const std::string errors = GetErrors(lines);
    check(Contains(errors, "region-borders") && Contains(errors, "\"" + std::string(name) + "\"") &&
        Contains(errors, "material"),
      "the error names the lines, the array, and those that there are");
  }
  borders->SetArray("material");
  check(GetErrors(lines).empty() && lines->GetOutput()->GetNumberOfLines() == 0,
    "one region has no borders");
  check(!borders->IsForAnySurface(), "not every surface has regions");
}
}

int TestRegionBorders(int, char*[])
{
  Checks check;
  TestKinds(check);
  TestIsland(check);
  TestErrors(check);
  return check.GetResult();
}
