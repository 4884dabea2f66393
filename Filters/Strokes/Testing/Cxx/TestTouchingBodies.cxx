// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Bodies that touch do not hide each other's lines, however differently they are tessellated; walls
// do, however thin they are.
#include "nprHiddenStrokes.h"

#include "nprVisibilityOracle.h"
#include "vtkNPRSurfaceNormals.h"
#include "vtkNPRSurfacePreparation.h"

#include <vtkAppendPolyData.h>
#include <vtkMath.h>

using namespace nprtest;

namespace
{
Checks check;

Vector3d GetPlace(double radius, double degrees, double z)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

/// A closed ring around z of so many sides.
Data MakeTube(double inner, double outer, double low, double high, int sides, double phase)
{
  Points corners;
  std::vector<std::vector<vtkIdType>> cells;
  for (int i = 0; i < sides; ++i)
  {
    const double degrees = phase + 360.0 * i / sides;
    for (const auto& [radius, z] : { std::pair(inner, low), std::pair(outer, low),
           std::pair(outer, high), std::pair(inner, high) })
    {
      corners.push_back(GetPlace(radius, degrees, z));
    }
    for (int k = 0; k < 4; ++k)
    {
      const int next = (i + 1) % sides;
      cells.push_back({ 4 * i + k, 4 * next + k, 4 * next + (k + 1) % 4, 4 * i + (k + 1) % 4 });
    }
  }
  return MakePolygons(corners, cells);
}

/// All as one surface, with estimated normals.
Data Prepare(const std::vector<Data>& bodies)
{
  vtkNew<vtkAppendPolyData> append;
  for (const Data& body : bodies)
  {
    append->AddInputData(body);
  }
  vtkNew<vtkNPRSurfacePreparation> preparation;
  preparation->SetInputConnection(append->GetOutputPort());
  vtkNew<vtkNPRSurfaceNormals> normals;
  normals->SetInputConnection(preparation->GetOutputPort());
  normals->Update();
  return normals->GetOutput();
}

/// A part of a polygon around z.
Points MakeArc(double radius, double z, int sides, double phase, double first, double last)
{
  Points arc;
  for (int i = -sides; i < 2 * sides; ++i)
  {
    const double degrees = phase + 360.0 * i / sides;
    if (degrees >= first && degrees <= last)
    {
      arc.push_back(GetPlace(radius, degrees, z));
    }
  }
  return arc;
}

void CheckAgainstOracle(
  const Parts& parts, const std::vector<Data>& surfaces, vtkCamera* camera, double height)
{
  VisibilityOracle oracle;
  for (const Data& surface : surfaces)
  {
    oracle.AddSurface(surface, Eigen::Matrix4d::Identity());
  }
  oracle.Prepare();
  oracle.SetView(camera, height);
  double all = 0.0;
  double wrong = 0.0;
  for (const Part& part : parts)
  {
    for (std::size_t i = 1; i < part.Line.size(); ++i)
    {
      const Vector3d middle = 0.5 * (part.Line[i - 1] + part.Line[i]);
      const double length = (part.Line[i] - part.Line[i - 1]).norm();
      all += length;
      wrong +=
        (oracle.CountLayers(middle, Vector3d::Zero(), Vector3d::Zero()) > 0) != (part.Layers > 0)
        ? length
        : 0;
    }
  }
  check(wrong < 0.01 * all, "touching bodies by brute force", wrong / all);
}

void TestSleeve()
{
  // A sleeve around a shaft: of the sleeve's inner rim all is visible that is before the shaft.
  const Data shaft = MakeTube(0.2, 1.0, -1.0, 1.0, 25, 0.0);
  for (const int sides : { 24, 25, 34, 60 })
  {
    for (const double phase : { 0.0, 1.7, 5.0 })
    {
      const Data sleeve = MakeTube(1.0, 1.5, -1.0, 0.0, sides, phase);
      const auto strokes = MakePolylines({ MakeArc(1.0, 0.0, sides, phase, 190.0, 350.0),
        MakeArc(1.0, 0.0, sides, phase, 20.0, 160.0) });
      for (const bool parallel : { true, false })
      {
        const auto camera = MakeCamera({ 0.0, -8.0, 5.0 }, parallel);
        for (const std::vector<Data>& surfaces :
          { std::vector<Data>{ Prepare({ shaft }), Prepare({ sleeve }) },
            { Prepare({ shaft, sleeve }) } })
        {
          const auto filter = MakeFilter(strokes, surfaces, camera);
          filter->SetMaximumLayersToVisibleOnly();
          const Parts parts = GetParts(filter);
          check(GetLayers(parts) == "0 1", "a rim on a shaft: " + GetLayers(parts), sides);
          CheckAgainstOracle(parts, surfaces, camera, filter->GetViewportHeight());
        }
      }
    }
  }
}

void TestGap()
{
  // A shaft that is thicker than the hole, by more than the chords are wrong, hides the rim.
  const Data sleeve = MakeTube(1.0, 1.5, -1.0, 0.0, 60, 1.7);
  const auto strokes = MakePolylines({ MakeArc(1.0, 0.0, 60, 1.7, 200.0, 340.0) });
  const auto camera = MakeCamera({ 0.0, -8.0, 5.0 });
  const Parts parts = GetParts(
    MakeFilter(strokes, { Prepare({ MakeTube(0.2, 1.05, -1.0, 1.0, 60, 0.0), sleeve }) }, camera));
  check(GetLayers(parts) == "1", "a rim in a shaft: " + GetLayers(parts));
}

void TestThinRoundWall()
{
  // A line on the far side of the wall before it, which is thinner than its chords are wrong, and
  // one on a shaft behind such a wall that it does not touch.
  for (const double thickness : { 0.01, 0.002 })
  {
    const Data wall = MakeTube(1.0 - thickness, 1.0, -1.0, 1.0, 25, 0.0);
    const auto strokes = MakePolylines({ MakeArc(1.0 - thickness, 0.1, 25, 0.0, 200.0, 340.0),
      MakeArc(1.0, 0.1, 25, 0.0, 200.0, 340.0), MakeArc(0.9, 0.0, 24, 3.0, 200.0, 340.0) });
    const Data shaft = MakeTube(0.2, 0.9, -1.0, 0.0, 24, 3.0);
    for (const bool parallel : { true, false })
    {
      const auto filter =
        MakeFilter(strokes, { Prepare({ wall, shaft }) }, MakeCamera({ 0.0, -8.0, 1.0 }, parallel));
      const std::string layers = GetLayers(GetParts(filter));
      check(layers == "1 0 2", "a thin round wall: " + layers, thickness);
    }
  }
}
}

int TestTouchingBodies(int, char*[])
{
  TestSleeve();
  TestGap();
  TestThinRoundWall();
  return check.GetResult();
}
