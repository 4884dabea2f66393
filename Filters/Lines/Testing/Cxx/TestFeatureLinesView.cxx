// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// The camera, the prop's matrix, and the measures that depend on the view.
#include "nprLineTesting.h"

#include "vtkNPRSuggestiveContours.h"

#include <vtkFieldData.h>
#include <vtkMatrix4x4.h>
#include <vtkStringArray.h>
#include <vtkTransform.h>

using namespace nprtest;

namespace
{
// The unit sphere under a matrix is an ellipsoid; its normals come from the inverse transpose.
void TestMatrix(bool parallel, double mirror, Checks& check)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(5.0, -2.0, 1.0);
  transform->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  transform->Scale(2.0, 0.5 * mirror, 1.2);
  const Vector eye(12.0, 3.0, 8.0);
  auto camera = MakeCamera(eye, parallel);
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition("contours");
  lines->SetCamera(camera);
  lines->SetMatrix(transform->GetMatrix());
  lines->SetInputData(MakeSphere(60, 1.0));
  lines->Update();
  const auto chains = GetChains(lines->GetOutput());
  check(chains.size() == 1 && chains[0].Closed, "an ellipsoid has one contour");
  for (const Chain& chain : chains)
  {
    for (const Vector& p : chain.Points)
    {
      check(std::abs(p.norm() - 1.0) < 5.0e-3, "lines are in the space of the model", p.norm());
      Vector world;
      Vector normal;
      transform->TransformPoint(p.data(), world.data());
      transform->TransformNormal(p.data(), normal.data());
      Vector toEye = eye - world;
      if (parallel)
      {
        toEye = -Vector(camera->GetDirectionOfProjection());
      }
      check(std::abs(normal.dot(toEye.normalized())) < 2.0e-3, "the line is a contour in the world",
        normal.dot(toEye.normalized()));
    }
  }
}

void TestUpdates(Checks& check)
{
  auto torus = Torus().Make(60, 30);
  auto camera = MakeCamera({ 3.0, 1.0, 3.0 });
  vtkNew<vtkMatrix4x4> matrix;
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition("contours");
  vtkNPRLineDefinition* suggestive = lines->AddDefinition("suggestive");
  lines->SetCamera(camera);
  lines->SetMatrix(matrix);
  lines->SetInputData(torus);
  lines->Update();
  auto last = GetSegments(GetChains(lines->GetOutput()));
  const auto first = last;
  const auto changed = [&](const char* what)
  {
    lines->Update();
    const auto now = GetSegments(GetChains(lines->GetOutput()));
    check(now != last, what);
    last = now;
  };
  camera->Azimuth(20.0);
  changed("lines follow the camera");
  matrix->SetElement(0, 0, 1.5);
  changed("lines follow the matrix");
  check(suggestive->SetParameter("threshold", 0.5), "a parameter is set by its name");
  check(suggestive->GetParameter("threshold") == 0.5, "a parameter is read by its name");
  check(!suggestive->SetParameter("threshold", -1.0), "a value out of range is refused");
  check(!suggestive->SetParameter("no such", 1.0), "an unknown parameter is refused");
  changed("lines follow their definition");
  lines->SetLengthScale(3.0);
  changed("lines follow the length scale");
  torus->GetPoints()->SetPoint(0, 2.0, 0.0, 0.0);
  torus->GetPoints()->Modified();
  torus->Modified();
  changed("lines follow the input");

  const vtkMTimeType time = lines->GetOutput()->GetMTime();
  lines->Update();
  check(lines->GetOutput()->GetMTime() == time, "nothing is done when nothing changed");

  auto names = vtkStringArray::SafeDownCast(
    lines->GetOutput()->GetFieldData()->GetAbstractArray(npr::names::LineTypeNames));
  check(names && names->GetNumberOfValues() == 2 && names->GetValue(0) == "contours" &&
      names->GetValue(1) == "suggestive",
    "LineTypeNames are those of the definitions");
}

void TestMinimumLength(bool parallel, Checks& check)
{
  // Seen from its centre line, the circle of the contour has one distance from the eye everywhere.
  const double distance = 4.0;
  auto camera = MakeCamera({ 0.0, 0.0, distance }, parallel);
  camera->SetParallelScale(3.0);
  camera->SetViewAngle(40.0);
  const double height = parallel ? 0.0 : 1.0 / distance;
  const double radius = std::sqrt(1.0 - height * height);
  const double view = parallel
    ? 2.0 * 3.0
    : 2.0 * std::hypot(radius, distance - height) * std::tan(20.0 * Pi / 180.0);
  const double expected = 2.0 * Pi * radius / view;
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition("contours");
  lines->SetCamera(camera);
  lines->SetInputData(MakeSphere(100, 1.0));
  lines->SetMinimumLength(0.99 * expected);
  lines->Update();
  check(lines->GetOutput()->GetNumberOfLines() == 1, "a line that is long enough is kept");
  lines->SetMinimumLength(1.01 * expected);
  lines->Update();
  check(lines->GetOutput()->GetNumberOfLines() == 0, "a line that is too short is left out");
}

void TestMinimumStrength(Checks& check)
{
  auto torus = Torus().Make(100, 50);
  vtkNew<vtkNPRSuggestiveContours> suggestive;
  suggestive->SetThreshold(0.0);
  suggestive->SetFade(20.0);
  vtkNew<vtkNPRFeatureLines> lines;
  lines->AddDefinition(suggestive);
  lines->SetCamera(MakeCamera({ 3.0, 1.0, 3.0 }));
  lines->SetInputData(torus);
  lines->Update();
  const auto all = GetChains(lines->GetOutput());
  double strongest = 0.0;
  for (const Chain& chain : all)
  {
    strongest =
      std::max(strongest, *std::max_element(chain.Strength.begin(), chain.Strength.end()));
  }
  check(strongest > 0.01 && strongest < 1.0, "the strongest chain is in between", strongest);
  lines->SetMinimumStrength(0.999 * strongest);
  lines->Update();
  const auto kept = GetChains(lines->GetOutput());
  check(!kept.empty(), "a strong chain is kept");
  for (const Chain& chain : kept)
  {
    check(std::count_if(all.begin(), all.end(),
            [&](const Chain& other) { return other.Points == chain.Points; }) == 1,
      "a chain is kept with its weak ends, or not at all");
  }
  lines->SetMinimumStrength(std::min(1.0, 1.001 * strongest));
  lines->Update();
  check(lines->GetOutput()->GetNumberOfLines() == 0, "weak chains are left out");
}
}

int TestFeatureLinesView(int, char*[])
{
  Checks check;
  for (bool parallel : { false, true })
  {
    TestMatrix(parallel, 1.0, check);
    TestMatrix(parallel, -1.0, check);
    TestMinimumLength(parallel, check);
  }
  TestUpdates(check);
  TestMinimumStrength(check);
  return check.GetResult();
}
