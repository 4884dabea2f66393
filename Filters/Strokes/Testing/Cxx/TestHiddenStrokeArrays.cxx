// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What cut strokes carry, what becomes of closed ones, and what bad input does.
#include "nprHiddenStrokes.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkStringArray.h>

#include <limits>

using namespace nprtest;

namespace
{
Checks check;
const Vector3d Front(0.0, 0.0, 10.0);
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

void TestArrays()
{
  // Hidden from x = -1 to 1; segments of different lengths.
  const auto strokes = MakePolylines({ { { -3.0, 0.5, -1.0 }, { -3.0, 0.5, -1.0 } },
    { { -2.0, 0.1, -1.0 }, { -1.5, 0.1, -1.0 }, { 0.0, 0.1, -1.0 }, { 0.5, 0.1, -1.0 },
      { 2.0, 0.1, -1.0 } } });
  vtkNew<vtkDoubleArray> value;
  value->SetName("Value");
  value->SetNumberOfComponents(2);
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  for (int i = 0; i < 7; ++i)
  {
    const double x = strokes->GetPoint(i)[0];
    value->InsertNextTuple2(3.0 * x + 1.0, -x);
    number->InsertNextValue(100 + i);
  }
  strokes->GetPointData()->AddArray(value);
  strokes->GetPointData()->AddArray(number);
  vtkNew<vtkStringArray> names;
  names->SetName("Names");
  names->InsertNextValue("short");
  names->InsertNextValue("long");
  strokes->GetCellData()->AddArray(names);
  vtkNew<vtkIntArray> oldLayers;
  oldLayers->SetName(npr::names::HidingLayers);
  oldLayers->InsertNextValue(7);
  oldLayers->InsertNextValue(7);
  strokes->GetCellData()->AddArray(oldLayers);
  vtkNew<vtkStringArray> field;
  field->SetName("Field");
  strokes->GetFieldData()->AddArray(field);

  const auto filter = MakeFilter(strokes, { MakeSheet(1.0, 1.0, 0.0) }, MakeCamera(Front));
  const Parts parts = GetParts(filter);
  vtkPolyData* const output = filter->GetOutput();
  check(GetLayers(parts) == "0 0 1 0", "parts with arrays: " + GetLayers(parts));
  check(output->GetFieldData()->HasArray("Field") == 1, "field data is passed");
  auto* const outputNames =
    vtkStringArray::SafeDownCast(output->GetCellData()->GetAbstractArray("Names"));
  for (int i = 0; i < 4; ++i)
  {
    check(outputNames && outputNames->GetValue(i) == (i == 0 ? "short" : "long"),
      "cell arrays are copied", i);
  }
  vtkDataArray* const values = output->GetPointData()->GetArray("Value");
  vtkDataArray* const numbers = output->GetPointData()->GetArray("Number");
  if (!check(values && numbers && output->GetNumberOfPoints() == 11, "point arrays are carried",
        static_cast<double>(output->GetNumberOfPoints())))
  {
    return;
  }
  for (vtkIdType i = 2; i < output->GetNumberOfPoints(); ++i)
  {
    const double x = output->GetPoint(i)[0];
    check(std::abs(values->GetComponent(i, 0) - 3.0 * x - 1.0) < 1e-12 &&
        std::abs(values->GetComponent(i, 1) + x) < 1e-12,
      "numbers are interpolated", x);
    const double nearest = x < -1.75 ? 102
      : x < -0.75                    ? 103
      : x < 0.25                     ? 104
      : x < 1.25                     ? 105
                                     : 106;
    check(numbers->GetComponent(i, 0) == nearest, "integers are those of the nearer point", x);
    const double arc = output->GetPointData()->GetArray(npr::names::ArcLength)->GetComponent(i, 0);
    check(std::abs(arc - (x + 2.0)) < 1e-6, "ArcLength goes on", arc);
  }
  // Parts that touch have all alike at their ends.
  for (const vtkIdType end : { 4, 8 })
  {
    check(values->GetComponent(end, 0) == values->GetComponent(end + 1, 0) &&
        numbers->GetComponent(end, 0) == numbers->GetComponent(end + 1, 0),
      "ends that touch are alike", static_cast<double>(end));
  }
  check(
    parts[1].Line.back() == parts[2].Line.front() && parts[2].Line.back() == parts[3].Line.front(),
    "ends that touch are in one place");

  // An ArcLength that is there is taken, whatever it measures.
  vtkNew<vtkFloatArray> arcs;
  arcs->SetName(npr::names::ArcLength);
  for (int i = 0; i < 7; ++i)
  {
    arcs->InsertNextValue(static_cast<float>(10.0 * strokes->GetPoint(i)[0]));
  }
  strokes->GetPointData()->AddArray(arcs);
  const Parts again = GetParts(filter);
  check(again.size() == 4 && std::abs(again[2].ArcLengths.front() + 10.0) < 1e-5 &&
      std::abs(again[2].ArcLengths.back() - 10.0) < 1e-5,
    "an ArcLength that is there goes on");
}

void TestClosed()
{
  // A circle behind a half plane, beginning in its visible half.
  Points circle;
  for (int i = 0; i <= 64; ++i)
  {
    const double angle = 2.0 * Pi * (i % 64) / 64.0;
    circle.emplace_back(std::cos(angle), std::sin(angle), -1.0);
  }
  const auto strokes = MakePolylines({ circle });
  const double length = 64.0 * 2.0 * std::sin(Pi / 64.0);
  const auto run = [&](double left, double right)
  {
    const auto sheet = MakePolygons(
      { { left, -2.0, 0.0 }, { right, -2.0, 0.0 }, { right, 2.0, 0.0 }, { left, 2.0, 0.0 } },
      { { 0, 1, 2, 3 } });
    return GetParts(MakeFilter(strokes, { sheet }, MakeCamera(Front)));
  };
  const Parts halves = run(-2.0, 0.01);
  check(GetLayers(halves) == "0 1", "a circle in two: " + GetLayers(halves));
  if (halves.size() == 2)
  {
    check(halves[0].Line.front() == halves[1].Line.back() &&
        halves[0].Line.back() == halves[1].Line.front(),
      "the parts of a circle touch twice");
    check(std::abs(halves[0].GetLength() + halves[1].GetLength() - length) < 1e-9,
      "nothing of a circle is lost");
    const std::vector<double>& arcs = halves[0].ArcLengths;
    check(arcs.front() > 0.7 * length && arcs.back() > length &&
        std::abs(arcs.back() - arcs.front() - halves[0].GetLength()) < 1e-5,
      "ArcLength goes on over the first point", arcs.back());
    check(std::is_sorted(arcs.begin(), arcs.end()), "ArcLength grows");
  }
  for (const double left : { -2.0, 3.0 })
  {
    const Parts whole = run(left, 4.0);
    check(whole.size() == 1 && whole[0].Line == circle, "a circle of one kind stays as it is");
  }
  // The short hidden piece over the first point goes, and with it the seam.
  const Parts merged = run(0.9999999, 4.0);
  check(merged.size() == 1 && merged[0].Layers == 0 && merged[0].Line == circle,
    "a circle without its short part", static_cast<double>(merged.size()));
}

void TestShortParts()
{
  // Pixels are 0.004 wide: the image is 1000 high and shows 4 units.
  const auto strokes = MakePolylines({ { { -2.0, 0.1, -1.0 }, { 2.0, 0.1, -1.0 } } });
  const auto filter = Filter::New();
  filter->SetInputData(strokes);
  filter->SetCamera(MakeCamera(Front));
  // 0.5 and 0.75 pixels of hidden line, 0.6 pixels of visible between them.
  for (const auto& [left, right] : { std::pair<double, double>(0.0, 0.002), { 0.0044, 0.0074 } })
  {
    filter->AddSurfaceData(MakePolygons(
      { { left, -1.0, 0.0 }, { right, -1.0, 0.0 }, { right, 1.0, 0.0 }, { left, 1.0, 0.0 } },
      { { 0, 1, 2, 3 } }));
  }
  filter->SetMinimumLength(0.0);
  check(AreParts(GetParts(filter), "0 1 0 1 0", 0, { 0.0, 0.002, 0.0044, 0.0074 }, 1e-6),
    "all parts are kept");
  filter->SetMinimumLength(0.55);
  check(AreParts(GetParts(filter), "0 1 0", 0, { 0.0044, 0.0074 }, 1e-6), "the shortest goes");
  filter->SetMinimumLength(1.0);
  check(GetLayers(GetParts(filter)) == "0", "all that are shorter than a pixel go");
  filter->SetViewportHeight(2000.0);
  check(AreParts(GetParts(filter), "0 1 0 1 0", 0, { 0.0, 0.002, 0.0044, 0.0074 }, 1e-6),
    "in a larger image they are long enough");
}

void TestEye()
{
  // Behind the eye, and through it; the last but one is but a point of the image.
  const auto strokes = MakePolylines(
    { { { 0.0, 0.3, -1.0 }, { 0.0, 0.3, 20.0 } }, { { 0.3, 0.0, 11.0 }, { 0.3, 0.0, 20.0 } },
      { { 0.0, 0.0, -1.0 }, { 0.0, 0.0, 20.0 } }, { { -5.0, 0.0, 10.0 }, { 5.0, 0.0, 10.0 } } });
  const auto camera = MakeCamera(Front, false);
  const Parts parts = GetParts(MakeFilter(strokes, { MakeSheet(2.0, 2.0, 0.5) }, camera));
  check(GetLayers(parts) == "1 0 0", "strokes at the eye: " + GetLayers(parts));
  for (const Part& part : parts)
  {
    for (const Vector3d& point : part.Line)
    {
      check(point.z() < 10.0, "what is behind the eye is left out", point.z());
    }
  }
  // The surface itself goes by the eye.
  const auto floor = MakePolygons(
    { { -50.0, -1.0, -50.0 }, { 50.0, -1.0, -50.0 }, { 50.0, -1.0, 50.0 }, { -50.0, -1.0, 50.0 } },
    { { 0, 1, 2, 3 } });
  const auto poles = MakePolylines({ { { 1.0, -2.0, -5.0 }, { 1.0, 1.0, -5.0 } } });
  check(AreParts(GetParts(MakeFilter(poles, { floor }, camera)), "1 0", 1, { -1.0 }, 1e-5),
    "a floor under the eye");
}

void TestBadStrokes()
{
  const auto sheet = MakeSheet(1.0, 1.0, 0.0);
  const auto camera = MakeCamera(Front);
  const auto strokes = MakePolylines({ {}, { { 0.0, 0.0, -1.0 } },
    { { -2.0, 0.1, -1.0 }, { -1.9, 0.1, -1.0 }, { NaN, 0.1, -1.0 }, { 0.0, 0.1, -1.0 },
      { 0.5, 0.1, -1.0 } },
    { { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 } }, { { 0.0, 0.1, 1.0 }, { 0.0, 0.1, 2.0 } },
    { { NaN, NaN, NaN }, { NaN, NaN, NaN } } });
  const auto filter = MakeFilter(strokes, { sheet }, camera);
  const Parts parts = GetParts(filter);
  check(GetErrors(filter).empty(), "bad strokes are no error");
  check(GetLayers(parts) == "0 1 0 0", "bad strokes: " + GetLayers(parts));
  for (const Part& part : parts)
  {
    for (const Vector3d& point : part.Line)
    {
      check(point.allFinite(), "no output that is no number");
    }
  }
  for (const Data& nothing : { Data::New(), MakePolylines({}), MakePolylines({ {} }) })
  {
    const auto empty = MakeFilter(nothing, { sheet }, camera);
    check(GetErrors(empty).empty() && empty->GetOutput()->GetNumberOfLines() == 0,
      "no strokes, no error");
  }
  const auto broken = MakePolygons({ { NaN, 0.0, 0.0 }, { 1.0, 1.0, 0.0 }, { 1.0, -1.0, 0.0 },
                                     { -1.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 } },
    { { 0, 1, 2 }, { 3, 4, 3 }, { 3, 2, 1 } });
  const auto line = MakePolylines({ { { 0.0, 0.1, -1.0 }, { 0.0, 3.0, -1.0 } } });
  check(GetLayers(GetParts(MakeFilter(line, { broken }, camera))) == "1 0",
    "broken triangles of a surface hide nothing, the others do");
}

void TestErrors()
{
  const auto strokes = MakePolylines({ { { -2.0, 0.1, -1.0 }, { 2.0, 0.1, -1.0 } } });
  const auto sheet = MakeSheet(1.0, 1.0, 0.0);
  const auto expect = [](vtkNPRStrokeVisibility* filter, const std::string& text)
  {
    const std::string errors = GetErrors(filter);
    check(errors.find(text) != std::string::npos, "an error says " + text + ": " + errors);
    check(filter->GetOutput()->GetNumberOfLines() == 0, "an error leaves no strokes: " + text);
  };
  expect(MakeFilter(strokes, { sheet }, nullptr), "SetCamera");
  expect(MakeFilter(strokes, {}, MakeCamera(Front)), "AddSurfaceConnection");
  const auto blind = MakeCamera(Front);
  blind->SetFocalPoint(Front.x(), Front.y(), Front.z());
  expect(MakeFilter(strokes, { sheet }, blind), "focal point");
  vtkNew<vtkMatrix4x4> bad;
  bad->SetElement(1, 2, NaN);
  const auto filter = MakeFilter(strokes, { sheet }, MakeCamera(Front));
  filter->SetSurfaceMatrix(0, bad);
  expect(filter, "matrix of surface 0");
  filter->SetSurfaceMatrix(0, nullptr);
  filter->SetStrokeMatrix(bad);
  expect(filter, "matrix of the strokes");
  filter->SetStrokeMatrix(nullptr);
  check(GetErrors(filter).empty() && GetLayers(GetParts(filter)) == "0 1 0",
    "after errors all is well again");
}
}

int TestHiddenStrokeArrays(int, char*[])
{
  TestArrays();
  TestClosed();
  TestShortParts();
  TestEye();
  TestBadStrokes();
  TestErrors();
  return check.GetResult();
}
