// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What surfaces hide and what they don't: planes at grazing angles, valleys, a sphere's contour.
#include "nprStrokeTesting.h"
#include "vtkNPROffscreen.h"

#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkPlane.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>

#include <cmath>
#include <cstdlib>

using nprtest::Check;
using nprtest::Line;
using nprtest::MakeLines;
using nprtest::Picture;

namespace
{
vtkSmartPointer<vtkActor> AddSurface(Picture& picture, vtkPolyData* surface)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(1, 1, 1); // so that all that is dark is ink
  picture.Renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkPolyData> MakePlane(const double origin[3], const double a[3], const double b[3])
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(origin[0], origin[1], origin[2]);
  source->SetPoint1(a[0], a[1], a[2]);
  source->SetPoint2(b[0], b[1], b[2]);
  source->SetResolution(7, 5);
  source->Update();
  return source->GetOutput();
}

vtkNPRStrokeMapper* GetMapper(vtkActor* actor)
{
  return vtkNPRStrokeMapper::SafeDownCast(actor->GetMapper());
}

/// The share of the ink drawn without a depth test that is drawn with one.
double GetVisibleShare(Picture& picture, vtkActor* strokes)
{
  GetMapper(strokes)->DepthTestOff();
  picture.Render();
  const double all = picture.GetInk();
  GetMapper(strokes)->DepthTestOn();
  picture.Render();
  Check(all > 100, "there is something to hide");
  return picture.GetInk() / all;
}

// A floor seen at grazing angles, with lines on it in all directions.
void TestFloor(int argc, char* argv[])
{
  const double origin[] = { -50, 0, -50 }, a[] = { 50, 0, -50 }, b[] = { -50, 0, 50 };
  std::vector<Line> star;
  for (int i = 0; i < 24; ++i)
  {
    const double angle = vtkMath::Pi() * i / 12 + 0.03;
    star.push_back({ { 0.3 * std::cos(angle), 0, 0.3 * std::sin(angle) },
      { 4 * std::cos(angle), 0, 4 * std::sin(angle) } });
  }
  for (bool parallel : { true, false })
  {
    for (double elevation : { 90.0, 45.0, 10.0, 3.0, 1.0 })
    {
      Picture picture(300, 200);
      AddSurface(picture, MakePlane(origin, a, b));
      vtkSmartPointer<vtkActor> strokes = picture.AddStrokes(MakeLines(star), 2);
      vtkCamera* camera = picture.Renderer->GetActiveCamera();
      camera->SetParallelProjection(parallel);
      camera->SetParallelScale(4);
      camera->SetFocalPoint(0, 0, 0);
      const double angle = vtkMath::RadiansFromDegrees(elevation);
      const double away = parallel ? 45 : 15;
      camera->SetPosition(0, away * std::sin(angle), away * std::cos(angle));
      camera->SetViewUp(0, std::cos(angle), -std::sin(angle));
      picture.Renderer->ResetCameraClippingRange();
      const std::string where = std::to_string(elevation) + " degrees, parallel " +
        std::to_string(parallel) + ": " + "share ";
      double share = GetVisibleShare(picture, strokes);
      Check(share > 0.999, "on the floor at " + where + std::to_string(share));
      if (elevation == 3.0)
      {
        picture.Write(argc, argv, parallel ? "StrokeFloorParallel" : "StrokeFloorPerspective");
      }

      // The actor's matrix moves the strokes above and below.
      strokes->SetPosition(0, 0.5, 0);
      share = GetVisibleShare(picture, strokes);
      Check(share > 0.999, "above the floor at " + where + std::to_string(share));
      strokes->SetPosition(0, -0.5, 0);
      share = GetVisibleShare(picture, strokes);
      Check(share < 0.001, "below the floor at " + where + std::to_string(share));
      GetMapper(strokes)->SetHiddenOpacity(0.25);
      share = GetVisibleShare(picture, strokes);
      Check(std::abs(share - 0.25) < 0.01, "hidden opacity at " + where + std::to_string(share));
    }
  }
}

// A line in a valley: its own walls are nearer on both sides.
void TestValley(int argc, char* argv[])
{
  Picture picture(200, 200);
  const double origin[] = { 100, -50, 0 }, along[] = { 100, 250, 0 };
  const double left[] = { 0, -50, 170 }, right[] = { 200, -50, 170 };
  AddSurface(picture, MakePlane(origin, left, along));
  AddSurface(picture, MakePlane(origin, along, right));
  vtkSmartPointer<vtkActor> strokes =
    picture.AddStrokes(MakeLines({ { { 100, 0, 0 }, { 100, 200, 0 } } }), 3);
  for (double roll : { 0.0, 17.0, 45.0 })
  {
    picture.Renderer->GetActiveCamera()->SetRoll(roll);
    const double share = GetVisibleShare(picture, strokes);
    Check(share > 0.999, "in a valley: share " + std::to_string(share));
  }
  picture.Write(argc, argv, "StrokeValley");
}

// A line that passes behind a square is cut at its edges.
void TestOccluder(int argc, char* argv[])
{
  Picture picture(200, 100);
  const double origin[] = { 60.5, 10, 0 }, a[] = { 140.5, 10, 0 }, b[] = { 60.5, 90, 0 };
  AddSurface(picture, MakePlane(origin, a, b));
  vtkSmartPointer<vtkActor> strokes =
    picture.AddStrokes(MakeLines({ { { 10, 50.2, -30 }, { 190, 50.2, -30 } } }), 4);
  picture.Render();
  Check(std::abs(picture.GetInk(20, 0, 55, 100) / 35 - 4) < 0.02, "beside the square");
  Check(picture.GetInk(62, 0, 139, 100) == 0, "behind the square");
  picture.Write(argc, argv, "StrokeOccluder");
  strokes->SetPosition(0, 0, 60);
  picture.Render();
  Check(std::abs(picture.GetInk(20, 0, 180, 100) / 160 - 4) < 0.02, "in front of the square");

  // Strokes don't write depth: one drawn later and farther away is still there.
  vtkSmartPointer<vtkActor> far =
    picture.AddStrokes(MakeLines({ { { 100, 0, -20 }, { 100, 100, -20 } } }), 4);
  far->GetProperty()->SetColor(1, 0, 0);
  picture.Render();
  const vtkIdType pixel = 4 * (5 * picture.Width + 100);
  Check(picture.Pixels->GetValue(pixel) > 250 && picture.Pixels->GetValue(pixel + 1) < 5,
    "the red line stands beside the square");
}

/// Where interpolated normals are at right angles to the view: the contour as filters extract it.
vtkSmartPointer<vtkPolyData> MakeContour(vtkPolyData* sphere, const double eye[3])
{
  vtkNew<vtkDoubleArray> facing;
  facing->SetName("facing");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    double p[3], v[3];
    sphere->GetPoint(i, p);
    vtkMath::Subtract(eye, p, v);
    vtkMath::Normalize(v);
    facing->InsertNextValue(vtkMath::Dot(p, v)); // the sphere stands at the origin
  }
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(sphere);
  copy->GetPointData()->SetScalars(facing);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(copy);
  contour->SetValue(0, 0.0);
  vtkNew<vtkStripper> chains;
  chains->SetInputConnection(contour->GetOutputPort());
  chains->SetMaximumLength(100000);
  chains->Update();
  return chains->GetOutput();
}

void TestSphereContour(int argc, char* argv[])
{
  for (int resolution : { 32, 64, 200 })
  {
    vtkNew<vtkSphereSource> source;
    source->SetRadius(1);
    source->SetThetaResolution(resolution);
    source->SetPhiResolution(resolution);
    source->Update();
    Picture picture(300, 300);
    AddSurface(picture, source->GetOutput());
    vtkSmartPointer<vtkActor> strokes = picture.AddStrokes(MakeLines({}), 3);
    vtkCamera* camera = picture.Renderer->GetActiveCamera();
    camera->ParallelProjectionOff();
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewAngle(30);
    for (int view = 0; view < 12; ++view)
    {
      const double angle = 0.13 * view;
      const double eye[] = { 4 * std::sin(angle), 1.2, 4 * std::cos(angle) };
      camera->SetPosition(eye);
      camera->SetViewUp(0, 1, 0);
      GetMapper(strokes)->SetInputData(MakeContour(source->GetOutput(), eye));
      picture.Renderer->ResetCameraClippingRange();
      picture.Render();
      // Every ray from the centre meets ink.
      int gaps = 0;
      for (int i = 0; i < 720; ++i)
      {
        const double direction = vtkMath::Pi() * i / 360;
        double most = 0;
        for (double r = 125; r < 147; r += 0.5)
        {
          most = std::max(most,
            picture.GetInk(static_cast<int>(150 + r * std::cos(direction)),
              static_cast<int>(150 + r * std::sin(direction))));
        }
        gaps += most < 0.9;
      }
      Check(gaps == 0,
        "a contour of a sphere of " + std::to_string(resolution) + ", view " +
          std::to_string(view) + ", has " + std::to_string(gaps) + " gaps of 720");
      if (view == 5)
      {
        picture.Write(argc, argv, "StrokeSphere" + std::to_string(resolution));
      }
    }
  }
}

// A line that begins behind the eye and runs away from it, and one far from the origin.
void TestProjection()
{
  Picture picture(200, 200);
  vtkCamera* camera = picture.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(0, 0, 0);
  camera->SetFocalPoint(0, 0, -1);
  camera->SetClippingRange(0.1, 1000);
  vtkSmartPointer<vtkActor> strokes =
    picture.AddStrokes(MakeLines({ { { -0.5, -0.5, 50 }, { -0.5, -0.5, -900 } } }), 2);
  picture.Render();
  // It projects onto the diagonal from the corner to the centre.
  Check(std::abs(picture.GetInk(0, 0, 100, 100) - 2 * 100 * std::sqrt(2.0)) < 6,
    "a line through the near plane");
  Check(picture.GetInk() - picture.GetInk(0, 0, 102, 102) < 1e-9, "and nothing else");

  const double far = 1e7;
  Picture away(200, 200);
  camera = away.Renderer->GetActiveCamera();
  camera->SetFocalPoint(far + 100, far + 100, far);
  camera->SetPosition(far + 100, far + 100, far + 1000);
  strokes = away.AddStrokes(
    MakeLines({ { { far + 20, far + 50.25, far }, { far + 180, far + 50.25, far } } }), 2);
  away.Render();
  Check(std::abs(away.GetInk(100, 48) - 0.0) < 0.02 &&
      std::abs(away.GetInk(100, 49) - 0.75) < 0.02 && std::abs(away.GetInk(100, 50) - 1.0) < 0.02 &&
      std::abs(away.GetInk(100, 51) - 0.25) < 0.02,
    "a line far from the origin, at its place to a fraction of a pixel");
}

// Planes of the world cut the strokes of an actor that is moved and turned, far from the origin
// too.
void TestClippingPlanes()
{
  for (double far : { 0.0, 1e6 })
  {
    Picture picture(200, 100);
    vtkCamera* camera = picture.Renderer->GetActiveCamera();
    camera->SetFocalPoint(far + 100, 50, 0);
    camera->SetPosition(far + 100, 50, 1000);
    // Along x in the world, from 20 to 180.
    vtkSmartPointer<vtkActor> strokes =
      picture.AddStrokes(MakeLines({ { { 50, -20, 0 }, { 50, -180, 0 } } }), 4);
    strokes->SetOrientation(0, 0, 90);
    strokes->SetPosition(far, 0, 0);
    const auto clip = [&](double x, double direction)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(far + x, 0, 0);
      plane->SetNormal(direction, 0, 0);
      strokes->GetMapper()->AddClippingPlane(plane);
    };
    picture.Render();
    Check(std::abs(picture.GetInk(10, 0, 190, 100) - 4 * (160 + vtkMath::Pi())) < 3, "unclipped");
    clip(60, 1);
    picture.Render();
    Check(picture.GetInk(0, 0, 57, 100) == 0 && picture.GetInk(58, 0, 60, 100) > 4 &&
        std::abs(picture.GetInk(60, 0, 100, 100) - 160) < 1,
      "clipped from the left: " + std::to_string(picture.GetInk()));
    clip(140, -1);
    picture.Render();
    Check(std::abs(picture.GetInk() - 4 * (80 + vtkMath::Pi())) < 2,
      "clipped from both sides: " + std::to_string(picture.GetInk()));
    clip(150, 1);
    picture.Render();
    Check(picture.GetInk() == 0, "clipped away");
    strokes->GetMapper()->RemoveAllClippingPlanes();
    picture.Render();
    Check(picture.GetInk() > 600, "without planes again");
  }
}
}

int TestStrokeVisibility(int argc, char* argv[])
{
  vtkNPROffscreen::Setup();
  TestFloor(argc, argv);
  TestValley(argc, argv);
  TestOccluder(argc, argv);
  TestSphereContour(argc, argv);
  TestProjection();
  TestClippingPlanes();
  return nprtest::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
