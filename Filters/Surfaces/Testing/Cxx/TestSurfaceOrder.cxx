// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The same surface with its arrays, neighbours close together, whatever the order was.
#include "nprPointValues.h"
#include "nprRemeshing.h"
#include "vtkNPRSurfaceOrder.h"

#include <numeric>
#include <utility>

using namespace nprtest;

namespace
{
vtkSmartPointer<vtkPolyData> Order(vtkPolyData* mesh)
{
  vtkNew<vtkNPRSurfaceOrder> order;
  order->SetInputData(mesh);
  order->Update();
  return order->GetOutput();
}

std::vector<vtkIdType> MakePermutation(vtkIdType size, int seed)
{
  std::vector<vtkIdType> ids(size);
  std::iota(ids.begin(), ids.end(), 0);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(seed);
  for (vtkIdType i = size - 1; i > 0; --i)
  {
    random->Next();
    std::swap(ids[i], ids[static_cast<vtkIdType>(random->GetValue() * (i + 1))]);
  }
  return ids;
}

vtkSmartPointer<vtkPolyData> Shuffle(vtkPolyData* mesh)
{
  const auto points = MakePermutation(mesh->GetNumberOfPoints(), 1);
  const auto cells = MakePermutation(mesh->GetNumberOfCells(), 2);
  vtkSmartPointer<vtkPolyData> result = Copy(mesh);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    result->GetPoints()->SetPoint(points[i], mesh->GetPoint(static_cast<vtkIdType>(i)));
  }
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c : cells)
  {
    mesh->GetCellPoints(c, ids);
    polygons->InsertNextCell(static_cast<int>(ids->GetNumberOfIds()));
    for (vtkIdType p : *ids)
    {
      polygons->InsertCellPoint(points[p]);
    }
  }
  result->SetPolys(polygons);
  return result;
}

/// Mean difference of the numbers of an edge's ends.
double GetSpread(vtkPolyData* mesh)
{
  double sum = 0.0;
  ForTriangles(mesh,
    [&](vtkIdType a, vtkIdType b, vtkIdType) { sum += std::abs(static_cast<double>(a - b)); });
  return sum / mesh->GetNumberOfCells();
}

void TestSameSurface(Checks& check)
{
  vtkSmartPointer<vtkPolyData> torus = MakeTorus(1.0, 0.4, 120, 60).Mesh;
  Shake(torus, 0.001); // no two triangles alike
  vtkSmartPointer<vtkPolyData> shuffled = Shuffle(torus);
  AddArrays(shuffled);
  vtkSmartPointer<vtkPolyData> ordered = Order(shuffled);
  check(ordered->GetNumberOfPoints() == torus->GetNumberOfPoints() &&
      ordered->GetNumberOfCells() == torus->GetNumberOfCells(),
    "nothing is lost");
  std::vector<int> uses(torus->GetNumberOfCells(), 0);
  vtkNew<vtkIdList> was;
  vtkNew<vtkIdList> is;
  vtkDataArray* cells = ordered->GetCellData()->GetArray("CellNumbers");
  for (vtkIdType c = 0; c < ordered->GetNumberOfCells(); ++c)
  {
    const auto number = static_cast<vtkIdType>(cells->GetComponent(c, 0));
    ++uses[number];
    shuffled->GetCellPoints(number, was);
    ordered->GetCellPoints(c, is);
    for (int i = 0; i < 3; ++i)
    {
      check(GetPoint(ordered, is->GetId(i)) == GetPoint(shuffled, was->GetId(i)),
        "triangles go with their arrays, corner by corner");
    }
  }
  check(std::count(uses.begin(), uses.end(), 1) == torus->GetNumberOfCells(), "each once");
  for (vtkIdType i = 0; i < ordered->GetNumberOfPoints(); ++i)
  {
    check(GetTuple<3>(ordered, "Coordinates", i) == GetPoint(ordered, i),
      "points go with their arrays");
  }
  check(ordered->GetPointData()->GetScalars() != nullptr, "what is active stays active");

  std::cout << "mean difference of neighbours' numbers: grid " << GetSpread(torus) << ", shuffled "
            << GetSpread(shuffled) << ", ordered " << GetSpread(ordered) << "\n";
  check(GetSpread(ordered) < 0.08 * GetSpread(shuffled), "neighbours come close");

  // Each triangle starts at the corner that it started at; so the points come out alike, too.
  vtkSmartPointer<vtkPolyData> other = Order(torus);
  double largest = 0.0;
  for (vtkIdType i = 0; i < other->GetNumberOfPoints(); ++i)
  {
    largest = std::max(largest, (GetPoint(other, i) - GetPoint(ordered, i)).norm());
  }
  check(largest == 0.0, "the order before does not matter", largest);
}

/// On a grid of small triangles the curve goes from each to one beside it.
void TestCurve(Checks& check)
{
  constexpr int n = 8;
  vtkNew<vtkPolyData> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i < n * n * n; ++i)
  {
    const Vector3d middle(i % n, i / n % n, i / n / n);
    const double steps[3][3] = { { 0.1, 0, 0 }, { -0.1, 0.1, 0 }, { 0, -0.1, 0 } };
    cells->InsertNextCell(3);
    for (const auto& step : steps)
    {
      const Vector3d p = middle + Vector3d(step[0], step[1], step[2]);
      cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
  }
  grid->SetPoints(points);
  grid->SetPolys(cells);
  vtkSmartPointer<vtkPolyData> ordered = Order(Shuffle(grid));
  Vector3d last = Vector3d::Zero();
  vtkIdType cell = 0;
  ForTriangles(ordered,
    [&](vtkIdType a, vtkIdType b, vtkIdType c)
    {
      const Vector3d middle =
        (GetPoint(ordered, a) + GetPoint(ordered, b) + GetPoint(ordered, c)) / 3.0;
      check(cell++ == 0 || std::abs((middle - last).norm() - 1.0) < 1e-9, "one step at a time",
        (middle - last).norm());
      last = middle;
    });
}

void TestOtherCells(Checks& check)
{
  // All kinds of cells, a point of none, copies of points, and one that is no number.
  const double NaN = std::numeric_limits<double>::quiet_NaN();
  const double coordinates[][3] = { { 9, 9, 9 }, { NaN, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 },
    { 6, 1, 0 }, { 5, 1, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 1, 0 } };
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> welded;
  welded->SetName(npr::names::WeldedPointIds);
  for (const auto& c : coordinates)
  {
    const vtkIdType id = points->InsertNextPoint(c);
    welded->InsertNextValue(id == 9 ? 8 : static_cast<int>(id));
  }
  const auto insert = [](const std::vector<std::vector<vtkIdType>>& all)
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const auto& ids : all)
    {
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
    return cells;
  };
  mesh->SetPoints(points);
  mesh->SetVerts(insert({ { 4 } }));
  mesh->SetLines(insert({ { 2, 4 }, { 7, 9 } }));
  mesh->SetPolys(insert({ { 1, 2, 3 }, { 2, 3, 4, 5 }, { 6, 7, 8 } }));
  mesh->SetStrips(insert({ { 6, 7, 9, 2 } }));
  AddArrays(mesh);
  mesh->GetPointData()->AddArray(welded);
  vtkSmartPointer<vtkPolyData> ordered = Order(mesh);
  check(ordered->GetNumberOfPoints() == 10 && ordered->GetNumberOfCells() == 7, "all kinds stay");
  vtkNew<vtkIdList> was;
  vtkNew<vtkIdList> is;
  vtkDataArray* cells = ordered->GetCellData()->GetArray("CellNumbers");
  for (vtkIdType c = 0; c < 7; ++c)
  {
    const auto number = static_cast<vtkIdType>(cells->GetComponent(c, 0));
    mesh->GetCellPoints(number, was);
    ordered->GetCellPoints(c, is);
    check(ordered->GetCellType(c) == mesh->GetCellType(number) &&
        is->GetNumberOfIds() == was->GetNumberOfIds(),
      "kind by kind");
    for (vtkIdType i = 0; i < is->GetNumberOfIds(); ++i)
    {
      check(GetValue(ordered, "PointNumbers", is->GetId(i)) == was->GetId(i), "with their points");
    }
  }
  check(cells->GetComponent(3, 0) == 5 && cells->GetComponent(4, 0) == 4 &&
      cells->GetComponent(5, 0) == 3,
    "along the curve, what is nowhere last");
  for (vtkIdType i = 0; i < 10; ++i)
  {
    const auto first = static_cast<vtkIdType>(GetValue(ordered, npr::names::WeldedPointIds, i));
    const double number = GetValue(ordered, "PointNumbers", i);
    check(number >= 8 ? GetValue(ordered, "PointNumbers", first) == 8 : first == i,
      "copies know their first");
  }
  vtkNew<vtkPolyData> empty;
  check(Order(empty)->GetNumberOfPoints() == 0, "nothing becomes nothing");
}
}

int TestSurfaceOrder(int, char*[])
{
  Checks check;
  TestSameSurface(check);
  TestCurve(check);
  TestOtherCells(check);
  return check.GetResult();
}
