// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes where it is known what hides what, and where strokes must be cut.
#include "nprHiddenStrokes.h"

#include "nprAnalyticSurfaces.h"

#include <vtkMatrix4x4.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

using namespace nprtest;

namespace
{
Checks check;
const Vector3d Front(0.0, 0.0, 10.0);

void TestSheets()
{
  // The line goes behind a wide sheet and a narrow one, and one is behind the line.
  const auto strokes = MakePolylines({ { { -2.0, 0.1, -1.0 }, { 2.0, 0.1, -1.0 } } });
  const std::vector<Data> sheets = { MakeSheet(1.0, 1.0, 0.0), MakeSheet(0.5, 1.0, 1.0),
    MakeSheet(1.9, 1.0, -2.0) };
  for (const bool parallel : { true, false })
  {
    const auto filter = MakeFilter(strokes, sheets, MakeCamera(Front, parallel));
    // In perspective edges at heights 0 and 1 are seen on the line at height -1.
    const double wide = parallel ? 1.0 : 1.1;
    const double narrow = parallel ? 0.5 : 0.5 * 11.0 / 9.0;
    check(AreParts(GetParts(filter), "0 1 2 1 0", 0, { -wide, -narrow, narrow, wide }, 1e-6),
      "two sheets hide a line");
    filter->SetMaximumLayersToVisibleOnly();
    check(AreParts(GetParts(filter), "0 1 0", 0, { -wide, wide }, 1e-6), "visible or not");
  }
  const auto between = MakePolylines({ { { -2.0, 0.1, 0.5 }, { 2.0, 0.1, 0.5 } } });
  check(AreParts(GetParts(MakeFilter(between, sheets, MakeCamera(Front))), "0 1 0", 0,
          { -0.5, 0.5 }, 1e-6),
    "a line between two sheets");
  check(GetLayers(GetParts(MakeFilter(between, { Data::New() }, MakeCamera(Front)))) == "0",
    "nothing hides nothing");
}

void TestSlanted()
{
  // In perspective the middle of a line is not the middle of its image. The sheet's borders are
  // seen where x is 1 - z / 10.
  const auto strokes = MakePolylines({ { { -2.0, 0.1, -3.0 }, { 2.0, 0.1, -1.0 } } });
  const auto filter = MakeFilter(strokes, { MakeSheet(1.0, 1.0, 0.0) }, MakeCamera(Front, false));
  check(AreParts(GetParts(filter), "0 1 0", 0, { -2.0 + 28.0 / 38.0, -2.0 + 132.0 / 42.0 }, 1e-6),
    "a slanted line in perspective");
}

void TestNarrow()
{
  // Far narrower than a pixel, before a line of one segment.
  const auto strokes = MakePolylines({ { { -2.0, 0.1, -1.0 }, { 2.0, 0.1, -1.0 } } });
  const auto filter = MakeFilter(strokes, { MakeSheet(1e-4, 1.0, 0.0) }, MakeCamera(Front));
  filter->SetMinimumLength(0.0);
  check(AreParts(GetParts(filter), "0 1 0", 0, { -1e-4, 1e-4 }, 1e-6), "a narrow sheet hides");
  filter->SetMinimumLength(1.0);
  check(GetLayers(GetParts(filter)) == "0", "what is shorter than a pixel becomes visible");
}

void TestShortEnds()
{
  // Half a pixel is on the other side of the border of the sheet.
  const double pixel = 0.004;
  const auto hidden = MakePolylines({ { { 1.0 - 0.5 * pixel, 0.1, -1.0 }, { 2.0, 0.1, -1.0 } } });
  const auto sheet = MakeSheet(1.0, 1.0, 0.0);
  auto filter = MakeFilter(hidden, { sheet }, MakeCamera(Front));
  filter->SetMinimumLength(1.0);
  check(AreParts(GetParts(filter), "1 0", 0, { 1.0 }, 1e-6), "a short hidden end stays hidden");
  const auto visible = MakePolylines({ { { 0.0, 0.1, -1.0 }, { 1.0 + 0.5 * pixel, 0.1, -1.0 } } });
  filter = MakeFilter(visible, { sheet }, MakeCamera(Front));
  filter->SetMinimumLength(1.0);
  check(GetLayers(GetParts(filter)) == "1", "a short visible end goes");
}

void TestSphere()
{
  // Entered and left: two layers. The finer the sphere, the nearer the cut to the true outline.
  const auto strokes = MakePolylines({ { { -2.0, 0.0, -2.0 }, { 2.0, 0.0, -2.0 } } });
  double before = 1.0;
  for (const int level : { 3, 5 })
  {
    const auto filter =
      MakeFilter(strokes, { MakeOctasphere(1.0, level) }, MakeCamera({ 0.3, 0.4, 10.0 }, false));
    filter->GetCamera()->SetPosition(0.0, 0.0, 10.0);
    const Parts parts = GetParts(filter);
    check(GetLayers(parts) == "0 2 0", "a sphere before a line");
    // The line of sight that touches the sphere.
    const double outline = 12.0 * std::tan(std::asin(0.1));
    const double error = parts.size() == 3 ? std::abs(parts[1].Line.back().x() - outline) : 1.0;
    check(error < 0.1 * before, "the outline of a sphere", error);
    before = error;
  }
}

void TestBox()
{
  const Vector3d sizes(0.8, 0.5, 1.0);
  const Points corners = GetBoxCorners(sizes);
  std::vector<Points> edges;
  for (int i = 0; i < 8; ++i)
  {
    for (const int bit : { 1, 2, 4 })
    {
      if (!(i & bit))
      {
        edges.push_back({ corners[i], corners[i | bit] });
      }
    }
  }
  const auto strokes = MakePolylines(edges);
  // Seen from a corner: the three edges at the far corner are hidden, each by one layer.
  for (const bool parallel : { true, false })
  {
    const Parts parts =
      GetParts(MakeFilter(strokes, { MakeBox(sizes) }, MakeCamera({ 5.0, 6.0, 7.0 }, parallel)));
    check(
      parts.size() == edges.size(), "no edge of a box is cut", static_cast<double>(parts.size()));
    for (const Part& part : parts)
    {
      const bool isHidden = part.Line.front() == -sizes || part.Line.back() == -sizes;
      check(part.Layers == (isHidden ? 1 : 0), "edges of a box", part.Layers);
    }
  }
  // Which side of a face is in front does not matter.
  const auto turned = MakePolygons(corners,
    { { 0, 2, 3, 1 }, { 4, 6, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 }, { 0, 4, 6, 2 },
      { 1, 5, 7, 3 } });
  const auto camera = MakeCamera({ 5.0, 6.0, 7.0 });
  check(GetLayers(GetParts(MakeFilter(strokes, { turned }, camera))) ==
      GetLayers(GetParts(MakeFilter(strokes, { MakeBox(sizes) }, camera))),
    "faces may be turned over");
  // Seen along an axis nothing but the line of the outline is there: no edge must be cut.
  const Parts along = GetParts(MakeFilter(strokes, { MakeBox(sizes) }, MakeCamera(Front)));
  check(
    along.size() == edges.size(), "a box seen along an axis", static_cast<double>(along.size()));
  for (const Part& part : along)
  {
    check(part.Layers == 0, "outlines seen along an axis are visible", part.Layers);
  }
}

void TestThinWall()
{
  // Two sheets a thousandth apart, joined around: lines on the far sheet never shine through.
  const auto wall = MakeBox({ 1.0, 1.0, 0.0005 });
  const auto strokes = MakePolylines({ { { -0.9, 0.3, -0.0005 }, { 0.95, -0.2, -0.0005 } },
    { { -0.9, 0.3, 0.0005 }, { 0.95, -0.2, 0.0005 } },
    { { -1.0, 1.0, -0.0005 }, { -1.0, -1.0, -0.0005 } } });
  for (const Vector3d& eye :
    { Front, Vector3d(3.0, 2.0, 8.0), Vector3d(9.0, 1.0, 1.0), Vector3d(9.0, 1.0, 0.1) })
  {
    for (const bool parallel : { true, false })
    {
      const std::string layers =
        GetLayers(GetParts(MakeFilter(strokes, { wall }, MakeCamera(eye, parallel))));
      // Straight from the front the far border is just behind the near one, and seen edge-on.
      const bool isBehind = !parallel || eye.x() > 0.0;
      check(layers == (isBehind ? "1 0 1" : "1 0 0"), "a thin wall: " + layers, eye.x());
    }
  }
}

void TestHole()
{
  // A plate with a square hole; wires go through the hole, and through the plate beside it.
  const double h = 0.25;
  const auto plate =
    MakePolygons({ { -1.0, -1.0, 0.0 }, { 1.0, -1.0, 0.0 }, { 1.0, 1.0, 0.0 }, { -1.0, 1.0, 0.0 },
                   { -h, -h, 0.0 }, { h, -h, 0.0 }, { h, h, 0.0 }, { -h, h, 0.0 } },
      { { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } });
  const auto camera = MakeCamera({ 5.0, 0.0, 5.0 });
  const auto run = [&](double x)
  {
    const auto wire = MakePolylines({ { { x, 0.1, -1.5 }, { x, 0.1, 1.0 } } });
    return GetParts(MakeFilter(wire, { plate }, camera));
  };
  check(AreParts(run(0.0), "0 1 0", 2, { -1.0, -h }, 1e-5), "a wire through a hole");
  check(AreParts(run(-0.6), "1 0 1 0", 2, { -0.85, -0.35, 0.0 }, 1e-5), "a wire through a plate");
}

void TestPlane()
{
  // In the surface, on it and beyond its border; seen from above, below, and along it.
  const auto strokes = MakePolylines({ { { -2.0, 0.123, 0.0 }, { 2.0, 0.234, 0.0 } } });
  for (const Vector3d& eye :
    { Front, Vector3d(0.0, 1.0, -9.0), Vector3d(1.0, 9.0, 1e-3), Vector3d(2.0, 9.0, 0.0) })
  {
    for (const bool parallel : { true, false })
    {
      check(GetLayers(GetParts(
              MakeFilter(strokes, { MakeSheet(1.0, 1.0, 0.0) }, MakeCamera(eye, parallel)))) == "0",
        "a line in a surface is visible", eye.z());
    }
  }
}

void TestMatrices()
{
  // Two sheets from one, by their matrices; the strokes have one, too.
  const auto sheet = MakeSheet(1.0, 1.0, 0.0);
  vtkNew<vtkMatrix4x4> narrow;
  narrow->SetElement(0, 0, 0.5);
  narrow->SetElement(2, 3, 1.0);
  vtkNew<vtkMatrix4x4> strokeMatrix;
  strokeMatrix->SetElement(0, 0, -2.0);
  strokeMatrix->SetElement(2, 3, -1.0);
  const auto strokes = MakePolylines({ { { -1.0, 0.1, 0.0 }, { 1.0, 0.1, 0.0 } } });
  const auto filter = Filter::New();
  filter->SetInputData(strokes);
  filter->AddSurfaceData(sheet);
  filter->AddSurfaceData(sheet, narrow);
  filter->SetStrokeMatrix(strokeMatrix);
  filter->SetCamera(MakeCamera(Front));
  check(AreParts(GetParts(filter), "0 1 2 1 0", 0, { -0.5, -0.25, 0.25, 0.5 }, 1e-6),
    "surfaces and strokes with matrices");
  narrow->SetElement(0, 0, 0.25);
  check(AreParts(GetParts(filter), "0 1 2 1 0", 0, { -0.5, -0.125, 0.125, 0.5 }, 1e-6),
    "a matrix changes");
  filter->GetCamera()->SetFocalPoint(0.0, 0.0, 20.0);
  check(GetLayers(GetParts(filter)) == "0", "the camera looks from the other side");
  filter->RemoveAllSurfaces();
  filter->AddSurfaceData(sheet);
  filter->GetCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  check(GetLayers(GetParts(filter)) == "0 1 0" && !filter->GetSurfaceMatrix(0),
    "surfaces are removed with their matrices");
}

void TestRigidMotion()
{
  vtkNew<vtkTransform> motion;
  motion->Translate(30.0, -20.0, 50.0);
  motion->RotateWXYZ(77.0, 1.0, 2.0, -0.5);
  const auto move = [&](vtkPolyData* data)
  {
    vtkNew<vtkTransformPolyDataFilter> filter;
    filter->SetTransform(motion);
    filter->SetInputData(data);
    filter->Update();
    return Data(filter->GetOutput());
  };
  const auto strokes =
    MakePolylines({ { { -1.5, -1.0, -1.0 }, { 0.0, 0.2, 0.1 }, { 1.5, 0.7, -0.8 } } });
  const std::vector<Data> surfaces = { MakeOctasphere(0.5, 3), MakeSheet(0.3, 0.9, 1.0) };
  const auto camera = MakeCamera({ 1.0, 2.0, 9.0 }, false);
  const Parts parts = GetParts(MakeFilter(strokes, surfaces, camera));
  check(parts.size() > 4, "a scene to be moved", static_cast<double>(parts.size()));
  camera->ApplyTransform(motion);
  const Parts moved =
    GetParts(MakeFilter(move(strokes), { move(surfaces[0]), move(surfaces[1]) }, camera));
  check(GetLayers(parts) == GetLayers(moved), "layers stay when all is moved");
  for (std::size_t i = 0; i < std::min(parts.size(), moved.size()); ++i)
  {
    Vector3d end;
    motion->TransformPoint(parts[i].Line.back().data(), end.data());
    check((end - moved[i].Line.back()).norm() < 1e-4, "cuts move along",
      (end - moved[i].Line.back()).norm());
  }
}
}

int TestHiddenStrokes(int, char*[])
{
  TestSheets();
  TestSlanted();
  TestNarrow();
  TestShortEnds();
  TestSphere();
  TestBox();
  TestThinWall();
  TestHole();
  TestPlane();
  TestMatrices();
  TestRigidMotion();
  return check.GetResult();
}
