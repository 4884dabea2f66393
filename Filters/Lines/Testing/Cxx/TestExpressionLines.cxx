// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines from formulas: against curves that are known, against the built-in kind that they repeat,
// and what they say when something is wrong.
#include "nprLineTesting.h"

#include "vtkNPRExpressionLines.h"
#include "vtkNPRSuggestiveContours.h"

#include <vtkMath.h>
#include <vtkSMPTools.h>

#include <cstring>
#include <limits>

using namespace nprtest;

namespace
{
vtkSmartPointer<vtkNPRExpressionLines> MakeLines(const char* field, const char* test = "")
{
  auto lines = vtkSmartPointer<vtkNPRExpressionLines>::New();
  lines->SetField(field);
  lines->SetTest(test);
  return lines;
}

std::vector<Chain> ExtractFrom(
  vtkPolyData* surface, vtkNPRLineDefinition* definition, vtkCamera* camera = nullptr)
{
  vtkNew<vtkNPRFeatureLines> filter;
  filter->AddDefinition(definition);
  filter->SetCamera(camera);
  filter->SetLengthScale(1.0);
  filter->SetInputData(surface);
  filter->Update();
  const auto chains = GetChains(filter->GetOutput());
  CheckSound(chains, *std::make_unique<Checks>());
  return chains;
}

// A coordinate of a sphere has circles.
void TestCircles(Checks& check)
{
  const Vector centre(10.0, -20.0, 5.0);
  auto sphere = MakeSphere(60, 2.0, centre);
  const auto circle = ExtractFrom(sphere, MakeLines("pz - 6"));
  check(circle.size() == 1 && circle[0].Closed, "one circle", static_cast<double>(circle.size()));
  for (const Chain& chain : circle)
  {
    for (std::size_t i = 0; i < chain.Points.size(); ++i)
    {
      check(std::abs(chain.Points[i][2] - 6.0) < 1.0e-6, "its height", chain.Points[i][2]);
      const double radius = std::hypot(chain.Points[i][0] - 10.0, chain.Points[i][1] + 20.0);
      check(std::abs(radius - std::sqrt(3.0)) < 0.005, "its radius", radius);
      check(chain.Strength[i] == 1.0, "full strength without a test");
    }
  }

  // Several levels, none twice; half of each by the test, which fades.
  auto lines = MakeLines("pz - c", "px > 10");
  check(lines->AddConstant("c", 5.0), "a constant");
  lines->SetLevels({ 1.0, -1.0, 0.5, 1.0 });
  lines->SetFade(0.5);
  check(!lines->IsViewDependent(), "positions depend on no view");
  auto halves = ExtractFrom(sphere, lines);
  std::sort(halves.begin(), halves.end(),
    [](const Chain& a, const Chain& b) { return a.Points[0][2] < b.Points[0][2]; });
  check(halves.size() == 3, "three halves", static_cast<double>(halves.size()));
  const std::vector<double> heights = { 4.0, 5.5, 6.0 };
  for (std::size_t c = 0; c < halves.size() && c < 3; ++c)
  {
    const Chain& chain = halves[c];
    check(!chain.Closed, "a half is open");
    for (std::size_t i = 0; i < chain.Points.size(); ++i)
    {
      const double x = chain.Points[i][0] - 10.0;
      check(std::abs(chain.Points[i][2] - heights[c]) < 1.0e-6, "the heights");
      check(x > -1.0e-6, "where the test holds", x);
      const double t = std::min(1.0, std::max(0.0, x / 0.5));
      check(std::abs(chain.Strength[i] - t * t * (3.0 - 2.0 * t)) < 0.01, "the strength",
        chain.Strength[i]);
    }
    for (const Vector& end : { chain.Points.front(), chain.Points.back() })
    {
      check(std::abs(end[0] - 10.0) < 1.0e-6, "ends are where the test turns, inside triangles",
        end[0] - 10.0);
    }
  }
  // As yes or no, the ends are somewhere in their triangles.
  const auto rough = ExtractFrom(sphere, MakeLines("pz - 6", "if(px > 10, 1, -1)"));
  check(rough.size() == 1 && std::abs(rough[0].Points.front()[0] - 10.0) > 1.0e-4,
    "the margin is what makes ends exact");
}

// The built-in kind, to the last bit.
void TestBuiltIn(Checks& check)
{
  const char* names[] = { "threshold", "fade", "minimumAngle", "contourFade" };
  const double values[2][4] = { { 0.25, 0.5, 15.0, 0.02 }, { 0.3, 0.7, 11.3, 0.123456789 } };
  for (const auto& v : values)
  {
    vtkNew<vtkNPRSuggestiveContours> builtIn;
    for (int i = 0; i < 4; ++i)
    {
      builtIn->SetParameter(names[i], v[i]);
    }
    auto lines = MakeLines("kr",
      "if(ndotv > 0 and sintheta > a, min((dwkr - t) * sintheta / f, (sintheta - a) / a, ndotv / "
      "c),"
      " min((sintheta - a) / a, ndotv / c))");
    const char* constants[] = { "t", "f", "a", "c" };
    for (int i = 0; i < 4; ++i)
    {
      const double value = i == 2 ? std::sin(vtkMath::RadiansFromDegrees(v[i])) : v[i];
      check(lines->AddConstant(constants[i], value), "a constant");
    }
    check(lines->IsViewDependent(), "kr depends on the view");
    for (const bool parallel : { false, true })
    {
      vtkSmartPointer<vtkPoints> points[2];
      vtkSmartPointer<vtkCellArray> cells[2];
      vtkSmartPointer<vtkDataArray> strength[2];
      int i = 0;
      for (vtkNPRLineDefinition* definition :
        std::initializer_list<vtkNPRLineDefinition*>{ builtIn, lines })
      {
        vtkNew<vtkNPRFeatureLines> filter;
        filter->AddDefinition(definition);
        filter->SetCamera(MakeCamera({ 3.0, 1.0, 3.0 }, parallel));
        filter->SetInputData(Torus().Make(240, 120));
        filter->Update();
        points[i] = filter->GetOutput()->GetPoints();
        cells[i] = filter->GetOutput()->GetLines();
        strength[i++] = filter->GetOutput()->GetPointData()->GetArray(npr::names::Strength);
      }
      const auto same = [&](vtkDataArray* a, vtkDataArray* b)
      {
        const auto size = a->GetDataSize() * a->GetDataTypeSize();
        return size == b->GetDataSize() * b->GetDataTypeSize() &&
          std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), size) == 0;
      };
      check(points[0]->GetNumberOfPoints() > 100, "there are suggestive contours");
      check(same(points[0]->GetData(), points[1]->GetData()), "the same points");
      check(same(cells[0]->GetConnectivityArray(), cells[1]->GetConnectivityArray()) &&
          same(cells[0]->GetOffsetsArray(), cells[1]->GetOffsetsArray()),
        "the same lines");
      check(same(strength[0], strength[1]), "the same strength");
    }
  }
}

void TestThreads(Checks& check)
{
  auto torus = Torus().Make(300, 150);
  auto lines = MakeLines("kr * cos(3 * px) + 0.1", "abs(dwkr) > 0.3 and ndotv > 0 or K < -1");
  std::vector<Segment> first;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]()
      {
        const auto segments = GetSegments(ExtractFrom(torus, lines, MakeCamera({ 3.0, 1.0, 3.0 })));
        first = threads == 1 ? segments : first;
        check(!first.empty() && segments == first, "the same with any number of threads", threads);
      });
  }
}

// Arrays of the input, whatever they are called.
void TestArrays(Checks& check)
{
  auto sphere = MakeSphere(30, 1.0);
  const auto add = [&](const char* name, int components, auto value)
  {
    auto array = AddArray(sphere, name, components);
    for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        array->SetComponent(i, c, value(Vector(sphere->GetPoint(i)), c));
      }
    }
  };
  const auto height = [](const Vector& p, int c) { return p[2] - 0.1 * (c + 1); };
  add("Wall thickness", 1, height);
  add("Wall_thickness", 1, [](const Vector& p, int) { return p[2] - 0.5; }); // has the name
  add("2nd", 1, height);
  add("P", 1, height);
  add("sin", 1, height);
  add("Field", 2, height);
  add("Flow", 3, height);
  const auto expect = [&](const char* field, double z)
  {
    const auto circle = ExtractFrom(sphere, MakeLines(field));
    check(circle.size() == 1 && std::abs(circle[0].Points[0][2] - z) < 1.0e-3, field,
      circle.empty() ? -1.0 : circle[0].Points[0][2]);
  };
  expect("Wall_thickness", 0.5);
  expect("array_2nd", 0.1);
  expect("array_P", 0.1);
  expect("array_sin", 0.1);
  expect("Field_1", 0.2);
  expect("Flow_0", 0.1);
  expect("Flow_z", 0.3);
  expect("Normals_z - 0.4", 0.4);
}

void TestErrors(Checks& check)
{
  auto torus = Torus().Make(20, 10);
  AddArray(torus, "Wall thickness", 1);
  const auto errors = [&](vtkNPRLineDefinition* definition)
  {
    vtkNew<vtkNPRFeatureLines> filter;
    filter->AddDefinition(definition);
    filter->SetCamera(MakeCamera({ 3.0, 1.0, 3.0 }));
    filter->SetInputData(torus);
    return GetErrors(filter);
  };
  auto lines = MakeLines("kr + krr");
  lines->SetName("mine");
  check(lines->AddConstant("limit", 1.0), "a constant");
  check(lines->FindProblem().empty(), "krr could be an array", 0.0);
  std::string text = errors(lines);
  for (const char* part : { "\"mine\"", "field \"kr + krr\"", "column 6", "'krr'", "ndotv", "e1x",
         "array", "Wall_thickness", "limit = 1" })
  {
    check(Contains(text, part), (std::string(part) + " is in: " + text).c_str());
  }
  lines->SetField("kr");
  check(errors(lines).empty(), "once right, it works");
  lines->SetTest("dwkr > (2");
  text = errors(lines);
  check(Contains(text, "test \"dwkr > (2\", column 8"), text.c_str());
  check(Contains(lines->FindProblem(), "column 8"), "known early");
  check(Contains(errors(MakeLines("")), "no field"), "no field is an error");

  for (const char* name : { "sin", "kr", "e1x", "while", "2a", "a b", "", "pi" })
  {
    check(!lines->AddConstant(name, 1.0), "no name for a constant");
  }
  check(!lines->AddConstant("a", std::numeric_limits<double>::quiet_NaN()), "no constant");
  for (const char* constants : { "a", "a = ", "a = 1 2", "kr = 2", "a = 1,, b = 2", "= 2" })
  {
    lines->SetConstants(constants);
    check(Contains(lines->FindProblem(), "constants are written"), constants);
  }
  lines->SetConstants(" a=1e-3,b = -2 ");
  check(lines->AddConstant("a", 1.0 / 3.0), "a constant is replaced");
  lines->SetTest("a > b");
  check(lines->FindProblem().empty(), lines->FindProblem().c_str());
  check(lines->GetConstants() == "a = 0.33333333333333331, b = -2", lines->GetConstants().c_str());
  lines->SetName("not good");
  check(Contains(lines->FindProblem(), "name"), "no name for lines");

  // What is missing is named with what makes it.
  vtkNew<vtkNPRFeatureLines> filter;
  filter->AddDefinition(MakeLines("K"));
  filter->SetInputData(MakeSphere(10, 1.0));
  check(Contains(GetErrors(filter), "vtkNPRCurvatureTensor"), "the filter that makes an array");
}

std::string GetWarnings(vtkNPRLineDefinition* definition, vtkNPRFeatureLines* filter)
{
  std::string warnings;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&warnings);
  observer->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
    { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
  const unsigned long tag = definition->AddObserver(vtkCommand::WarningEvent, observer);
  filter->Update();
  definition->RemoveObserver(tag);
  return warnings;
}

// Not a number: no lines there, and a count of what has been left out.
void TestUndefined(Checks& check)
{
  const int n = 30;
  auto sphere = MakeSphere(n, 1.0);
  vtkNew<vtkNPRFeatureLines> filter;
  filter->SetInputData(sphere);
  auto lines = MakeLines("px + sqrt(pz - 0.3) - sqrt(pz - 0.3)");
  filter->AddDefinition(lines);
  const std::string warning = GetWarnings(lines, filter);
  // Counted by hand.
  int points = 0;
  int triangles = 0;
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    points += sphere->GetPoint(i)[2] < 0.3;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < sphere->GetNumberOfPolys(); ++t)
  {
    sphere->GetPolys()->GetCellAtId(t, ids);
    triangles += sphere->GetPoint(ids->GetId(0))[2] < 0.3 ||
      sphere->GetPoint(ids->GetId(1))[2] < 0.3 || sphere->GetPoint(ids->GetId(2))[2] < 0.3;
  }
  check(Contains(warning, ("at " + std::to_string(points) + " points").c_str()) &&
      Contains(warning, ("the " + std::to_string(triangles) + " triangles").c_str()),
    warning.c_str(), triangles);
  const auto chains = GetChains(filter->GetOutput());
  check(chains.size() == 1, "a half circle is left", static_cast<double>(chains.size()));
  for (const Chain& chain : chains)
  {
    for (const Vector& p : chain.Points)
    {
      check(p.allFinite() && std::abs(p[0]) < 1.0e-6 && p[2] > 0.3, "where the field is", p[2]);
    }
  }
  lines->SetField("px");
  lines->SetTest("1 / (pz > 0)"); // infinite below
  check(Contains(GetWarnings(lines, filter), "the test at"), "tests, too");
  lines->SetTest("1");
  check(GetWarnings(lines, filter).empty(), "no warning without reason");
}

// Kinds of one's own, by their names.
void TestAddKind(Checks& check)
{
  auto lines = MakeLines("pz - half", "px > 0");
  check(!vtkNPRLineDefinition::AddKind(lines), "no name like a built-in kind");
  lines->SetName("slice");
  lines->SetLevels({ 0.0, 0.1 });
  lines->AddConstant("half", 0.5);
  const int before = vtkNPRLineDefinition::GetNumberOfLineNames();
  check(vtkNPRLineDefinition::AddKind(lines), "added");
  check(vtkNPRLineDefinition::AddKind(lines), "and again, in its own place");
  check(vtkNPRLineDefinition::GetNumberOfLineNames() == before + 1 &&
      std::string(vtkNPRLineDefinition::GetLineName(before)) == "slice",
    "it is among the kinds");
  auto copy = vtk::TakeSmartPointer(vtkNPRLineDefinition::NewFromName("slice"));
  check(copy && copy != lines.Get(), "a copy each time");
  auto sphere = MakeSphere(20, 1.0);
  check(GetSegments(ExtractFrom(sphere, copy)) == GetSegments(ExtractFrom(sphere, lines)),
    "with the same lines");
  copy->SetTextParameter("field", "pz");
  check(lines->GetField() == "pz - half", "that is changed by itself");
  vtkNPRLineDefinition::RemoveKind("slice");
  check(vtkNPRLineDefinition::NewFromName("slice") == nullptr, "and gone again");
  check(!vtkNPRLineDefinition::AddKind(nullptr), "nothing is not added");
}
}

int TestExpressionLines(int, char*[])
{
  Checks check;
  TestCircles(check);
  TestBuiltIn(check);
  TestThreads(check);
  TestArrays(check);
  TestErrors(check);
  TestUndefined(check);
  TestAddKind(check);
  return check.GetResult();
}
