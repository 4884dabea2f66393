// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sample is one closed, oriented surface without holes, even and smooth, and the same each
// time.
#include <vtkNPRSampleSource.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>
#include <utility>

namespace
{
int Failures = 0;

void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++Failures;
  }
}

vtkSmartPointer<vtkPolyData> Make(int resolution)
{
  vtkNew<vtkNPRSampleSource> source;
  source->SetResolution(resolution);
  source->Update();
  return source->GetOutput();
}

struct Measures
{
  double Volume = 0.0;
  double Area = 0.0;
  double LeastQuality = 1.0; // of a triangle: 1 if it is equilateral, 0 without area
  double FlippedArea = 0.0;  // of triangles that face against the normals of their corners
};

Measures Measure(vtkPolyData* surface)
{
  Measures measures;
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  vtkNew<vtkIdList> cell;
  for (vtkIdType t = 0; t < surface->GetNumberOfPolys(); ++t)
  {
    surface->GetPolys()->GetCellAtId(t, cell);
    double p[3][3];
    double mean[3] = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(cell->GetId(i), p[i]);
      const double* normal = normals->GetTuple3(cell->GetId(i));
      vtkMath::Add(mean, normal, mean);
    }
    double normal[3];
    vtkTriangle::ComputeNormal(p[0], p[1], p[2], normal);
    const double area = vtkTriangle::TriangleArea(p[0], p[1], p[2]);
    const double squares = vtkMath::Distance2BetweenPoints(p[0], p[1]) +
      vtkMath::Distance2BetweenPoints(p[1], p[2]) + vtkMath::Distance2BetweenPoints(p[2], p[0]);
    measures.Area += area;
    measures.Volume += vtkMath::Determinant3x3(p[0], p[1], p[2]) / 6.0;
    measures.LeastQuality = std::min(measures.LeastQuality, 4.0 * std::sqrt(3.0) * area / squares);
    measures.FlippedArea += vtkMath::Dot(normal, mean) < 0.0 ? area : 0.0;
  }
  return measures;
}

// Each edge is met once in each direction: closed, manifold and of one orientation.
void TestTopology(vtkPolyData* surface, const std::string& name)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  bool isDouble = false;
  vtkNew<vtkIdList> cell;
  for (vtkIdType t = 0; t < surface->GetNumberOfPolys(); ++t)
  {
    surface->GetPolys()->GetCellAtId(t, cell);
    for (int i = 0; i < 3; ++i)
    {
      isDouble = !edges.emplace(cell->GetId(i), cell->GetId((i + 1) % 3)).second || isDouble;
    }
  }
  bool isOpen = false;
  for (const auto& edge : edges)
  {
    isOpen = edges.count({ edge.second, edge.first }) == 0 || isOpen;
  }
  Expect(!isDouble, name + " is manifold and oriented");
  Expect(!isOpen, name + " is closed");
  const auto characteristic = surface->GetNumberOfPoints() -
    static_cast<vtkIdType>(edges.size() / 2) + surface->GetNumberOfPolys();
  Expect(characteristic == 2,
    name + " has the Euler characteristic 2, not " + std::to_string(characteristic));
  vtkNew<vtkPolyDataConnectivityFilter> parts;
  parts->SetInputData(surface);
  parts->SetExtractionModeToAllRegions();
  parts->Update();
  Expect(parts->GetNumberOfExtractedRegions() == 1, name + " is in one piece");
}

bool AreEqual(vtkPolyData* a, vtkPolyData* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() ||
    a->GetNumberOfPolys() != b->GetNumberOfPolys())
  {
    return false;
  }
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    if (!std::equal(p, p + 3, q))
    {
      return false;
    }
  }
  return true;
}
}

int TestSampleSource(int, char*[])
{
  const auto start = std::chrono::steady_clock::now();
  const auto sample = Make(320);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::cout << sample->GetNumberOfPolys() << " triangles in " << seconds.count() << " s\n";
  Expect(sample->GetNumberOfPolys() > 150000 && sample->GetNumberOfPolys() < 250000,
    "the default has " + std::to_string(sample->GetNumberOfPolys()) + " triangles");
  TestTopology(sample, "the default");
  const Measures fine = Measure(sample);
  Expect(fine.Volume > 1.0, "it faces outwards; its volume is " + std::to_string(fine.Volume));
  Expect(fine.LeastQuality > 0.2,
    "its triangles are even; the worst has the quality " + std::to_string(fine.LeastQuality));
  Expect(fine.FlippedArea < 1e-5 * fine.Area, "no triangle is folded over");
  double bounds[6];
  sample->GetBounds(bounds);
  Expect(std::abs(bounds[2]) < 1e-5, "it stands on y = 0");
  Expect(bounds[1] - bounds[0] > 3.9 && bounds[1] - bounds[0] < 4.1, "it is four long");

  vtkSmartPointer<vtkPolyData> once;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 }, [&once]() { once = Make(160); });
  vtkSmartPointer<vtkPolyData> again;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 2 }, [&again]() { again = Make(160); });
  Expect(AreEqual(once, again), "it is the same for one thread and two");

  for (const int resolution : { 120, 160, 233 })
  {
    const auto coarse = Make(resolution);
    const std::string name = "resolution " + std::to_string(resolution);
    TestTopology(coarse, name);
    const double ratio =
      static_cast<double>(sample->GetNumberOfPolys()) / coarse->GetNumberOfPolys();
    const double expected = 320.0 * 320.0 / resolution / resolution;
    Expect(ratio > 0.9 * expected && ratio < 1.15 * expected,
      name + " scales the triangles by " + std::to_string(ratio));
    // The shape stays, whatever the resolution.
    Expect(std::abs(Measure(coarse).Volume / fine.Volume - 1.0) < 0.01, name + " keeps the volume");
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
