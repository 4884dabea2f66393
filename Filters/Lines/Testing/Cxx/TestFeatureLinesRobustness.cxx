// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// What must not matter (threads, the order of points and triangles) and what must not break.
#include "nprLineTesting.h"

#include "vtkNPRLineDefinition.h"

#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkMatrix4x4.h>
#include <vtkSMPTools.h>

#include <limits>
#include <numeric>
#include <random>
#include <string>

using namespace nprtest;

namespace
{
const std::vector<const char*> AllLines = { "contours", "suggestive", "creases", "boundaries" };

// A torus with a piece cut out, so that it has borders.
vtkSmartPointer<vtkPolyData> MakeOpenTorus(int nu, int nv)
{
  auto torus = Torus().Make(nu, nv);
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < torus->GetNumberOfPolys(); ++i)
  {
    if (i % (2 * nv) >= nv / 3 || i > nu * nv / 2)
    {
      torus->GetPolys()->GetCellAtId(i, ids);
      triangles->InsertNextCell(ids);
    }
  }
  torus->SetPolys(triangles);
  return torus;
}

void TestThreads(Checks& check)
{
  auto torus = MakeOpenTorus(200, 100);
  auto camera = MakeCamera({ 3.0, 1.0, 3.0 });
  std::vector<Chain> first;
  for (int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]()
      {
        const auto chains = Extract(torus, AllLines, camera);
        CheckSound(chains, check);
        if (threads == 1)
        {
          first = chains;
          return;
        }
        bool same = chains.size() == first.size();
        for (std::size_t i = 0; same && i < chains.size(); ++i)
        {
          same = chains[i].Points == first[i].Points && chains[i].Strength == first[i].Strength &&
            chains[i].Normals == first[i].Normals && chains[i].Type == first[i].Type;
        }
        check(same, "the number of threads does not matter", threads);
      });
  }
  check(first.size() > 4, "there are lines of all kinds");
}

void TestOrder(Checks& check)
{
  auto torus = MakeOpenTorus(80, 40);
  const vtkIdType numberOfPoints = torus->GetNumberOfPoints();
  std::vector<vtkIdType> newId(numberOfPoints);
  std::iota(newId.begin(), newId.end(), 0);
  std::mt19937 random(7);
  std::shuffle(newId.begin(), newId.end(), random);

  vtkNew<vtkPolyData> shuffled;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(numberOfPoints);
  shuffled->SetPoints(points);
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    points->SetPoint(newId[i], torus->GetPoint(i));
  }
  for (int a = 0; a < torus->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = torus->GetPointData()->GetArray(a);
    auto copy = AddArray(shuffled, array->GetName(), array->GetNumberOfComponents());
    for (vtkIdType i = 0; i < numberOfPoints; ++i)
    {
      copy->SetTuple(newId[i], array->GetTuple(i));
    }
  }
  std::vector<vtkIdType> order(torus->GetNumberOfPolys());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t : order)
  {
    torus->GetPolys()->GetCellAtId(t, ids);
    const vtkIdType turn = t % 3;
    triangles->InsertNextCell({ newId[ids->GetId(turn)], newId[ids->GetId((turn + 1) % 3)],
      newId[ids->GetId((turn + 2) % 3)] });
  }
  shuffled->SetPolys(triangles);

  auto camera = MakeCamera({ 3.0, 1.0, 3.0 });
  for (const char* name : AllLines)
  {
    std::vector<Segment> segments[2];
    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkNPRFeatureLines> lines;
      lines->AddDefinition(name);
      lines->SetCamera(camera);
      lines->SetLengthScale(1.0);
      lines->SetInputData(i == 0 ? torus.Get() : shuffled.Get());
      lines->Update();
      segments[i] = GetSegments(GetChains(lines->GetOutput()));
    }
    check(segments[0] == segments[1], name, static_cast<double>(segments[0].size()));
  }
}

// The text of the errors of one update.
std::string GetErrors(vtkNPRFeatureLines* lines)
{
  std::string errors;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&errors);
  observer->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
    { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
  const unsigned long tag = lines->AddObserver(vtkCommand::ErrorEvent, observer);
  // The executive adds that the filter failed.
  const unsigned long executiveTag =
    lines->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  lines->Update();
  lines->RemoveObserver(tag);
  lines->GetExecutive()->RemoveObserver(executiveTag);
  return errors;
}

bool Contains(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

void TestErrors(Checks& check)
{
  {
    vtkNew<vtkNPRFeatureLines> lines;
    lines->SetInputData(MakeSphere(10, 1.0));
    check(Contains(GetErrors(lines), "AddDefinition"), "no definition is an error");
  }
  {
    vtkNew<vtkNPRFeatureLines> lines;
    lines->SetInputData(MakeSphere(10, 1.0));
    lines->AddDefinition("contours");
    check(Contains(GetErrors(lines), "SetCamera"), "no camera is an error");
    lines->SetCamera(MakeCamera({ 3.0, 1.0, 3.0 }));
    check(GetErrors(lines).empty(), "with a camera there is none");
    vtkNew<vtkMatrix4x4> flat;
    flat->SetElement(2, 2, 0.0);
    lines->SetMatrix(flat);
    check(Contains(GetErrors(lines), "no inverse"), "a flat prop is an error");
    lines->SetMatrix(nullptr);
    lines->AddDefinition("suggestive");
    const std::string errors = GetErrors(lines);
    check(Contains(errors, "\"CurvatureTensor\"") && Contains(errors, "vtkNPRCurvatureTensor"),
      "an error names the array that is missing, and what makes it");
  }
  for (int i = 0; i < vtkNPRLineDefinition::GetNumberOfLineNames(); ++i)
  {
    const char* name = vtkNPRLineDefinition::GetLineName(i);
    vtkNew<vtkNPRFeatureLines> lines;
    check(lines->AddDefinition(name) && lines->GetDefinition(0)->GetName() == std::string(name),
      "a definition is made by its name");
    lines->SetCamera(MakeCamera({ 3.0, 1.0, 3.0 }));
    vtkNew<vtkPolyData> empty;
    lines->SetInputData(empty);
    check(GetErrors(lines).empty() && lines->GetOutput()->GetNumberOfLines() == 0,
      "an empty input has no lines and no error");
  }
  check(vtkNPRLineDefinition::NewFromName("no such") == nullptr, "there is no such kind of line");
}

void TestHostileInput(Checks& check)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Vector oblique(3.0, 1.0, 3.0);
  // NaN in any array: lines elsewhere stay, and nothing is out of range.
  const auto whole = Extract(Torus().Make(60, 30), AllLines, MakeCamera(oblique));
  auto torus = Torus().Make(60, 30);
  const int numberOfArrays = torus->GetPointData()->GetNumberOfArrays();
  for (int a = 0; a <= numberOfArrays; ++a)
  {
    torus = Torus().Make(60, 30);
    for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); i += 97)
    {
      if (a == numberOfArrays)
      {
        torus->GetPoints()->SetPoint(i, nan, nan, nan);
      }
      else
      {
        torus->GetPointData()->GetArray(a)->SetComponent(i, 0, nan);
      }
    }
    const auto chains = Extract(torus, AllLines, MakeCamera(oblique));
    check(chains.size() > 1, "lines away from the NaN stay");
    for (const Chain& chain : chains)
    {
      for (std::size_t i = 0; i < chain.Points.size(); ++i)
      {
        check(chain.Points[i].allFinite() && chain.Strength[i] >= 0.0 && chain.Strength[i] <= 1.0,
          "no NaN gets into lines");
      }
    }
  }
  check(whole.size() >= 2, "the whole torus has lines");

  // The eye inside, at a point, and in the middle of a triangle.
  check(Extract(MakeSphere(20, 1.0), { "contours" }, MakeCamera(Vector(0.1, 0.0, 0.0))).empty(),
    "from inside a sphere has no contour");
  torus = Torus().Make(60, 30);
  for (vtkIdType i : { 0, 100, 777 })
  {
    Vector point;
    torus->GetPoint(i, point.data());
    CheckSound(Extract(torus, AllLines, MakeCamera(point)), check);
  }

  // Triangles without area, and one that is there twice.
  torus->GetPolys()->InsertNextCell({ 0, 1, 1 });
  torus->GetPolys()->InsertNextCell({ 0, 1, 2 });
  torus->GetPolys()->InsertNextCell({ 0, 1, 2 });
  torus->GetPolys()->Modified();
  check(!Extract(torus, AllLines, MakeCamera(oblique)).empty(), "bad triangles do no harm");
}
}

int TestFeatureLinesRobustness(int, char*[])
{
  Checks check;
  TestThreads(check);
  TestOrder(check);
  TestErrors(check);
  TestHostileInput(check);
  return check.Result();
}
