// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Isophotes of a light with the model, beside the viewer, and at the eye.
#include "nprTrueCurves.h"

#include "vtkNPRIsophotes.h"

#include <vtkMath.h>
#include <vtkTransform.h>

using namespace nprtest;

namespace
{
constexpr double ViewerDistance = 5.0; // of ExtractLines(), along z

vtkSmartPointer<vtkPolyData> MakeExactSphere()
{
  const ParametricSurface patch = SpherePatch(1.0);
  const ParametricSurface sphere = { patch.At, { 0.0, 2.0 * Pi, -1.565, 1.565 }, true, false };
  const AnalyticSurface surface = MakeSurface(sphere, 120, 80);
  AddExactArrays(surface);
  return surface.Mesh;
}

// The lines are the circles n.l = c on a sphere: one for each level.
void CheckCircles(const std::vector<Chain>& chains, const Vector3d& light, std::size_t levels,
  double minimum, Checks& check)
{
  check(chains.size() == levels, "one circle for each level", double(chains.size()));
  for (const Chain& chain : chains)
  {
    check(chain.Closed, "a circle is closed");
    const double level = chain.Points[0].dot(light);
    const double step = (level - minimum) / (1.0 - minimum) * (levels + 1.0);
    check(std::abs(step - std::round(step)) < 0.02, "at even steps", step);
    for (const Vector3d& p : chain.Points)
    {
      check(std::abs(p.dot(light) - level) < 2.0e-3, "all at one level", p.dot(light) - level);
    }
  }
}

void TestModelLight(Checks& check)
{
  vtkNew<vtkNPRIsophotes> isophotes;
  check(isophotes->IsViewDependent(), "the light is the eye");
  check(isophotes->SetParameter("direction", { 0.0, 2.0 * std::sqrt(3.0), 2.0 }), "a direction");
  check(!isophotes->IsViewDependent(), "the light stays with the model");
  // No line runs through the holes at the poles.
  isophotes->SetLevels(4.0);
  isophotes->SetMinimum(0.0);
  const auto sphere = MakeExactSphere();
  const Vector3d light(0.0, 0.5 * std::sqrt(3.0), 0.5);
  CheckCircles(ExtractLines(sphere, isophotes), light, 4, 0.0, check);
  isophotes->SetMinimum(-1.0);
  isophotes->SetLevels(9.0);
  CheckCircles(ExtractLines(sphere, isophotes), light, 9, -1.0, check);

  isophotes->SetLevels(1.0);
  isophotes->SetMinimum(0.8);
  isophotes->SetThreshold(0.0);
  isophotes->SetDistance(0.0);
  isophotes->SetSmoothing(0.0);
  isophotes->SetDirection(0.3, 0.0, 1.0);
  const Vector3d unit = Vector3d(0.3, 0.0, 1.0).normalized();
  CheckConvergence(
    isophotes, { Bump(1.2), [&](const Truth& t) { return t.Normal.dot(unit) - 0.9; } }, 1, check);
}

void TestViewerLight(Checks& check)
{
  // The viewer of ExtractLines() looks along -z, and up is (0.1, 0.9, 0.3).
  vtkNew<vtkNPRIsophotes> isophotes;
  isophotes->SetLevels(4.0);
  isophotes->SetDistance(0.0);
  isophotes->SetAzimuth(40.0);
  isophotes->SetElevation(20.0);
  const Vector3d right = Vector3d(0.1, 0.9, 0.3).cross(Vector3d::UnitZ()).normalized();
  const Vector3d up = Vector3d::UnitZ().cross(right);
  const double azimuth = vtkMath::RadiansFromDegrees(40.0);
  const double elevation = vtkMath::RadiansFromDegrees(20.0);
  const Vector3d light = std::sin(azimuth) * std::cos(elevation) * right +
    std::sin(elevation) * up + std::cos(azimuth) * std::cos(elevation) * Vector3d::UnitZ();
  const auto sphere = MakeExactSphere();
  CheckCircles(ExtractLines(sphere, isophotes), light, 4, 0.0, check);

  // A prop that is turned and scaled has its light where the viewer's is.
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
  transform->Scale(0.1, 0.1, 0.1);
  vtkNew<vtkNPRFeatureLines> lines;
  lines->SetMatrix(transform->GetMatrix());
  lines->SetCamera(MakeCamera({ 0.0, 0.0, ViewerDistance }));
  lines->AddDefinition(isophotes);
  lines->SetInputData(sphere);
  lines->Update();
  Vector3d turned;
  transform->GetLinearInverse()->TransformVector(light.data(), turned.data());
  CheckCircles(GetChains(lines->GetOutput()), turned.normalized(), 4, 0.0, check);
}

void TestEyeLight(Checks& check)
{
  vtkNew<vtkNPRIsophotes> isophotes;
  isophotes->SetLevels(1.0);
  isophotes->SetMinimum(0.8);
  isophotes->SetThreshold(0.0);
  isophotes->SetDistance(0.0);
  isophotes->SetSmoothing(0.0);
  const auto field = [](const Truth& t)
  { return t.Normal.dot((Vector3d(0.0, 0.0, ViewerDistance) - t.Point).normalized()) - 0.9; };
  CheckConvergence(isophotes, { Bump(1.2), field }, 1, check);
  isophotes->SetThreshold(0.2);
  const AnalyticSurface bump = MakeSurface(Bump(1.2), 120, 120);
  AddExactArrays(bump);
  check(ExtractLines(bump.Mesh, isophotes).size() == 1, "where the surface bends, as before");

  // A flat table has isophotes in perspective, but they show nothing of its shape.
  const auto plane = [](double x, double y) {
    return MakeHeightTruth(x, y, { 0.0, { 0.0, 0.0 }, { 0, 0, 0 }, { 0, 0, 0, 0 } });
  };
  const AnalyticSurface table = MakeSurface({ plane, { -6.0, 6.0, -6.0, 6.0 } }, 60, 60);
  AddExactArrays(table);
  check(ExtractLines(table.Mesh, isophotes).empty(), "none on flat parts");
  isophotes->SetThreshold(0.0);
  check(ExtractLines(table.Mesh, isophotes).size() == 1, "but by wish");
}

// On a sphere of the radius 1, which is its length scale, the distances are known.
void TestDistance(Checks& check)
{
  const auto sphere = MakeExactSphere();
  vtkNew<vtkNPRIsophotes> isophotes;
  isophotes->SetLevels(9.0);
  isophotes->SetThreshold(0.0);
  // From the eye the cosine falls by the tangent of its angle: less than 1 at 0.9 and 0.8.
  isophotes->SetDistance(0.1);
  check(ExtractLines(sphere, isophotes).size() == 2, "where lines crowd for the eye, none");
  isophotes->SetDistance(0.0);
  check(ExtractLines(sphere, isophotes).size() == 9, "by wish they crowd");
  // Along the surface it falls by the sine: less than 0.75 at 0.9, 0.8 and 0.7.
  isophotes->SetDirection(0.0, 1.0, 0.0);
  isophotes->SetDistance(0.1 / 0.75);
  check(ExtractLines(sphere, isophotes).size() == 3, "where lines crowd on the surface, none");
}

// On the grain of a scan, lines fray; on its form, they do not.
void TestSmoothing(Checks& check)
{
  const auto sphere = MakeExactSphere();
  vtkDataArray* const normals = sphere->GetPointData()->GetArray(npr::names::Normals);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    Vector3d n(normals->GetTuple(i));
    n += 0.04 * Vector3d(std::sin(37.0 * i), std::sin(59.0 * i), std::sin(83.0 * i));
    normals->SetTuple(i, n.normalized().eval().data());
  }
  vtkNew<vtkNPRIsophotes> isophotes;
  isophotes->SetLevels(4.0);
  isophotes->SetDistance(0.0);
  isophotes->SetDirection(0.0, 0.5 * std::sqrt(3.0), 0.5);
  const Vector3d light(0.0, 0.5 * std::sqrt(3.0), 0.5);
  const auto getFarthest = [&](const std::vector<Chain>& chains)
  {
    double farthest = 0.0;
    for (const Chain& chain : chains)
    {
      for (const Vector3d& p : chain.Points)
      {
        const double step = 5.0 * p.dot(light);
        farthest = std::max(farthest, std::abs(step - std::round(step)));
      }
    }
    return farthest;
  };
  isophotes->SetSmoothing(0.0);
  const auto raw = ExtractLines(sphere, isophotes);
  check(raw.size() > 8, "grain, without smoothing", double(raw.size()));
  isophotes->SetSmoothing(0.15);
  const auto smooth = ExtractLines(sphere, isophotes);
  check(smooth.size() == 4, "one circle for each level", double(smooth.size()));
  check(getFarthest(smooth) < 0.1, "in its place", getFarthest(smooth));

  // Two definitions with radii of their own; and a new radius counts at once.
  vtkNew<vtkNPRIsophotes> rough;
  rough->SetLevels(4.0);
  rough->SetDistance(0.0);
  rough->SetDirection(light.data());
  rough->SetSmoothing(0.0);
  vtkNew<vtkNPRFeatureLines> both;
  both->AddDefinition(rough);
  both->AddDefinition(isophotes);
  both->SetInputData(sphere);
  both->Update();
  check(both->GetOutput()->GetNumberOfLines() == static_cast<vtkIdType>(raw.size() + 4),
    "each its own", double(both->GetOutput()->GetNumberOfLines()));
  rough->SetSmoothing(0.15);
  both->Update();
  check(both->GetOutput()->GetNumberOfLines() == 8, "a new radius",
    double(both->GetOutput()->GetNumberOfLines()));

  // What is not a number stays at its point.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  normals->SetTuple3(4000, nan, nan, nan);
  sphere->Modified();
  normals->Modified();
  vtkIdType points = 0;
  for (const Chain& chain : ExtractLines(sphere, isophotes))
  {
    points += static_cast<vtkIdType>(chain.Points.size());
  }
  check(points > 500, "lines all the same", double(points));
}
}

int TestIsophotes(int, char*[])
{
  Checks check;
  TestModelLight(check);
  TestViewerLight(check);
  TestEyeLight(check);
  TestDistance(check);
  TestSmoothing(check);
  return check.GetResult();
}
