// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Widths and opacities of strokes whose answers are known, overshooting ends, and waves that are
// the same everywhere.
#include "nprArrayNames.h"
#include "nprLatticeNoise.h"
#include "nprLengthScale.h"
#include "nprSplines.h"
#include "vtkNPRStrokeAttributes.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace
{
using Points = std::vector<npr::Vector3>;

int failures = 0;

void Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++failures;
  }
}

void Expect(double value, double expected, double tolerance, const std::string& what)
{
  Check(std::abs(value - expected) <= tolerance,
    what + ": " + std::to_string(value) + " instead of " + std::to_string(expected));
}

vtkSmartPointer<vtkPolyData> MakeLines(const std::vector<Points>& lines)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Points& line : lines)
  {
    vtkNew<vtkIdList> ids;
    for (const npr::Vector3& point : line)
    {
      ids->InsertNextId(points->InsertNextPoint(point.data()));
    }
    cells->InsertNextCell(ids);
  }
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

void AddPointArray(vtkPolyData* data, const char* name, const std::vector<float>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  for (float value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetPointData()->AddArray(array);
}

void AddCellArray(vtkPolyData* data, const char* name, const std::vector<int>& values)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  for (int value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetCellData()->AddArray(array);
}

vtkPolyData* Run(vtkNPRStrokeAttributes* filter, vtkPolyData* data)
{
  filter->SetInputData(data);
  filter->Update();
  return filter->GetOutput();
}

double Get(vtkPolyData* data, const char* name, vtkIdType point)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  Check(array && array->GetNumberOfTuples() == data->GetNumberOfPoints(), name);
  return array ? array->GetComponent(point, 0) : std::nan("");
}

npr::Vector3 GetPoint(vtkPolyData* data, vtkIdType point)
{
  npr::Vector3 result;
  data->GetPoint(point, result.data());
  return result;
}

double Distance(const npr::Vector3& a, const npr::Vector3& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

Points Circle(int n, double radius, double height = 0.0)
{
  Points points;
  for (int i = 0; i <= n; ++i)
  {
    const double angle = 2 * vtkMath::Pi() * (i % n) / n;
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle), height });
  }
  return points;
}

Points Straight(double length, int segments)
{
  Points points;
  for (int i = 0; i <= segments; ++i)
  {
    points.push_back({ 0, length * i / segments, 0 });
  }
  return points;
}

void TestNothingAsked()
{
  vtkSmartPointer<vtkPolyData> data = MakeLines({ Straight(3, 7), Circle(12, 1) });
  AddPointArray(data, "Heat", std::vector<float>(data->GetNumberOfPoints(), 4.5f));
  AddCellArray(data, npr::names::LineType, { 3, 8 });
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->SetConstantWidth(2.5);
  filter->SetConstantOpacity(0.5);
  vtkPolyData* output = Run(filter, data);
  Check(output->GetNumberOfPoints() == data->GetNumberOfPoints(), "no points are added");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Check(GetPoint(output, i) == GetPoint(data, i), "nothing moves");
    Expect(Get(output, npr::names::Width, i), 2.5, 0, "the constant width");
    Expect(Get(output, npr::names::Opacity, i), 0.5, 0, "the constant opacity");
    Expect(Get(output, "Heat", i), 4.5, 0, "other arrays");
  }
  Check(output->GetCellData()->GetArray(npr::names::LineType)->GetComponent(1, 0) == 8, "cells");
  // One filter after another.
  vtkNew<vtkNPRStrokeAttributes> second;
  second->SetConstantWidth(2);
  Expect(Get(Run(second, output), npr::names::Width, 3), 5, 1e-6, "a product of filters");
}

// x (2 - x) from both ends, wherever the input's points are, in each unit.
void TestTaper()
{
  vtkNew<vtkCamera> camera;
  camera->ParallelProjectionOn();
  camera->SetParallelScale(20); // 40 high
  camera->SetPosition(0, 0, 100);
  camera->SetFocalPoint(0, 0, 0);
  struct Unit
  {
    int Value;
    double Length;
  };
  for (const Unit& unit :
    { Unit{ vtkNPRStrokeAttributes::STROKE, 2.0 / 10 }, Unit{ vtkNPRStrokeAttributes::MODEL, 2.0 },
      Unit{ vtkNPRStrokeAttributes::VIEW, 2.0 / 40 } })
  {
    for (int segments : { 1, 3, 200 })
    {
      vtkNew<vtkNPRStrokeAttributes> filter;
      filter->SetLengthUnit(unit.Value);
      filter->SetCamera(camera);
      filter->SetTaperLength(unit.Length);
      filter->SetTaperedWidth(0.25);
      filter->SetTaperedOpacity(0.5);
      vtkPolyData* output = Run(filter, MakeLines({ Straight(10, segments) }));
      const std::string what = std::to_string(unit.Value) + "/" + std::to_string(segments);
      double widestStep = 0;
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        const double s = GetPoint(output, i)[1];
        const double x = std::min(std::min(s, 10 - s) / 2, 1.0);
        const double rise = x * (2 - x);
        Expect(Get(output, npr::names::Width, i), 0.25 + 0.75 * rise, 1e-5, "taper " + what);
        Expect(Get(output, npr::names::Opacity, i), 0.5 + 0.5 * rise, 1e-5, "its opacity " + what);
        Expect(Get(output, npr::names::ArcLength, i), s, 1e-5, "arc length " + what);
        widestStep =
          i > 0 && s <= 2 ? std::max(widestStep, s - GetPoint(output, i - 1)[1]) : widestStep;
      }
      Check(widestStep <= 0.2501, "points enough for a taper " + what);
    }
  }
  // A short stroke tapers over half of its length.
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->SetLengthUnitToModel();
  filter->SetTaperLength(50);
  vtkPolyData* output = Run(filter, MakeLines({ Straight(1, 2) }));
  Expect(Get(output, npr::names::Width, 0), 0, 0, "a pointed end");
  Expect(Get(output, npr::names::Width, output->GetNumberOfPoints() / 2), 1, 1e-6, "its middle");
}

void TestClosed()
{
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->SetTaperLength(0.3);
  filter->SetOvershootLength(0.1);
  vtkPolyData* output = Run(filter, MakeLines({ Circle(40, 2) }));
  Check(output->GetNumberOfPoints() == 41, "a closed loop keeps its points");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Expect(Get(output, npr::names::Width, i), 1, 0, "a closed loop does not taper");
  }

  // Waves have no seam: steps of the displacement there are as small as everywhere.
  filter->SetWobbleAmplitude(0.01);
  filter->SetWobbleWavelength(0.137);
  const int n = 2000;
  output = Run(filter, MakeLines({ Circle(n, 2) }));
  const vtkIdType last = output->GetNumberOfPoints() - 1;
  Check(last == n && GetPoint(output, 0) == GetPoint(output, last), "a loop stays closed");
  const Points circle = Circle(n, 2);
  const auto displacement = [&](vtkIdType i)
  {
    const npr::Vector3 p = GetPoint(output, i % n);
    return npr::Vector3{ p[0] - circle[i % n][0], p[1] - circle[i % n][1], p[2] };
  };
  double largest = 0, step = 0;
  for (vtkIdType i = 1; i < n; ++i)
  {
    largest = std::max(largest, Distance(displacement(i), { 0, 0, 0 }));
    step = std::max(step, Distance(displacement(i), displacement(i - 1)));
  }
  const double amplitude = 0.01 * 4 * vtkMath::Pi();
  Check(largest > 0.4 * amplitude && largest <= std::sqrt(3.0) * amplitude, "amplitude");
  Check(Distance(displacement(n), displacement(n - 1)) <= step && step < 0.05 * largest, "no seam");
}

// A circle bends evenly: by 1 / radius, in whatever unit.
void TestCurvature()
{
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, npr::names::CurveCurvature);
  filter->SetTermRange(0, 0, 20);
  filter->SetTermFactors(0, 0, 20);
  const auto expect = [&](vtkPolyData* data, double expected, const std::string& what)
  {
    vtkPolyData* output = Run(filter, data);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      Expect(Get(output, npr::names::CurveCurvature, i), expected, 3e-3 * expected, what);
      Expect(Get(output, npr::names::Width, i), expected, 3e-3 * expected, what + " as a width");
    }
  };
  Points arc = Circle(1600, 2.5);
  arc.resize(601);
  expect(MakeLines({ Circle(1600, 2.5) }), 2 * vtkMath::Pi(), "a circle");
  expect(MakeLines({ arc }), 2 * vtkMath::Pi() * 600 / 1600, "an arc, up to its ends");
  expect(MakeLines({ Straight(3, 5) }), 0, "a straight line");

  filter->SetLengthUnitToModel();
  vtkSmartPointer<vtkPolyData> circle = MakeLines({ Circle(1600, 2.5) });
  npr::SetLengthScale(circle, 10);
  filter->SetReach(0.3);
  expect(circle, 4, "a circle in a model of size 10");

  vtkNew<vtkCamera> camera;
  camera->SetViewAngle(30);
  camera->SetPosition(0, 0, 50);
  camera->SetFocalPoint(0, 0, 0);
  filter->SetLengthUnitToView();
  filter->SetCamera(camera);
  filter->SetReach(0.02);
  const double height = 2 * 48 * std::tan(vtkMath::RadiansFromDegrees(15.0));
  expect(MakeLines({ Circle(1600, 2.5, 2) }), height / 2.5, "a circle on the page");
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, 2);
  matrix->SetElement(1, 1, 2);
  filter->SetMatrix(matrix);
  expect(MakeLines({ Circle(1600, 2.5, 2) }), height / 5, "an enlarged circle on the page");
  const vtkMTimeType before = filter->GetMTime();
  camera->Azimuth(10);
  Check(filter->GetMTime() > before, "it follows the camera");
}

// The cosine of the angle between normal and light, in the model's or the viewer's axes.
void TestShade()
{
  vtkSmartPointer<vtkPolyData> data = MakeLines({ Circle(720, 2) });
  vtkNew<vtkFloatArray> normals;
  normals->SetName(npr::names::Normals);
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const npr::Vector3 p = GetPoint(data, i);
    normals->InsertNextTuple3(0.5 * p[0], 0.5 * p[1], 0);
  }
  data->GetPointData()->AddArray(normals);
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, npr::names::Shade);
  filter->SetTermRange(0, -1, 1);
  filter->SetTermFactors(0, 2, 0);
  filter->SetReach(1e-4);
  filter->SetLightDirection(0, 3, 0);
  const auto expect = [&](int axis, double sign, const char* what)
  {
    vtkPolyData* output = Run(filter, data);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double cosine = sign * GetPoint(data, i)[axis] / 2;
      Expect(Get(output, npr::names::Shade, i), cosine, 1e-3, what);
      Expect(Get(output, npr::names::Width, i), 1 - cosine, 1e-3, std::string("width by ") + what);
    }
  };
  expect(1, 1, "light from above");
  vtkNew<vtkCamera> camera; // on its side: up is -x
  camera->SetPosition(0, 0, 50);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(-1, 0, 0);
  filter->SetCamera(camera);
  filter->SetLengthUnitToView();
  expect(0, -1, "light from above, as seen");
  vtkNew<vtkMatrix4x4> matrix; // mirrored
  matrix->SetElement(0, 0, -2);
  filter->SetMatrix(matrix);
  vtkPolyData* output = Run(filter, data);
  Expect(Get(output, npr::names::Shade, 0), 1, 1e-3, "a mirrored model");
  // Averages along the stroke: details vanish.
  filter->SetMatrix(nullptr);
  filter->SetLengthUnitToStroke();
  filter->SetReach(0.5);
  output = Run(filter, data);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Expect(Get(output, npr::names::Shade, i), 0, 1e-3, "averaged over all of a loop");
  }
}

// A stroke that has been cut is as wide as it was whole, in each of its parts.
void TestAveragesOverCuts()
{
  const auto shadeOf = [](const std::vector<Points>& lines, const std::vector<int>& layers)
  {
    const vtkSmartPointer<vtkPolyData> data = MakeLines(lines);
    vtkNew<vtkFloatArray> normals;
    normals->SetName(npr::names::Normals);
    normals->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      const double angle = GetPoint(data, i)[0] + GetPoint(data, i)[1];
      normals->InsertNextTuple3(0, std::cos(angle), std::sin(angle));
    }
    data->GetPointData()->AddArray(normals);
    AddCellArray(data, npr::names::HidingLayers, layers);
    AddCellArray(data, npr::names::ChainId, std::vector<int>(layers.size(), 7));
    vtkNew<vtkNPRStrokeAttributes> filter;
    filter->SetLengthUnitToModel();
    filter->SetReach(1.5);
    filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, npr::names::Shade);
    filter->SetLightDirection(0, 1, 0);
    vtkPolyData* output = Run(filter, data);
    std::vector<double> shade;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      shade.push_back(Get(output, npr::names::Shade, i));
    }
    return shade;
  };
  const Points whole = Straight(8, 8);
  const auto part = [&whole](std::ptrdiff_t begin, std::ptrdiff_t end)
  { return Points(whole.begin() + begin, whole.begin() + end + 1); };
  const std::vector<double> expected = shadeOf({ whole }, { 0 });
  const std::vector<double> cut = shadeOf({ part(0, 3), part(3, 4), part(4, 8) }, { 0, 1, 0 });
  for (std::size_t i = 0; i < cut.size(); ++i)
  {
    const std::size_t place = i - (i > 3) - (i > 5);
    Expect(cut[i], expected[place], 1e-6, "average in parts at " + std::to_string(place));
  }
  const std::vector<double> apart = shadeOf({ part(0, 3), part(4, 8) }, { 0, 0 });
  Check(std::abs(apart[3] - expected[3]) > 0.01, "what is not connected has averages of its own");

  // A closed one, from a part to the first again.
  const Points circle = Circle(40, 1);
  const std::vector<double> loop = shadeOf({ circle }, { 0 });
  const std::vector<double> halves = shadeOf(
    { Points(circle.begin(), circle.begin() + 21), Points(circle.begin() + 20, circle.end()) },
    { 0, 1 });
  for (std::size_t i = 0; i < halves.size(); ++i)
  {
    Expect(halves[i], loop[i - (i > 20)], 1e-6, "average in a loop at " + std::to_string(i));
  }
}

// The widest place of small strokes is a share of their size; all else follows it.
void TestWidthPerSize()
{
  const auto widths = [](const std::vector<Points>& lines, const std::vector<int>& layers,
                        double widthPerSize, int unit = vtkNPRStrokeAttributes::MODEL)
  {
    const vtkSmartPointer<vtkPolyData> data = MakeLines(lines);
    std::vector<float> given;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      given.push_back(GetPoint(data, i)[0] > 1e-9 ? 2.0f : 1.0f);
    }
    AddPointArray(data, npr::names::Width, given);
    AddCellArray(data, npr::names::HidingLayers, layers);
    vtkNew<vtkNPRStrokeAttributes> filter;
    filter->SetLengthUnit(unit);
    filter->SetWidthPerSize(widthPerSize);
    vtkPolyData* output = Run(filter, data);
    std::vector<double> found;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      found.push_back(Get(output, npr::names::Width, i) / given[i]);
    }
    return found;
  };
  const auto expect = [](const std::vector<double>& found, double expected, const char* what)
  {
    for (const double factor : found)
    {
      Expect(factor, expected, 2e-3 * expected, what);
    }
  };
  const Points circle = Circle(400, 3);
  expect(widths({ circle }, { 0 }, 0.2), 0.2 * 6 / 2, "a circle is as large as its diameter");
  expect(widths({ circle }, { 0 }, 0.5), 1, "a large one is as it was");
  expect(widths({ circle }, { 0 }, 0), 1, "without a limit");
  expect(widths({ circle }, { 0 }, 0.01), 0.25, "never less than a quarter");
  const Points begin(circle.begin(), circle.begin() + 151);
  const Points end(circle.begin() + 150, circle.end());
  expect(widths({ begin, end }, { 0, 1 }, 0.2), 0.6, "a loop in parts is one loop");
  const Points half(circle.begin() + 100, circle.begin() + 301); // of Width 1
  expect(widths({ half }, { 0 }, 0.1), 0.6, "half a circle is as large as a whole one");
  expect(widths({ { { -3, 0, 0 }, { -3, 2, 0 } } }, { 0 }, 0.5), 2 / vtkMath::Pi(),
    "a straight stroke is as large as a half circle of its length");
  expect(widths({ circle }, { 0 }, 3, vtkNPRStrokeAttributes::STROKE), 1.5 / vtkMath::Pi(),
    "in shares of the length");

  // As it is seen: turned by 60 degrees, a circle is an ellipse.
  const vtkSmartPointer<vtkPolyData> data = MakeLines({ circle });
  vtkNew<vtkCamera> camera;
  camera->ParallelProjectionOn();
  camera->SetParallelScale(50);
  camera->SetPosition(0, 100 * std::sin(vtkMath::Pi() / 3), 100 * std::cos(vtkMath::Pi() / 3));
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->SetLengthUnitToView();
  filter->SetCamera(camera);
  filter->SetWidthPerSize(10);
  vtkPolyData* output = Run(filter, data);
  double length = 0; // of the ellipse with the half axes 3 and 1.5
  for (int i = 0; i < 1000; ++i)
  {
    const double angle = 2 * vtkMath::Pi() * (i + 0.5) / 1000;
    length += 2 * vtkMath::Pi() / 1000 * std::hypot(3 * std::sin(angle), 1.5 * std::cos(angle));
  }
  const double size = 4 * vtkMath::Pi() * 3 * 1.5 / length;
  Expect(Get(output, npr::names::Width, 0), 10 * size / 100, 1e-3, "an ellipse on the page");
}

void TestTerms()
{
  vtkSmartPointer<vtkPolyData> data = MakeLines({ Straight(4, 4) });
  const float nan = std::numeric_limits<float>::quiet_NaN();
  AddPointArray(data, npr::names::ViewDistance, { 5, 6, 7, 8, 30 });
  AddPointArray(data, npr::names::Strength, { 0, 0.25f, 0.5f, nan, 1 });
  vtkNew<vtkFloatArray> flow;
  flow->SetName("Flow");
  flow->SetNumberOfComponents(2);
  for (int i = 0; i < 5; ++i)
  {
    flow->InsertNextTuple2(3 * i, 4 * i);
  }
  data->GetPointData()->AddArray(flow);
  vtkNew<vtkNPRStrokeAttributes> filter;
  const auto expect = [&](const char* name, const std::vector<double>& values, const char* what)
  {
    vtkPolyData* output = Run(filter, data);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      Expect(Get(output, name, static_cast<vtkIdType>(i)), values[i], 1e-6,
        std::string(what) + " at " + std::to_string(i));
    }
  };
  const int depth = filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, npr::names::ViewDistance);
  filter->SetTermRange(depth, 6, 8);
  filter->SetTermFactors(depth, 1.5, 0.5);
  expect(npr::names::Width, { 1.5, 1.5, 1.0, 0.5, 0.5 }, "nearer is wider");
  filter->SetTermRange(depth, 8, 6);
  filter->SetTermFactors(depth, 0.5, 1.5);
  expect(npr::names::Width, { 1.5, 1.5, 1.0, 0.5, 0.5 }, "the other way round");
  filter->SetTermShape(depth, vtkNPRStrokeAttributes::SMOOTH);
  filter->SetTermRange(depth, 4, 8);
  expect(npr::names::Width, { 0.5 + 0.15625, 1.0, 1.5 - 0.15625, 1.5, 1.5 }, "smoothly");

  const int strength = filter->AddTerm(vtkNPRStrokeAttributes::OPACITY, npr::names::Strength);
  filter->SetTermRange(strength, 0, 1);
  expect(npr::names::Opacity, { 0, 0.25, 0.5, 0, 1 }, "by strength");
  expect(npr::names::Width, { 0.5 + 0.15625, 1.0, 1.5 - 0.15625, 1.5, 1.5 }, "each by itself");

  filter->RemoveAllTerms();
  filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, "Flow");
  expect(npr::names::Width, { 0, 0.25, 0.5, 0.75, 1 }, "the range of the data, by magnitude");
  const int again = filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, "Flow");
  filter->SetTermFactors(again, 2, 2);
  expect(npr::names::Width, { 0, 0.5, 1, 1.5, 2 }, "a product");
}

// A step of an array, averaged over the stroke around it, is a ramp.
void TestAverage()
{
  vtkSmartPointer<vtkPolyData> data = MakeLines({ Straight(100, 100) });
  std::vector<float> step(101, 0.0f);
  std::fill(step.begin() + 51, step.end(), 1.0f);
  AddPointArray(data, "Heat", step);
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->SetLengthUnitToModel();
  filter->SetReach(10);
  const int term = filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, "Heat");
  filter->SetTermFactors(term, 1, 3);
  filter->SetTermAverage(term, true);
  vtkPolyData* output = Run(filter, data);
  for (int i = 0; i <= 100; ++i)
  {
    const double share = std::min(std::max((i - 40.5) / 20.0, 0.0), 1.0);
    Expect(
      Get(output, npr::names::Width, i), 1 + 2 * share, 0.02, "an average at " + std::to_string(i));
  }
}

void TestOvershoot()
{
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->SetLengthUnitToModel();
  filter->SetOvershootLength(0.5);
  vtkPolyData* output =
    Run(filter, MakeLines({ { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 2, 1 } }, Circle(9, 1) }));
  Check(output->GetNumberOfPoints() == 5 + 10, "one point more at each end");
  Expect(Distance(GetPoint(output, 0), { -0.5, 0, 0 }), 0, 1e-9, "the start");
  const double s = 0.5 / std::sqrt(5.0);
  Expect(Distance(GetPoint(output, 4), { 3, 2 + 2 * s, 1 + s }), 0, 1e-9, "the end");
  Expect(Get(output, npr::names::ArcLength, 4), 4 + std::sqrt(5.0), 1e-5, "its arc length");

  // One stroke in three parts: only its true ends overshoot and taper, and arc lengths go on.
  vtkSmartPointer<vtkPolyData> parts = MakeLines({ { { 0, 0, 0 }, { 1, 0, 0 } },
    { { 1, 0, 0 }, { 2, 0, 0 } }, { { 2, 0, 0 }, { 3, 0, 0 } }, { { 2, 0, 0 }, { 2, 5, 0 } } });
  AddCellArray(parts, npr::names::HidingLayers, { 0, 1, 0, 1 });
  AddCellArray(parts, npr::names::ChainId, { 7, 7, 7, 8 });
  AddPointArray(parts, npr::names::ArcLength, { 0, 1, 1, 2, 2, 3, 0, 5 });
  filter->SetTaperLength(0.25);
  output = Run(filter, parts);
  vtkNew<vtkIdList> ids;
  const auto check = [&](vtkIdType line, bool start, bool end)
  {
    output->GetLines()->GetCellAtId(line, ids);
    const vtkIdType first = ids->GetId(0), last = ids->GetId(ids->GetNumberOfIds() - 1);
    const std::string what = "part " + std::to_string(line);
    Expect(Get(output, npr::names::Width, first), start ? 0 : 1, 0, what + ", start");
    Expect(Get(output, npr::names::Width, last), end ? 0 : 1, 0, what + ", end");
    const double length = Distance(GetPoint(output, first), GetPoint(output, last));
    Expect(length, (line == 3 ? 5 : 1) + 0.5 * start + 0.5 * end, 1e-9, what + ", length");
  };
  check(0, true, false);
  check(1, false, false);
  check(2, false, true);
  check(3, true, true);
  output->GetLines()->GetCellAtId(2, ids);
  Expect(Get(output, npr::names::ArcLength, ids->GetId(0)), 2, 0, "arc lengths go on");
}

void TestWobble()
{
  // The hash that shaders have, too.
  Check(npr::HashInteger(1) == 0x514e28b7u && npr::HashInteger(0xffffffffu) == 0x81f16f39u, "hash");
  Expect(npr::GetLatticeNoise(3.0, 5), npr::GetLatticeValue(3, 5), 0, "noise at its places");
  Expect(npr::GetLatticeNoise(3.5, 5),
    0.5 * (npr::GetLatticeValue(3, 5) + npr::GetLatticeValue(4, 5)), 1e-12, "noise between them");
  Expect(npr::GetLatticeNoise(-0.75, 9, 4), npr::GetLatticeNoise(7.25, 9, 4), 1e-12, "a period");

  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->SetLengthUnitToModel();
  filter->SetWobbleAmplitude(0.1);
  filter->SetWobbleWavelength(1.5);
  const auto run = [&](const std::vector<int>& chains)
  {
    std::vector<Points> lines;
    for (int chain : chains)
    {
      lines.push_back(Straight(10 + chain, 1));
    }
    vtkSmartPointer<vtkPolyData> data = MakeLines(lines);
    AddCellArray(data, npr::names::ChainId, chains);
    Run(filter, data);
    std::vector<Points> result;
    vtkNew<vtkIdList> ids;
    for (vtkIdType line = 0; line < filter->GetOutput()->GetNumberOfLines(); ++line)
    {
      filter->GetOutput()->GetLines()->GetCellAtId(line, ids);
      result.emplace_back();
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        result.back().push_back(GetPoint(filter->GetOutput(), ids->GetId(i)));
      }
    }
    return result;
  };
  const std::vector<Points> waves = run({ 1, 2 });
  double most = 0, turn = 0;
  for (std::size_t i = 0; i < waves[0].size(); ++i)
  {
    most = std::max({ most, std::abs(waves[0][i][0]), std::abs(waves[0][i][2]) });
    if (i > 1)
    {
      turn = std::max(turn, std::abs(waves[0][i][0] - 2 * waves[0][i - 1][0] + waves[0][i - 2][0]));
    }
  }
  Check(most > 0.04 && most <= 0.1, "it strays, but not too far");
  Check(waves[0].size() > 16 * 10 / 1.5 && turn < 0.02, "smooth");
  Check(std::abs(waves[0][20][0] - waves[1][20][0]) > 1e-4, "strokes differ");
  const std::vector<Points> others = run({ 2, 5, 1 });
  Check(others[2] == waves[0] && others[0] == waves[1], "chains keep their waves");
  filter->SetSeed(4);
  Check(run({ 1, 2 })[0] != waves[0], "another seed");
  filter->SetSeed(0);
  Check(run({ 1, 2 }) == waves, "the same seed");

  // On the page, nothing comes nearer.
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 5, 60);
  camera->SetFocalPoint(0, 5, 0);
  filter->SetCamera(camera);
  filter->SetLengthUnitToView();
  filter->SetWobbleAmplitude(0.01);
  filter->SetWobbleWavelength(0.1);
  const std::vector<Points> seen = run({ 1 });
  for (const npr::Vector3& point : seen[0])
  {
    Expect(point[2], 0, 1e-12, "in the plane of the image");
    Check(std::abs(point[0]) <= 0.01 * 120 * std::tan(vtkMath::RadiansFromDegrees(15.0)), "so far");
  }
}

void TestThreads()
{
  std::vector<Points> lines;
  for (int i = 0; i < 300; ++i)
  {
    lines.push_back(i % 3 == 0 ? Circle(5 + i % 50, 1 + i) : Straight(1 + i, 1 + i % 40));
  }
  vtkSmartPointer<vtkPolyData> data = MakeLines(lines);
  const auto run = [&](int threads)
  {
    vtkNew<vtkNPRStrokeAttributes> filter;
    filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, npr::names::CurveCurvature);
    filter->SetTaperLength(0.2);
    filter->SetOvershootLength(0.01);
    filter->SetWobbleAmplitude(0.02);
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ threads }, [&]() { copy->DeepCopy(Run(filter, data)); });
    return copy;
  };
  const auto four = run(4); // first: the number of workers does not grow again
  const auto one = run(1);
  Check(one->GetNumberOfPoints() == four->GetNumberOfPoints(), "threads");
  const auto same = [](vtkDataArray* a, vtkDataArray* b)
  {
    return std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
             a->GetNumberOfValues() * a->GetDataTypeSize()) == 0;
  };
  Check(same(one->GetPoints()->GetData(), four->GetPoints()->GetData()), "points of threads");
  for (const char* name : { npr::names::Width, npr::names::Opacity, npr::names::CurveCurvature })
  {
    Check(same(one->GetPointData()->GetArray(name), four->GetPointData()->GetArray(name)), name);
  }
}

void TestBadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkNPRStrokeAttributes> filter;
  filter->SetTaperLength(0.5);
  filter->SetOvershootLength(0.1);
  filter->SetWobbleAmplitude(0.1);
  filter->AddTerm(vtkNPRStrokeAttributes::WIDTH, npr::names::CurveCurvature);
  vtkPolyData* output = Run(filter,
    MakeLines({ {}, { { 1, 1, 1 } }, { { 1, 1, 1 }, { 1, 1, 1 } }, { { nan, 0, 0 }, { 1, 1, 1 } },
      { { 0, 0, 0 }, { 1, 0, 0 }, { nan, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } },
      { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } } }));
  Check(output->GetNumberOfLines() == 3, "what there is of lines");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const npr::Vector3 p = GetPoint(output, i);
    Check(std::isfinite(p[0] + p[1] + p[2]), "points are finite");
    Check(std::isfinite(Get(output, npr::names::Width, i)), "widths are finite");
  }
  Check(Run(filter, vtkNew<vtkPolyData>())->GetNumberOfPoints() == 0, "nothing");

  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto expectError = [&](const char* what)
  {
    Check(observer->GetError() && observer->GetErrorMessage().find(what) != std::string::npos,
      std::string("an error that says '") + what + "': " + observer->GetErrorMessage());
    observer->Clear();
  };
  filter->SetLengthUnitToView();
  Run(filter, MakeLines({ Straight(1, 1) }));
  expectError("SetCamera()");
  filter->SetCamera(vtkNew<vtkCamera>());
  filter->SetMatrix(vtkNew<vtkMatrix4x4>());
  filter->GetMatrix()->Zero();
  Run(filter, MakeLines({ Straight(1, 1) }));
  expectError("no inverse");
  filter->SetLengthUnitToStroke();
  filter->AddTerm(vtkNPRStrokeAttributes::OPACITY, "Heat");
  vtkSmartPointer<vtkPolyData> data = MakeLines({ Straight(1, 1) });
  AddPointArray(data, "Hoot", { 1, 2 });
  Run(filter, data);
  expectError("'Heat' to take their opacity from; they have: Hoot");
  Check(filter->GetOutput()->GetNumberOfPoints() == 0, "nothing half done");
  filter->RemoveAllTerms();
  filter->AddTerm(vtkNPRStrokeAttributes::OPACITY, npr::names::Shade);
  Run(filter, data);
  expectError("'Normals' to take their opacity from");
  filter->SetTermFactors(0, 0.5, 2);
  expectError("from 0 to 1");
  filter->SetTermRange(9, 0, 1);
  expectError("no term 9");
  filter->SetTermRange(0, 0, nan);
  expectError("finite");
  Check(filter->AddTerm(5, "Heat") == -1, "no such attribute");
  expectError("WIDTH or OPACITY");
}
}

int TestStrokeAttributes(int, char*[])
{
  TestNothingAsked();
  TestTaper();
  TestClosed();
  TestCurvature();
  TestShade();
  TestAveragesOverCuts();
  TestWidthPerSize();
  TestTerms();
  TestAverage();
  TestOvershoot();
  TestWobble();
  TestThreads();
  TestBadInput();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
