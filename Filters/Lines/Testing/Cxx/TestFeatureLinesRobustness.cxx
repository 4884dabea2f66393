// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors, and inputs that must not break anything.
#include "nprLineTesting.h"

#include "vtkNPRLineDefinition.h"

#include <vtkMatrix4x4.h>

#include <limits>
#include <string>

using namespace nprtest;

namespace
{
const std::vector<const char*> AllLines = { "contours", "suggestive", "creases", "boundaries" };

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
    check(Contains(errors, "\"PrincipalCurvature1\"") && Contains(errors, "vtkNPRCurvatureTensor"),
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
  TestErrors(check);
  TestHostileInput(check);
  return check.GetResult();
}
