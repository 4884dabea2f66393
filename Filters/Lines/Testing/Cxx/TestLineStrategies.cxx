// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Ways to find lines: the hierarchy finds what the full traversal does, to the last bit, from
// everywhere; random seeds find a part of it, and most of it after some views.
#include "nprBumpyRing.h"

#include <vtkFloatArray.h>

#include <cstring>
#include <random>
#include <string>

using namespace nprtest;

namespace
{
// A ring with bumps large and small, so that bounds are sharp in some places and not in others.
vtkSmartPointer<vtkPolyData> MakeRing()
{
  return MakeBumpyRing(240, 100, false,
    [](double u, double v)
    {
      return 1.0 + 0.12 * std::sin(5.0 * u + 0.3) * std::sin(3.0 * v + 0.2) +
        (u > 4.0 ? 0.02 * std::sin(40.0 * u) * std::sin(17.0 * v) : 0.0);
    });
}

// All that the lines of two filters have.
bool AreSame(vtkPolyData* a, vtkPolyData* b)
{
  const auto isSame = [](vtkDataArray* x, vtkDataArray* y)
  {
    const std::size_t bytes =
      static_cast<std::size_t>(x->GetNumberOfValues()) * x->GetDataTypeSize();
    return x->GetNumberOfValues() == y->GetNumberOfValues() &&
      (bytes == 0 || std::memcmp(x->GetVoidPointer(0), y->GetVoidPointer(0), bytes) == 0);
  };
  bool same = isSame(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
    isSame(a->GetLines()->GetConnectivityArray(), b->GetLines()->GetConnectivityArray()) &&
    isSame(a->GetLines()->GetOffsetsArray(), b->GetLines()->GetOffsetsArray());
  for (int i = 0; i < a->GetPointData()->GetNumberOfArrays(); ++i)
  {
    same = same &&
      isSame(a->GetPointData()->GetArray(i),
        b->GetPointData()->GetArray(a->GetPointData()->GetArray(i)->GetName()));
  }
  return same;
}

// Eyes far away, near, inside of the ring's tube, in its surface, and at infinity.
std::vector<vtkSmartPointer<vtkCamera>> MakeCameras()
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<vtkSmartPointer<vtkCamera>> cameras;
  for (const double distance : { 20.0, 4.0, 1.6, 1.2, 0.9 })
  {
    for (int i = 0; i < 8; ++i)
    {
      const Vector direction = Vector(normal(random), normal(random), normal(random)).normalized();
      cameras.push_back(MakeCamera(distance * direction, i % 4 == 3));
    }
  }
  cameras.push_back(MakeCamera({ 1.0, 0.0, 0.0 }));
  cameras.push_back(MakeCamera(Torus().Point(0.0, 0.0)));
  return cameras;
}

void TestHierarchy(Checks& check)
{
  const auto surface = MakeRing();
  for (const char* name : { "contours", "suggestive", "apparent-ridges", "principal-highlights",
         "isophotes", "contour-edges" })
  {
    vtkNew<vtkNPRFeatureLines> full;
    vtkNew<vtkNPRFeatureLines> hierarchical;
    full->SetStrategy(vtkNPRFeatureLines::FULL_TRAVERSAL);
    vtkIdType points = 0;
    for (vtkNPRFeatureLines* lines : { full.Get(), hierarchical.Get() })
    {
      lines->AddDefinition(name);
      lines->SetInputData(surface);
    }
    for (const auto& camera : MakeCameras())
    {
      full->SetCamera(camera);
      hierarchical->SetCamera(camera);
      full->Update();
      hierarchical->Update();
      check(AreSame(full->GetOutput(), hierarchical->GetOutput()), name,
        full->GetOutput()->GetNumberOfPoints() - hierarchical->GetOutput()->GetNumberOfPoints());
      points += full->GetOutput()->GetNumberOfPoints();
    }
    check(points > 1000, "there are lines to compare", static_cast<double>(points));
  }
}

//------------------------------------------------------------------------------
void TestRandomSeeds(Checks& check)
{
  const auto surface = MakeRing();
  vtkNew<vtkNPRFeatureLines> full;
  vtkNew<vtkNPRFeatureLines> random;
  random->SetStrategy(vtkNPRFeatureLines::RANDOM_SEEDS);
  vtkNew<vtkCamera> camera;
  for (vtkNPRFeatureLines* lines : { full.Get(), random.Get() })
  {
    lines->AddDefinition("contours");
    lines->SetInputData(surface);
    lines->SetCamera(camera);
  }
  double all = 0.0;
  double found = 0.0;
  for (int view = 0; view < 20; ++view)
  {
    const double angle = 0.01 * view;
    camera->SetPosition(4.0 * std::sin(angle), 1.5, 4.0 * std::cos(angle));
    full->Update();
    random->Update();
    const auto expected = GetSegments(GetChains(full->GetOutput()));
    const auto some = GetSegments(GetChains(random->GetOutput()));
    check(std::includes(expected.begin(), expected.end(), some.begin(), some.end()),
      "seeds find no lines that are none");
    if (view >= 5)
    {
      all += static_cast<double>(expected.size());
      found += static_cast<double>(some.size());
    }
  }
  check(found > 0.95 * all, "after some views most lines are found", found / all);
  random->SetSeedShare(0.0);
  vtkNew<vtkNPRFeatureLines> none;
  none->SetStrategy(vtkNPRFeatureLines::RANDOM_SEEDS);
  none->SetSeedShare(0.0);
  none->AddDefinition("contours");
  none->SetInputData(surface);
  none->SetCamera(camera);
  none->Update();
  check(
    none->GetOutput()->GetNumberOfLines() == 0, "without seeds and a view before there is nothing");
}
}

//------------------------------------------------------------------------------
int TestLineStrategies(int, char*[])
{
  Checks check;
  TestHierarchy(check);
  TestRandomSeeds(check);
  return check.GetResult();
}
