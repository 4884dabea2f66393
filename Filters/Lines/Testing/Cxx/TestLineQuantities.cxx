// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What lines carry of their surface, on a torus whose quantities are known everywhere.
#include "nprLineTesting.h"

#include "nprLengthScale.h"

#include <cstring>

using namespace nprtest;

namespace
{
const Torus Ring;

/// With a scalar and a vector of our own: z, and (x, y, z).
vtkSmartPointer<vtkPolyData> MakeRing(int nu, int nv)
{
  auto ring = Ring.Make(nu, nv);
  auto height = AddArray(ring, "Height", 1);
  auto place = AddArray(ring, "Place", 3);
  for (vtkIdType i = 0; i < ring->GetNumberOfPoints(); ++i)
  {
    const Vector p(ring->GetPoint(i));
    height->SetValue(i, static_cast<float>(p.z()));
    place->SetTuple(i, p.data());
  }
  return ring;
}

vtkSmartPointer<vtkNPRFeatureLines> MakeFilter(
  vtkPolyData* surface, const std::vector<const char*>& lines, vtkCamera* camera)
{
  auto filter = vtkSmartPointer<vtkNPRFeatureLines>::New();
  for (const char* name : lines)
  {
    filter->AddDefinition(name);
  }
  filter->SetCamera(camera);
  filter->SetInputData(surface);
  return filter;
}

double GetLargest(vtkPolyData* lines, const char* name,
  const std::function<double(const Vector& point, const double* value)>& error)
{
  vtkDataArray* const array = lines->GetPointData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() != lines->GetNumberOfPoints())
  {
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    const double here = error(Vector(lines->GetPoint(i)), array->GetTuple(i));
    largest = std::max(largest, std::isfinite(here) ? std::abs(here) : 1e300);
  }
  return largest;
}

// Points of the lines are on edges, at ends in triangles, and at vertices.
void TestLinearArrays(Checks& check)
{
  auto filter = MakeFilter(MakeRing(60, 30),
    { "contours", "suggestive", "ridges", "contour-edges", "apparent-ridges" },
    MakeCamera({ 2.0, 3.0, 2.5 }));
  for (const char* name : { "Height", "Place", "p" })
  {
    filter->AddQuantity(name);
  }
  filter->Update();
  vtkPolyData* const lines = filter->GetOutput();
  check(lines->GetNumberOfPoints() > 400, "lines to look at", double(lines->GetNumberOfPoints()));
  const auto place = [](const Vector& p, const double* value)
  { return (Vector(value) - p).norm(); };
  check(GetLargest(lines, "Height",
          [](const Vector& p, const double* value) { return *value - p.z(); }) < 1e-6,
    "a scalar that is linear in space is so on lines");
  check(GetLargest(lines, "Place", place) < 1e-6, "and a vector");
  check(GetLargest(lines, "p", place) < 1e-6, "and the place, as expressions have it");
}

void TestQuantities(Checks& check)
{
  const auto surface = MakeRing(160, 80);
  const Vector eye(2.0, 3.0, 2.5);
  auto filter = MakeFilter(surface, { "contours" }, MakeCamera(eye));
  for (const char* name : { "K", "kr", "ndotv", "e1", "sintheta" })
  {
    filter->AddQuantity(name);
  }
  check(filter->GetNumberOfQuantities() == 5 && !std::strcmp(filter->GetQuantity(1), "kr") &&
      !filter->GetQuantity(5) && !filter->GetQuantity(-1),
    "quantities are listed");
  filter->Update();
  vtkPolyData* const lines = filter->GetOutput();
  const double L = npr::GetLengthScale(surface);
  check(std::abs(npr::GetLengthScale(lines) - L) < 1e-9 * L, "lines know the length scale");
  const auto getV = [](const Vector& p)
  { return std::atan2(p.z(), std::hypot(p.x(), p.y()) - Ring.R); };
  check(GetLargest(lines, "K",
          [&](const Vector& p, const double* value)
          { return *value - L * L * Ring.CurvatureU(getV(p)) / Ring.r; }) < 0.02 * L * L,
    "Gaussian curvature");
  check(GetLargest(lines, "kr",
          [&](const Vector& p, const double* value)
          {
            const double v = getV(p);
            const double u = std::atan2(p.y(), p.x());
            const Vector w = (eye - p).normalized();
            const double alongV = w.dot(Ring.AlongV(u, v));
            const double alongU = w.dot(Ring.AlongU(u));
            const double truth = (alongV * alongV / Ring.r + alongU * alongU * Ring.CurvatureU(v)) /
              (alongV * alongV + alongU * alongU);
            return *value - L * truth;
          }) < 0.02 * L,
    "radial curvature");
  check(
    GetLargest(lines, "ndotv", [](const Vector&, const double* value) { return *value; }) < 2e-3,
    "contours are where n.v is 0");
  check(GetLargest(lines, "sintheta",
          [](const Vector&, const double* value) { return *value - 1.0; }) < 2e-3,
    "and the sine 1");

  filter->RemoveAllQuantities();
  filter->Update();
  check(!filter->GetOutput()->GetPointData()->HasArray("K"), "nothing is carried any more");
}

// A direction whose sign changes from point to point is an axis all the same.
void TestAxes(Checks& check)
{
  const auto surface = MakeRing(160, 80);
  auto* const axes = surface->GetPointData()->GetArray(npr::names::PrincipalDirection1);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); i += 2)
  {
    const Vector axis = -Vector(axes->GetTuple(i));
    axes->SetTuple(i, axis.data());
  }
  auto filter = MakeFilter(surface, { "contours" }, MakeCamera({ 2.0, 3.0, 2.5 }));
  filter->AddQuantity("e1");
  filter->AddQuantity(npr::names::PrincipalDirection1);
  filter->Update();
  for (const char* name : { "e1", npr::names::PrincipalDirection1 })
  {
    check(GetLargest(filter->GetOutput(), name,
            [](const Vector& p, const double* value)
            {
              const double v = std::atan2(p.z(), std::hypot(p.x(), p.y()) - Ring.R);
              const Vector truth = Ring.AlongV(std::atan2(p.y(), p.x()), v);
              return 1.0 - std::abs(truth.dot(Vector(value)));
            }) < 2e-3,
      name);
  }
}

// Static lines stay where they are in the output; what they carry of the view does not.
void TestNewViews(Checks& check)
{
  const auto surface = MakeRing(60, 30);
  const auto run = [&](bool again)
  {
    auto filter = MakeFilter(surface, { "contour-edges", "ridges" }, MakeCamera({ 2.0, 3.0, 2.5 }));
    filter->AddQuantity("ndotv");
    filter->Update();
    if (again)
    {
      filter->SetCamera(MakeCamera({ -1.0, 3.0, 1.5 }));
      filter->Update();
      filter->SetCamera(MakeCamera({ 2.0, 3.0, 2.5 }));
      filter->Update();
    }
    return vtkSmartPointer<vtkPolyData>(filter->GetOutput());
  };
  const auto once = run(false);
  const auto later = run(true);
  vtkDataArray* const a = once->GetPointData()->GetArray("ndotv");
  vtkDataArray* const b = later->GetPointData()->GetArray("ndotv");
  bool same = a->GetNumberOfTuples() == b->GetNumberOfTuples() && a->GetNumberOfTuples() > 0;
  for (vtkIdType i = 0; same && i < a->GetNumberOfTuples(); ++i)
  {
    same = a->GetComponent(i, 0) == b->GetComponent(i, 0);
  }
  check(same, "the values of this view");
}

void TestProblems(Checks& check)
{
  const auto surface = MakeRing(20, 10);
  const auto has = [](const std::string& text, const char* part)
  { return text.find(part) != std::string::npos; };

  auto unknown = MakeFilter(surface, { "contours" }, MakeCamera({ 2.0, 3.0, 2.5 }));
  unknown->AddQuantity("Temperature");
  const std::string error = GetErrors(unknown);
  check(has(error, "\"Temperature\"") && has(error, "Height"), "what there is: " + error);

  auto blind = MakeFilter(surface, { "boundaries" }, nullptr);
  blind->AddQuantity("kr");
  check(has(GetErrors(blind), "SetCamera"), "kr needs a camera");
  blind->RemoveAllQuantities();
  blind->AddQuantity("K");
  check(GetErrors(blind).empty(), "K does not");

  vtkNew<vtkPolyData> bare;
  bare->SetPoints(surface->GetPoints());
  bare->SetPolys(surface->GetPolys());
  auto lacking = MakeFilter(bare, { "contour-edges" }, MakeCamera({ 2.0, 3.0, 2.5 }));
  lacking->AddQuantity("K");
  check(has(GetErrors(lacking), "vtkNPRCurvatureTensor"), "who makes what is missing");
  lacking->ComputeMissingArraysOn();
  check(GetErrors(lacking).empty(), "unless it is to be made");
  check(lacking->GetOutput()->GetPointData()->HasArray("K"), "and it is");
}

void TestNames(Checks& check)
{
  vtkNew<vtkNPRFeatureLines> filter;
  vtkObject::GlobalWarningDisplayOff();
  filter->AddQuantity("Strength");
  filter->AddQuantity("");
  filter->AddQuantity(nullptr);
  vtkObject::GlobalWarningDisplayOn();
  check(filter->GetNumberOfQuantities() == 0, "names that can not be");
}
}

//------------------------------------------------------------------------------
int TestLineQuantities(int, char*[])
{
  Checks check;
  TestLinearArrays(check);
  TestQuantities(check);
  TestAxes(check);
  TestNewViews(check);
  TestProblems(check);
  TestNames(check);
  return check.GetResult();
}
