// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines from frame to frame: points that move while the triangles stay, and numbers that lines keep
// while the eye moves.
#include "nprChainIds.h"
#include "nprLineClusters.h"
#include "nprLineSurface.h"
#include "nprLineTesting.h"

#include "vtkNPRCurvatureTensor.h"
#include "vtkNPRLineDefinition.h"

#include <vtkIntArray.h>

#include <map>
#include <set>

using namespace nprtest;

namespace
{
constexpr int NU = 120;
constexpr int NV = 60;

// A torus that swells somewhere, with time.
void Move(vtkPolyData* surface, double time)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(NU * NV);
  for (int i = 0; i < NU; ++i)
  {
    for (int j = 0; j < NV; ++j)
    {
      const double u = 2.0 * Pi * i / NU;
      const double v = 2.0 * Pi * j / NV;
      Torus torus;
      torus.r *= 1.0 + 0.3 * time * std::sin(3.0 * u + time) * std::sin(2.0 * v);
      points->SetPoint(i * NV + j, Vector(torus.Point(u, v) + Vector(time, 0.0, 0.0)).data());
    }
  }
  surface->SetPoints(points);
}

void TestMovingPoints(Checks& check)
{
  const auto ring = MakeGrid(NU, NV, true, true);
  vtkNew<vtkNPRCurvatureTensor> tensor;
  tensor->SetEstimator(vtkNPRCurvatureTensor::PER_FACE);
  tensor->SetInputData(ring);
  vtkNew<vtkNPRFeatureLines> lines;
  const auto add = [](vtkNPRFeatureLines* filter)
  {
    for (const char* name : { "contours", "suggestive", "ridges", "creases", "topographic" })
    {
      filter->AddDefinition(name)->SetParameter("angle", 8.0);
    }
    filter->SetCamera(MakeCamera({ 2.0, 1.7, 2.4 }));
  };
  add(lines);
  lines->SetInputConnection(tensor->GetOutputPort());
  for (const double time : { 0.0, 0.4, 0.8 })
  {
    Move(ring, time);
    lines->Update();
    vtkNew<vtkPolyData> still;
    still->DeepCopy(tensor->GetOutput());
    vtkNew<vtkNPRFeatureLines> fresh;
    add(fresh);
    fresh->SetInputData(still);
    fresh->Update();
    const auto expected = GetSegments(GetChains(fresh->GetOutput()));
    const auto found = GetSegments(GetChains(lines->GetOutput()));
    check(expected.size() > 500, "there are lines", static_cast<double>(expected.size()));
    // The order in which a new surface is gone through follows its points.
    check(found == expected, "lines of moved points are those of a new surface",
      static_cast<double>(found.size()) - static_cast<double>(expected.size()));
  }
}

void TestWhatIsKept(Checks& check)
{
  const auto ring = MakeGrid(NU, NV, true, true);
  Move(ring, 0.0);
  npr::LineSurface surface(ring);
  Move(ring, 0.5);
  check(surface.Move(ring), "points alone may move");
  const vtkIdType first = surface.GetPointId(0);
  const Vector moved = surface.GetMesh().GetPoint(0).cast<double>() + surface.GetMesh().GetOrigin();
  check((moved - Vector(ring->GetPoint(first))).norm() < 1.0e-6, "and are then where they are");
  ring->GetPoints()->SetPoint(3, std::nan(""), 0.0, 0.0);
  ring->GetPoints()->Modified();
  check(!surface.Move(ring), "a point that is nowhere changes the triangles");
  const auto other = MakeGrid(NU, NV, true, false);
  Move(other, 0.0);
  check(!surface.Move(other), "other triangles are another surface");
}

//------------------------------------------------------------------------------
void TestChainIds(Checks& check)
{
  const auto surface = Torus().Make(200, 100);
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition("contours");
  lines->AddDefinition("suggestive");
  vtkNew<vtkCamera> camera;
  lines->SetCamera(camera);
  lines->SetInputData(surface);
  std::set<int> last;
  double kept = 0.0;
  double all = 0.0;
  for (int view = 0; view < 40; ++view)
  {
    const double angle = 0.5 * view * Pi / 180.0;
    camera->SetPosition(3.0 * std::sin(angle), 2.0, 3.0 * std::cos(angle));
    lines->Update();
    const auto ids =
      vtkIntArray::SafeDownCast(lines->GetOutput()->GetCellData()->GetArray(npr::names::ChainId));
    if (!check(ids && ids->GetNumberOfValues() == lines->GetOutput()->GetNumberOfLines(),
          "chains have numbers"))
    {
      return;
    }
    std::set<int> now;
    for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
    {
      check(now.insert(ids->GetValue(i)).second, "no number comes twice");
      if (view > 0)
      {
        kept += static_cast<double>(last.count(ids->GetValue(i)));
        all += 1.0;
      }
    }
    last.swap(now);
  }
  check(all > 40.0 && kept > 0.9 * all, "lines keep their numbers", kept / all);
}

// Many short lines side by side, as of a scan.
void TestCrowdedChainIds(Checks& check)
{
  const auto surface = Torus().Make(200, 100);
  vtkPoints* const points = surface->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Vector p;
    points->GetPoint(i, p.data());
    p *= 1.0 + 0.03 * std::sin(25.0 * p[0]) * std::sin(23.0 * p[1]) * std::sin(27.0 * p[2]);
    points->SetPoint(i, p.data());
  }
  surface->GetPointData()->Initialize();
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition("apparent-ridges");
  lines->ComputeMissingArraysOn();
  vtkNew<vtkCamera> camera;
  lines->SetCamera(camera);
  lines->SetInputData(surface);
  const auto getIds = [&](double degrees)
  {
    const double angle = degrees * Pi / 180.0;
    camera->SetPosition(3.0 * std::sin(angle), 2.0, 3.0 * std::cos(angle));
    camera->Modified();
    lines->Update();
    const auto ids =
      vtkIntArray::SafeDownCast(lines->GetOutput()->GetCellData()->GetArray(npr::names::ChainId));
    return std::vector<int>(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues());
  };
  const std::vector<int> first = getIds(0.0);
  check(first.size() > 100, "many lines", static_cast<double>(first.size()));
  check(getIds(0.0) == first, "the same view has the same numbers");
  const std::vector<int> moved = getIds(0.05);
  const auto kept = std::count_if(moved.begin(), moved.end(),
    [&](int id) { return std::find(first.begin(), first.end(), id) != first.end(); });
  check(kept > 0.95 * moved.size(), "lines keep their numbers", double(kept) / moved.size());
}

// Adds an open chain whose vertices are in these triangles.
void AddChain(npr::LineChains& chains, const std::vector<npr::LineChains::Index>& triangles)
{
  chains.Begins.push_back(chains.Triangles.size());
  chains.Triangles.insert(chains.Triangles.end(), triangles.begin(), triangles.end());
  chains.Ends.push_back(chains.Triangles.size());
  chains.Closed.push_back(0);
  chains.Levels.push_back(0);
}

// A short line that has moved to where a long one was is not taken for it.
void TestShortBesideLong(Checks& check)
{
  constexpr npr::LineChains::Index place = npr::LineClusters::TrianglesOfCluster;
  npr::LineChains before;
  AddChain(before, { 0, 1, place, place + 1, 2 * place, 2 * place + 1 });
  AddChain(before, { place + 8, place + 9 });
  npr::ChainIds ids;
  ids.Remember(before, { 0, 1 }, { 5, 6 });

  npr::LineChains now;
  AddChain(now, { place, place + 1 });
  npr::ChainIds::Claim claim;
  ids.GetClaims(now, 0, 1, &claim);
  check(ids.Give({ claim }) == std::vector<int>{ 6 }, "a short line goes on from a short one");
}

// How often the number of lines changes while the eye comes and goes a little around the place
// where one is just long enough.
int CountChanges(double hysteresis, double minimumLength)
{
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition("contours");
  lines->SetMinimumLength(minimumLength);
  lines->SetHysteresis(hysteresis);
  vtkNew<vtkCamera> camera;
  lines->SetCamera(camera);
  lines->SetInputData(MakeSphere(30, 1.0));
  int changes = 0;
  vtkIdType last = -1;
  for (int view = 0; view < 20; ++view)
  {
    camera->SetPosition(0.1, 0.2, 6.0 + 0.2 * (view % 2));
    lines->Update();
    const vtkIdType now = lines->GetOutput()->GetNumberOfLines();
    changes += last >= 0 && now != last;
    last = now;
  }
  return changes;
}

void TestHysteresis(Checks& check)
{
  // The contour's length in heights of the view, between that of the nearer and the farther eye.
  const double half = std::asin(1.0 / 6.1);
  const double length = 2.0 * Pi * std::tan(half) / (2.0 * std::tan(15.0 * Pi / 180.0));
  check(CountChanges(0.0, length) == 19, "without, a line comes and goes");
  check(CountChanges(0.2, length) == 0, "with hysteresis it stays", CountChanges(0.2, length));
}
}

//------------------------------------------------------------------------------
int TestMovingLines(int, char*[])
{
  Checks check;
  TestMovingPoints(check);
  TestWhatIsKept(check);
  TestChainIds(check);
  TestCrowdedChainIds(check);
  TestShortBesideLong(check);
  TestHysteresis(check);
  return check.GetResult();
}
