// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// How far a sphere is dark beside its contour, against a walk over it from the contour to the eye.
#include "nprArrayNames.h"
#include "nprChecks.h"
#include "nprIsophoteDistance.h"
#include "nprLengthScale.h"
#include "vtkNPRStrokeAttributes.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTestErrorObserver.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <string>

using nprtest::Checks;

namespace
{
constexpr double Pi = 3.14159265358979323846;
const Eigen::Vector3d Light = Eigen::Vector3d(-0.5, 0.7, 0.5).normalized();

// Over a circle of a radius, from where n is the normal on towards the eye, in small steps.
double Walk(double radius, double normalCosine, double eyeCosine, double level)
{
  constexpr int steps = 200000;
  for (int i = 0; i < steps; ++i)
  {
    const double turn = 0.5 * Pi * i / steps;
    if (normalCosine * std::cos(turn) + eyeCosine * std::sin(turn) >= level)
    {
      return radius * (1.0 - std::cos(turn));
    }
  }
  return radius;
}

void TestCircles(Checks& check)
{
  for (const double level : { -0.9, -0.5, 0.0, 0.3, 0.8 })
  {
    for (int i = 0; i < 24; ++i)
    {
      for (const double eyeCosine : { -0.7, -0.2, 0.0, 0.4, 0.7 })
      {
        const double normalCosine = 0.7 * std::sin(2.0 * Pi * i / 24.0);
        const double truth = Walk(2.5, normalCosine, eyeCosine, level);
        const double found =
          npr::GetIsophoteDistance(1.0 / 2.5, normalCosine, eyeCosine, level, 100.0);
        check(std::abs(found - truth) < 1e-4, "the distance of a walk", found - truth);
      }
    }
  }
  check(npr::GetIsophoteDistance(0.001, -0.9, 0.1, 0.0, 3.0) == 3.0, "flat ones end somewhere");
  check(npr::GetIsophoteDistance(-1.0, -0.9, 0.1, 0.0, 3.0) == 3.0, "and hollow ones");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check(npr::GetIsophoteDistance(1.0, nan, 0.1, 0.0, 3.0) == 0.0, "no normal, no shade");
}

// The contour of a sphere of radius 2 around the origin, seen from +z.
vtkSmartPointer<vtkPolyData> MakeContour(double eye)
{
  constexpr int size = 720;
  constexpr double scale = 1.6;
  const double height = eye > 0.0 ? 4.0 / eye : 0.0;
  auto contour = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkFloatArray> normals;
  normals->SetName(npr::names::Normals);
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> curvatures;
  curvatures->SetName(npr::names::RadialCurvature);
  lines->InsertNextCell(size + 1);
  for (int i = 0; i < size; ++i)
  {
    const double around = std::sqrt(4.0 - height * height);
    const double p[3] = { around * std::cos(2.0 * Pi * i / size),
      around * std::sin(2.0 * Pi * i / size), height };
    lines->InsertCellPoint(points->InsertNextPoint(p));
    normals->InsertNextTuple3(0.5 * p[0], 0.5 * p[1], 0.5 * p[2]);
    curvatures->InsertNextValue(static_cast<float>(0.5 * scale));
  }
  lines->InsertCellPoint(0);
  contour->SetPoints(points);
  contour->SetLines(lines);
  contour->GetPointData()->AddArray(normals);
  contour->GetPointData()->AddArray(curvatures);
  npr::SetLengthScale(contour, scale);
  return contour;
}

// The part of the page, inwards from the contour, that is darker than the level.
void TestSphere(bool parallel, double modelScale, Checks& check)
{
  constexpr double eye = 10.0;
  constexpr double level = -0.3;
  const auto contour = MakeContour(parallel ? 0.0 : eye / modelScale);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, eye);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 1, 0);
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(5.0);
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 3; ++i)
  {
    matrix->SetElement(i, i, modelScale);
  }
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->SetInputData(contour);
  filter->SetLengthUnitToView();
  filter->SetCamera(camera);
  filter->SetMatrix(matrix);
  filter->SetReach(1e-4);
  filter->SetLightDirection(Light.data());
  filter->SetIsophoteLevel(level);
  filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, npr::names::IsophoteDistance);
  filter->SetTermRange(0, 0.0, 0.1);
  filter->SetTermFactors(0, 0.5, 2.5);
  filter->Update();
  vtkPolyData* const output = filter->GetOutput();
  vtkDataArray* const distances = output->GetPointData()->GetArray(npr::names::IsophoteDistance);
  vtkDataArray* const widths = output->GetPointData()->GetArray(npr::names::Width);
  check(distances && widths, "the arrays");
  if (!distances || !widths)
  {
    return;
  }
  double darkest = 0.0;
  int lit = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); i += 20)
  {
    const Eigen::Vector3d p = modelScale * Eigen::Vector3d(output->GetPoint(i));
    const Eigen::Vector3d n = p.normalized();
    const Eigen::Vector3d toEye = parallel
      ? Eigen::Vector3d::UnitZ()
      : Eigen::Vector3d((Eigen::Vector3d(0, 0, eye) - p).normalized());
    const double inwards = Walk(2.0 * modelScale, n.dot(Light), toEye.dot(Light), level);
    const double viewHeight = parallel ? 10.0 : 2.0 * std::tan(15.0 * Pi / 180.0) * (eye - p.z());
    const double truth = inwards * n.head<2>().norm() / viewHeight;
    const double found = distances->GetComponent(i, 0);
    // In perspective, what lies farther in is at another depth.
    check(std::abs(found - truth) < (parallel ? 1e-3 : 0.05) * std::max(truth, 1e-2),
      "the shade on the page", found - truth);
    check(std::abs(widths->GetComponent(i, 0) - 0.5 - 20.0 * std::min(found, 0.1)) < 1e-4,
      "the width", widths->GetComponent(i, 0));
    darkest = std::max(darkest, found);
    lit += found == 0.0;
  }
  check(darkest > 0.01 && lit > 8, "dark on one side, lit on the other", darkest);
}

void TestProblems(Checks& check)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executiveObserver;
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executiveObserver);
  const auto expectError = [&](const std::string& part)
  {
    filter->Update();
    check(observer->GetErrorMessage().find(part) != std::string::npos, part);
    observer->Clear();
  };
  const auto contour = MakeContour(0.0);
  filter->SetInputData(contour);
  filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, npr::names::IsophoteDistance);
  expectError("SetLengthUnitToView()");
  filter->SetLengthUnitToView();
  vtkNew<vtkCamera> camera;
  filter->SetCamera(camera);
  contour->GetPointData()->RemoveArray(npr::names::RadialCurvature);
  contour->Modified();
  expectError("'kr' (vtkNPRFeatureLines::AddQuantity())");
}
}

//------------------------------------------------------------------------------
int TestIsophoteDistance(int, char*[])
{
  Checks check;
  TestCircles(check);
  TestSphere(true, 1.0, check);
  TestSphere(false, 1.0, check);
  TestSphere(true, 0.5, check);
  TestSphere(false, 0.5, check);
  TestProblems(check);
  return check.GetResult();
}
